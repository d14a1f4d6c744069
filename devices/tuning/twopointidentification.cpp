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
#include <limits>
#include <utility>

namespace mb::tuning {
namespace {

constexpr double firmer = 2.5;                            ///< P of the second point, of the first
constexpr double damper = 2.0;                            ///< D of the third
constexpr double tried = 0.5;                             ///< of full output that P makes of each step
constexpr double smallestStep = 60.0;                     ///< of the smallest step
constexpr double trustedCounts = 200.0;                   ///< of it where nobody knows what full output is
constexpr std::array<double, 3> moreForce{1.0, 2.5, 6.0}; ///< times P, until it moves
constexpr double leastRoom = 20.0;                        ///< counts
constexpr double roomShare = 0.6;                         ///< of the travel
constexpr double dampedLeast = 0.35;
constexpr double dampedMost = 1.4;
constexpr double moreDamping = 2.5;
constexpr int mostLooks = 5;
constexpr double larger = 4.0;          ///< times, of steps that play spoils
constexpr double fewestP = 10.0;        ///< raw
constexpr double secondsOfRound = 33.0; ///< s, that another round takes at most, and a proof
constexpr double swings = 12.0;         ///< of 1/(ζω) that a step is held
constexpr double fewestDamping = 8.0;   ///< D for 1 of P, where the unit has none
constexpr double mostRaw = 30000.0;
constexpr double mostResidual = 0.08;    ///< of a step
constexpr double mostUncertainty = 0.3;  ///< of what D does
constexpr double mostFriction = 0.6;     ///< of what P makes of a step
constexpr double mostLoad = 0.1;         ///< of it
constexpr double earlierWhenSmall = 0.8; ///< of the time that a larger step takes to its middle
constexpr double trust = 2.0;            ///< times as quick as what was tried
constexpr double trustOfLaw = 4.0;       ///< the same where its firmware's law is known
constexpr double noiseShare = 0.1;       ///< of full output that one count may make through D
constexpr double heldMore = 1.15;        ///< times what was seen, that friction may hold
constexpr double easyFriction = 0.15;    ///< of what P makes of a step
constexpr double mostGrowth = 2.5;       ///< of steps whose output is not known, where friction takes more of them
constexpr double shareOfCurrent = 0.7;   ///< of its limit, that P makes a step draw
constexpr double breakawayOver = 1.4;    ///< times friction, of what was seen to move it
constexpr double easilyDrawn = 0.6;      ///< of what its current allows, from which on it is led
constexpr double gentlestP = 12.0;       ///< raw, that its steps are still fine enough of
constexpr double gentleCounts = 2000.0;  ///< of a step that is led
constexpr double hiddenDrag = 3.0;       ///< times as long as was found, a lag of ways that were led
constexpr double fastestProfile = 1e6;   ///< counts/s
constexpr double rateShare = 0.8;        ///< of its current limit, that D makes of a profile that begins

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
    run.note(say("a step of %1 counts with the gains as they are", std::round(counts)));
    return plan;
}

/// Share, of what a D makes the motor do.
double doubtOf(const LoopFit &fit)
{
    return std::hypot(fit.pushError, fit.dError / fit.d);
}

} // namespace

Task<void> TwoPointIdentification::identify(AutotuneRun &run)
{
    auto looking = look(run);
    co_await std::move(looking);
    if (run.isOver())
        co_return {};
    if (auto chosen = choose(run); !chosen)
        co_return fail(chosen.error());
    for (bool again = true; again && !run.isOver();) {
        auto settling = settle(run);
        co_await std::move(settling);
        if (run.isOver())
            co_return {};
        auto trying = tryAll(run);
        co_await std::move(trying);
        if (run.isOver())
            co_return {};
        if (m_swung) // it is done again with less D
            continue;
        auto concluding = conclude(run);
        again = co_await std::move(concluding);
    }
    co_return {};
}

/// Counts of a step, in which play and whole counts are less of it: the same output of a weaker P. False where there is no room or no time.
bool TwoPointIdentification::enlarge(const AutotuneRun &run)
{
    const double weaker = std::round(m_first.p / larger);
    const bool fits = weaker >= fewestP && m_drive / weaker <= roomOf(run) && run.left() >= secondsOfRound;
    if (std::exchange(m_enlarged, true) || !fits)
        return false;
    m_first = {weaker, std::max(std::round(m_first.d / std::sqrt(larger)), 1.0)};
    run.note(say("what is left over is much of so small steps; the same with larger ones"));
    return true;
}

