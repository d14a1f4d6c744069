// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/experimentrun.h"

#include "async/sleep.h"
#include "experiment/announcement.h"
#include "experiment/envelope.h"
#include "experiment/equivalenttime.h"
#include "experiment/gains.h"
#include "experiment/latepush.h"
#include "experiment/owedgains.h"
#include "experiment/seconds.h"
#include "experiment/verdict.h"
#include "model/family.h"

#include <cmath>

namespace mb::tuning {
namespace {

using namespace std::chrono_literals;

constexpr Duration hearLimit = 1s;
constexpr Duration hearPeriod = 5ms;
constexpr Duration approachLimit = 3s;
constexpr double nearX = 0.02; ///< of |Y − X|
constexpr Duration stillBefore = 250ms;
constexpr Duration leastHold = 400ms;
constexpr double levelShare = 0.5;
constexpr double settledWidth = 0.02; ///< of |Y − X|
constexpr double longestReturn = 5.0; ///< s
constexpr double returnedShare
    = 0.35;                     ///< of a way back, over which it stays where it began: nothing but its next step waits
constexpr double stopLag = 0.2; ///< s, as the guard of the travel counts
constexpr int relayTurns = 18;
constexpr Duration relayGlance = 2ms;
constexpr Duration standsSpan = 150ms; ///< the same without a loop

} // namespace

ExperimentRun::ExperimentRun(
    Device &device, SetPointStream &stream, ExperimentPlan plan, ExperimentSurroundings surroundings)
    : m_device(device)
    , m_stream(stream)
    , m_plan(std::move(plan))
    , m_around(std::move(surroundings))
    , m_beat(inSeconds(device.family().capabilities.commandPeriod))
    , m_recorder(device, stream, m_plan.mode, m_plan.axis)
    , m_rates(device)
{
    if (m_around.interruption)
        m_around.interruption->setStream(&stream);
}

ExperimentRun::~ExperimentRun()
{
    if (m_around.interruption)
        m_around.interruption->setStream(nullptr);
    if (m_stream.isRunning())
        m_stream.stop();
}

void ExperimentRun::note(const Message &text) const
{
    if (m_around.note)
        m_around.note(text);
}

Task<void> ExperimentRun::hearPosition()
{
    const Instant limit = m_device.clock().now() + hearLimit;
    while (!m_recorder.latest("position") || !m_device.liveness().heard) {
        if (m_device.clock().now() >= limit)
            co_return fail(Fault::Timeout, say("%1 does not tell its position", m_device.selector()));
        Sleep nap(m_device.clock(), hearPeriod);
        co_await nap;
    }
    m_origin = *m_recorder.latest("position");
    co_return {};
}

Task<void> ExperimentRun::prepare()
{
    if (auto allowed = m_device.mayMove(); !allowed)
        co_return fail(allowed.error());
    auto hearing = hearPosition();
    co_await std::move(hearing);
    const bool counted = m_plan.mode == Mode::Position && m_device.family().capabilities.zeroPosition;
    if (counted)
        m_origin = 0.0; // it counts from its start
    auto reading = readOwnLimits(m_device, m_plan.axis, m_plan.slot, m_origin);
    const Envelope own = co_await std::move(reading);
    const Mode bounded = m_plan.loop.value_or(m_plan.mode);
    const auto envelope = resolve(m_device.family(), factsOf(m_device, m_plan.axis), bounded, m_plan.limits, own);
    if (!envelope)
        co_return fail(envelope.error());
    const double from = m_plan.from.value_or(m_plan.mode == Mode::Position ? m_origin : 0.0);
    const auto stimulus = Stimulus::make(m_plan.profile, from, m_plan.to, m_plan.seconds, m_beat);
    if (!stimulus)
        co_return fail(stimulus.error());
    if (stimulus->from == stimulus->to)
        co_return fail(Fault::OutOfRange, say("there is no way from %1 to itself", from), say("give another target"));
    if (auto inside = checkInside(*envelope, m_plan.mode, *stimulus, m_plan.repeat, m_origin); !inside)
        co_return fail(inside.error());
    m_trial.stimulus = *stimulus;
    m_trial.envelope = *envelope;
    if (!counted) {
        for (const double target : {stimulus->from, stimulus->to}) {
            if (auto legal = m_device.check(setPointAt(target)); !legal)
                co_return fail(legal.error());
        }
    }
    if (m_plan.keep != Keep::Always) {
        auto replacing = readReplaced(m_device, m_plan.gains);
        m_owed = co_await std::move(replacing);
    }
    describe(m_trial, m_device);
    m_trial.mode = m_plan.mode;
    m_trial.axis = m_plan.axis;
    m_trial.slot = m_plan.slot;
    m_trial.repeat = m_plan.repeat;
    co_return {};
}

Task<void> ExperimentRun::perform()
{
    if (needsRestart(m_device, m_plan.gains))
        m_trial.flags.emplace_back(flag::restartNeeded);
    auto writing = writeDown();
    co_await std::move(writing);
    if (isInterrupted())
        co_return {};
    if (m_plan.mode == Mode::Position && m_device.family().capabilities.zeroPosition) {
        auto zeroing = m_device.zeroPosition();
        co_await std::move(zeroing);
    }
    auto raising = m_rates.raise(m_plan.axis, rate());
    co_await std::move(raising);
    announce(m_device, m_around, m_plan, m_trial, m_origin);
    auto finding = findDirection();
    co_await std::move(finding);
    if (const Message caution = m_device.caution(setPointAt(m_trial.stimulus.to)); !caution.empty())
        m_around.caution(caution);
    auto driving = drive();
    co_await std::move(driving);
    co_return {};
}

Task<void> ExperimentRun::writeDown()
{
    const bool owes = !m_plan.gains.empty() && m_plan.keep != Keep::Always;
    m_trial.gains = numbersOf(m_device.family(), m_plan.gains); // for whoever finds this trial cut off
    if (m_around.journal) {
        auto beginning = m_around.journal->begin(m_trial);
        const Result<std::int64_t> number = co_await std::move(beginning).attempt();
        if (!number && owes)
            co_return fail(number.error());
        if (number)
            m_trial.number = m_number = *number;
        else
            m_around.caution(say("this trial is not kept: %1", number.error().detail));
    }
    if (owes && !m_number)
        co_return fail(Fault::Unsafe, say("nothing could put the gains back after a crash"),
            say("keep what is tried, or name a notebook that can be written"));
    if (owes) {
        auto owing = m_around.journal->owe(*m_number, m_trial.unit, m_owed);
        co_await std::move(owing);
    }
    if (!m_plan.gains.empty()) {
        m_wrote = true;
        auto writing = writeGains(m_device, m_plan.gains);
        co_await std::move(writing);
    }
    auto reading = readGains(m_device, m_plan.mode, m_plan.axis, m_plan.slot);
    m_trial.gains = co_await std::move(reading);
    co_return {};
}

double ExperimentRun::rate() const
{
    const TrialTraits &traits = *m_device.family().trials;
    const double usual = m_around.rate > 0.0 ? m_around.rate : traits.rate;
    return m_plan.rate.value_or(m_plan.mode == Mode::Current && traits.currentRate > 0.0 ? traits.currentRate : usual);
}

SetPoint ExperimentRun::setPointAt(double target) const
{
    SetPoint setPoint;
    setPoint.mode = m_plan.profiled ? Mode::RampPosition : m_plan.mode;
    setPoint.target = target;
    setPoint.axis = m_plan.axis;
    setPoint.slot = m_plan.slot;
    if (m_device.family().capabilities.outputOptions)
        setPoint.brake = true; // a coasting motor goes on many times as far
    return setPoint;
}

GuardPlan ExperimentRun::guardPlan() const
{
    const TrialTraits &traits = *m_device.family().trials;
    const Stimulus &stimulus = m_trial.stimulus;
    GuardPlan plan;
    plan.envelope = m_trial.envelope;
    plan.origin = m_origin;
    plan.swing = std::abs(stimulus.to - stimulus.from);
    plan.noise = m_plan.noise;
    plan.dutyKnown = m_plan.mode == Mode::Duty || axisChannel(m_device, "duty", m_plan.axis).has_value();
    plan.isVelocity = m_plan.mode == Mode::Velocity;
    plan.breakaway = m_breakaway;
    plan.late = ofSeconds(secondsUntilPush(m_device, m_trial, m_breakaway));
    plan.hottest = traits.hottest;
    plan.lowestBus = traits.lowestBus;
    plan.highestBus = traits.highestBus;
    plan.telemetry = ofSeconds(std::max(1.0 / rate(), m_recorder.positionPeriod()));
    plan.command = m_device.family().capabilities.commandPeriod;
    const double once = 2.0 * inSeconds(stillBefore) + stimulus.length() + std::min(stimulus.length(), longestReturn);
    plan.longest = approachLimit + ofSeconds(once * m_plan.repeat);
    return plan;
}

Task<void> ExperimentRun::findDirection()
{
    if (!isClosedLoop(m_plan.mode) || !m_around.directions)
        co_return {};
    const auto known = m_around.directions->find(m_device.selector(), m_plan.axis);
    if (known) {
        m_breakaway = *known > 0.0 ? *known : m_breakaway;
        co_return {};
    }
    Interruption alone;
    const Interruption &interruption = m_around.interruption ? *m_around.interruption : alone;
    m_moved = true;
    auto checking = checkDirection(m_device, m_stream, m_recorder, m_plan.axis, guardPlan(), interruption, m_trip);
    const Result<double> duty = co_await std::move(checking).attempt();
    m_recorder.unguard();
    if (!duty)
        co_return fail(duty.error());
    m_around.directions->add(m_device.selector(), m_plan.axis, *duty);
    m_breakaway = *duty > 0.0 ? *duty : m_breakaway;
    co_return {};
}

/// The check of the direction has moved it a little, and its loop does not bring it back: where nobody asked for another X,
/// that is where it stands now.
bool ExperimentRun::beginsHere()
{
    const auto here = m_recorder.latest("position");
    if (m_plan.mode != Mode::Position || m_plan.from || !here)
        return false;
    const auto stimulus = Stimulus::make(m_plan.profile, *here, m_plan.to, m_plan.seconds, m_beat);
    if (!stimulus)
        return false;
    m_trial.stimulus = *stimulus;
    setTarget(*here);
    return true;
}

bool ExperimentRun::isInterrupted() const
{
    return m_around.interruption && m_around.interruption->isRequested();
}

bool ExperimentRun::isOver() const
{
    return m_recorder.trip() || !m_stream.isRunning() || isInterrupted();
}

void ExperimentRun::setTarget(double target)
{
    m_recorder.expect(target);
    if (m_stream.isRunning() && m_stream.setPoint().target != target)
        (void)m_stream.follow(setPointAt(target)); // a refusal ends the stream, and that is seen
}

Task<void> ExperimentRun::drive()
{
    if (isInterrupted())
        co_return {};
    m_recorder.guard(guardPlan());
    m_recorder.expect(m_trial.stimulus.from);
    m_moved = true;
    if (auto started = m_stream.start(setPointAt(m_trial.stimulus.from), experimentLease); !started)
        co_return fail(started.error());
    auto going = goTo(m_trial.stimulus.from);
    co_await std::move(going);
    const double period = 1.0 / rate();
    for (int i = 0; i < m_plan.repeat && !isOver(); ++i) {
        auto following = followOnce(ditherOf(i, m_plan.repeat, period));
        co_await std::move(following);
    }
    m_recorder.unguard();
    if (m_stream.isRunning())
        m_stream.stop();
    co_return {};
}

Task<void> ExperimentRun::goTo(double target)
{
    const double width = nearX * std::abs(m_trial.stimulus.to - m_trial.stimulus.from);
    const std::string_view key = measuredOf(m_plan.mode);
    const Instant from = m_device.clock().now();
    const Instant limit = from + approachLimit;
    while (!isOver()) {
        const double here = m_recorder.latest(key).value_or(0.0);
        const bool rests = m_recorder.isSettled(from, stillBefore, levelShare, 2.0 * width);
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
            co_return fail(Fault::Refused,
                say("the unit stays %1 away from where the experiment begins, more than 2 % of its step",
                    std::round(std::abs(here - target) * 100.0) / 100.0),
                say("take a larger one, or begin where it stands"));
        }
        Sleep nap(m_device.clock(), hearPeriod);
        co_await nap;
    }
    co_return {};
}

