// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/twopointidentification.h"

#include "experiment/envelope.h"
#include "experiment/figures.h"
#include "experiment/gains.h"
#include "model/family.h"
#include "model/loopparameters.h"
#include "tuning/aside.h"
#include "tuning/autotunerun.h"
#include "tuning/firstmotion.h"
#include "tuning/loopfit.h"
#include "tuning/rawstep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace mb::tuning {
namespace {

constexpr std::array<double, 3> moreForce{1.0, 2.5, 6.0}; ///< times P, until it moves
constexpr double roomShare = 0.6;                         ///< of the travel
constexpr double dampedLeast = 0.35;
constexpr double dampedMost = 1.4;
constexpr double moreDamping = 2.5;
constexpr int mostLooks = 5;
constexpr double secondsOfRound = 33.0; ///< s, that another round takes at most, and a proof
constexpr double swings = 12.0;         ///< of 1/(ζω) that a step is held
constexpr double trust = 2.0;           ///< times as quick as what was tried
constexpr double trustOfLaw = 4.0;      ///< the same where its firmware's law is known
constexpr double hiddenDrag = 3.0;      ///< times as long as was found, a lag of ways that were led
using Steps = TwoPointSteps;

std::string inWhole(double number)
{
    return numberText(std::round(number));
}

/// By a count at least, in the last experiment, which counted from where it stood.
bool hasMoved(const AutotuneRun &run)
{
    const auto position = axisChannel(run.device(), "position", run.plan().axis);
    const auto last = position ? run.device().telemetry()->latest(*position) : std::nullopt;
    return last && last->value != 0.0;
}

double roomOf(const AutotuneRun &run)
{
    return roomShare * run.envelope().travel.value_or(1e9);
}

/// A step with the gains that it has.
ExperimentPlan asItIs(const AutotuneRun &run, double counts, double seconds)
{
    ExperimentPlan plan;
    plan.mode = Mode::Position;
    plan.slot = run.plan().slot;
    plan.to = counts;
    plan.seconds = seconds;
    plan.intent = say("a step of %1 counts with the gains as they are", std::round(counts));
    return plan;
}

} // namespace

Task<void> TwoPointIdentification::identify(AutotuneRun &run)
{
    co_await look(run);
    if (run.isOver())
        co_return {};
    m_ground.room = roomOf(run);
    m_ground.envelope = run.envelope();
    m_steps = co_await Steps::chosenFrom(m_ground);
    if (m_steps.isLed)
        run.note(say(
            "a step would draw too much current: the unit's own profile leads, at %1 counts/s at most", m_steps.rate));
    for (bool again = true; again && !run.isOver();) {
        co_await settle(run);
        if (run.isOver())
            co_return {};
        co_await tryAll(run);
        if (run.isOver())
            co_return {};
        if (m_swung) // it is done again with less D
            continue;
        again = co_await conclude(run);
    }
    co_return {};
}

/// False where there is no room or no time.
bool TwoPointIdentification::enlarge(const AutotuneRun &run)
{
    if (run.left() < secondsOfRound || !m_steps.enlarge(m_ground))
        return false;
    run.note(say("what is left over is much of so small steps; the same with larger ones"));
    return true;
}

/// What it has, and which way it counts, before a gain is changed.
Task<void> TwoPointIdentification::look(AutotuneRun &run)
{
    const TunePlan &plan = run.plan();
    const auto gains = co_await readGains(run.device(), plan.loop, plan.axis, plan.slot);
    for (const auto &[key, value] : gains) {
        const Role role = roleOf(run.device().family(), key);
        if (role == Role::Proportional)
            m_ground.stored.p = value.value_or(0.0);
        if (role == Role::Derivative)
            m_ground.stored.d = value.value_or(0.0);
    }
    co_await run.readEnvelope();
    if (m_ground.stored.p < 1.0)
        co_return fail(Fault::Refused, say("the unit stores no P, so nothing moves it"),
            say("write a small gain.p once, with which it moves"));
    const RawLoop &raw = run.device().family().trials->raw;
    m_ground.isKnown = raw.dialects.find(run.device().identity().dialect) != std::string_view::npos;
    m_ground.full = raw.fullDuty;
    m_ground.cycle = raw.cycle;
    if (!m_ground.isKnown) {
        m_ground.moves = co_await findFirstMotion(run, m_ground.stored.p);
        co_return {};
    }
    co_await begin(run);
    co_return {};
}