/// What it has, and which way it counts, before a gain is changed.
Task<void> TwoPointIdentification::look(AutotuneRun &run)
{
    const TunePlan &plan = run.plan();
    auto reading = readGains(run.device(), plan.loop, plan.axis, plan.slot);
    const auto gains = co_await std::move(reading);
    for (const auto &[key, value] : gains) {
        const Role role = roleOf(run.device().family(), key);
        if (role == Role::Proportional)
            m_stored.p = value.value_or(0.0);
        if (role == Role::Derivative)
            m_stored.d = value.value_or(0.0);
    }
    auto bounding = run.readEnvelope();
    co_await std::move(bounding);
    if (m_stored.p < 1.0)
        co_return fail(Fault::Refused, say("the unit stores no P, so nothing moves it"),
            say("write a small gain.p once, with which it moves"));
    const RawLoop &raw = run.device().family().trials->raw;
    m_known = raw.dialects.find(run.device().identity().dialect) != std::string_view::npos;
    m_full = raw.fullDuty;
    if (!m_known) {
        auto moving = findFirstMotion(run, m_stored.p);
        m_moves = co_await std::move(moving);
        co_return {};
    }
    auto beginning = begin(run);
    co_await std::move(beginning);
    co_return {};
}

/// A step with the gains as they are: the first closed loop of a run of the program checks the direction. Where friction holds
/// what they make of so little, firmer ones: P and what damps it.
Task<void> TwoPointIdentification::begin(AutotuneRun &run)
{
    const TrialTraits &traits = *run.device().family().trials;
    for (const double more : moreForce) {
        const RawGains point{std::round(more * m_stored.p),
            std::round(std::clamp(std::sqrt(more) * m_stored.d, 0.0, std::max(mostRaw, m_stored.d)))};
        const bool tooMuch = point.p > mostRaw || point.p * traits.nudge > tried * m_full;
        if (more > 1.0 && (tooMuch || !hasMoved(run))) // a dead sensor is not asked with more and more force
            break;
        run.forgive();
        const double step = std::round(std::max(tried * m_full / point.p, leastRoom));
        auto running = run.run(more > 1.0 ? rawStep(run, point, std::min(step, roomOf(run)), m_seconds)
                                          : asItIs(run, std::min(step, roomOf(run)), m_seconds));
        (void)co_await std::move(running);
        if (run.report().stopReason != toString(Guard::NoMotion))
            break;
    }
    if (run.report().stopReason == toString(Guard::NoMotion))
        run.report().evidence
            = joined(run.report().evidence, say("where it is neither, its gain.p is too small for so short a way"));
    if (run.report().stopReason == toString(Guard::Oscillation))
        run.forgive(); // the gains that swing are what is to be replaced
    co_return {};
}

/// Raw P times counts that its current allows.
double TwoPointIdentification::mostDrive(const AutotuneRun &run) const
{
    const auto most = run.envelope().current;
    return most && m_moves.current > 0.0 ? shareOfCurrent * *most / m_moves.current
                                         : std::numeric_limits<double>::infinity();
}

Result<void> TwoPointIdentification::choose(const AutotuneRun &run)
{
    const double room = roomOf(run);
    if (m_known) {
        m_drive = tried * m_full * run.envelope().duty.value_or(1.0);
        const double step = std::min(firmer * smallestStep, room);
        m_first.p = std::clamp(std::round(std::min(m_drive / step, m_stored.p)), 1.0, mostRaw / firmer);
        m_first.d = m_stored.d * std::sqrt(m_first.p / m_stored.p);
    } else {
        m_first.p = std::max(std::round(m_stored.p / firmer), 1.0);
        m_first.d = m_stored.d / damper;
        m_drive = firmer * m_first.p * trustedCounts;
        if (m_drive >= easilyDrawn * mostDrive(run))
            return chooseGentle(run);
        const double clear = m_moves.push / breakawayOver / easyFriction;
        m_grown = clear > m_drive;
        m_drive = std::min(std::clamp(clear, m_drive, mostGrowth * m_drive), mostDrive(run));
    }
    m_drive = std::min(m_drive, m_first.p * room);
    if (m_drive < firmer * m_first.p * leastRoom)
        return fail(Fault::OutOfRange,
            say("there is not enough room: its limits leave steps of %1 counts",
                inWhole(m_drive / (firmer * m_first.p))),
            say("allow more travel"));
    const double least = m_stored.d > 0.0 ? 1.0 : fewestDamping * m_first.p;
    m_first.d = std::round(std::clamp(m_first.d, least, mostRaw / damper));
    return {};
}

