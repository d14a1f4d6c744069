// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/setadviser.h"
#include "widgets/common/theme.h"
#include "widgets/design/designbook.h"

#include <QWidget>

namespace mb {

class AdviserList;
class ScrollColumn;
class TuningSteps;

/// The right column of the Design page: what is to be known of the chosen set, what will happen to it, and at the foot, always in sight,
/// the order that begins it, unless that stands elsewhere. What an adviser proposes is staged here (EditDesk), and written on the pages where it is edited.
class DesignCourse : public QWidget {
    Q_OBJECT
public:
    DesignCourse(Workbench &workbench, DesignBook &book, const ThemeSource &theme, QWidget *parent);

    /// The order at its foot, which it takes; nullptr: it stands elsewhere.
    void setOrder(QWidget *order);

    /// A set that is chosen, or nothing.
    struct Chosen {
        const tuning::Proposal *proposal = nullptr;
        QString name;
        Envelope inForce;
        bool isFoundAnew = false; ///< when it is written
    };
    /// Of the device that is shown; `running` while an order runs.
    void follow(const DeviceView &view, const OperationView *running, const Chosen &chosen);

protected:
    void resizeEvent(QResizeEvent *) override { fit(); }

private:
    void fit();
    void advise(const DeviceView &view, const Chosen &chosen);
    void stage(const tuning::SetAdvice &advice, bool staged);

    Workbench &m_workbench;
    DesignBook &m_book;
    ScrollColumn *m_area = nullptr;
    QWidget *m_foot = nullptr;
    AdviserList *m_advisers = nullptr;
    TuningSteps *m_steps = nullptr;
};

} // namespace mb
