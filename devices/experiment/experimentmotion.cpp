// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/experimentmotion.h"

#include "async/sleep.h"
#include "experiment/direction.h"
#include "experiment/equivalenttime.h"
#include "experiment/motiontimes.h"
#include "experiment/seconds.h"
#include "experiment/verdict.h"
#include "model/family.h"

#include <algorithm>
#include <cmath>

namespace mb::tuning {
namespace {

using namespace std::chrono_literals;

constexpr Duration glance = 5ms;
constexpr int relayTurns = 18;
constexpr Duration relayGlance = 2ms;
constexpr Duration standsSpan = 150ms; ///< the same without a loop

} // namespace

ExperimentMotion::ExperimentMotion(Device &device, SetPointStream &stream, const ExperimentPlan &plan,
    const ExperimentSurroundings &surroundings, TrialRecorder &recorder, Trial &trial)
    : m_device(device)
    , m_stream(stream)
    , m_plan(plan)
    , m_around(surroundings)
    , m_recorder(recorder)
    , m_trial(trial)
    , m_beat(device.family().capabilities.commandPeriod)
{
}

SetPoint ExperimentMotion::setPointAt(double target) const
{
    SetPoint setPoint;
    setPoint.mode = m_plan.profiled ? Mode::RampPosition : m_plan.mode;
    setPoint.target = target;
    setPoint.axis = m_plan.axis;
    setPoint.slot = m_plan.slot;
    if (m_device.family().capabilities.output.brake)
        setPoint.brake = true; // a coasting motor goes on many times as far
    return setPoint;
}

Duration ExperimentMotion::longest() const
{
    return ofSeconds(longestSeconds(m_trial.stimulus.length(), m_plan.repeat));
}

void ExperimentMotion::setTarget(double target)
{
    m_recorder.expect(target);
    if (m_stream.isRunning() && m_stream.setPoint().target != target)
        (void)m_stream.follow(setPointAt(target)); // a refusal ends the stream, and that is seen
}

Task<void> ExperimentMotion::run(GuardPlan guards, double period)
{
    m_origin = guards.origin;
    m_recorder.guard(guards);
    const SetPoint first = setPointAt(m_trial.stimulus.from);
    if (auto started = m_stream.start(first, experimentLease, {}, SetPointStream::Since::Renewal); !started)
        co_return fail(started.error());
    co_await untilSent(m_device.clock(), m_stream); // until then nothing pushes it to X
    m_recorder.expect(m_trial.stimulus.from);
    co_await goTo(m_trial.stimulus.from);
    for (int i = 0; i < m_plan.repeat && !isOver(); ++i)
        co_await followOnce(ditherOf(i, m_plan.repeat, period));
    m_completed = !isOver();
    m_recorder.unguard();
    if (m_stream.isRunning())
        m_stream.stop();
    co_return {};
}

/// The check of the direction has moved it a little, and its loop does not bring it back: where nobody asked for another X,
/// that is where it stands now.
bool ExperimentMotion::beginsHere()
{
    const auto here = m_recorder.latest("position");
    if (m_plan.mode != Mode::Position || m_plan.from || !here)
        return false;
    const auto stimulus = Stimulus::make(m_plan.profile, *here, m_plan.to, m_plan.seconds, inSeconds(m_beat));
    if (!stimulus)
        return false;
    m_trial.stimulus = *stimulus;
    setTarget(*here);
    return true;
}

Task<void> ExperimentMotion::goTo(double target)
{
    const std::string_view key = measuredOf(m_plan.mode);
    const Instant from = m_device.clock().now();
    const Instant limit = from + MotionTimes::approachLimit;
    while (!isOver()) {
        const double width = restWidth();
        const double here = m_recorder.latest(key).value_or(0.0);
        const bool rests = m_recorder.isSettled(from, MotionTimes::stillBefore, MotionTimes::levelShare, 2.0 * width);
        const bool arrived
            = m_plan.mode == Mode::Duty || m_plan.mode == Mode::Current || std::abs(here - target) <= width;
        if (rests && arrived)
            break;
        if (m_device.clock().now() >= limit) {
            if (arrived || m_plan.mode == Mode::Current)
                break; // noise, or a slow creep
            if (beginsHere())
                break;
            m_stream.stop();
            m_unreached = Trip{EndReason::Time,
                say("the unit stays %1 away from where the experiment begins, more than 2 % of its step",
                    std::round(std::abs(here - target) * 100.0) / 100.0),
                limit};
            break;
        }
        co_await Sleep(m_device.clock(), glance);
    }
    co_return {};
}

/// Of what is measured, within which it rests: 2 % of the way from X to Y. A duty is no measure of that, but what it makes now is.
double ExperimentMotion::restWidth() const
{
    const double here = m_plan.mode == Mode::Duty ? m_recorder.latest(measuredOf(m_plan.mode)).value_or(0.0) : 0.0;
    return MotionTimes::restShare * std::max(std::abs(m_trial.stimulus.to - m_trial.stimulus.from), std::abs(here));
}

/// X for a moment, the stimulus, and back to X.
Task<void> ExperimentMotion::followOnce(double dither)
{
    Clock &clock = m_device.clock();
    co_await Sleep(clock, MotionTimes::stillBefore + ofSeconds(dither));
    const Instant begin = clock.now();
    const Instant end = begin + ofSeconds(m_trial.stimulus.length());
    auto following = m_plan.relay ? swing(end) : followProfile(begin, end);
    co_await std::move(following);
    keepHolds(begin, clock.now());
    co_await comeBack();
    co_return {};
}

/// On the device's beat, or that of what glides. After a stall with one set-point, not a burst.
Task<void> ExperimentMotion::followProfile(Instant begin, Instant end)
{
    const Stimulus &stimulus = m_trial.stimulus;
    Clock &clock = m_device.clock();
    const bool endsSettled = stimulus.ends && stimulus.profile == Profile::Step;
    const double start = m_recorder.latest(measuredOf(m_plan.mode)).value_or(stimulus.from);
    const auto way = isClosedLoop(m_plan.mode) ? std::optional(TrialRecorder::Way{start, stimulus.to}) : std::nullopt;
    const double place = m_recorder.latest("position").value_or(m_origin);
    const Duration beat = stimulus.glides() ? m_device.family().trials->glideBeat : m_beat;
    while (!isOver() && clock.now() < end) {
        setTarget(stimulus.at(inSeconds(clock.now() - begin)));
        if (hasGoneFar(place)
            || (endsSettled && m_recorder.hasSettled(begin, MotionTimes::leastHold, way, restWidth())))
            break;
        const Instant next = begin + ((clock.now() - begin) / beat + 1) * beat;
        co_await Sleep(clock, std::min(next, end) - clock.now());
    }
    co_return {};
}

/// The duty of Y one way and the other: what makes the motor swing tells how sluggish it is (relaycycle.h).
Task<void> ExperimentMotion::swing(Instant end)
{
    Clock &clock = m_device.clock();
    const double middle = m_recorder.latest("position").value_or(m_origin);
    double target = m_trial.stimulus.to;
    for (int turns = 0; !isOver() && clock.now() < end && turns < relayTurns;) {
        setTarget(target);
        co_await Sleep(clock, relayGlance);
        const double passed = m_recorder.latest("position").value_or(middle) - middle;
        if (passed * target > 0.0 && std::abs(passed) > *m_plan.relay) {
            target = -target;
            ++turns;
        }
    }
    co_return {};
}

void ExperimentMotion::keepHolds(Instant begin, Instant back)
{
    const Stimulus &stimulus = m_trial.stimulus;
    for (const double edge : stimulus.edges())
        m_holds.emplace_back(begin + ofSeconds(edge), std::min(begin + ofSeconds(edge + stimulus.hold()), back));
    if (stimulus.edges().empty())
        m_holds.emplace_back(begin, back);
}

Task<void> ExperimentMotion::comeBack()
{
    const Stimulus &stimulus = m_trial.stimulus;
    Clock &clock = m_device.clock();
    const Instant back = clock.now();
    setTarget(stimulus.from);
    tellMeasured();
    const Instant limit
        = back + ofSeconds(std::max(std::min(stimulus.length(), MotionTimes::longestReturn), m_plan.rest));
    while (!isOver() && clock.now() < limit && !hasReturned(back))
        co_await Sleep(clock, m_beat);
    m_returns.emplace_back(back, clock.now());
    co_return {};
}

/// Farther, or quicker, than a push is to go.
bool ExperimentMotion::hasGoneFar(double from) const
{
    const double stops = m_recorder.stopsAt(stopLag);
    const double rolls = std::abs(stops - m_recorder.latest("position").value_or(stops));
    return (m_plan.reach && std::abs(stops - from) > *m_plan.reach)
        || (m_plan.fastest && rolls > *m_plan.fastest * stopLag);
}

/// To X, after the hold that ended at `since`.
bool ExperimentMotion::hasReturned(Instant since) const
{
    const Stimulus &stimulus = m_trial.stimulus;
    if (m_plan.mode == Mode::Duty && stimulus.from == 0.0)
        return m_recorder.isStill(since, standsSpan);
    return m_recorder.isSettled(
        since, std::max(MotionTimes::leastHold, ofSeconds(m_plan.rest)), MotionTimes::returnedShare, restWidth());
}

void ExperimentMotion::tellMeasured() const
{
    const auto newest = static_cast<std::ptrdiff_t>(m_trial.stimulus.edges().size());
    if (!m_around.measured || isOver() || newest == 0)
        return;
    Trial sofar = m_trial;
    sofar.samples = m_recorder.samples();
    sofar.lost = m_recorder.lost();
    const auto first = m_holds.end() - newest;
    Span within
        = TrialRecorder::everything; // from where the hold before ended: how long this takes is no matter of repeats
    if (first != m_holds.begin())
        within.from = inSeconds((first - 1)->second - first->first);
    measure(sofar, m_device.family(), m_recorder, {first, m_holds.end()}, {}, within);
    m_around.measured(sofar);
}

} // namespace mb::tuning