/// A motor that draws more than it may long before its output is at its end: P makes less than that of its steps, D less than a tenth of
/// it of a count, and a profile leads to their ends, for of the edge of a step D makes more than P.
Result<void> TwoPointIdentification::chooseGentle(const AutotuneRun &run)
{
    const double room = roomOf(run);
    const double counts = std::min({gentleCounts, room, mostDrive(run) / gentlestP});
    m_first.p = std::clamp(std::round(mostDrive(run) / counts), 1.0, m_stored.p);
    m_drive = std::min(mostDrive(run), m_first.p * room);
    if (const double friction = m_moves.push / breakawayOver; friction > mostFriction * m_drive)
        return fail(Fault::OutOfRange,
            say("friction takes %1 of what its current limit and its room allow, at most 60 %",
                percentText(friction / m_drive)),
            say("see whether the motor is too strong for this unit"));
    const double likely = 0.5 * m_stored.d * std::sqrt(m_first.p / m_stored.p);
    const double strongest = noiseShare * *run.envelope().current / m_moves.current;
    m_first.d = std::round(std::clamp(std::min(likely, strongest / damper), 1.0, mostRaw / damper));
    m_isLed = true;
    chooseRate(run);
    run.note(say("a step would draw too much current: the unit's own profile leads, at %1 counts/s at most", m_rate));
    return {};
}

/// With which what D makes of a profile that begins draws less than the limit.
void TwoPointIdentification::chooseRate(const AutotuneRun &run)
{
    if (!m_isLed)
        return;
    const double cycle = run.device().family().trials->raw.cycle;
    const double drawn = m_moves.current * damper * m_first.d * cycle; // A for 1 count/s
    m_rate = std::round(
        std::min(rateShare * *run.envelope().current / drawn, run.envelope().speed.value_or(fastestProfile)));
}

/// One trial with these gains; it is one of the runs unless the loop swung itself up.
Task<void> TwoPointIdentification::step(AutotuneRun &run, RawGains gains, double counts)
{
    ExperimentPlan plan = rawStep(run, gains, counts, m_seconds);
    leadByProfile(run, m_rate, plan);
    auto running = run.run(std::move(plan));
    Trial trial = co_await std::move(running);
    m_swung = run.report().stopReason == toString(Guard::Oscillation);
    if (m_swung)
        run.forgive();
    if (run.report().stopReason == toString(Guard::NoMotion) && hasGone(run)) {
        run.forgive();
        co_return fail(Fault::Refused, say("friction takes more than half of what P makes of a step"),
            say("allow more travel, duty or current"));
    }
    if (run.isOver() || m_swung)
        co_return {};
    for (LoopRun &seen : runsOf(trial, gains.p, gains.d, m_rate))
        m_runs.push_back(std::move(seen));
    m_trials.push_back(std::move(trial));
    co_return {};
}

