// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "service/queuerow.h"
#include "service/recipematter.h"
#include "widgets/firmware/updateside.h"

#include <memory>

namespace mb {

class QueueRecipe;
struct QueueLine;
class UnitSteps;

/// One unit beside the queue: whether power may be cut now, what hands have to do, its steps, its pages. GUI thread.
class QueueSide : public UpdateSide {
    Q_OBJECT
public:
    QueueSide(const ThemeSource &theme, QWidget *parent);

    /// Of what is done to every unit.
    void noteWhatTurns(const QueueRecipe &recipe);
    /// By what is or was done to it. nullptr: none that was served, and none at all.
    void showUnit(const service::QueueRow *row, const QueueLine *line, const QueueRecipe &recipe);
    [[nodiscard]] UnitSteps &unit() const { return *m_unit; }

private:
    void setRecipe(const QueueRecipe &recipe);
    void followHands(const service::QueueRow *row);

    UnitSteps *m_unit = nullptr;
    std::shared_ptr<const service::RecipeMatter> m_matter; ///< that steps and pages are of
};

} // namespace mb
