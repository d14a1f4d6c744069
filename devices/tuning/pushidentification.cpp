// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/pushidentification.h"

#include "experiment/figures.h"
#include "model/family.h"
#include "transport/canlink.h"
#include "tuning/autotunerun.h"
#include "tuning/currentidentification.h"
#include "tuning/frictionramp.h"
#include "tuning/proof.h"
#include "tuning/relayidentification.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr std::array<double, 3> probes{0.15, 0.25, 0.4}; ///< duty
constexpr double probeSeconds = 0.6; ///< longer than a motor may stand before it is taken for stalled
constexpr double probeReach = 0.3;   ///< of the travel
constexpr double firstTouch = 0.03;  ///< duty, where only so much speed is allowed
constexpr double touchSeconds = 0.3;
constexpr double beatOfTouch = 0.05; ///< s, that the end of one may be off by
constexpr double harderTouch = 1.5;
constexpr double touchedShare = 0.5;    ///< of the speed that is allowed
constexpr double strongest = 0.4;       ///< duty of the pushes
constexpr double overBreakaway = 2.5;   ///< times what moved the motor
constexpr double weaker = 0.6;          ///< of the strongest,
constexpr double hardlyWeaker = 0.9;    ///< or up to so much
constexpr double freeOfFriction = 0.65; ///< share of a push that friction may take
constexpr double leastPush = 0.1;
constexpr double taus = 5.0; ///< that a push lasts
constexpr double leastTaus = 2.5;
constexpr double samplesOfPush = 12.0; ///< of a push
constexpr double longestPush = 3.0;    ///< s
constexpr double usableShare = 0.75;   ///< of a limit of the envelope
constexpr double nearlyFull = 0.96;    ///< of the duty limit
constexpr double speedReserve = 1.3;   ///< friction takes a smaller share of a stronger push
constexpr double mostOfFriction
    = 2.0; ///< friction of half the probe: a stronger push is not twice as quick for its duty
constexpr int pushRepeats = 2;
constexpr double loopDelays = 1.5;        ///< periods of the device's loop
constexpr double orderWaits = 0.5;        ///< of them, until an order is looked at
constexpr double electrical = 0.5e-3;     ///< s, L/R while nobody knows it
constexpr double mostCurrentDoubt = 0.15; ///< of what the motor draws at standstill

/// Of a push, where travel is given: what it does beyond is not known yet.
std::optional<double> reachOf(const AutotuneRun &run)
{
    const auto &travel = run.plan().limits.travel;
    return travel ? std::optional(probeReach * *travel) : std::nullopt;
}

/// What the motor draws; nothing where its current is not told in ampere, or not well enough.
std::optional<Ohm> drawnBy(const std::vector<Trial> &pushes)
{
    const Signal *const current = pushes.empty() ? nullptr : pushes.front().signal("current");
    if (!current || current->unit != "A")
        return std::nullopt;
    const auto ohm = fitOhm(pushes);
    return ohm && ohm->gainError <= mostCurrentDoubt * ohm->gain ? std::optional(*ohm) : std::nullopt;
}

/// s, that an order and the position which shows it are on their way: a frame of eight bytes each. Neither is a delay of the loop.
double onTheWire(const Device &device)
{
    const auto *const can = dynamic_cast<const CanLink *>(&device.link());
    if (!can || can->bitrate() <= 0)
        return 0.0;
    const CanFrame shortest // that no bit is stuffed into
        = extendedFrame(0x0AAAAAAA, {0x55, 0x55, 0x55, 0x55, 0x55, 0x55, 0x55, 0x55});
    return 2.0 * bitsOnWire(shortest) / can->bitrate();
}

/// A first touch was ended before its time.
bool wasCut(const Trial &trial)
{
    return !trial.holds.empty() && trial.holds.front().to - trial.holds.front().from < touchSeconds - beatOfTouch;
}

/// How its loop takes a velocity is designed on: asked for where nobody has yet.
Task<void> askForEdges(Device &device)
{
    const auto index = findParameter(device.family().parameters, device.family().loop->velocityEdges);
    if (!index || device.parameters().entry(*index).raw)
        co_return {};
    co_await device.read(*index);
    co_return {};
}

} // namespace

