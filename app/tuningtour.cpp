// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tuningtour.h"

#include "widgets/control/trialsview.h"
#include "widgets/control/tuneform.h"
#include "widgets/control/tunepage.h"
#include "widgets/design/designpage.h"
#include "widgets/parameters/editdesk.h"

#include <cmath>
#include <cstdio>

namespace mb {
namespace {

constexpr double trialTarget = 60000.0; ///< counts/s
constexpr double calmerP = 0.55;        ///< of what is stored
constexpr double calmerI = 0.42;
constexpr std::chrono::seconds trialTime{30};
constexpr std::chrono::seconds tuningTime{180};
constexpr std::chrono::seconds toldTime{1}; ///< nothing changes any more
constexpr double foundOvershoot = 0.15;     ///< of the step, at least, as it was found
constexpr double mostOvershoot = 0.02;      ///< after one press
constexpr std::chrono::milliseconds beforeTrial{300};
constexpr std::chrono::milliseconds afterTrial{600};

} // namespace

void TuningTour::plan()
{
    planTrials();
    planDesign();
}

/// Stages these shares of what the unit has; 1 stages nothing.
void TuningTour::tryGains(double p, double i)
{
    const DeviceView &view = *unit();
    StagedEdits &edits = EditDesk::of(m_stage.workbench()).editsOf(view);
    std::vector<ParameterChange> changes;
    const std::span<const std::string_view> gains = view.family->demo->livelyGains;
    for (const auto &[key, share] : {std::pair(gains[0], p), std::pair(gains[1], i)}) {
        const ParameterIndex index = *findParameter(view.family->parameters, key);
        const auto raw = (*view.parameters)[index.value].raw;
        if (raw && share != 1.0)
            changes.push_back({index, std::llround(static_cast<double>(*raw) * share)});
    }
    if (!changes.empty())
        edits.stageAll(changes, TourStage::tr("tour"));
    auto &page = m_stage.page<TunePage>(PageId::Tune);
    StimulusChoice stimulus;
    stimulus.to = trialTarget;
    stimulus.repeat = 2;
    page.form().chooseStimulus(Mode::Velocity, stimulus);
    page.run();
}

/// Of the newest trial.
double TuningTour::overshoot()
{
    return m_stage.page<TunePage>(PageId::Tune).trials().b()->trial.metrics.overshoot.value_or(0.0);
}

void TuningTour::arm()
{
    m_stage.arm("arm for a trial", [this] { return unit(); });
}

void TuningTour::planTrial(const char *name, double p, double i, bool second)
{
    arm();
    m_stage.pause(beforeTrial);
    m_stage.add(
        name, [this, p, i] { tryGains(p, i); },
        [this, second] {
            const TrialsView &trials = m_stage.page<TunePage>(PageId::Tune).trials();
            return !m_stage.window().arming().isOnTrial() && trials.b() && (!second || trials.a());
        },
        trialTime);
}

/// What the page is for: a loop as it was found, and after one change, over each other.
void TuningTour::planTrials()
{
    m_stage.add(
        "the lively one",
        [this] {
            m_stage.window().selection().select(unit()->id);
            m_stage.window().showPage(PageId::Tune);
        },
        [this] { return unit()->mayNotMove.empty() && isRead(*unit()); });
    planTrial("a trial", 1.0, 1.0, false);
    m_stage.act("as it was found", [this] { m_found = overshoot(); });
    planTrial("a calmer trial", calmerP, calmerI, true);
    m_stage.picture("tune", afterTrial);
    m_stage.act("disarm", [this] { m_stage.window().arming().disarm(); });
}

/// One press, from whatever the unit has to gains that were proven on it, and the same step once more.
void TuningTour::planDesign()
{
    m_stage.act("design", [this] { m_stage.window().showPage(PageId::Design); });
    arm();
    m_stage.add(
        "autotune", [this] { m_stage.page<DesignPage>(PageId::Design).autotune(); },
        [this] {
            const tuning::TuneReport *const report = m_stage.page<DesignPage>(PageId::Design).report();
            return !m_stage.window().arming().isOnTrial() && report && report->result == tuning::TuneResult::Kept;
        },
        tuningTime);
    m_stage.picture("design", afterTrial);
    m_stage.act("back to tune", [this] { m_stage.window().showPage(PageId::Tune); });
    planTrial("the same step", 1.0, 1.0, false);
    m_stage.picture("tuned", afterTrial);
    m_stage.add(
        "at most 2 % after one press",
        [this] {
            std::printf("#%d overshoots by %.1f %% as it was found, by %.1f %% after one press\n",
                unit()->identity->address, 100.0 * m_found, 100.0 * overshoot());
            std::fflush(stdout);
            m_stage.window().arming().disarm();
        },
        [this] { return m_found >= foundOvershoot && overshoot() <= mostOvershoot; }, toldTime);
}

} // namespace mb
