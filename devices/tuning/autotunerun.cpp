// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/autotunerun.h"

#include "model/family.h"
#include "tuning/aside.h"
#include "tuning/envelope.h"
#include "tuning/figures.h"
#include "tuning/gains.h"
#include "tuning/proof.h"
#include "tuning/proposals.h"
#include "tuning/refinement.h"
#include "tuning/seconds.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr int proofRepeats = 2;
constexpr int currentRepeats = 6; ///< short ones: they take the noise out of each other
constexpr int mostRepeats = 4;    ///< of an experiment on a wire that loses frames
constexpr double proofSettles
    = 2.5; ///< predicted times to settle that a proof holds its step: twice may pass until it has settled
constexpr double proofCreeps = 2.0;    ///< times of the integral, in which it creeps to its target, at least
constexpr double slowProof = 1.2;      ///< s, that a slow one waits at most beyond what was predicted
constexpr double proofRest = 0.3;      ///< s longer
constexpr double leastProof = 0.7;     ///< s
constexpr double longestProof = 5.0;   ///< s
constexpr double unknownSettle = 1.5;  ///< s, where none was predicted
constexpr double currentSettles = 4.0; ///< of a current loop
constexpr double leastCurrent = 0.08;  ///< s that it is held
constexpr double longestCurrent = 0.2; ///< s
constexpr double notableRest = 0.02;   ///< of the step

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

void AutotuneRun::note(const Message &text) const
{
    if (m_around.note)
        m_around.note(text);
}

/// One experiment; what ended it, if it was not its own end, ends the tuning. Travel is counted from where the tuning began.
Task<Trial> AutotuneRun::runOnce(ExperimentPlan plan)
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
        const bool counted = plan.mode == Mode::Position && m_device.family().capabilities.zeroPosition;
        if (!std::exchange(m_placed, true) && !counted)
            m_start = position->trace.y.front();
        m_here = position->trace.y.back() + (counted ? m_here : 0.0); // each counts from its own start
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