Task<void> PushIdentification::identify(AutotuneRun &run)
{
    co_await run.readEnvelope();
    co_await probe(run);
    if (run.isOver())
        co_return {};
    if (m_isNarrow) {
        run.note(say("there is no room for pushes that last"));
        RelayIdentification relay;
        co_await relay.identify(run, m_probed);
        co_return {};
    }
    co_await push(run);
    if (run.isOver())
        co_return {};
    co_await askForEdges(run.device());
    auto found = co_await tuning::identify(m_pushes, run.device().family().loop->cycle);
    FrictionRamp ramp(m_duty, m_held);
    co_await ramp.run(run, found);
    if (run.isOver())
        co_return {};
    co_return conclude(run, std::move(found));
}

/// Pushes that grow until the motor turns.
Task<void> PushIdentification::probe(AutotuneRun &run)
{
    if (const auto &speed = run.plan().limits.speed) {
        co_await feelSpeed(run, *speed);
        if (run.isOver())
            co_return {};
    }
    Trial trial;
    double most = std::min({probes.back(), run.envelope().duty.value_or(1.0), m_careful});
    for (const double duty : probes) {
        m_probed = std::min(duty, most);
        auto pushing = run.push({m_probed, probeSeconds, 1, reachOf(run)});
        trial = co_await std::move(pushing);
        most = std::min(most, trial.envelope.duty.value_or(1.0));
        const bool stuck = run.report().stopReason == EndReason::NoMotion || (!run.isOver() && pushesOf(trial).empty());
        if (!stuck)
            break;
        if (duty >= most) {
            run.end(EndReason::NoMotion,
                joined(
                    say("the motor did not turn at up to %1 duty: stalled, or the encoder is dead", percentText(most)),
                    trial.has(flag::limitSwitch) ? say("a limit switch was met") : Message()));
            break;
        }
        m_held = m_probed;
        run.forgive();
    }
    if (run.isOver())
        co_return {};
    co_await measureOut(run, std::move(trial));
    if (m_duty >= leastDuty() || m_seconds <= longestPush)
        co_return checkRoom(run);
    auto again = run.push({m_probed, probeSeconds, 1, reachOf(run)}); // a lag without end is that of a lost order
    trial = co_await std::move(again);
    if (run.isOver())
        co_return {};
    if (!pushesOf(trial).empty())
        co_await measureOut(run, std::move(trial));
    co_return checkRoom(run);
}

/// Nobody knows how quick it is: pushes of little duty that grow, each ended at half of the speed that is allowed, until the first probe is
/// known to stay below that.
Task<void> PushIdentification::feelSpeed(AutotuneRun &run, double allowed)
{
    const double most = std::min(probes.front(), run.envelope().duty.value_or(1.0));
    for (double duty = firstTouch; duty < most; duty *= harderTouch) {
        auto touching = run.push({duty, touchSeconds, 1, reachOf(run), {}, touchedShare * allowed});
        const Trial trial = co_await std::move(touching);
        const bool tooQuick = run.report().stopReason == EndReason::Speed;
        if (run.isOver() && !tooQuick)
            co_return {};
        const std::vector<PushRecord> seen = pushesOf(trial);
        const auto fit = fitPushes(seen);
        if (tooQuick || (fit ? std::abs(fit->speeds.front()) > usableShare * allowed : wasCut(trial)))
            co_return fail(Fault::OutOfRange,
                say("%1 duty makes the motor quicker than %2 counts/s, which are allowed", percentText(duty), allowed),
                say("allow more speed"));
        if (!fit)
            continue; // it stands, or hardly moves
        const double gain = mostOfFriction * std::abs(fit->speeds.front()) / duty;
        run.expect(gain);
        m_careful = std::max(duty, touchedShare * allowed / gain);
        if (m_careful >= most || gain * harderTouch * duty > touchedShare * allowed)
            break;
    }
    co_return {};
}

