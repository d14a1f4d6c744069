// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/firstmotion.h"

#include "experiment/guards.h"
#include "model/family.h"
#include "tuning/autotunerun.h"
#include "tuning/rawstep.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mb::tuning {
namespace {

constexpr double gentlestForce = 8.0; ///< the stored P is so many times the first
constexpr double firmestForce = 8.0;  ///< times the stored P
constexpr double nextForce = 1.4;
constexpr double shortHold = 0.8; ///< s
constexpr double mostRawP = 30000.0;
constexpr double tellingCurrent = 0.1; ///< A
constexpr double turningShare = 0.75;
constexpr int mostAgain = 2;

/// What stands draws as much to the end as it is pushed for; what turns, less and less.
bool hasFallen(const DrawnCurrent &drawn)
{
    return drawn.most() > tellingCurrent && drawn.last() < turningShare * drawn.most();
}

/// An answer that was lost leaves open whether the move was done, and a place that was missed may look like a start anew: where the motor
/// was seen stopped, it is looked again from where it stands.
bool isLossy(const AutotuneRun &run)
{
    const SetPointStream::End end = run.stream().end();
    const bool isLoss = end == SetPointStream::End::DeviceRestarted || end == SetPointStream::End::Refused;
    return isLoss && run.report().stopped && run.device().liveness().heard;
}

/// An output goes in whole steps: what a push draws is up to one of them less than its share. None draws more than the least that was seen.
class DrawnByPush {
public:
    /// A for 1 of P times counts, halfway between what the pushes leave open.
    [[nodiscard]] double ofOne(double push, double current)
    {
        m_step = std::min(m_step, current);
        m_least = std::max(m_least, current / push);
        m_most = std::min(m_most, (current + m_step) / push);
        return 0.5 * (m_least + std::max(m_least, m_most));
    }

private:
    double m_step = std::numeric_limits<double>::infinity();
    double m_least = 0.0;
    double m_most = std::numeric_limits<double>::infinity();
};

Task<void> tryForce(AutotuneRun &run, ExperimentPlan plan)
{
    for (int again = 0;; ++again) {
        const Trial ran = co_await run.run(plan);
        const bool hasBegun = ran.reason == EndReason::Done || !ran.holds.empty();
        if (hasBegun || again == mostAgain || !isLossy(run))
            co_return {};
        run.forgive();
        run.note(say("an answer was lost; the same again"));
        auto reading = run.device().refresh(); // what a restart would have taken
        co_await std::move(reading);
    }
}

} // namespace

Task<FirstMotion> findFirstMotion(AutotuneRun &run, double storedP)
{
    const double nudge = run.device().family().trials->nudge;
    const double most = std::min(firmestForce * storedP, mostRawP);
    const double allowed = run.envelope().current.value_or(std::numeric_limits<double>::infinity());
    FirstMotion first;
    DrawnByPush drawing;
    for (double p = std::max(std::round(storedP / gentlestForce), 1.0);; p = std::min(std::ceil(nextForce * p), most)) {
        run.forgive();
        const DrawnCurrent drawn(run);
        auto trying = tryForce(run, rawStep(run, {p, 0.0}, -nudge, shortHold));
        co_await std::move(trying);
        first.push = p * nudge;
        const bool isHeld = run.report().stopReason == EndReason::NoMotion && !hasGone(run);
        const bool isTurning = isHeld && hasFallen(drawn);
        if (isHeld || first.current == 0.0)
            first.current = drawing.ofOne(first.push, drawn.most());
        const bool isStrongest = p >= most || nextForce * first.push * first.current > allowed;
        if (!isHeld || isTurning || isStrongest) // a dead sensor is not asked with more and more force
            break;
    }
    const EndReason ending = run.report().stopReason;
    if (ending == EndReason::NoMotion && !hasGone(run))
        run.report().evidence
            = joined(run.report().evidence, say("where it is neither, its gain.p is too small for so short a way"));
    else if (ending == EndReason::NoMotion || ending == EndReason::Oscillation)
        run.forgive(); // these gains are not for keeping
    co_return first;
}

} // namespace mb::tuning
