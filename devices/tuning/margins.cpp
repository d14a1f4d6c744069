// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/margins.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace mb::tuning {
namespace {

constexpr double decadesBelow = 4.0; ///< of 1/(τ + delay)
constexpr double decadesAbove = 3.0;

/// Without the delay: its phase is added unwrapped.
std::complex<double> withoutDelay(Mode loop, const PlantModel &plant, const ContinuousGains &gains, double omega)
{
    const std::complex<double> s(0.0, omega);
    std::complex<double> motor = plant.gain / (plant.tau * s + 1.0);
    if (loop == Mode::Position)
        motor /= s;
    return motor * (gains.p + gains.i / s + gains.d * s);
}

} // namespace

std::complex<double> openLoop(Mode loop, const PlantModel &plant, const ContinuousGains &gains, double omega)
{
    return withoutDelay(loop, plant, gains, omega) * std::polar(1.0, -omega * plant.delay);
}

Margins marginsOf(Mode loop, const PlantModel &plant, const ContinuousGains &gains, int points)
{
    Margins margins{1.0, std::numeric_limits<double>::infinity(), 180.0, 0.0};
    const double centre = 1.0 / (plant.tau + plant.delay);
    const int first = static_cast<int>(-decadesBelow * points);
    const int last = static_cast<int>(decadesAbove * points);
    double phase = 0.0; // unwrapped, without the delay's
    double magnitude = 0.0;
    double total = 0.0;
    for (int k = first; k <= last; ++k) {
        const double omega = centre * std::pow(10.0, static_cast<double>(k) / points);
        const std::complex<double> plain = withoutDelay(loop, plant, gains, omega);
        double angle = std::arg(plain);
        if (k > first)
            angle += 2.0 * std::numbers::pi * std::round((phase - angle) / (2.0 * std::numbers::pi));
        else if (angle > 0.0)
            angle -= 2.0 * std::numbers::pi; // two integrators begin at −180°, not +180°
        const double now = angle - omega * plant.delay;
        const double size = std::abs(plain);
        if (k > first) {
            if (magnitude >= 1.0 && size < 1.0) { // the last crossing counts
                margins.phase = 180.0 + now * 180.0 / std::numbers::pi;
                margins.crossover = omega;
            }
            if (total > -std::numbers::pi && now <= -std::numbers::pi && 1.0 / size < margins.gain) {
                margins.gain = 1.0 / size;
                margins.turnover = omega;
            }
        }
        margins.ms = std::max(margins.ms, 1.0 / std::abs(1.0 + std::polar(size, now)));
        phase = angle;
        magnitude = size;
        total = now;
    }
    if (!margins.isStable())
        margins.ms = std::numeric_limits<double>::infinity();
    return margins;
}

} // namespace mb::tuning
