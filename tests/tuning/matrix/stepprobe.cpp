// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/tuning/matrix/stepprobe.h"

#include "experiment/envelope.h"
#include "experiment/experiment.h"
#include "experiment/gains.h"
#include "model/family.h"
#include "tests/tuning/matrix/groundtruth.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mb::test {
namespace {

using namespace std::chrono_literals;

constexpr Duration look = 1ms;
constexpr Duration lookAtCurrent = 250us;
constexpr double passesOfStart = 2.0; ///< until a profile is as fast as it will be
constexpr double restShare = 2e-3;    ///< of the step, in a tenth of a second
constexpr int mostWaits = 100;
constexpr double band = 0.05;
constexpr double longRest = 2.0; ///< s
constexpr double stableBand = 0.3;
constexpr Duration longestBeat = 501ms;
constexpr double goodEnough = 4.0; ///< counts beside a target that nobody asks to be mended

/// s between two steps, at least. A QuadQuad2Drv takes a motor for moving until it has waited 0.67 s for its next edge, and its integral
/// with it: it creeps back before it rests.
double restOf(const Cell &cell)
{
    return cell.family == "quadquad2drv" && cell.loop == Mode::Velocity ? longRest : 0.0;
}

double fractionOf(double value)
{
    return value - std::floor(value);
}

/// Of the integrals, with the worse of all else: another run of the same.
void add(ShaftResponse &all, const ShaftResponse &run)
{
    all.itae += run.itae;
    all.overshoot = std::max(all.overshoot, run.overshoot);
    all.settle = std::max(all.settle, run.settle);
    all.peakCurrent = std::max(all.peakCurrent, run.peakCurrent);
    all.isStable = all.isStable && run.isStable;
}

} // namespace

std::vector<StepPhase> stepPhases(int count, int first)
{
    constexpr double byCount = 0.7548776662466927; // powers of the root of x³ = x + 1
    constexpr double byTime = byCount * byCount;
    std::vector<StepPhase> phases;
    for (int i = first; i < first + count; ++i)
        phases.push_back({fractionOf(0.5 + i * byCount), fractionOf(0.5 + i * byTime)});
    return phases;
}

StepProbe::StepProbe(const Cell &cell, const ProbedStep &step)
    : m_cell(cell)
    , m_step(step)
    , m_unit(std::make_unique<MatrixUnit>(cell, true))
{
    if (step.rate > 0.0)
        leadByProfile();
}

/// As a tuning has it lead.
void StepProbe::leadByProfile()
{
    const RawLoop &raw = device().family().trials->raw;
    std::vector<ParameterChange> changes;
    for (const auto &[key, value] : {std::pair(raw.profileRate, m_step.rate),
             std::pair(raw.profileAcceleration, m_step.rate / (passesOfStart * raw.cycle))}) {
        if (const auto index = findParameter(device().family().parameters, key))
            changes.push_back({*index, std::llround(value)});
    }
    EXPECT_TRUE(test::run(m_unit->clock(), tuning::writeGains(device(), changes)));
}

SetPoint StepProbe::setPoint(double target) const
{
    SetPoint point;
    point.mode = m_step.rate > 0.0 ? Mode::RampPosition : m_cell.loop;
    point.target = target;
    if (m_unit->device().family().capabilities.output.brake)
        point.brake = true;
    return point;
}

/// Without power: at no duty, or, where a unit knows none, stopped.
bool StepProbe::comeToRest()
{
    VirtualClock &clock = m_unit->clock();
    if (const auto &modes = device().family().modes; std::find(modes.begin(), modes.end(), Mode::Duty) != modes.end()) {
        SetPoint none = setPoint(0.0);
        none.mode = Mode::Duty;
        if (!m_unit->stream().start(none, tuning::experimentLease))
            return false;
    }
    int still = 0;
    const double share = m_cell.loop == Mode::Current ? 0.0 : restShare;
    for (int i = 0; i < mostWaits && still < 2; ++i) {
        const double before = m_unit->simulator().position();
        clock.advance(100ms);
        still = std::abs(m_unit->simulator().position() - before) < std::max(1.0, share * m_step.size) ? still + 1 : 0;
    }
    m_unit->stream().stop();
    clock.advance(50ms);
    (void)m_unit->simulator().disturb("winding-temperature", 25.0); // every step on a cold motor
    return still == 2;
}

/// Turns the rotor on to where the phase begins, and waits for its time.
void StepProbe::meet(StepPhase phase)
{
    VirtualClock &clock = m_unit->clock();
    const double counts = fractionOf(phase.count - m_unit->simulator().position());
    EXPECT_TRUE(m_unit->simulator().disturb("turn", counts * 2.0 * std::numbers::pi / countsOfTurn(m_cell)));
    const Duration late = clock.now().time_since_epoch() % longestBeat;
    const auto beat = std::chrono::duration<double>(longestBeat).count();
    const auto at = std::chrono::duration_cast<Duration>(std::chrono::duration<double>(phase.time * beat));
    clock.advance((at - late + longestBeat) % longestBeat);
}

