// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/autotunerun.h"

#include "model/family.h"
#include "tuning/envelope.h"
#include "tuning/figures.h"
#include "tuning/gains.h"
#include "tuning/proof.h"
#include "tuning/seconds.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr std::array<double, 3> probes{0.15, 0.25, 0.4}; ///< duty
constexpr double probeSeconds = 0.6;
constexpr double strongest = 0.4; ///< duty of the pushes
constexpr double weaker = 0.6;    ///< of the strongest
constexpr double leastPush = 0.1;
constexpr double taus = 8.0; ///< that a push lasts
constexpr double leastTaus = 2.5;
constexpr double leastSamples = 12.0; ///< of a push
constexpr double longestPush = 3.0;   ///< s
constexpr double usableShare = 0.75;  ///< of a limit of the envelope
constexpr double nearlyFull = 0.96;   ///< of the duty limit
constexpr double speedReserve = 1.3;  ///< friction takes a smaller share of a stronger push
constexpr int pushRepeats = 2;
constexpr int proofRepeats = 2;
constexpr double proofSettles = 4.0;  ///< predicted times to settle that a proof holds its step
constexpr double notableRest = 0.02;  ///< of the step
constexpr double integralShare = 0.1; ///< weight of the integral where friction must be overcome by it
constexpr double usualMs = 1.6;       ///< largest sensitivity, of the model
constexpr double usualMsOff = 1.9;    ///< and of a motor that is not quite as it says
constexpr double briskMs = 1.7;
constexpr double briskMsOff = 2.3;
constexpr double loopDelays = 1.5; ///< periods of the device's loop

std::string whole(double number)
{
    return numberText(std::round(number));
}

} // namespace

AutotuneRun::AutotuneRun(Device &device, SetPointStream &stream, TunePlan plan, ExperimentSurroundings surroundings)
    : m_device(device)
    , m_stream(stream)
    , m_plan(std::move(plan))
    , m_around(std::move(surroundings))
{
    m_report.device = device.selector();
    m_report.simulated = device.link().address().isSimulated();
    m_report.loop = m_plan.loop;
    m_report.axis = m_plan.axis;
    m_report.slot = m_plan.slot;
    m_provingSlot = device.family().capabilities.gainSlots > 1 ? 1 - m_plan.slot : m_plan.slot;
}

void AutotuneRun::note(const std::string &text) const
{
    if (m_around.note)
        m_around.note(text);
}

/// One experiment; what ended it, if it was not its own end, ends the tuning. Travel is counted from where the tuning began.
Task<Trial> AutotuneRun::run(ExperimentPlan plan)
{
    plan.axis = m_plan.axis;
    plan.limits = m_plan.limits;
    if (plan.limits.travel)
        *plan.limits.travel = std::max(*plan.limits.travel - std::abs(m_here - m_start), 0.0);
    auto running = runExperiment(m_device, m_stream, plan, m_around);
    Trial trial = co_await std::move(running);
    m_moved = true;
    if (trial.number)
        m_report.trials.push_back(*trial.number);
    if (const Signal *const position = trial.signal("position"); position && !position->trace.isEmpty()) {
        if (m_pushes.empty() && m_start == 0.0)
            m_start = position->trace.y.front();
        m_here = position->trace.y.back();
    }
    m_report.stopped = trial.stopped || m_device.isSeenStopped();
    if (trial.reason.empty())
        co_return fail(Fault::Refused, trial.detail);
    if (trial.reason != "done") {
        m_report.stopReason = trial.reason;
        m_report.evidence = trial.detail;
    }
    co_return trial;
}

Task<Trial> AutotuneRun::pushOnce(Push push)
{
    ExperimentPlan plan;
    plan.mode = Mode::Duty;
    plan.slot = m_plan.slot;
    plan.to = push.duty;
    plan.seconds = push.seconds;
    plan.repeat = push.repeat;
    note("pushing with " + percentText(push.duty) + " duty for " + numberText(std::round(push.seconds * 100.0) / 100.0)
        + " s" + (push.repeat > 1 ? ", " + std::to_string(push.repeat) + " times" : std::string()));
    return run(std::move(plan));
}