/// X for a moment, the stimulus on the device's beat, and back to X.
Task<void> ExperimentRun::followOnce(double dither)
{
    const Stimulus &stimulus = m_trial.stimulus;
    Clock &clock = m_device.clock();
    const double width = settledWidth * std::abs(stimulus.to - stimulus.from);
    const auto aim = isClosedLoop(m_plan.mode) ? std::optional(stimulus.to) : std::nullopt;
    Sleep waiting(clock, stillBefore + ofSeconds(dither));
    co_await waiting;
    const Instant begin = clock.now();
    const Instant end = begin + ofSeconds(stimulus.length());
    const double place = m_recorder.latest("position").value_or(m_origin);
    if (m_plan.relay) {
        auto swinging = swing(end);
        co_await std::move(swinging);
    }
    for (int beat = 0; !m_plan.relay && !isOver() && clock.now() < end; ++beat) {
        setTarget(stimulus.at(inSeconds(clock.now() - begin)));
        if (hasGoneFar(place) || (stimulus.ends && m_recorder.hasSettled(begin, leastHold, aim, width)))
            break;
        Sleep nap(clock, std::min(begin + ofSeconds(m_beat * (beat + 1)), end) - clock.now());
        co_await nap;
    }
    const Instant back = clock.now();
    for (const double edge : stimulus.edges())
        m_holds.emplace_back(begin + ofSeconds(edge), std::min(begin + ofSeconds(edge + stimulus.hold()), back));
    if (stimulus.edges().empty())
        m_holds.emplace_back(begin, back);
    setTarget(stimulus.from);
    tellMeasured();
    const Instant limit = back + ofSeconds(std::max(std::min(stimulus.length(), longestReturn), m_plan.rest));
    while (!isOver() && clock.now() < limit && !hasReturned(back)) {
        Sleep nap(clock, ofSeconds(m_beat));
        co_await nap;
    }
    m_returns.emplace_back(back, clock.now());
    co_return {};
}