/// Its loop holds it where it stands: what the unit calls that.
std::optional<double> StepProbe::begin()
{
    VirtualClock &clock = m_unit->clock();
    const bool counts = device().family().capabilities.zeroPosition;
    if (counts && !test::run(clock, device().zeroPosition()))
        return std::nullopt;
    const auto channel = tuning::axisChannel(device(), "position", 1);
    const auto told = channel ? device().telemetry()->latest(*channel) : std::nullopt;
    const double origin = m_cell.loop == Mode::Position && told && !counts ? told->value : 0.0;
    if (!m_unit->stream().start(setPoint(origin), tuning::experimentLease))
        return std::nullopt;
    clock.advance(100ms);
    return origin;
}

/// A motor that a current has driven is brought to rest before it is driven again.
bool StepProbe::waitForReturn(double origin, bool again, ShaftResponse &response)
{
    if (m_cell.loop == Mode::Current && again)
        return comeToRest() && begin();
    if (!m_unit->stream().update(setPoint(origin)))
        return false;
    const Duration rest = std::chrono::milliseconds(std::lround(1e3 * std::max(m_step.seconds, restOf(m_cell))));
    const Duration pause = m_step.mostCurrent > 0.0 ? look : rest;
    for (Duration past = pause; past <= rest; past += pause) {
        m_unit->clock().advance(pause);
        noteCurrent(response);
    }
    return true;
}

std::optional<ShaftResponse> StepProbe::runAll(
    const std::vector<ParameterChange> &changes, const std::vector<StepPhase> &phases, const StepLimits &limits)
{
    double left = limits.itae * static_cast<double>(phases.size());
    std::vector<double> integrals;
    std::optional<ShaftResponse> all;
    for (const StepPhase &phase : phases) {
        const auto response = run(changes, phase, {left, limits.overshoot});
        if (!response)
            return std::nullopt;
        left -= response->itae;
        integrals.push_back(response->itae);
        if (all)
            add(*all, *response);
        else
            all = response;
    }
    if (!all)
        return std::nullopt;
    all->itae /= static_cast<double>(integrals.size());
    double squares = 0.0;
    for (const double integral : integrals)
        squares += (integral - all->itae) * (integral - all->itae);
    all->spread = std::sqrt(squares / static_cast<double>(integrals.size())) / all->itae;
    return all;
}

std::optional<ShaftResponse> StepProbe::run(
    const std::vector<ParameterChange> &changes, StepPhase phase, const StepLimits &limits)
{
    ++m_runs;
    if (!comeToRest())
        return std::nullopt;
    if (!changes.empty() && !test::run(m_unit->clock(), tuning::writeGains(device(), changes)))
        return std::nullopt;
    meet(phase);
    const double base = m_cell.loop == Mode::Position ? m_unit->simulator().position() : 0.0;
    const auto origin = begin();
    if (!origin)
        return std::nullopt;
    ShaftResponse worse;
    worse.isStable = true;
    for (int repeat = 0; repeat < 2; ++repeat) {
        if (!m_unit->stream().update(setPoint(*origin + m_step.size)))
            return std::nullopt;
        const auto seen = watch(base, {2.0 * limits.itae - worse.itae, limits.overshoot});
        if (!seen)
            return std::nullopt;
        add(worse, *seen);
        if (!waitForReturn(*origin, repeat == 0, worse))
            return std::nullopt;
    }
    m_unit->stream().stop();
    worse.itae *= 0.5;
    return worse;
}

double StepProbe::looked() const
{
    const Simulator &shaft = m_unit->simulator();
    if (m_cell.loop == Mode::Current)
        return shaft.current().value_or(0.0);
    return m_cell.loop == Mode::Position ? shaft.position() : shaft.speed();
}

void StepProbe::noteCurrent(ShaftResponse &response) const
{
    if (m_step.mostCurrent > 0.0)
        response.peakCurrent = std::max(response.peakCurrent, std::abs(m_unit->simulator().current().value_or(0.0)));
}

std::optional<ShaftResponse> StepProbe::watch(double base, const StepLimits &limits)
{
    ShaftResponse response;
    const double near = m_cell.loop == Mode::Position ? goodEnough / m_step.size : 0.0;
    const Duration pause = m_cell.loop == Mode::Current ? lookAtCurrent : look;
    const double seconds = std::chrono::duration<double>(pause).count();
    double low = 1e9;
    double high = -1e9;
    for (double t = seconds; t <= m_step.seconds + 1e-9; t += seconds) {
        m_unit->clock().advance(pause);
        noteCurrent(response);
        const double value = (looked() - base) / m_step.size;
        response.itae += t * std::max(std::abs(1.0 - value) - near, 0.0) * seconds;
        response.overshoot = std::max(response.overshoot, value - 1.0);
        if (response.itae > limits.itae || response.overshoot > limits.overshoot)
            return std::nullopt;
        if (std::abs(1.0 - value) > band)
            response.settle = t;
        if (t > 0.75 * m_step.seconds) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    response.isStable = high - low < stableBand && std::isfinite(response.itae);
    return response;
}

} // namespace mb::test
