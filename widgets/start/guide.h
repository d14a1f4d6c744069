// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/selection.h"
#include "widgets/common/workbench.h"
#include "widgets/control/arming.h"
#include "widgets/start/story.h"

#include <optional>

namespace mb {

namespace tuning {
struct Trial;
}
struct KeptTrial;

/// Leads through a story. A step counts as done when the snapshot, the Arm button or the notebook says that it has happened, however
/// the user got there; nothing is done for them. GUI thread.
class Guide : public QObject {
    Q_OBJECT
public:
    Guide(Workbench &workbench, Selection &selection, Arming &arming, QObject *parent = nullptr);

    /// From its first step; what was begun before is forgotten.
    void begin(const Story &story);
    void end();
    /// nullptr: none was begun.
    [[nodiscard]] const Story *story() const { return m_story; }
    /// The step to do now, from 0; as many as there are: the story is done.
    [[nodiscard]] std::size_t step() const { return m_step; }
    [[nodiscard]] bool isDone() const { return m_story && m_step == m_story->steps.size(); }
    /// What was measured so far, "overshoot 21 % at first, 3 % now"; empty before.
    [[nodiscard]] QString result() const;
    /// The unit of the story; nullptr while it is not found.
    [[nodiscard]] const DeviceView *device() const;
    [[nodiscard]] static const DeviceView *deviceOf(const Story &story, const Snapshot &shot);
    /// Something was tried on its unit already: it is no story for the first minute any more.
    [[nodiscard]] static bool isBegun(const Story &story, const Snapshot &shot);

Q_SIGNALS:
    void changed();

private:
    void follow();
    void watch(const DeviceView &device);
    [[nodiscard]] bool isProved(Proof proof, const DeviceView &device) const;
    void askNotebook(const DeviceView &device);
    void takeRest(const tuning::Trial &trial);
    void take(const std::vector<KeptTrial> &trials);

    Workbench &m_workbench;
    Selection &m_selection;
    Arming &m_arming;
    const Story *m_story = nullptr;
    std::size_t m_step = 0;
    bool m_here = false; ///< the unit of the story answers
    int m_run = 0;       ///< answers to an earlier story are not taken
    bool m_asked = false;
    std::uint32_t m_askedAfter = 0;        ///< operation whose trial was asked for
    std::optional<std::int64_t> m_newest;  ///< trial in the notebook when the story began
    std::optional<double> m_overshoot;     ///< of the first step, fraction
    std::optional<double> m_lastOvershoot; ///< of the newest one after it
    std::optional<double> m_peakCurrent;   ///< A, of the newest
    std::optional<double> m_left;          ///< counts beside its target after the first step that stopped short …
    double m_way = 0.0;                    ///< … over so many
    std::optional<double> m_lastLeft;      ///< after the newest one since
    bool m_wrote = false;                  ///< a value was seen that is not in flash yet
};

} // namespace mb
