// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/control/tunemotion.h"

namespace mb {

/// The axes of a board beside the one that is shown: what they do stays in sight, and they can take over what is chosen.
class TuneAxes : public QObject {
    Q_OBJECT
public:
    TuneAxes(Workbench &workbench, TuneChoices &choices, TuneMotion &motion, TuneColumn &column);

    void follow(const DeviceView &view);
    /// Axes that Run is about, without the one that is shown.
    [[nodiscard]] std::vector<int> beside() const;
    /// Mode and set-point of the axis that is shown, for all that are to run together; a position as the same distance.
    void spread();

Q_SIGNALS:
    /// Other axes have other choices.
    void changed();

private:
    void spreadTo(const DeviceView &view, int axis, const TuneChoice &shown);

    Workbench &m_workbench;
    TuneChoices &m_choices;
    TuneMotion &m_motion;
    TuneColumn &m_column;
};

} // namespace mb