Task<void> AutotuneRun::probe()
{
    Trial trial;
    double most = std::min(probes.back(), m_plan.limits.duty.value_or(1.0));
    for (const double duty : probes) {
        auto pushing = pushOnce({std::min(duty, most), probeSeconds, 1});
        trial = co_await std::move(pushing);
        most = std::min(most, trial.envelope.duty.value_or(1.0));
        const bool stuck = m_report.stopReason == toString(Guard::NoMotion) || (!isOver() && pushesOf(trial).empty());
        if (!stuck)
            break;
        if (duty >= most) {
            m_report.stopReason = toString(Guard::NoMotion);
            m_report.evidence
                = "the motor did not turn at up to " + percentText(most) + " duty: stalled, or the encoder is dead";
            break;
        }
        m_report.stopReason.clear();
    }
    if (isOver())
        co_return {};
    const std::vector<PushRecord> seen = pushesOf(trial);
    const auto fit = fitPushes(seen);
    if (!fit)
        co_return fail(fit.error());
    auto reading = readEnvelope(); // anew: some devices get a limit with their first motion
    co_await std::move(reading);
    const Envelope &envelope = m_envelope;
    const double gain = speedReserve * std::abs(fit->speeds.front() / seen.front().duty); // counts/s per duty, at most
    m_duty = std::min(strongest, nearlyFull * envelope.duty.value_or(1.0));
    if (envelope.speed)
        m_duty = std::min(m_duty, usableShare * *envelope.speed / gain);
    const double period = std::max(samplePeriod(seen.front().position), 1e-3);
    m_seconds = std::min(std::max(taus * fit->tau, leastSamples * period), longestPush);
    if (envelope.travel) {
        const double room = usableShare * *envelope.travel / (pushRepeats * 1.25); // it rolls on while it brakes
        const double shortest = std::max(leastTaus * fit->tau, leastSamples * period);
        m_seconds = std::max(std::min(room / (gain * m_duty), m_seconds), shortest); // a slow motor takes its time
        m_duty = std::min(m_duty, room / (gain * m_seconds));
    }
    if (m_duty < leastPush)
        co_return fail(Fault::OutOfRange,
            "there is not enough room to identify the motor: its limits leave pushes of " + percentText(m_duty)
                + " duty only",
            "allow more travel or speed");
    co_return {};
}

Task<void> AutotuneRun::push()
{
    for (const double size : {m_duty, weaker * m_duty}) {
        for (const double sign : {1.0, -1.0}) {
            auto pushing = pushOnce({sign * size, m_seconds, pushRepeats});
            m_pushes.push_back(co_await std::move(pushing));
            if (isOver())
                co_return {};
        }
    }
    co_return {};
}

Result<void> AutotuneRun::identifyMotor()
{
    auto found = identify(m_pushes);
    if (!found)
        return fail(found.error());
    m_report.gates = judge(*found, m_pushes);
    m_report.motor = std::move(*found);
    const MotorFound &motor = *m_report.motor;
    const double loop = m_device.family().loop->cycle;
    m_report.plant = {motor.line.gain, motor.pushes.tau, motor.pushes.delay + loopDelays * loop, motor.line.friction};
    if (m_plan.loop == Mode::Velocity && motor.filter)
        m_report.plant.delay += motor.filter->delay;
    for (const Gate &gate : m_report.gates) {
        if (!gate.passed)
            return fail(Fault::Refused, "the model is not to be believed: " + gate.detail, gate.remedy);
    }
    return {};
}

Task<void> AutotuneRun::recall()
{
    m_report.plant = *m_plan.known;
    const auto position = axisChannel(m_device, "position", m_plan.axis);
    const auto last = position ? m_device.telemetry()->latest(*position) : std::nullopt;
    if (m_plan.loop == Mode::Position && !last)
        co_return fail(Fault::Timeout, m_device.selector() + " has not told where it stands", "wait until it is heard");
    m_start = m_here = last ? last->value : 0.0;
    auto reading = readEnvelope();
    co_await std::move(reading);
    co_return {};
}

/// From where the motor stands.
Task<void> AutotuneRun::readEnvelope()
{
    auto reading = readOwnLimits(m_device, m_plan.axis, m_plan.slot, m_here);
    const Envelope own = co_await std::move(reading);
    const auto resolved = resolve(m_device.family(), factsOf(m_device, m_plan.axis), m_plan.loop, m_plan.limits, own);
    if (!resolved)
        co_return fail(resolved.error());
    m_envelope = *resolved;
    co_return {};
}

/// The plan's own response and damping take the place of its aim's.
Result<Proposal> AutotuneRun::proposalFor(Aim aim) const
{
    const Family &family = m_device.family();
    const PlantModel &plant = m_report.plant;
    const bool asked = aim == m_plan.aim;
    const bool brisk = aim == Aim::Brisk && !(asked && m_plan.ms);
    const double ms = (asked ? m_plan.ms : std::nullopt).value_or(brisk ? briskMs : usualMs);
    const double response = (asked ? m_plan.response : std::nullopt).value_or(responseOf(m_plan.loop, aim, plant));
    LoopBounds bounds;
    bounds.period = family.loop->cycle;
    if (m_plan.loop == Mode::Position && !hasFrictionHelp(family))
        bounds.integralWeight = integralShare;
    Proposal proposal;
    proposal.aim = aim;
    proposal.design
        = design(m_plan.loop, plant, response, bounds, ms, ms * (brisk ? briskMsOff / briskMs : usualMsOff / usualMs));
    auto scaled = scaleGains(m_device, m_plan.loop, m_plan.axis, m_plan.slot, proposal.design.gains);
    if (!scaled)
        return fail(scaled.error());
    proposal.gains = std::move(*scaled);
    if (m_plan.loop == Mode::Position)
        addFrictionHelp(family, m_plan.axis, m_plan.slot, plant, proposal.gains);
    const ContinuousGains &gains = proposal.gains.made;
    proposal.margins = marginsOf(m_plan.loop, plant, gains);
    proposal.step = proofStep(m_plan.loop, plant, gains, m_envelope);
    const double seconds = 1.0 + 10.0 * (plant.tau + plant.delay);
    proposal.predicted = predictStep(m_plan.loop, plant, gains, 0.0, proposal.step, seconds,
        m_envelope.duty.value_or(1.0), std::clamp(family.loop->cycle, 1e-4, 0.02));
    return proposal;
}

