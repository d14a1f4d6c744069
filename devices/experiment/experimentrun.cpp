// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/experimentrun.h"

#include "async/sleep.h"
#include "experiment/announcement.h"
#include "experiment/envelope.h"
#include "experiment/foresight.h"
#include "experiment/gains.h"
#include "experiment/latepush.h"
#include "experiment/owedgains.h"
#include "experiment/seconds.h"
#include "experiment/verdict.h"
#include "model/family.h"

#include <cmath>
#include <utility>

namespace mb::tuning {
namespace {

using namespace std::chrono_literals;

constexpr Duration hearLimit = 1s;
constexpr Duration hearPeriod = 5ms;

} // namespace

ExperimentRun::ExperimentRun(
    Device &device, SetPointStream &stream, ExperimentPlan plan, ExperimentSurroundings surroundings)
    : m_device(device)
    , m_stream(stream)
    , m_plan(std::move(plan))
    , m_around(std::move(surroundings))
    , m_user(m_around.interruption, stream)
    , m_recorder(device, stream, m_plan.mode, m_plan.axis)
    , m_motion(device, stream, m_plan, m_around, m_recorder, m_trial)
    , m_rates(device)
{
}

ExperimentRun::~ExperimentRun()
{
    if (m_stream.isRunning())
        m_stream.stop();
    if (m_number && !m_concluded)
        m_around.journal->abandon(*m_number);
}

void ExperimentRun::note(const Message &text) const
{
    if (m_around.note)
        m_around.note(text);
}

Task<double> ExperimentRun::hearPosition()
{
    const Instant limit = m_device.clock().now() + hearLimit;
    while (!m_recorder.latest("position") || !m_device.liveness().heard) {
        if (m_device.clock().now() >= limit)
            co_return fail(Fault::Timeout, say("%1 does not tell its position", m_device.selector()));
        co_await Sleep(m_device.clock(), hearPeriod);
    }
    co_return *m_recorder.latest("position");
}

Task<void> ExperimentRun::prepare()
{
    co_await m_device.mayMove();
    double place = co_await hearPosition();
    m_start.origin = m_around.start ? m_around.start->value_or(place) : place;
    m_start.gone = place - m_start.origin;
    if (isCounted())
        m_start.origin -= std::exchange(place, 0.0);
    const Envelope own = co_await readOwnLimits(m_device, m_plan.axis, m_plan.slot, m_start.origin, m_plan.gains);
    const Mode bounded = m_plan.loop.value_or(m_plan.mode);
    const auto envelope
        = co_await resolve(m_device.family(), factsOf(m_device, m_plan.axis), bounded, m_plan.limits, own);
    const StartPlace start{place, m_start.origin, m_start.gone};
    const auto stimulus = co_await stimulusWithin(m_device.family(), envelope, m_plan, start);
    m_trial.stimulus = stimulus;
    m_trial.stimulus.ends = stimulus.ends || m_plan.turnsBack;
    m_trial.envelope = envelope;
    co_await checkTargets(m_plan.gains.empty());
    if (m_plan.keep != Keep::Always) {
        m_owed = co_await readReplaced(m_device, m_plan.gains);
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
    if (m_around.before)
        co_await m_around.before();
    if (needsRestart(m_device, m_plan.gains))
        m_trial.flags.emplace_back(flag::restartNeeded);
    co_await writeDown();
    co_await zero();
    if (m_around.start)
        *m_around.start = m_start.origin; // in the counts of now
    co_await m_rates.raise(m_plan.axis, rate(), m_around);
    if (!m_plan.intent.empty())
        note(m_plan.intent);
    announce(m_device, m_around, m_plan, m_trial, m_start.origin, m_start.gone);
    co_await findDirection();
    if (const Message caution = m_device.caution(m_motion.setPointAt(m_trial.stimulus.to)); !caution.empty())
        m_around.caution(caution);
    m_moved = true;
    co_await m_motion.run(guardPlan(), 1.0 / rate());
    if (m_motion.unreached())
        m_trip = m_motion.unreached();
    co_return {};
}

bool ExperimentRun::isCounted() const
{
    return m_plan.mode == Mode::Position && m_device.family().capabilities.zeroPosition;
}

Result<void> ExperimentRun::checkTargets(bool inForce) const
{
    for (const double target : {m_trial.stimulus.from, m_trial.stimulus.to}) {
        const auto checked = isCounted() ? Result<void>() : m_device.check(m_motion.setPointAt(target));
        if (!checked && (inForce || checked.error().fault != Fault::Unsafe))
            return checked;
    }
    return {};
}

Task<void> ExperimentRun::zero()
{
    if (!isCounted())
        co_return {};
    co_await m_user.mayGoOn();
    m_stoppedForZero = true;
    co_await m_device.zeroPosition();
    co_return {};
}

Task<void> ExperimentRun::writeDown()
{
    const bool owes = !m_plan.gains.empty() && m_plan.keep != Keep::Always;
    m_trial.gains = numbersOf(m_device.family(), m_plan.gains); // for whoever finds this trial cut off
    if (m_around.journal) {
        const Result<std::int64_t> number = co_await m_around.journal->begin(m_trial).attempt();
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
    if (owes)
        co_await m_around.journal->owe(*m_number, m_trial.unit, m_owed);
    if (!m_plan.gains.empty()) {
        co_await m_user.mayGoOn();
        m_wrote = true;
        co_await writeGains(m_device, m_plan.gains);
        m_inForce = true;
        co_await checkTargets(true);
    }
    const auto tried = m_trial.gains; // which stay where the unit does not tell its own
    m_trial.gains = co_await readGains(m_device, m_plan.mode, m_plan.axis, m_plan.slot);
    for (const auto &gain : tried) { // of another slot, or no gain of the loop
        if (std::ranges::find(m_trial.gains, gain.first, &decltype(m_trial.gains)::value_type::first)
            == m_trial.gains.end())
            m_trial.gains.push_back(gain);
    }
    co_return {};
}

double ExperimentRun::rate() const
{
    const TrialTraits &traits = *m_device.family().trials;
    const double usual = m_around.rate > 0.0 ? m_around.rate : traits.rate;
    return m_plan.rate.value_or(m_plan.mode == Mode::Current && traits.currentRate > 0.0 ? traits.currentRate : usual);
}

GuardPlan ExperimentRun::guardPlan() const
{
    const TrialTraits &traits = *m_device.family().trials;
    const Stimulus &stimulus = m_trial.stimulus;
    GuardPlan plan;
    plan.envelope = m_trial.envelope;
    plan.origin = m_start.origin;
    plan.swing = std::abs(stimulus.to - stimulus.from);
    plan.noise = m_plan.noise;
    plan.dutyKnown = m_plan.mode == Mode::Duty || axisChannel(m_device, "duty", m_plan.axis).has_value();
    plan.isVelocity = m_plan.mode == Mode::Velocity;
    if (m_around.directions)
        plan.lag = std::max(plan.lag, m_around.directions->lag(m_device.selector(), m_plan.axis));
    plan.breakaway = m_breakaway;
    plan.late = ofSeconds(secondsUntilPush(m_device, m_trial, m_breakaway));
    plan.hottest = traits.hottest;
    plan.lowestBus = traits.lowestBus;
    plan.highestBus = traits.highestBus;
    plan.telemetry = ofSeconds(std::max(1.0 / rate(), m_recorder.positionPeriod()));
    plan.command = m_device.family().capabilities.commandPeriod;
    plan.longest = m_motion.longest();
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
    m_moved = true;
    GuardPlan guards = guardPlan();
    if (m_device.family().trials->nudge > 0.0) // a short way, from where it stands
        guards.origin += m_start.gone;
    auto checking = checkDirection(m_device, m_stream, m_recorder, m_plan.axis, guards, m_trip);
    const Result<double> duty = co_await std::move(checking).attempt();
    m_recorder.unguard();
    if (!duty)
        co_return fail(duty.error());
    m_around.directions->add(m_device.selector(), m_plan.axis, *duty);
    m_breakaway = *duty > 0.0 ? *duty : m_breakaway;
    co_return {};
}

/// What it leaves in force is there on purpose: nothing else is owed.
Task<void> ExperimentRun::releaseKept()
{
    if (!m_around.journal)
        co_return {};
    std::vector<std::string> keys;
    for (const ParameterChange &change : m_plan.gains)
        keys.emplace_back(m_device.parameters().parameter(change.index).key);
    if (const auto released = co_await m_around.journal->release(m_trial.unit, std::move(keys)).attempt(); !released)
        m_around.caution(say("the notebook may offer to put back what was there before: %1", released.error().detail));
    co_return {};
}

Task<void> ExperimentRun::putBack()
{
    const bool owes = m_number && !m_owed.empty() && m_plan.keep != Keep::Always;
    if (!m_wrote && owes) { // as before, whatever its motor does
        (void)co_await m_around.journal->settle(*m_number).attempt();
    }
    if (!m_wrote)
        co_return {};
    if (m_plan.keep == Keep::Always && m_around.leftInForce)
        m_around.leftInForce(say("what was there is not known, and those that were tried are in force"));
    if (m_plan.keep == Keep::Always && !m_inForce)
        co_return {};
    if (m_plan.keep == Keep::Always || (m_plan.keep == Keep::WhenDone && m_trial.reason == EndReason::Done)) {
        co_await releaseKept();
        co_return {};
    }
    Result<void> written = fail(Fault::LinkLost, m_device.link().loss().message());
    if (m_device.link().state() == LinkState::Open && m_device.liveness().restarted) { // it may be another one
        written = fail(Fault::Unsafe, say("%1 has restarted, and nobody has looked at it since", m_device.selector()));
    } else if (m_device.link().state() == LinkState::Open && !m_stands) {
        written = fail(Fault::Unsafe, say("the motor was not seen to stand"));
    } else if (m_device.link().state() == LinkState::Open) {
        written = co_await writeGains(m_device, changesOf(m_device.family(), m_owed)).attempt();
    }
    if (!written) {
        m_trial.notPutBack = written.error().detail;
        if (m_around.leftInForce)
            m_around.leftInForce(m_trial.notPutBack);
        m_around.caution(
            say("the gains were not put back: %1; they are offered at the next connection", written.error().detail));
        co_return {};
    }
    (void)co_await markPutBack(m_device, *m_around.journal, *m_number).attempt();
    co_return {};
}

void ExperimentRun::classifyEnding(const std::optional<Error> &error)
{
    if (m_recorder.trip() && !m_trip)
        m_trip = m_recorder.trip();
    if (m_recorder.limitMet())
        m_trial.flags.emplace_back(flag::limitSwitch);
    if (m_trip && m_trip->guard == EndReason::NoMotion && m_recorder.limitMet())
        m_trip->detail = joined(m_trip->detail, Message::label(m_recorder.limitMet()->clause));
    Ending ending;
    ending.completed = m_motion.isCompleted();
    ending.trip = m_trip;
    if (m_moved) { // else it is of an experiment before
        ending.stream = m_stream.end();
        ending.streamReason = m_stream.reason();
        using End = SetPointStream::End;
        const Liveness &seen = m_device.liveness();
        if (error && ending.stream == End::None
            && (seen.foreignMaster || seen.restarted)) { // it came between two pushes
            ending.stream = seen.foreignMaster ? End::ForeignMaster : End::DeviceRestarted;
            ending.streamReason = error->detail;
        }
    }
    ending.interrupted = m_user.isRequested() || m_device.gate().isStopPressed();
    ending.linkOpen = m_device.link().state() == LinkState::Open;
    ending.error = error;
    nameEnding(m_trial, ending);
}

Task<void> ExperimentRun::conclude(std::optional<Error> error)
{
    if (m_stream.isRunning())
        m_stream.stop();
    m_recorder.unguard();
    classifyEnding(error);
    if (m_user.isRequested() || (m_stoppedForZero && !m_moved))
        m_device.stop(); // whoever calls for a stop is told whether the motor stands, whatever moved it
    if (hasResult()) {
        m_trial.stopped = co_await confirmStop(m_device);
        const bool rests = co_await untilAtRest(m_device, m_plan.axis);
        m_stands = rests && m_trial.stopped;
    }
    m_trial.samples = m_recorder.samples();
    m_trial.lost = m_recorder.lost();
    measure(m_trial, m_device.family(), m_recorder, m_motion.holds(), m_motion.returns());
    co_await putBack();
    auto lowering = m_rates.lower(m_around); // over a lost link too: the device owes it then
    co_await std::move(lowering);
    if (m_number) {
        const Result<void> completed = co_await m_around.journal->complete(*m_number, m_trial).attempt();
        if (!completed)
            note(say("this trial is kept without its result: %1", completed.error().detail));
        m_concluded = completed.has_value();
    }
    co_return {};
}

} // namespace mb::tuning