/// Looks for a first point that neither swings nor creeps.
Task<void> TwoPointIdentification::settle(AutotuneRun &run)
{
    double most = m_first.d; // of what swung
    double least = m_first.d;
    bool more = true;
    for (int i = 0; i < mostLooks; ++i) {
        m_runs.clear();
        m_trials.clear();
        chooseRate(run);
        auto stepping = step(run, m_first, m_drive / m_first.p);
        co_await std::move(stepping);
        if (run.isOver())
            co_return {};
        if (m_swung) { // for lack of D, or by a rotor that is free in its play and that D drives to and fro
            most = std::min(more ? moreDamping * most : most, mostRaw / damper);
            least = std::max(more ? least : std::round(least / moreDamping), 1.0);
            m_first.d = std::exchange(more, !more) ? most : least;
            continue;
        }
        const auto fit = m_runs.empty() ? std::nullopt : fitStep(m_runs.front());
        if (!fit) {
            run.end(toString(Guard::NoMotion), say("the motor did not follow a step: stalled, or the encoder is dead"));
            co_return {};
        }
        m_seconds = std::clamp(swings / (std::min(fit->zeta, 1.0) * fit->omega), 0.5, 1.5);
        const double held = std::abs(leftOf(m_runs.front())) / m_drive;
        if (!m_known && !m_grown && held > easyFriction) {
            m_drive = std::min(
                {m_drive * std::min(held / easyFriction, mostGrowth), m_first.p * roomOf(run), mostDrive(run)});
            m_grown = true;
            continue;
        }
        const bool swinging = fit->zeta < dampedLeast && m_first.d < mostRaw / damper;
        const bool creeping = !m_isLed && fit->zeta > dampedMost && m_first.d > 1.0;
        if (!swinging && !creeping)
            co_return {};
        m_first.d = std::round(
            swinging ? std::min(moreDamping * m_first.d, mostRaw / damper) : std::max(m_first.d / moreDamping, 1.0));
    }
    co_return fail(Fault::Refused, say("no D was found with which a small P neither swings nor creeps"),
        say("see that nothing is loose, and write gains once with which it comes to rest"));
}

/// Less D, once: what its double makes of a count or of a rotor that is free in its play does not rest. False where that was tried.
bool TwoPointIdentification::calm()
{
    m_first.d = std::max(std::round(m_first.d / moreDamping), 1.0);
    return !std::exchange(m_calmed, true);
}

Task<void> TwoPointIdentification::tryAll(AutotuneRun &run)
{
    const RawGains second{std::round(firmer * m_first.p), m_first.d};
    const RawGains third{second.p, std::round(damper * m_first.d)};
    struct Try {
        RawGains point;
        double share;
    };
    std::vector<Try> tries{{m_first, -1.0}, {second, 1.0}, {second, -1.0}, {third, 1.0}, {third, -1.0}};
    if (!m_known)
        tries.push_back({third, 0.5}); // where the output is at its end, a smaller step is quicker
    tries.push_back({{m_first.p, third.d}, 1.0});
    std::size_t before = 0;
    for (const Try &next : tries) {
        before = m_runs.size();
        auto stepping = step(run, next.point, next.share * m_drive / next.point.p);
        co_await std::move(stepping);
        if (run.isOver())
            co_return {};
        if (m_swung && (enlarge(run) || calm()))
            co_return {};
        if (m_swung)
            co_return fail(Fault::Refused,
                say("it swung itself up with P %1 and D %2", inWhole(next.point.p), inWhole(next.point.d)),
                say("see that nothing is loose; a stronger load than it was built for cannot be tuned"));
    }
    m_creeping.assign(m_runs.begin() + static_cast<std::ptrdiff_t>(before), m_runs.end());
    m_runs.resize(before);
    co_return {};
}

/// Friction makes a smaller step later on its way; only an output that is at its end makes it earlier.
bool TwoPointIdentification::isLinear() const
{
    std::vector<double> small;
    std::vector<double> large;
    for (const LoopRun &run : m_runs) {
        if (run.p == m_runs.back().p && run.d == m_runs.back().d)
            (std::abs(run.step) * run.p < 0.75 * m_drive ? small : large).push_back(halfWay(run));
    }
    return m_known || small.empty() || large.empty() || median(small) >= earlierWhenSmall * median(large);
}

std::vector<Gate> TwoPointIdentification::gatesOf(const LoopFit &fit) const
{
    const double friction = holding();
    double load = 0.0;
    for (const LoopRun &one : m_runs)
        load += leftOf(one) / static_cast<double>(m_runs.size());
    load = std::abs(load);
    const bool linear = isLinear();
    const double doubt = doubtOf(fit);
    return {{"fit", say("what is left over is %1 of the steps, at most 8 %", percentText(fit.residual)),
                fit.residual <= mostResidual, say("see that nothing is loose and that steps look alike")},
        {"damping", say("what D does is known within %1, at most 30 %", percentText(doubt)), doubt <= mostUncertainty,
            say("write a larger gain.d once, with which it still comes to rest")},
        {"friction", say("friction takes %1 of what P makes of a step, at most 60 %", percentText(friction / m_drive)),
            friction <= mostFriction * m_drive, say("allow more travel or duty")},
        {"asymmetric load", say("a load takes %1 of what P makes of a step, at most 10 %", percentText(load / m_drive)),
            load <= mostLoad * m_drive, say("see whether a load always pulls one way")},
        {"output", linear ? say("no step met the end of the output") : say("the steps met the end of the output"),
            linear, say("write a smaller gain.p once")}};
}

