// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/modelnumbers.h"

namespace mb::tuning {
namespace {

/// Of what is never 0 where it is known.
std::optional<double> known(double number)
{
    return number > 0.0 ? std::optional(number) : std::nullopt;
}

/// The lag of a winding is taken until steps tell it, and then within a share of it.
std::optional<double> errorOfLag(const TuneReport &report, const MotorFound &motor)
{
    return known(report.loop == Mode::Current ? report.plant.lagDoubt * report.plant.tau : motor.pushes.tauError);
}

} // namespace

ModelNumbers modelNumbers(const TuneReport &report)
{
    const PlantModel &plant = report.plant;
    const MotorFound motor = report.motor.value_or(MotorFound());
    ModelNumbers numbers;
    numbers.gain = {plant.gain, known(motor.line.gainError)};
    numbers.tau = {plant.tau, errorOfLag(report, motor)};
    numbers.delay = {plant.delay, known(motor.pushes.delayError)};
    const auto frictionError = known(motor.line.frictionError);
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
