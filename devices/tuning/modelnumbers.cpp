// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/modelnumbers.h"

#include "tuning/uncertainty.h"

namespace mb::tuning {
namespace {

/// Of what is never 0 where it is known.
std::optional<double> known(double number)
{
    return number > 0.0 ? std::optional(number) : std::nullopt;
}

} // namespace

ModelNumbers modelNumbers(const TuneReport &report)
{
    const PlantModel &plant = report.plant;
    const MotorFound motor = report.motor.value_or(MotorFound());
    const PlantErrors errors = errorsOf(report);
    const bool isTaken = report.loop == Mode::Current && plant.lagDoubt == 0.0; // nobody has seen its lag
    ModelNumbers numbers;
    numbers.gain = {plant.gain, known(errors.gain)};
    numbers.tau = {plant.tau, isTaken ? std::nullopt : known(errors.tau)};
    numbers.delay = {plant.delay, known(errors.delay)};
    const auto frictionError = known(errors.friction);
    numbers.friction = {frictionError ? std::optional(plant.friction) : known(plant.friction), frictionError};
    if (motor.line.forward > 0.0 && motor.line.reverse > 0.0)
        numbers.load = {motor.line.offset, known(motor.line.offsetError)};
    numbers.forward.value = known(motor.line.forward);
    numbers.reverse.value = known(motor.line.reverse);
    numbers.noise.value = motor.restNoise;
    numbers.latency.value = motor.latency;
    return numbers;
}

} // namespace mb::tuning
