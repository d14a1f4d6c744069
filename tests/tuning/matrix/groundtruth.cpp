// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/tuning/matrix/groundtruth.h"

#include "families/supermodified/protocol.h"
#include "model/family.h"
#include "simulation/motormodel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mb::test {
namespace {

constexpr double bridge = 0.005; ///< Ohm
constexpr double usualDuty = 0.3;
constexpr double loopPeriods = 1.5;
constexpr double noiseShare = 0.1;       ///< of full duty that one count may make through D,
constexpr double storedD = 16000.0;      ///< or what a Supermodified of the bench has
constexpr double edgesOfQuadQuad = 32.0; ///< of its window, with a history of 8

const Family &familyOf(const Cell &cell)
{
    return **std::find_if(
        families().begin(), families().end(), [&cell](const Family *f) { return f->key == cell.family; });
}

supermodified::Dialect dialectOf(const Cell &cell)
{
    using supermodified::Dialect;
    return cell.dialect == "D3" ? Dialect::D3 : cell.dialect == "D2" ? Dialect::D2 : Dialect::D1;
}

/// Seconds over which the loop takes its velocity.
double windowOf(const Cell &cell, double speed, double cycle)
{
    if (cell.family == "dmc60c")
        return 0.1;
    if (cell.family == "quadquad2drv")
        return std::max(edgesOfQuadQuad / std::abs(speed), cycle);
    return cycle;
}

tuning::PlantModel windingOf(const Cell &cell, const MotorParameters &m, double r)
{
    tuning::PlantModel plant;
    plant.gain = m.nominalVoltage / r;
    plant.tau = m.inductance / r;
    plant.delay = loopPeriods * cycleOf(cell);
    return plant;
}

} // namespace

double countsOfTurn(const Cell &cell)
{
    const double gear = motorByName(cell.motor)->gearRatio;
    return cell.family == "supermodified" ? ticksPerTurn(dialectOf(cell)) / gear : countsOf(cell);
}

double cycleOf(const Cell &cell)
{
    const Family &family = familyOf(cell);
    return family.loop ? family.loop->cycle : family.trials->raw.cycle;
}

std::optional<tuning::TriedScale> trueScale(const Cell &cell)
{
    const Family &family = familyOf(cell);
    if (family.loop)
        return std::nullopt;
    using supermodified::Dialect;
    const double finer = ticksPerTurn(dialectOf(cell)) / static_cast<double>(ticksPerTurn(Dialect::D1));
    const double full = family.trials->raw.fullDuty * finer;
    const double cycle = family.trials->raw.cycle;
    return tuning::TriedScale{1.0 / full, cycle / full, cycle, std::max(noiseShare * full, storedD), 0.0,
        1.0 / (full * family.trials->raw.integral * cycle)};
}

tuning::PlantModel groundTruth(const Cell &cell, double speed)
{
    const MotorParameters &m = *motorByName(cell.motor);
    const double r = m.resistance + bridge + usualDuty * usualDuty * cell.around.busResistance;
    if (cell.loop == Mode::Current)
        return windingOf(cell, m, r);
    const double kept = m.constant * (1.0 - m.torqueLoss);
    const double perSpeed = m.constant + r * m.viscosity / kept;
    const double inertia = m.inertia * std::max(1.0, usualLoad(cell.motor) * cell.loadFactor);
    tuning::PlantModel plant;
    plant.tau = r * inertia / kept / perSpeed;
    plant.friction = r * cell.around.friction * m.friction / kept / m.nominalVoltage;
    plant.gain = m.nominalVoltage / perSpeed * countsOfTurn(cell) / (2.0 * std::numbers::pi);
    const double cycle = cycleOf(cell);
    plant.delay = loopPeriods * cycle + m.inductance / r;
    if (cell.loop == Mode::Velocity)
        plant.delay += 0.5 * windowOf(cell, speed, cycle);
    return plant;
}

} // namespace mb::test