/// What holds its motor, P times counts: it rests anywhere up to that, and within a count.
double TwoPointIdentification::holding() const
{
    double friction = 0.0;
    for (const auto *const runs : {&m_runs, &m_creeping}) {
        for (const LoopRun &one : *runs)
            friction = std::max(friction, heldMore * (std::abs(leftOf(one)) + one.p));
    }
    return friction;
}

/// What one pass of its loop makes of raw gains: as its firmware has it, or as far as that can be told.
LoopLaw TwoPointIdentification::lawOf(const AutotuneRun &run, const TwoPointFit &linear) const
{
    const double full = m_known ? m_full : std::min(m_drive, trustedCounts * m_stored.p) / tried;
    const double cycle = run.device().family().trials->raw.cycle;
    const double firmest = damper * m_first.d;
    const double strongest = m_known ? std::max(noiseShare * full, m_stored.d)
        : m_isLed                    ? firmest
                                     : std::min(noiseShare * full, trust * firmest);
    const double quickest = 1.0 / ((m_known ? trustOfLaw : trust) * std::sqrt(linear.p * firmer * m_first.p));
    const double i = m_known ? 1.0 / (full * run.device().family().trials->raw.integral * cycle) : 0.0;
    return {{1.0 / full, m_known || m_isLed ? cycle / full : linear.d / (linear.p * full), cycle, strongest, quickest,
                i, m_rate},
        m_known};
}

/// Takes what the steps have told; true where larger ones are to tell it first.
Task<bool> TwoPointIdentification::conclude(AutotuneRun &run)
{
    const auto linear = fitTwoPoint(m_runs);
    if (!linear)
        co_return fail(linear.error());
    LoopLaw law = lawOf(run, *linear);
    std::vector<LoopRun> runs = m_runs;
    runs.insert(runs.end(), m_creeping.begin(), m_creeping.end());
    auto fitting = aside<LoopFit>(run.device(), [runs, law, first = *linear] { return fitLoop(runs, law, first); });
    const LoopFit fit = co_await std::move(fitting);
    if ((fit.residual > mostResidual || doubtOf(fit) > mostUncertainty) && enlarge(run))
        co_return true;
    law.scale.d = fit.d;
    if (m_isLed) // what the linear fit says of runs with a profile is no more than where to begin
        law.scale.quickest
            = 1.0 / (trust * std::sqrt(fit.plant.gain / fit.plant.tau * law.scale.p * firmer * m_first.p));
    PlantModel plant = fit.plant;
    if (m_isLed) { // friction hides what else brakes so short ways: no margin is built on it
        plant.tau *= hiddenDrag;
        plant.gain *= hiddenDrag;
    }
    plant.delay = cyclesOfDelay * law.scale.cycle + fit.winding;
    if (run.envelope().current && m_moves.current > 0.0) {
        plant.stallCurrent = m_moves.current / law.scale.p;
        plant.backDuty = 1.0 / plant.gain;
    }
    const auto taken = run.take({motorOf(fit, law), plant, gatesOf(fit), law.scale});
    if (!taken)
        co_return fail(taken.error());
    co_return false;
}

MotorFound TwoPointIdentification::motorOf(const LoopFit &fit, const LoopLaw &law) const
{
    MotorFound found;
    found.line.gain = fit.plant.gain;
    found.line.gainError = fit.gainError;
    found.line.friction = holding() * law.scale.p;
    found.pushes.tau = fit.plant.tau;
    found.pushes.tauError = fit.tauError;
    found.pushes.delay = fit.shift;
    found.pushes.delayError = fit.shiftError;
    found.pushes.cost = fit.residual;
    found.braking = fit.plant.braking;
    found.unit = m_known ? "counts/s per duty" : "counts/s per " + inWhole(1.0 / law.scale.p) + " of P × counts";
    return found;
}

} // namespace mb::tuning
