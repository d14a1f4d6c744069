// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/tuning/matrix/groundtruth.h"

#include "model/family.h"
#include "simulation/motormodel.h"

#include <cmath>
#include <numbers>

namespace mb::test {
namespace {

constexpr double bridge = 0.005; ///< Ohm
constexpr double usualDuty = 0.3;
constexpr double loopPeriods = 1.5;
constexpr double edgesOfQuadQuad = 32.0; ///< of its window, with a history of 8

/// Seconds over which the loop takes its velocity.
double windowOf(const Cell &cell, double speed, double cycle)
{
    if (cell.family == "dmc60c")
        return 0.1;
    if (cell.family == "quadquad2drv")
        return std::max(edgesOfQuadQuad / std::abs(speed), cycle);
    return cycle;
}

} // namespace

tuning::PlantModel groundTruth(const Cell &cell, double speed)
{
    const MotorParameters &m = *motorByName(cell.motor);
    const double r = m.resistance + bridge + usualDuty * usualDuty * cell.around.busResistance;
    const double kept = m.constant * (1.0 - m.torqueLoss);
    const double perSpeed = m.constant + r * m.viscosity / kept;
    const double inertia = m.inertia * std::max(1.0, usualLoad(cell.motor) * cell.loadFactor);
    tuning::PlantModel plant;
    plant.tau = r * inertia / kept / perSpeed;
    plant.friction = r * cell.around.friction * m.friction / kept / m.nominalVoltage;
    plant.gain = m.nominalVoltage / perSpeed * countsOf(cell) / (2.0 * std::numbers::pi);
    const auto *const family = *std::find_if(
        families().begin(), families().end(), [&cell](const Family *f) { return f->key == cell.family; });
    const double cycle = family->loop ? family->loop->cycle : 1e-3;
    plant.delay = loopPeriods * cycle + m.inductance / r;
    if (cell.loop == Mode::Velocity)
        plant.delay += 0.5 * windowOf(cell, speed, cycle);
    return plant;
}

} // namespace mb::test
