// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/pushidentification.h"

#include "experiment/figures.h"
#include "model/family.h"
#include "tuning/autotunerun.h"
#include "tuning/currentidentification.h"
#include "tuning/proof.h"
#include "tuning/relayidentification.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr std::array<double, 3> probes{0.15, 0.25, 0.4}; ///< duty
constexpr double probeSeconds = 0.6;  ///< longer than a motor may stand before it is taken for stalled
constexpr double probeReach = 0.3;    ///< of the travel
constexpr double strongest = 0.4;     ///< duty of the pushes
constexpr double overBreakaway = 2.5; ///< times what moved the motor
constexpr double weaker = 0.6;        ///< of the strongest
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

} // namespace

Task<void> PushIdentification::identify(AutotuneRun &run)
{
    auto probing = probe(run);
    co_await std::move(probing);
    if (run.isOver())
        co_return {};
    if (m_isNarrow) {
        run.note(say("there is no room for pushes that last"));
        RelayIdentification relay;
        auto swinging = relay.identify(run, m_probed);
        co_await std::move(swinging);
        co_return {};
    }
    auto pushing = push(run);
    co_await std::move(pushing);
    if (run.isOver())
        co_return {};
    co_return conclude(run);
}

/// Pushes that grow until the motor turns.
Task<void> PushIdentification::probe(AutotuneRun &run)
{
    Trial trial;
    double most = std::min(probes.back(), run.plan().limits.duty.value_or(1.0));
    for (const double duty : probes) {
        m_probed = std::min(duty, most);
        auto pushing = run.push({m_probed, probeSeconds, 1, reachOf(run)});
        trial = co_await std::move(pushing);
        most = std::min(most, trial.envelope.duty.value_or(1.0));
        const bool stuck
            = run.report().stopReason == toString(Guard::NoMotion) || (!run.isOver() && pushesOf(trial).empty());
        if (!stuck)
            break;
        if (duty >= most) {
            run.end(toString(Guard::NoMotion),
                say("the motor did not turn at up to %1 duty: stalled, or the encoder is dead", percentText(most)));
            break;
        }
        run.forgive();
    }
    if (run.isOver())
        co_return {};
    auto measuring = measureOut(run, std::move(trial));
    co_await std::move(measuring);
    if (m_duty >= leastPush || m_seconds <= longestPush)
        co_return checkRoom(run);
    auto again = run.push({m_probed, probeSeconds, 1, reachOf(run)}); // a lag without end is that of a lost order
    trial = co_await std::move(again);
    if (run.isOver())
        co_return {};
    if (!pushesOf(trial).empty()) {
        auto measuringAgain = measureOut(run, std::move(trial));
        co_await std::move(measuringAgain);
    }
    co_return checkRoom(run);
}

/// How strong and how long the others are.
Task<void> PushIdentification::measureOut(AutotuneRun &run, Trial trial)
{
    const std::vector<PushRecord> seen = pushesOf(trial);
    const auto fit = fitPushes(seen);
    if (!fit)
        co_return fail(fit.error());
    auto reading = run.readEnvelope(); // anew: some devices get a limit with their first motion
    co_await std::move(reading);
    const Envelope &envelope = run.envelope();
    const double gain = speedReserve * std::abs(fit->speeds.front() / seen.front().duty); // counts/s per duty, at most
    m_duty = std::min(std::max(strongest, overBreakaway * seen.front().duty), nearlyFull * envelope.duty.value_or(1.0));
    run.expect(mostOfFriction * std::abs(fit->speeds.front() / seen.front().duty));
    if (envelope.speed)
        m_duty = std::min(m_duty, usableShare * *envelope.speed / gain);
    const double period = std::max(samplePeriod(seen.front().position), 1e-3);
    m_seconds = std::min(std::max({taus * fit->tau, samplesOfPush * period, probeSeconds}), longestPush);
    if (envelope.travel) {
        const double room = usableShare * *envelope.travel / (pushRepeats * 1.25); // it rolls on while it brakes
        const double shortest = std::max(leastTaus * fit->tau, samplesOfPush * period);
        m_seconds = std::max(std::min(room / (gain * m_duty), m_seconds), shortest); // a slow motor takes its time
        m_duty = std::min(m_duty, room / (gain * m_seconds));
    }
    co_return {};
}

/// A position loop can do without pushes that last.
Result<void> PushIdentification::checkRoom(const AutotuneRun &run)
{
    m_isNarrow = m_duty < leastPush && run.plan().loop == Mode::Position;
    if (m_duty < leastPush && !m_isNarrow)
        return fail(Fault::OutOfRange,
            say("there is not enough room to identify the motor: its limits leave pushes of %1 duty only",
                percentText(m_duty)),
            say("allow more travel or speed"));
    return {};
}

/// Of two sizes, both ways.
Task<void> PushIdentification::push(AutotuneRun &run)
{
    for (const double size : {m_duty, weaker * m_duty}) {
        for (const double sign : {1.0, -1.0}) {
            auto pushing = run.push({sign * size, m_seconds, pushRepeats});
            m_pushes.push_back(co_await std::move(pushing));
            if (run.isOver())
                co_return {};
        }
    }
    co_return {};
}

Result<void> PushIdentification::conclude(AutotuneRun &run) const
{
    auto found = tuning::identify(m_pushes);
    if (!found)
        return fail(found.error());
    const LoopScale &scale = *run.device().family().loop;
    const double loop = scale.cycle;
    const double waited = scale.dutyAtOnce ? 0.0 : orderWaits * loop;
    const double own
        = m_pushes.front().signal("duty") ? electrical : 0.0; // of the motor, that the wait taken off may have been
    const double delay = std::max(found->pushes.delay - waited, own) + loopDelays * loop;
    PlantModel plant{found->line.gain, found->pushes.tau, delay, found->line.friction, found->braking};
    plant.sag = found->pushes.sag;
    plant.warming = found->pushes.warming;
    if (const auto ohm = drawnBy(m_pushes)) {
        plant.stallCurrent = ohm->gain;
        plant.backDuty = ohm->back;
    }
    if (run.plan().loop == Mode::Velocity) {
        const double speed = proofStep(Mode::Velocity, plant, {}, run.envelope());
        plant.delay += velocityTaking(run.device(), speed, found->filter).delay;
    }
    auto gates = gatesOf(*found, m_pushes);
    return run.take({std::move(*found), plant, std::move(gates), std::nullopt});
}

} // namespace mb::tuning
