// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/autotunerun.h"

#include "experiment/direction.h"
#include "experiment/envelope.h"
#include "experiment/figures.h"
#include "experiment/motiontimes.h"
#include "experiment/seconds.h"
#include "model/family.h"
#include "tuning/proof.h"

#include <algorithm>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr int mostRepeats = 4;       ///< of an experiment on a wire that loses frames
constexpr double wholeTime = 60.0;   ///< s: docs/tuning.md#how-well
constexpr double knownReserve = 1.3; ///< of a gain that was found: a battery may be fuller

} // namespace

AutotuneRun::AutotuneRun(Device &device, SetPointStream &stream, TunePlan plan, ExperimentSurroundings surroundings)
    : m_device(device)
    , m_stream(stream)
    , m_plan(std::move(plan))
    , m_around(std::move(surroundings))
    , m_user(m_around.interruption, stream)
    , m_begin(device.clock().now())
{
    m_around.start = m_plan.limits.travel ? &m_start : nullptr;
    m_around.leftInForce = [this](const Message &why) { m_report.notPutBack = why; };
    m_report.device = device.selector();
    m_report.simulated = device.link().address().isSimulated();
    m_report.loop = m_plan.loop;
    m_report.axis = m_plan.axis;
    m_report.slot = m_plan.slot;
}

void AutotuneRun::note(const Message &text) const
{
    if (m_around.note)
        m_around.note(text);
}

Task<void> AutotuneRun::keepBefore()
{
    if (const auto before = std::exchange(m_around.before, {}))
        co_await before();
    co_return {};
}

/// One experiment; what ended it, if it was not its own end, ends the tuning. Travel is counted from where the tuning began.
Task<Trial> AutotuneRun::runOnce(ExperimentPlan plan)
{
    plan.loop = m_plan.loop;
    plan.axis = m_plan.axis;
    plan.limits = m_plan.limits;
    plan.announced = m_gain;
    Trial trial = co_await runExperiment(m_device, m_stream, plan, m_around);
    m_around.before = {}; // it was called by the first that moved
    m_moved = true;
    if (!trial.envelope.current)
        m_plan.limits.current.reset(); // that nobody holds it was said
    if (trial.number)
        m_report.trials.push_back(*trial.number);
    if (const Signal *const position = trial.signal("position"); position && !position->trace.isEmpty())
        m_here = position->trace.y.back();
    m_report.stopped = trial.stopped || m_device.isSeenStopped();
    co_await judgeEnding(trial);
    co_return trial;
}

/// Nothing follows a trial that could not begin, whose motor may still turn, or whose gains are still in force.
Result<void> AutotuneRun::judgeEnding(const Trial &trial)
{
    if (trial.reason == EndReason::None)
        return fail(Fault::Refused, trial.detail);
    if (trial.reason != EndReason::Done) {
        m_report.stopReason = trial.reason;
        m_report.evidence = trial.detail;
    }
    if (!m_report.stopped && m_report.stopReason == EndReason::None && !m_device.liveness().heard) {
        m_report.stopReason = EndReason::Link;
        m_report.evidence = say("the device is not heard any more");
    }
    if (!m_report.stopped)
        return fail(Fault::Unsafe, joined(m_report.evidence, say("the stop was not confirmed by %1", m_report.device)));
    if (!trial.notPutBack.empty())
        return fail(
            Fault::Refused, joined(m_report.evidence, say("the gains were not put back: %1", trial.notPutBack)));
    return {};
}

/// A wire that loses a frame now and then ends an experiment by its guard now and then. That has stopped the motor; the same is tried
/// again, from where it stands, while the unit is heard and the minute has room for it; once where it was to be done twice.
Task<Trial> AutotuneRun::run(ExperimentPlan plan, double followed)
{
    for (int again = 0;; ++again) {
        const double before = m_here;
        Trial trial = co_await runOnce(plan);
        const bool lossy = trial.reason == EndReason::Link && m_report.stopped && m_device.liveness().heard;
        if (!lossy || again == mostRepeats)
            co_return trial;
        const int fewest = plan.mode == Mode::Current ? currentRepeats(0.0, 1.0) : 1; // fewer do not tell it from noise
        plan.repeat = std::max(plan.repeat / 2, std::min(plan.repeat, fewest));
        if (left() < longestSeconds(plan.seconds.value_or(0.0), plan.repeat) + followed) {
            m_report.evidence = joined(m_report.evidence, say("no time was left to do the same again"));
            co_return trial;
        }
        note(say("the wire lost too many frames; the same again"));
        forgive();
        if (plan.mode == Mode::Position && !m_device.family().capabilities.zeroPosition)
            plan.to += m_here - before;
    }
}

