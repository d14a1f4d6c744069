// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/ramp.h"

#include "experiment/localfit.h"
#include "tuning/leastsquares.h"

#include <algorithm>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr double restBeforeRamp = 0.2; ///< s, over which its place at rest is taken
constexpr double leastMotion = 3.0;    ///< counts that are a motion,
constexpr double noisesOfMotion = 3.0; ///< and σ of its noise
constexpr double leastLineHalf = 0.05; ///< s, half of what a local speed is taken over
constexpr double periodsOfLine = 2.0;
constexpr double shareOfSpeed = 0.1; ///< of its last speed, from which on it counts
constexpr std::size_t leastRampRows = 10;
constexpr std::size_t firstPlaces = 5;      ///< of a motion, that tell when it began
constexpr double doubtOfStart = 0.5;        ///< share of the time since a motor let go, that it may be off by
constexpr double leastDetermination = 0.98; ///< R²
constexpr double mostGainOff = 0.1;         ///< of a ramp's gain beside that of the pushes
constexpr int letGoHalvings = 40;

/// The duty of a ramp without its sign, at the times of the position.
class Course {
public:
    Course(const Trial &ramp, const RampedMotor &motor)
        : m_ramp(ramp)
        , m_duty(ramp.signal("duty"))
        , m_sign(ramp.stimulus.to > 0.0 ? 1.0 : -1.0)
        , m_late(motor.delay + 0.5 * motor.beat)
    {
        const Signal *const bus = ramp.signal("bus_voltage");
        const Trace under = bus ? bus->trace.part(0.0, ramp.stimulus.time) : Trace();
        double sum = 0.0;
        for (const double volts : under.y)
            sum += volts / static_cast<double>(under.size());
        if (motor.supply > 0.0 && !under.isEmpty())
            m_supply = sum / motor.supply;
    }
    /// What it tells itself came with the position; what was ordered acts later, on the beat in the mean.
    [[nodiscard]] double at(double t) const
    {
        const double duty
            = m_duty && !m_duty->trace.isEmpty() ? valueAt(m_duty->trace, t) : m_ramp.stimulus.at(t - m_late);
        return std::max(m_sign * duty, 0.0) * m_supply;
    }
    [[nodiscard]] double sign() const { return m_sign; }

private:
    const Trial &m_ramp;
    const Signal *m_duty;
    double m_sign;
    double m_late;
    double m_supply = 1.0;
};

/// counts/s around a sample.
double localSpeed(const Trace &way, std::size_t at, double half)
{
    std::vector<double> t;
    std::vector<double> y;
    for (std::size_t i = 0; i < way.size(); ++i) {
        if (std::abs(way.t[i] - way.t[at]) <= half) {
            t.push_back(way.t[i] - way.t[at]);
            y.push_back(way.y[i]);
        }
    }
    return fitLine(t, y).slope;
}

/// The first sample from which it never comes back to its rest.
std::optional<std::size_t> firstMoved(const Trace &way, double least)
{
    std::optional<std::size_t> first;
    for (std::size_t i = 0; i < way.size(); ++i) {
        if (way.y[i] < least)
            first.reset();
        else if (!first)
            first = i;
    }
    return first;
}

/// Rows of the regression from a sample on.
std::optional<RampWay> regressRamp(
    const Trace &way, std::size_t from, const std::vector<double> &speeds, const Course &duty, double tau)
{
    LeastSquares<3> rows;
    double area = 0.0;
    double sum = 0.0;
    double squares = 0.0;
    std::size_t count = 0;
    for (std::size_t i = from; i < speeds.size(); ++i) {
        if (i > from)
            area += 0.5 * (duty.at(way.t[i]) + duty.at(way.t[i - 1])) * (way.t[i] - way.t[i - 1]);
        rows.add({1.0, way.t[i] - way.t[from], way.y[i] - way.y[from] + tau * (speeds[i] - speeds[from])}, area);
        sum += area;
        squares += area * area;
        ++count;
    }
    const auto solution = count >= leastRampRows ? rows.solve() : std::nullopt;
    if (!solution || solution->values[2] <= 0.0)
        return std::nullopt;
    const double spread = squares - sum * sum / static_cast<double>(count);
    RampWay found;
    found.friction = std::max(solution->values[1], 0.0);
    found.frictionError = solution->errors[1];
    found.gain = 1.0 / solution->values[2];
    found.determination = spread > 0.0 ? 1.0 - solution->residual / spread : 0.0;
    return found;
}