Result<void> AutotuneRun::propose()
{
    for (const Aim aim : {Aim::Calm, Aim::Normal, Aim::Brisk}) {
        auto proposal = proposalFor(aim);
        if (!proposal && aim == m_plan.aim)
            return fail(proposal.error());
        if (!proposal)
            continue;
        if (aim == m_plan.aim) {
            m_report.design = proposal->design;
            m_report.proposed = proposal->gains;
            m_report.margins = proposal->margins;
            m_report.predicted = proposal->predicted;
            m_step = proposal->step;
        }
        m_report.proposals.push_back(std::move(*proposal));
    }
    return {};
}

/// The proposal as changes of the slot that it is proven in, with everything else of the slot that it is for.
std::vector<ParameterChange> AutotuneRun::inProvingSlot() const
{
    if (m_provingSlot == m_plan.slot)
        return m_report.proposed.changes;
    const Family &family = m_device.family();
    const LoopGains &loop = *loopOf(family, m_plan.loop);
    std::vector<ParameterChange> changes;
    for (const std::string_view name : loop.names) {
        const std::string pattern = std::string(loop.prefix) + std::string(name);
        const auto from = findParameter(family.parameters, gainKey(family, pattern, m_plan.axis, m_plan.slot));
        const auto into = findParameter(family.parameters, gainKey(family, pattern, m_plan.axis, m_provingSlot));
        if (!from || !into)
            continue;
        const auto &proposed = m_report.proposed.changes;
        const auto found = std::find_if(
            proposed.begin(), proposed.end(), [&from](const ParameterChange &change) { return change.index == *from; });
        if (found != proposed.end())
            changes.push_back({*into, found->raw});
        else if (const auto &entry = m_device.parameters().entry(*from); entry.raw)
            changes.push_back({*into, *entry.raw});
    }
    return changes;
}

Task<void> AutotuneRun::prove()
{
    auto reading = readGains(m_device, m_plan.loop, m_plan.axis, m_plan.slot);
    m_report.before = co_await std::move(reading);
    for (const double sign : {1.0, -1.0}) {
        ExperimentPlan plan;
        plan.mode = m_plan.loop;
        plan.slot = m_provingSlot;
        plan.repeat = proofRepeats;
        plan.seconds = std::clamp(proofSettles * m_report.predicted->metrics.settle.value_or(1.0), 0.8, 5.0);
        plan.gains = inProvingSlot();
        plan.keep = m_plan.keep && m_provingSlot == m_plan.slot ? Keep::Always : Keep::Never;
        plan.from = m_plan.loop == Mode::Position ? std::optional<double>() : 0.0;
        plan.to = sign * m_step + (m_plan.loop == Mode::Position ? m_here : 0.0);
        note("proving: a step of " + whole(sign * m_step) + (m_plan.loop == Mode::Position ? " counts" : " counts/s"));
        auto running = run(std::move(plan));
        m_report.proof.push_back(co_await std::move(running));
        if (isOver())
            co_return {};
    }
    m_report.measured = worseOf(m_report.proof);
    const std::string wrong = judgeProof(
        m_report.measured, m_report.predicted->metrics, m_step, deadband(m_report.plant, m_report.proposed.made));
    if (!wrong.empty()) {
        m_report.result = TuneResult::RolledBack;
        m_report.evidence = wrong;
    }
    co_return {};
}

Task<void> AutotuneRun::keep()
{
    auto writing = writeGains(m_device, m_report.proposed.changes);
    co_await std::move(writing);
    m_report.result = TuneResult::Kept;
    const Capabilities &can = m_device.family().capabilities;
    m_report.evidence = std::string("the steps in both directions did what was predicted; the gains were written")
        + (can.readback ? " and read back" : ", which this family cannot read back");
    const double resting = restingError(m_device.family(), m_report.plant, m_report.proposed.made);
    if (resting > notableRest * m_step)
        m_report.evidence
            += "; it may rest " + whole(resting) + " short of its target, less does not move its integral";
    if (can.storesAfter > std::chrono::seconds(0))
        m_report.evidence
            += "; the unit stores them by itself within " + std::to_string(can.storesAfter.count()) + " s";
    co_return {};
}

} // namespace mb::tuning
