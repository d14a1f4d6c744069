// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/tuning/matrix/stepprobe.h"

#include "model/family.h"
#include "tuning/envelope.h"
#include "tuning/experiment.h"
#include "tuning/gains.h"

#include <algorithm>
#include <cmath>

namespace mb::test {
namespace {

using namespace std::chrono_literals;

constexpr Duration look = 1ms;
constexpr double lookSeconds = 1e-3;
constexpr double restShare = 2e-3; ///< of the step, in a tenth of a second
constexpr int mostWaits = 100;
constexpr double band = 0.05;
constexpr double longRest = 2.0; ///< s
constexpr double stableBand = 0.3;
constexpr double goodEnough = 4.0; ///< counts beside a target that nobody asks to be mended

/// s between two steps, at least. A QuadQuad2Drv takes a motor for moving until it has waited 0.67 s for its next edge, and its integral
/// with it: it creeps back before it rests.
double restOf(const Cell &cell)
{
    return cell.family == "quadquad2drv" && cell.loop == Mode::Velocity ? longRest : 0.0;
}

} // namespace

StepProbe::StepProbe(const Cell &cell, double step, double seconds)
    : m_cell(cell)
    , m_step(step)
    , m_seconds(seconds)
    , m_unit(std::make_unique<MatrixUnit>(cell, true))
{
}

SetPoint StepProbe::setPoint(double target) const
{
    SetPoint point;
    point.mode = m_cell.loop;
    point.target = target;
    if (m_unit->device().family().capabilities.outputOptions)
        point.brake = true;
    return point;
}

bool StepProbe::comeToRest()
{
    VirtualClock &clock = m_unit->clock();
    SetPoint none = setPoint(0.0);
    none.mode = Mode::Duty;
    if (!m_unit->stream().start(none, tuning::experimentLease))
        return false;
    int still = 0;
    for (int i = 0; i < mostWaits && still < 2; ++i) {
        const double before = m_unit->simulator().position();
        clock.advance(100ms);
        still = std::abs(m_unit->simulator().position() - before) < std::max(1.0, restShare * m_step) ? still + 1 : 0;
    }
    m_unit->stream().stop();
    clock.advance(50ms);
    (void)m_unit->simulator().disturb("winding-temperature", 25.0); // every step on a cold motor
    return still == 2;
}

std::optional<ShaftResponse> StepProbe::run(const std::vector<ParameterChange> &changes)
{
    ++m_runs;
    VirtualClock &clock = m_unit->clock();
    if (!comeToRest())
        return std::nullopt;
    if (!changes.empty() && !test::run(clock, tuning::writeGains(device(), changes)))
        return std::nullopt;
    const bool position = m_cell.loop == Mode::Position;
    const auto channel = tuning::axisChannel(device(), "position", 1);
    const auto told = channel ? device().telemetry()->latest(*channel) : std::nullopt;
    const double origin = position && told ? told->value : 0.0;
    const double base = m_unit->simulator().position();
    if (!m_unit->stream().start(setPoint(origin), tuning::experimentLease))
        return std::nullopt;
    clock.advance(100ms);
    ShaftResponse worse;
    worse.isStable = true;
    for (int repeat = 0; repeat < 2; ++repeat) {
        if (!m_unit->stream().update(setPoint(origin + m_step)))
            return std::nullopt;
        const ShaftResponse seen = watch(position ? base : 0.0, position);
        worse.itae += 0.5 * seen.itae;
        worse.overshoot = std::max(worse.overshoot, seen.overshoot);
        worse.settle = std::max(worse.settle, seen.settle);
        worse.isStable = worse.isStable && seen.isStable;
        if (!m_unit->stream().update(setPoint(origin)))
            return std::nullopt;
        clock.advance(std::chrono::milliseconds(std::lround(1e3 * std::max(m_seconds, restOf(m_cell)))));
    }
    m_unit->stream().stop();
    return worse;
}

ShaftResponse StepProbe::watch(double base, bool position)
{
    Simulator &shaft = m_unit->simulator();
    ShaftResponse response;
    const double near = position ? goodEnough / m_step : 0.0;
    double low = 1e9;
    double high = -1e9;
    for (double t = lookSeconds; t <= m_seconds + 1e-9; t += lookSeconds) {
        m_unit->clock().advance(look);
        const double value = ((position ? shaft.position() : shaft.speed()) - base) / m_step;
        response.itae += t * std::max(std::abs(1.0 - value) - near, 0.0) * lookSeconds;
        response.overshoot = std::max(response.overshoot, value - 1.0);
        if (std::abs(1.0 - value) > band)
            response.settle = t;
        if (t > 0.75 * m_seconds) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    response.isStable = high - low < stableBand && std::isfinite(response.itae);
    return response;
}

} // namespace mb::test