/// A step with the gains as they are: the first closed loop of a run of the program checks the direction. Where friction holds
/// what they make of so little, firmer ones: P and what damps it.
Task<void> TwoPointIdentification::begin(AutotuneRun &run)
{
    const TrialTraits &traits = *run.device().family().trials;
    for (const double more : moreForce) {
        const RawGains point{std::round(more * m_ground.stored.p),
            std::round(
                std::clamp(std::sqrt(more) * m_ground.stored.d, 0.0, std::max(Steps::mostRaw, m_ground.stored.d)))};
        const bool tooMuch = point.p > Steps::mostRaw || point.p * traits.nudge > Steps::tried * m_ground.full;
        if (more > 1.0 && (tooMuch || !hasMoved(run))) // a dead sensor is not asked with more and more force
            break;
        run.forgive();
        const double step = std::round(std::max(Steps::tried * m_ground.full / point.p, Steps::leastRoom));
        auto running = run.run(more > 1.0 ? rawStep(run, point, std::min(step, roomOf(run)), m_seconds)
                                          : asItIs(run, std::min(step, roomOf(run)), m_seconds));
        (void)co_await std::move(running);
        if (run.report().stopReason != EndReason::NoMotion)
            break;
    }
    if (run.report().stopReason == EndReason::NoMotion)
        run.report().evidence
            = joined(run.report().evidence, say("where it is neither, its gain.p is too small for so short a way"));
    if (run.report().stopReason == EndReason::Oscillation)
        run.forgive(); // the gains that swing are what is to be replaced
    co_return {};
}

/// One trial with these gains; it is one of the runs unless the loop swung itself up.
Task<void> TwoPointIdentification::step(AutotuneRun &run, RawGains gains, double counts)
{
    ExperimentPlan plan = rawStep(run, gains, counts, m_seconds);
    leadByProfile(run, m_steps.rate, plan);
    Trial trial = co_await run.run(std::move(plan));
    m_swung = run.report().stopReason == EndReason::Oscillation;
    if (m_swung)
        run.forgive();
    if (run.report().stopReason == EndReason::NoMotion && hasGone(run)) {
        run.forgive();
        co_return fail(Fault::Refused, say("friction takes more than half of what P makes of a step"),
            say("allow more travel, duty or current"));
    }
    if (run.isOver() || m_swung)
        co_return {};
    for (LoopRun &seen : runsOf(trial, gains.p, gains.d, m_steps.rate))
        m_seen.steps.push_back(std::move(seen));
    m_trials.push_back(std::move(trial));
    co_return {};
}

/// Looks for a first point that neither swings nor creeps.
Task<void> TwoPointIdentification::settle(AutotuneRun &run)
{
    double most = m_steps.first.d; // of what swung
    double least = m_steps.first.d;
    bool more = true;
    for (int i = 0; i < mostLooks; ++i) {
        m_seen.steps.clear();
        m_trials.clear();
        if (m_steps.isLed)
            m_steps.rate = m_ground.profileRate(m_steps.first.d);
        co_await step(run, m_steps.first, m_steps.drive / m_steps.first.p);
        if (run.isOver())
            co_return {};
        if (m_swung) { // for lack of D, or by a rotor that is free in its play and that D drives to and fro
            most = std::min(more ? moreDamping * most : most, Steps::mostRaw / Steps::damper);
            least = std::max(more ? least : std::round(least / moreDamping), 1.0);
            m_steps.first.d = std::exchange(more, !more) ? most : least;
            continue;
        }
        const auto fit = m_seen.steps.empty() ? std::nullopt : fitStep(m_seen.steps.front());
        if (!fit) {
            run.end(EndReason::NoMotion, say("the motor did not follow a step: stalled, or the encoder is dead"));
            co_return {};
        }
        m_seconds = std::clamp(swings / (std::min(fit->zeta, 1.0) * fit->omega), 0.5, 1.5);
        const double held = std::abs(leftOf(m_seen.steps.front())) / m_steps.drive;
        if (m_steps.grow(m_ground, held))
            continue;
        const bool swinging = fit->zeta < dampedLeast && m_steps.first.d < Steps::mostRaw / Steps::damper;
        const bool creeping = !m_steps.isLed && fit->zeta > dampedMost && m_steps.first.d > 1.0;
        if (!swinging && !creeping)
            co_return {};
        m_steps.first.d = std::round(swinging ? std::min(moreDamping * m_steps.first.d, Steps::mostRaw / Steps::damper)
                                              : std::max(m_steps.first.d / moreDamping, 1.0));
    }
    co_return fail(Fault::Refused, say("no D was found with which a small P neither swings nor creeps"),
        say("see that nothing is loose, and write gains once with which it comes to rest"));
}

/// Less D, once: what its double makes of a count or of a rotor that is free in its play does not rest. False where that was tried.
bool TwoPointIdentification::calm()
{
    m_steps.first.d = std::max(std::round(m_steps.first.d / moreDamping), 1.0);
    return !std::exchange(m_calmed, true);
}