/// Farther, or quicker, than a push is to go.
bool ExperimentRun::hasGoneFar(double from) const
{
    const double stops = m_recorder.stopsAt(stopLag);
    const double rolls = std::abs(stops - m_recorder.latest("position").value_or(stops));
    return (m_plan.reach && std::abs(stops - from) > *m_plan.reach)
        || (m_plan.fastest && rolls > *m_plan.fastest * stopLag);
}

/// The duty of Y one way and the other: what makes the motor swing tells how sluggish it is (relaycycle.h).
Task<void> ExperimentRun::swing(Instant end)
{
    Clock &clock = m_device.clock();
    const double middle = m_recorder.latest("position").value_or(m_origin);
    double target = m_trial.stimulus.to;
    for (int turns = 0; !isOver() && clock.now() < end && turns < relayTurns;) {
        setTarget(target);
        Sleep nap(clock, relayGlance);
        co_await nap;
        const double passed = m_recorder.latest("position").value_or(middle) - middle;
        if (passed * target > 0.0 && std::abs(passed) > *m_plan.relay) {
            target = -target;
            ++turns;
        }
    }
    co_return {};
}

bool ExperimentRun::hasReturned(Instant since) const
{
    const Stimulus &stimulus = m_trial.stimulus;
    if (m_plan.mode == Mode::Duty && stimulus.from == 0.0)
        return m_recorder.isStill(since, standsSpan);
    const double width = settledWidth * std::abs(stimulus.to - stimulus.from);
    return m_recorder.isSettled(since, std::max(leastHold, ofSeconds(m_plan.rest)), returnedShare, width);
}

