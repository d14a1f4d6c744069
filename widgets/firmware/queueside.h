// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "service/queuerow.h"
#include "widgets/firmware/updateside.h"

namespace mb {

class QueueRecipe;
struct QueueLine;
class UnitSteps;

/// One unit beside the queue: whether power may be cut now, what hands have to do, its steps, its pages. GUI thread.
class QueueSide : public UpdateSide {
    Q_OBJECT
public:
    QueueSide(const ThemeSource &theme, QWidget *parent);

    /// What is done to every unit.
    void setRecipe(const QueueRecipe &recipe);
    /// nullptr: none that was served, and none at all.
    void showUnit(const service::QueueRow *row, const QueueLine *line, const QueueRecipe &recipe);
    [[nodiscard]] UnitSteps &unit() const { return *m_unit; }

private:
    void followHands(const service::QueueRow *row);

    UnitSteps *m_unit = nullptr;
};

} // namespace mb