/// Counts that it makes within a time of letting go, at a duty that exceeds friction by `step` and grows by `rate`.
double wayWithin(double t, double step, double rate, double gain, double tau)
{
    const double lost = tau * (1.0 - std::exp(-t / tau));
    return gain * (step * (t - lost) + rate * (0.5 * t * t - tau * t + tau * lost));
}

/// s before a sample at which it must have let go to be there then.
double sinceLetGo(double counts, double duty, double rate, const RampWay &found, double tau)
{
    const double longest = std::max((duty - found.friction) / rate, 0.0); // below friction it does not turn
    double low = 0.0;
    double high = longest;
    for (int i = 0; i < letGoHalvings; ++i) {
        const double middle = 0.5 * (low + high);
        const double step = duty - rate * middle - found.friction;
        (wayWithin(middle, step, rate, found.gain, tau) < counts ? low : high) = middle;
    }
    return high;
}

} // namespace

double RampFound::error() const
{
    return std::hypot(forward.frictionError, reverse.frictionError) / 2.0;
}

double RampFound::determination() const
{
    return std::min(forward.determination, reverse.determination);
}

bool RampFound::agreesWith(double gain) const
{
    return determination() >= leastDetermination && std::abs(forward.gain / gain - 1.0) <= mostGainOff
        && std::abs(reverse.gain / gain - 1.0) <= mostGainOff;
}

std::optional<RampWay> readRamp(const Trial &ramp, const RampedMotor &motor)
{
    const Signal *const position = ramp.signal("position");
    if (!position || ramp.holds.empty() || ramp.stimulus.to == 0.0 || motor.tau <= 0.0)
        return std::nullopt;
    const Course duty(ramp, motor);
    const Trace rest = position->trace.part(-restBeforeRamp, 0.0);
    Trace way = position->trace.part(0.0, ramp.holds.front().to);
    if (rest.isEmpty() || way.size() < leastRampRows)
        return std::nullopt;
    const double origin = median(rest.y);
    for (double &y : way.y)
        y = duty.sign() * (y - origin);
    const auto moved = firstMoved(way, leastMotion + noisesOfMotion * motor.noise);
    if (!moved)
        return std::nullopt;
    const double half = std::max(leastLineHalf, periodsOfLine * samplePeriod(way));
    std::vector<double> speeds; // a line that leans to one side is of another time
    for (std::size_t i = 0; i < way.size() && way.t[i] + half <= way.t.back(); ++i)
        speeds.push_back(localSpeed(way, i, half));
    std::size_t from = *moved;
    while (from < speeds.size() && speeds[from] < shareOfSpeed * speeds.back())
        ++from;
    auto found = regressRamp(way, from, speeds, duty, motor.tau);
    if (!found)
        return std::nullopt;
    const double rate = std::abs(ramp.stimulus.to) / ramp.stimulus.time;
    std::vector<double> breakaways;
    std::vector<double> errors;
    for (std::size_t i = *moved; i < std::min(*moved + firstPlaces, way.size()); ++i) {
        const double now = duty.at(way.t[i]);
        const double since = sinceLetGo(way.y[i], now, rate, *found, motor.tau);
        breakaways.push_back(now - rate * since);
        errors.push_back(rate * (doubtOfStart * since + samplePeriod(way)));
    }
    found->breakaway = median(std::move(breakaways));
    found->breakawayError = median(std::move(errors)) + found->frictionError;
    return found;
}

} // namespace mb::tuning