/// How strong and how long the others are.
Task<void> PushIdentification::measureOut(AutotuneRun &run, Trial trial)
{
    const std::vector<PushRecord> seen = pushesOf(trial);
    const auto fit = co_await fitPushes(seen);
    auto reading = run.readEnvelope(); // anew: some devices get a limit with their first motion
    co_await std::move(reading);
    const Envelope &envelope = run.envelope();
    m_speed = std::abs(fit.speeds.front());
    const double gain = speedReserve * m_speed / std::abs(seen.front().duty); // counts/s per duty, at most
    m_duty = std::min(std::max(strongest, overBreakaway * seen.front().duty), nearlyFull * envelope.duty.value_or(1.0));
    run.expect(mostOfFriction * m_speed / std::abs(seen.front().duty));
    if (envelope.speed)
        m_duty = std::min(m_duty, usableShare * *envelope.speed / gain);
    const double period = std::max(samplePeriod(seen.front().position), 1e-3);
    m_seconds = std::min(std::max({taus * fit.tau, samplesOfPush * period, probeSeconds}), longestPush);
    if (envelope.travel) {
        const double room = usableShare * *envelope.travel / (pushRepeats * 1.25); // it rolls on while it brakes
        const double shortest = std::max(leastTaus * fit.tau, samplesOfPush * period);
        m_seconds = std::max(std::min(room / (gain * m_duty), m_seconds), shortest); // a slow motor takes its time
        m_duty = std::min(m_duty, room / (gain * m_seconds));
    }
    co_return {};
}

/// Of pushes that tell something: what has moved it does, as far as a limit of duty leaves it.
double PushIdentification::leastDuty() const
{
    return std::min(leastPush, nearlyFull * m_probed);
}

/// A position loop can do without pushes that last.
Result<void> PushIdentification::checkRoom(const AutotuneRun &run)
{
    const bool isWeak = m_duty < leastDuty();
    m_isNarrow = isWeak && run.plan().loop == Mode::Position;
    if (isWeak && !m_isNarrow)
        return fail(Fault::OutOfRange,
            say("there is not enough room to identify the motor: its limits leave pushes of %1 duty only",
                percentText(m_duty)),
            say("allow more travel or speed"));
    return {};
}

/// Of two sizes, both ways; first back from where the probe has gone, where travel is short.
Task<void> PushIdentification::push(AutotuneRun &run)
{
    const double first = run.plan().limits.travel ? -1.0 : 1.0;
    for (const bool strong : {true, false}) {
        const double size = strong ? m_duty : weakerDuty();
        for (const double sign : {first, -first}) {
            auto pushing = run.push({sign * size, m_seconds, pushRepeats});
            m_pushes.push_back(co_await std::move(pushing));
            if (run.isOver())
                co_return {};
        }
    }
    co_return {};
}

/// Where friction takes much of what may push, the two sizes lie closer together: both must overcome it.
double PushIdentification::weakerDuty() const
{
    const std::vector<PushRecord> seen = pushesOf(m_pushes.front());
    const auto fit = fitPushes(seen);
    if (!fit || m_duty <= m_probed || std::abs(fit->speeds.front()) <= m_speed)
        return weaker * m_duty;
    const double gain = (std::abs(fit->speeds.front()) - m_speed) / (m_duty - m_probed);
    const double friction = m_probed - m_speed / gain;
    return std::clamp(friction / freeOfFriction, weaker * m_duty, hardlyWeaker * m_duty);
}

Result<void> PushIdentification::conclude(AutotuneRun &run, MotorFound found) const
{
    const LoopScale &scale = *run.device().family().loop;
    const double loop = scale.cycle;
    const double waited = scale.dutyAtOnce ? 0.0 : orderWaits * loop;
    const double own
        = m_pushes.front().signal("duty") ? electrical : 0.0; // of the motor, that the wait taken off may have been
    const double delay = std::max(found.pushes.delay - waited - onTheWire(run.device()), own) + loopDelays * loop;
    PlantModel plant{found.line.gain, found.pushes.tau, delay, found.line.friction, found.braking};
    plant.sag = found.pushes.sag;
    plant.warming = found.pushes.warming;
    if (found.ramp && found.ramp->agreesWith(found.line.gain))
        plant.breakaway = std::max(found.ramp->forward.breakaway + found.ramp->forward.breakawayError,
            found.ramp->reverse.breakaway + found.ramp->reverse.breakawayError);
    if (const auto ohm = drawnBy(m_pushes)) {
        plant.stallCurrent = ohm->gain;
        plant.backDuty = ohm->back;
    }
    if (run.plan().loop == Mode::Velocity) {
        const double speed = proofStep(Mode::Velocity, plant, {}, run.envelope());
        plant.delay += velocityTaking(run.device(), speed, found.filter).delay;
    }
    auto gates = gatesOf(found, m_pushes);
    if (auto ramped = rampGate(found))
        gates.push_back(std::move(*ramped));
    return run.take({std::move(found), plant, std::move(gates), std::nullopt});
}

} // namespace mb::tuning