/// A wire that loses a frame now and then ends an experiment by its guard now and then. That has stopped the motor; the same is tried
/// again, from where it stands, while the unit is heard.
Task<Trial> AutotuneRun::run(ExperimentPlan plan)
{
    for (int again = 0;; ++again) {
        const double before = m_here;
        auto running = runOnce(plan);
        Trial trial = co_await std::move(running);
        const bool lossy = trial.reason == toString(Guard::Link) && m_report.stopped && m_device.liveness().heard;
        if (!lossy || again == mostRepeats)
            co_return trial;
        note(say("the wire lost too many frames; the same again"));
        m_report.stopReason.clear();
        m_report.evidence = {};
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
    if (const double rate = m_device.family().trials->currentRate; m_plan.loop == Mode::Current && rate > 0.0)
        plan.rate = rate;
    const double seconds = std::round(push.seconds * 100.0) / 100.0;
    note(push.relay ? say("swinging with %1 duty to and fro", percentText(push.duty))
            : push.repeat > 1
            ? say("pushing with %1 duty for %2 s, %3 times", percentText(push.duty), seconds, push.repeat)
            : say("pushing with %1 duty for %2 s", percentText(push.duty), seconds));
    return run(std::move(plan));
}

void AutotuneRun::end(std::string_view reason, Message evidence)
{
    m_report.stopReason = reason;
    m_report.evidence = std::move(evidence);
}

Result<void> AutotuneRun::take(Finding finding)
{
    m_report.motor = std::move(finding.motor);
    m_report.plant = finding.plant;
    m_report.gates = std::move(finding.gates);
    m_report.scale = finding.scale;
    for (const Gate &gate : m_report.gates) {
        if (!gate.passed)
            return fail(Fault::Refused, say("the model is not to be believed: %1", gate.detail), gate.remedy);
    }
    return {};
}

Task<void> AutotuneRun::recall()
{
    m_report.plant = *m_plan.known;
    m_report.scale = m_plan.scale;
    const auto position = axisChannel(m_device, "position", m_plan.axis);
    if (m_plan.loop == Mode::Position && !(position && m_device.telemetry()->latest(*position)))
        co_return fail(
            Fault::Timeout, say("%1 has not told where it stands", m_device.selector()), say("wait until it is heard"));
    lookWhere();
    auto reading = readEnvelope();
    co_await std::move(reading);
    co_return {};
}

void AutotuneRun::lookWhere()
{
    const auto position = axisChannel(m_device, "position", m_plan.axis);
    const auto last = position ? m_device.telemetry()->latest(*position) : std::nullopt;
    const bool counted = m_device.family().capabilities.zeroPosition; // each experiment from its own start
    m_here = last && !counted ? last->value : 0.0;
    if (!std::exchange(m_placed, true))
        m_start = m_here;
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

ProposalBasis AutotuneRun::basis() const
{
    return {m_device.family(), m_device.profile(), m_plan.loop, m_plan.axis, m_plan.slot, m_report.plant, m_envelope,
        m_report.scale, m_report.taking};
}

/// The plan's own response and damping take the place of its aim's.
ProposalWish AutotuneRun::wishFor(Aim aim) const
{
    const bool asked = aim == m_plan.aim;
    return {aim, asked ? m_plan.response : std::nullopt, asked ? m_plan.ms : std::nullopt};
}

VelocityTaking AutotuneRun::taking() const
{
    if (m_plan.loop != Mode::Velocity || m_report.scale)
        return {};
    if (m_plan.known && m_plan.taking != VelocityTaking())
        return m_plan.taking;
    const double speed = proofStep(Mode::Velocity, m_report.plant, {}, m_envelope);
    return velocityTaking(m_device, speed, m_report.motor ? m_report.motor->filter : std::nullopt);
}

/// The error that the proof may end with, in the unit of the loop.
double AutotuneRun::resting() const
{
    if (m_plan.loop == Mode::Current)
        return droopOf(m_report.proof, m_report.plant, m_report.proposed.made);
    if (m_report.scale)
        return deadband(m_report.plant, m_report.proposed.made);
    return restingError(m_device.family(), m_plan.loop, m_report.plant, m_report.proposed.made, proofSeconds());
}

double AutotuneRun::proofSeconds() const
{
    const double settle = m_report.predicted->metrics.settle.value_or(unknownSettle);
    if (m_plan.loop == Mode::Current)
        return std::clamp(currentSettles * settle, leastCurrent, longestCurrent);
    const ContinuousGains &gains = m_report.proposed.made;
    const double creeps = m_plan.loop == Mode::Velocity && gains.i > 0.0 ? gains.p / gains.i : 0.0;
    return std::clamp(std::max(std::min(proofSettles * settle, settle + slowProof), proofCreeps * creeps) + proofRest,
        leastProof, longestProof);
}

Task<void> AutotuneRun::propose()
{
    m_report.taking = taking();
    std::vector<ProposalWish> wishes;
    for (const Aim aim : {Aim::Calm, Aim::Normal, Aim::Brisk})
        wishes.push_back(wishFor(aim));
    auto designing = designed(m_device, basis(), wishes);
    std::vector<Result<Proposal>> proposals = co_await std::move(designing);
    for (std::size_t i = 0; i < wishes.size(); ++i) {
        auto &proposal = proposals.at(i);
        const bool asked = wishes[i].aim == m_plan.aim;
        if (!proposal && asked)
            co_return fail(proposal.error());
        if (!proposal)
            continue;
        if (asked)
            choose(*proposal);
        m_report.proposals.push_back(std::move(*proposal));
    }
    co_return {};
}

void AutotuneRun::choose(const Proposal &proposal)
{
    m_report.design = proposal.design;
    m_report.proposed = proposal.gains;
    m_report.margins = proposal.margins;
    m_report.predicted = proposal.predicted;
    m_step = proposal.step;
}

Task<bool> AutotuneRun::reconsider()
{
    if (m_plan.response || m_plan.ms)
        co_return false;
    const Message why = m_report.evidence;
    const std::string_view aim = toString(m_plan.aim);
    if (!std::exchange(m_refined, true)) {
        auto refining = refine();
        if (co_await std::move(refining)) {
            m_quicker = say("the %1 gains of the first model did not: %2", Message::label(aim), why);
            note(joined(m_quicker, say("now those of the model as that step has corrected it")));
            beginAnew();
            co_return true;
        }
    }
    const auto calm = std::find_if(m_report.proposals.begin(), m_report.proposals.end(),
        [](const Proposal &proposal) { return proposal.aim == Aim::Calm; });
    if (m_plan.aim == Aim::Calm || calm == m_report.proposals.end())
        co_return false;
    m_quicker = say("the %1 gains did not: %2", Message::label(aim), why);
    note(joined(m_quicker, say("now the calm ones")));
    m_plan.aim = Aim::Calm;
    m_isCalmed = true;
    choose(*calm);
    beginAnew();
    co_return true;
}

void AutotuneRun::beginAnew()
{
    m_report.result = TuneResult::Refused;
    m_report.evidence = {};
    m_report.proof.clear();
}

/// A model that explains the steps that were just seen, and new gains on it; false where the steps do not tell one.
Task<bool> AutotuneRun::refine()
{
    if (m_report.scale || m_plan.loop == Mode::Current)
        co_return false;
    const SteppedLoop stepped{m_report.proposed.made, m_report.predicted->shape, m_report.proof};
    auto working = aside<std::optional<PlantModel>>(m_device,
        [stepped, plant = m_report.plant]() -> Result<std::optional<PlantModel>> { return refinedBy(stepped, plant); });
    const auto plant = co_await std::move(working);
    if (!plant)
        co_return false;
    const PlantModel first = std::exchange(m_report.plant, *plant);
    const std::vector<Proposal> proposals = std::exchange(m_report.proposals, {});
    auto proposing = propose();
    const Result<void> proposed = co_await std::move(proposing).attempt();
    if (!proposed) {
        m_report.plant = first;
        m_report.proposals = proposals;
        co_return false;
    }
    co_return true;
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

double AutotuneRun::proofTarget(double sign) const
{
    const bool counted = m_device.family().capabilities.zeroPosition; // each experiment from its own start
    return sign * m_step + (m_plan.loop == Mode::Position && !counted ? m_here : 0.0);
}

Task<void> AutotuneRun::prove()
{
    if (m_quicker.empty()) { // else they are known, and those that did not hold may be in force
        auto reading = readGains(m_device, m_plan.loop, m_plan.axis, m_plan.slot);
        m_report.before = co_await std::move(reading);
    }
    const bool unknown = std::any_of(
        m_report.before.begin(), m_report.before.end(), [](const auto &gain) { return !gain.second.has_value(); });
    const bool mayStay = m_plan.keep && unknown && m_provingSlot == m_plan.slot; // else they are put back
    for (const double sign : {1.0, -1.0}) {
        ExperimentPlan plan;
        plan.mode = m_plan.loop;
        plan.slot = m_provingSlot;
        plan.repeat = m_plan.loop == Mode::Current ? currentRepeats : proofRepeats;
        plan.seconds = proofSeconds();
        plan.gains = inProvingSlot();
        plan.keep = mayStay ? Keep::Always : Keep::Never;
        plan.from = m_plan.loop == Mode::Position ? std::optional<double>() : 0.0;
        plan.to = proofTarget(sign);
        const double step = sign * m_step;
        note(m_plan.loop == Mode::Current       ? say("proving: a step of %1 A", std::round(step * 100.0) / 100.0)
                : m_plan.loop == Mode::Position ? say("proving: a step of %1 counts", std::round(step))
                                                : say("proving: a step of %1 counts/s", std::round(step)));
        auto running = run(std::move(plan));
        m_report.proof.push_back(co_await std::move(running));
        if (isOver())
            co_return {};
        m_report.measured = worseOf(m_report.proof);
        const Message wrong = judgeProof(m_report.measured, m_report.predicted->metrics, m_step, resting());
        if (!wrong.empty()) { // what fails one way needs no proof the other way
            m_report.result = TuneResult::RolledBack;
            m_report.evidence = joined(wrong, m_quicker);
            co_return {};
        }
    }
    co_return {};
}

Task<void> AutotuneRun::keep()
{
    auto writing = writeGains(m_device, m_report.proposed.changes);
    co_await std::move(writing);
    m_report.result = TuneResult::Kept;
    const Capabilities &can = m_device.family().capabilities;
    m_report.evidence = can.readback
        ? say("the steps in both directions did what was predicted; the gains were written and read back")
        : say("the steps in both directions did what was predicted; the gains were written, which this family cannot "
              "read "
              "back");
    if (!m_quicker.empty())
        m_report.evidence = joined(m_report.evidence,
            m_isCalmed ? say("these are the calm gains, %1", m_quicker)
                       : say("their model was corrected by a step, %1", m_quicker));
    if (const double rests = resting(); rests > notableRest * m_step)
        m_report.evidence = joined(m_report.evidence,
            m_report.scale ? say("it may rest %1 short of its target, less does not move its motor", std::round(rests))
                : m_plan.loop == Mode::Current
                ? say("its current stays %1 A behind while the motor speeds up", std::round(rests * 100.0) / 100.0)
                : say("it may rest %1 short of its target, less does not move its integral", std::round(rests)));
    if (std::any_of(m_report.proof.begin(), m_report.proof.end(),
            [](const Trial &trial) { return trial.has(flag::restartNeeded); }))
        m_report.evidence = joined(m_report.evidence, say("a part of them is in force after a restart only"));
    if (can.storesAfter > std::chrono::seconds(0))
        m_report.evidence
            = joined(m_report.evidence, say("the unit stores them by itself within %1 s", can.storesAfter.count()));
    co_return {};
}

} // namespace mb::tuning
