// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tour.h"

#include "widgets/control/trialsview.h"
#include "widgets/control/tuneform.h"
#include "widgets/control/tunepage.h"
#include "widgets/design/designpage.h"
#include "widgets/parameters/editdesk.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace mb {
namespace {

constexpr auto lively = &DemoUnits::overshooting;
constexpr double trialTarget = 60000.0; ///< counts/s
constexpr double calmerP = 0.55;        ///< of what is stored
constexpr double calmerI = 0.42;
constexpr std::chrono::seconds trialTime{30};
constexpr std::chrono::seconds tuningTime{180};

} // namespace

/// Stages these shares of what the unit has; 1 stages nothing.
void Tour::tryGains(double p, double i)
{
    const DeviceView &view = *device(lively);
    StagedEdits &edits = EditDesk::of(m_workbench).editsOf(view);
    std::vector<ParameterChange> changes;
    const std::span<const std::string_view> gains = view.family->demo->livelyGains;
    for (const auto &[key, share] : {std::pair(gains[0], p), std::pair(gains[1], i)}) {
        const ParameterIndex index = *findParameter(view.family->parameters, key);
        const auto raw = view.parameters[index.value].raw;
        if (raw && share != 1.0)
            changes.push_back({index, std::llround(static_cast<double>(*raw) * share)});
    }
    if (!changes.empty())
        edits.stageAll(changes, tr("tour"));
    auto *page = qobject_cast<TunePage *>(m_window.page(PageId::Tune));
    StimulusChoice stimulus;
    stimulus.to = trialTarget;
    stimulus.repeat = 2;
    page->form().chooseStimulus(Mode::Velocity, stimulus);
    page->run();
}

/// What the page is for: a loop as it was found, and after one change, over each other.
void Tour::planTrials()
{
    const auto page = [this] { return qobject_cast<TunePage *>(m_window.page(PageId::Tune)); };
    add(
        QStringLiteral("the lively one"),
        [this] {
            m_window.selection().select(device(lively)->id);
            m_window.showPage(PageId::Tune);
        },
        [this] {
            const auto &entries = device(lively)->parameters;
            return device(lively)->mayNotMove.empty()
                && std::all_of(
                    entries.begin(), entries.end(), [](const ParameterStore::Entry &e) { return e.raw.has_value(); });
        });
    for (const bool first : {true, false}) {
        add(
            QStringLiteral("arm for a trial"), [this] { m_window.arming().arm(device(lively)->id); },
            [this] { return m_window.arming().isArmed(device(lively)->id); });
        pause(std::chrono::milliseconds(300));
        add(
            QStringLiteral("a trial"), [this, first] { tryGains(first ? 1.0 : calmerP, first ? 1.0 : calmerI); },
            [this, page, first] {
                return !m_window.arming().isOnTrial() && page()->trials().b() && (first || page()->trials().a());
            },
            trialTime);
        if (first)
            add(
                QStringLiteral("as it was found"),
                [this, page] { m_foundOvershoot = page()->trials().b()->trial.metrics.overshoot.value_or(0.0); },
                [] { return true; });
    }
    pause(std::chrono::milliseconds(600));
    picture(QStringLiteral("tune"));
    add(
        QStringLiteral("disarm"), [this] { m_window.arming().disarm(); }, [] { return true; });
}

/// One press, from whatever the unit has to gains that were proven on it, and the same step once more.
void Tour::planDesign()
{
    const auto design = [this] { return qobject_cast<DesignPage *>(m_window.page(PageId::Design)); };
    const auto tune = [this] { return qobject_cast<TunePage *>(m_window.page(PageId::Tune)); };
    const auto arm = [this] {
        add(
            QStringLiteral("arm"), [this] { m_window.arming().arm(device(lively)->id); },
            [this] { return m_window.arming().isArmed(device(lively)->id); });
    };
    add(
        QStringLiteral("design"), [this] { m_window.showPage(PageId::Design); }, [] { return true; });
    arm();
    add(
        QStringLiteral("autotune"), [design] { design()->autotune(); },
        [this, design] {
            return !m_window.arming().isOnTrial() && design()->report()
                && design()->report()->result == tuning::TuneResult::Kept;
        },
        tuningTime);
    pause(std::chrono::milliseconds(600));
    picture(QStringLiteral("design"));
    add(
        QStringLiteral("back to tune"), [this] { m_window.showPage(PageId::Tune); }, [] { return true; });
    arm();
    pause(std::chrono::milliseconds(300));
    add(
        QStringLiteral("the same step"), [this] { tryGains(1.0, 1.0); },
        [this, tune] { return !m_window.arming().isOnTrial() && tune()->trials().b(); }, trialTime);
    pause(std::chrono::milliseconds(600));
    picture(QStringLiteral("tuned"));
    add(
        QStringLiteral("tell"),
        [this, tune] {
            m_tunedOvershoot = tune()->trials().b()->trial.metrics.overshoot.value_or(0.0);
            tellOvershoot();
            m_window.arming().disarm();
        },
        [] { return true; });
}

void Tour::tellOvershoot() const
{
    std::printf("#%d overshoots by %.1f %% as it was found, by %.1f %% after one press\n",
        device(lively)->identity.address, 100.0 * m_foundOvershoot, 100.0 * m_tunedOvershoot);
    std::fflush(stdout);
}

} // namespace mb