Task<void> TwoPointIdentification::tryAll(AutotuneRun &run)
{
    const RawGains second{std::round(Steps::firmer * m_steps.first.p), m_steps.first.d};
    const RawGains third{second.p, std::round(Steps::damper * m_steps.first.d)};
    struct Try {
        RawGains point;
        double share;
    };
    std::vector<Try> tries{{m_steps.first, -1.0}, {second, 1.0}, {second, -1.0}, {third, 1.0}, {third, -1.0}};
    if (!m_ground.isKnown)
        tries.push_back({third, 0.5}); // where the output is at its end, a smaller step is quicker
    tries.push_back({{m_steps.first.p, third.d}, 1.0});
    std::size_t before = 0;
    for (const Try &next : tries) {
        before = m_seen.steps.size();
        co_await step(run, next.point, next.share * m_steps.drive / next.point.p);
        if (run.isOver())
            co_return {};
        if (m_swung && (enlarge(run) || calm()))
            co_return {};
        if (m_swung)
            co_return fail(Fault::Refused,
                say("it swung itself up with P %1 and D %2", inWhole(next.point.p), inWhole(next.point.d)),
                say("see that nothing is loose; a stronger load than it was built for cannot be tuned"));
    }
    m_seen.creeping.assign(m_seen.steps.begin() + static_cast<std::ptrdiff_t>(before), m_seen.steps.end());
    m_seen.steps.resize(before);
    co_return {};
}

/// What one pass of its loop makes of raw gains: as its firmware has it, or as far as that can be told.
LoopLaw TwoPointIdentification::lawOf(const AutotuneRun &run, const TwoPointFit &linear) const
{
    const double full = m_ground.isKnown
        ? m_ground.full
        : std::min(m_steps.drive, Steps::trustedCounts * m_ground.stored.p) / Steps::tried;
    const double cycle = m_ground.cycle;
    const double firmest = Steps::damper * m_steps.first.d;
    const double strongest = m_ground.isKnown ? std::max(Steps::noiseShare * full, m_ground.stored.d)
        : m_steps.isLed                       ? firmest
                                              : std::min(Steps::noiseShare * full, trust * firmest);
    const double quickest
        = 1.0 / ((m_ground.isKnown ? trustOfLaw : trust) * std::sqrt(linear.p * Steps::firmer * m_steps.first.p));
    const double i = m_ground.isKnown ? 1.0 / (full * run.device().family().trials->raw.integral * cycle) : 0.0;
    return {{1.0 / full, m_ground.isKnown || m_steps.isLed ? cycle / full : linear.d / (linear.p * full), cycle,
                strongest, quickest, i, m_steps.rate},
        m_ground.isKnown};
}

/// Takes what the steps have told; true where larger ones are to tell it first.
Task<bool> TwoPointIdentification::conclude(AutotuneRun &run)
{
    const auto linear = co_await fitTwoPoint(m_seen.steps);
    LoopLaw law = lawOf(run, linear);
    auto fitting = aside<LoopFit>(
        run.device(), [runs = m_seen.all(), law, first = linear] { return fitLoop(runs, law, first); });
    const LoopFit fit = co_await std::move(fitting);
    if (isDoubtful(fit) && enlarge(run))
        co_return true;
    law.scale.d = fit.d;
    if (m_steps.isLed) // what the linear fit says of runs with a profile is no more than where to begin
        law.scale.quickest
            = 1.0 / (trust * std::sqrt(fit.plant.gain / fit.plant.tau * law.scale.p * Steps::firmer * m_steps.first.p));
    PlantModel plant = fit.plant;
    if (m_steps.isLed) { // friction hides what else brakes so short ways: no margin is built on it
        plant.tau *= hiddenDrag;
        plant.gain *= hiddenDrag;
    }
    plant.delay = cyclesOfDelay * law.scale.cycle + fit.winding;
    if (run.envelope().current && m_ground.moves.current > 0.0) {
        plant.stallCurrent = m_ground.moves.current / law.scale.p;
        plant.backDuty = 1.0 / plant.gain;
    }
    const auto taken
        = run.take({motorOf(fit, law), plant, m_seen.gates(fit, m_steps.drive, m_ground.isKnown), law.scale});
    if (!taken)
        co_return fail(taken.error());
    co_return false;
}

MotorFound TwoPointIdentification::motorOf(const LoopFit &fit, const LoopLaw &law) const
{
    MotorFound found;
    found.line.gain = fit.plant.gain;
    found.line.gainError = fit.gainError;
    found.line.friction = m_seen.holding() * law.scale.p;
    found.pushes.tau = fit.plant.tau;
    found.pushes.tauError = fit.tauError;
    found.pushes.delay = fit.shift;
    found.pushes.delayError = fit.shiftError;
    found.pushes.cost = fit.residual;
    found.braking = fit.plant.braking;
    found.unit
        = m_ground.isKnown ? "counts/s per duty" : "counts/s per " + inWhole(1.0 / law.scale.p) + " of P × counts";
    return found;
}

} // namespace mb::tuning