void ExperimentRun::tellMeasured() const
{
    if (!m_around.measured || isOver())
        return;
    Trial sofar = m_trial;
    sofar.samples = m_recorder.samples();
    sofar.lost = m_recorder.lost();
    measure(sofar, m_device.family(), m_recorder, m_holds, m_returns);
    m_around.measured(sofar);
}

Task<void> ExperimentRun::putBack()
{
    if (!m_wrote || m_plan.keep == Keep::Always)
        co_return {};
    if (m_plan.keep == Keep::WhenDone && m_trial.reason == "done") {
        auto settling = m_around.journal->settle(*m_number);
        (void)co_await std::move(settling).attempt();
        co_return {};
    }
    auto writing = writeGains(m_device, changesOf(m_device.family(), m_owed));
    const Result<void> written = co_await std::move(writing).attempt();
    if (!written) {
        note(say("the gains were not put back: %1; the notebook has them, 'motorbenchctl trials' lists what is owed",
            written.error().detail));
        co_return {};
    }
    auto marking = markPutBack(m_device, *m_around.journal, {*m_number, 0.0, m_owed});
    (void)co_await std::move(marking).attempt();
    co_return {};
}

void ExperimentRun::classifyEnding(const std::optional<Error> &error)
{
    if (m_recorder.trip() && !m_trip)
        m_trip = m_recorder.trip();
    const Ending ending{
        m_trip, m_stream.end(), m_stream.reason(), isInterrupted(), m_device.link().state() == LinkState::Open, error};
    nameEnding(m_trial, ending);
}

Task<void> ExperimentRun::conclude(std::optional<Error> error)
{
    if (m_stream.isRunning())
        m_stream.stop();
    m_recorder.unguard();
    classifyEnding(error);
    if (m_moved) {
        auto confirming = confirmStop(m_device);
        m_trial.stopped = co_await std::move(confirming);
        auto resting = untilAtRest(m_device, m_recorder);
        (void)co_await std::move(resting);
    }
    m_trial.samples = m_recorder.samples();
    m_trial.lost = m_recorder.lost();
    measure(m_trial, m_device.family(), m_recorder, m_holds, m_returns);
    if (m_device.link().state() == LinkState::Open) {
        auto putting = putBack();
        co_await std::move(putting);
        auto lowering = m_rates.lower(m_around);
        co_await std::move(lowering);
    }
    if (m_number) {
        auto completing = m_around.journal->complete(*m_number, m_trial);
        const Result<void> completed = co_await std::move(completing).attempt();
        if (!completed)
            note(say("this trial is kept without its result: %1", completed.error().detail));
    }
    co_return {};
}

} // namespace mb::tuning