Task<Trial> AutotuneRun::push(Push push)
{
    ExperimentPlan plan;
    plan.mode = Mode::Duty;
    plan.slot = m_plan.slot;
    plan.to = push.duty;
    plan.seconds = push.seconds;
    plan.repeat = push.repeat;
    plan.reach = push.reach;
    plan.relay = push.relay;
    plan.fastest = push.fastest;
    if (push.grows) {
        plan.profile = Profile::Ramp;
        plan.turnsBack = true;
    }
    if (const double rate = m_device.family().trials->currentRate; m_plan.loop == Mode::Current && rate > 0.0)
        plan.rate = rate;
    const double seconds = std::round(push.seconds * 100.0) / 100.0;
    plan.intent = push.grows ? say("pushing with a duty that grows to %1 in %2 s", percentText(push.duty), seconds)
        : push.relay         ? say("swinging with %1 duty to and fro", percentText(push.duty))
        : push.repeat > 1 ? say("pushing with %1 duty for %2 s, %3 times", percentText(push.duty), seconds, push.repeat)
                          : say("pushing with %1 duty for %2 s", percentText(push.duty), seconds);
    return run(std::move(plan));
}

void AutotuneRun::end(EndReason reason, Message evidence)
{
    m_report.stopReason = reason;
    m_report.evidence = std::move(evidence);
}

void AutotuneRun::beginClock()
{
    m_begin = m_device.clock().now();
}

/// What the motor has gone since the tuning began is gone.
std::optional<double> AutotuneRun::travelLeft() const
{
    const auto &travel = m_plan.limits.travel;
    if (!travel || !m_start || !m_envelope.travel)
        return m_envelope.travel;
    return std::clamp(*travel - std::abs(m_here - *m_start), 0.0, *m_envelope.travel);
}

std::optional<double> AutotuneRun::room(double sign) const
{
    const auto &travel = m_plan.limits.travel;
    if (!travel || !m_start || !m_envelope.travel)
        return m_envelope.travel;
    return std::clamp(*travel - sign * (m_here - *m_start), 0.0, *m_envelope.travel);
}

double AutotuneRun::left() const
{
    return wholeTime - inSeconds(m_device.clock().now() - m_begin);
}

void AutotuneRun::expectOf(const PlantModel &plant, const std::optional<TriedScale> &scale)
{
    if (m_plan.loop != Mode::Current && !scale)
        m_gain = knownReserve * plant.gain;
    if (m_plan.loop != Mode::Current && m_around.directions)
        m_around.directions->setLag(m_device.selector(), m_plan.axis, plant.tau);
}

Result<void> AutotuneRun::take(Finding finding)
{
    m_report.motor = std::move(finding.motor);
    m_report.motor->plant = finding.plant;
    m_report.plant = finding.plant;
    m_report.gates = std::move(finding.gates);
    m_report.scale = finding.scale;
    expectOf(m_report.plant, m_report.scale);
    for (const Gate &gate : m_report.gates) {
        if (!gate.passed)
            return fail(Fault::Refused, say("the model is not to be believed: %1", gate.detail), gate.remedy);
    }
    return {};
}

Task<void> AutotuneRun::recall()
{
    m_report.plant = *m_plan.known;
    expectOf(*m_plan.known, m_plan.scale);
    m_report.scale = m_plan.scale;
    m_report.gates = m_plan.gates;
    m_report.motor = m_plan.motor;
    if (m_report.motor)
        m_report.motor->heat = 0.0; // of pushes that were long ago
    const auto position = axisChannel(m_device, "position", m_plan.axis);
    if (m_plan.loop == Mode::Position && !(position && m_device.telemetry()->latest(*position)))
        co_return fail(
            Fault::Timeout, say("%1 has not told where it stands", m_device.selector()), say("wait until it is heard"));
    lookWhere();
    co_await readEnvelope();
    co_return {};
}

void AutotuneRun::lookWhere()
{
    const auto position = axisChannel(m_device, "position", m_plan.axis);
    const auto last = position ? m_device.telemetry()->latest(*position) : std::nullopt;
    m_here = last ? last->value : 0.0;
    if (!m_start)
        m_start = m_here;
}

/// From where the motor stands.
Task<void> AutotuneRun::readEnvelope()
{
    const Envelope own = co_await readOwnLimits(m_device, m_plan.axis, m_plan.slot, m_here);
    m_envelope = co_await resolve(m_device.family(), factsOf(m_device, m_plan.axis), m_plan.loop, m_plan.limits, own);
    co_return {};
}

} // namespace mb::tuning
