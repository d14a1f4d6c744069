// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/loopfit.h"

#include "tuning/marquardt.h"
#include "tuning/simulatedloop.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace mb::tuning {
namespace {

enum Unknown : std::size_t { Push, Drag, Friction, Shift, Braking, Damping, End, Winding };
constexpr std::size_t unknownCount = 8;
using LoopSearch = Marquardt<unknownCount>;

constexpr std::size_t fewestRuns = 3;
constexpr double farPush = 5.0; ///< times what one step alone tells
constexpr double farthestLog = 20.0;
constexpr double usualLeft = 0.02; ///< of a step: what doubts of the unknowns are weighed against
constexpr double unknownEnd = 1e3; ///< of what is taken for full duty, at most
constexpr std::array<double, 3> ledOmegas{12.0, 35.0, 100.0}; ///< rad/s, of a loop that is led
constexpr int stillPasses = 10;
constexpr int roundsOfWait = 6;
constexpr double noSlope = 1e-12;
constexpr double halfACount = 0.5;
constexpr double longestWait = 0.1; ///< s

constexpr double usualBraking = 0.4;    ///< 1.5 times: a gear makes it 2, a motor alone 1.1 to 1.3
constexpr double usualWinding = 0.5e-3; ///< s
constexpr double mostWinding = 4e-3;    ///< s

/// What is likely before anything is measured: the middle and σ of an unknown.
struct Likely {
    Unknown which;
    double middle;
    double sigma;
};
constexpr std::array<Likely, 6> likely{{
    {Drag, 2.3, 1.5},      // 0.1 s
    {Friction, -3.0, 1.5}, // 5 % of full duty
    {Shift, 0.4, 0.5},
    {Braking, usualBraking, 0.4},
    {End, 0.0, 0.7},
    {Winding, 0.0, 0.7},
}};
constexpr double knownSigma = 1e-3; ///< of what the firmware tells

struct LikelyStart {
    double push;     ///< times what the linear fit says
    double drag;     ///< 1/s; 0: as the linear fit says
    double friction; ///< duty
};
constexpr std::array<LikelyStart, 4> likelyStarts{
    {{1.0, 0.0, 0.01}, {1.0, 6.0, 0.05}, {0.5, 6.0, 0.1}, {0.3, 15.0, 0.05}}};

double exponential(double logarithm)
{
    return std::exp(std::clamp(logarithm, -farthestLog, farthestLog));
}

double windingOf(double number)
{
    return std::min(usualWinding * exponential(number), mostWinding);
}

PlantModel plantOf(const LoopSearch::Unknowns &x)
{
    PlantModel plant;
    plant.tau = 1.0 / exponential(x[Drag]);
    plant.gain = exponential(x[Push]) * plant.tau;
    plant.friction = exponential(x[Friction]);
    plant.braking = std::clamp(exponential(x[Braking]), 1.0, mostBraking);
    return plant;
}

/// 1/s² for 1 of P, where the search begins. A run that was led tells little of it by itself.
std::vector<double> likelyPushes(const LoopRun &run, const TwoPointFit &first)
{
    if (run.rate > 0.0) {
        std::vector<double> pushes;
        for (const double omega : ledOmegas)
            pushes.push_back(omega * omega / run.p);
        return pushes;
    }
    const auto seen = fitStep(run);
    const double push = seen ? seen->omega * seen->omega / run.p : first.p;
    return {std::clamp(first.p, push / farPush, push * farPush)};
}

class SteppedFit {
public:
    SteppedFit(std::span<const LoopRun> runs, const LoopLaw &law)
        : m_runs(runs)
        , m_law(law)
    {
        m_shape.period = law.scale.cycle;
    }

    void remainder(const LoopSearch::Unknowns &x, std::vector<double> &left) const
    {
        left.clear();
        for (const LoopRun &run : m_runs)
            add(run, x, left);
        for (const Likely &usual : likely) {
            const Likely one = likelyHere(usual);
            left.push_back(usualLeft * (x[one.which] - one.middle) / one.sigma);
        }
        left.push_back(usualLeft * x[Damping] / (m_law.isKnown ? knownSigma : 1.0));
    }

private:
    /// Where a firmware's law is not known, what D makes and what a winding takes are not told apart. A motor that has to be led has no gear.
    [[nodiscard]] Likely likelyHere(Likely one) const
    {
        if ((one.which == End && m_law.isKnown) || (one.which == Winding && !m_law.isKnown))
            one.sigma = knownSigma;
        if (one.which == Braking && m_runs.front().rate > 0.0)
            one.middle = 0.0;
        return one;
    }
    /// Where each pass leaves the motor, from its order on; no further than where it rests.
    [[nodiscard]] std::vector<double> placesOf(const LoopRun &run, const LoopSearch::Unknowns &x) const
    {
        const ContinuousGains gains{run.p * m_law.scale.p, 0.0, run.d * m_law.scale.d * exponential(x[Damping]), 0.0};
        LoopShape shape = m_shape;
        shape.mostDuty = std::min(exponential(x[End]), unknownEnd);
        shape.setPointRate = run.rate;
        shape.winding = windingOf(x[Winding]);
        SimulatedLoop simulated(Mode::Position, plantOf(x), gains, shape, 0.0);
        simulated.beginAt(run.from);
        std::vector<double> places{0.0};
        int still = 0;
        for (double t = 0.0; t < run.way.t.back() && still < stillPasses; t += shape.period) {
            (void)simulated.pass(run.step);
            still = simulated.value() == places.back() && t >= run.rise() ? still + 1 : 0;
            places.push_back(simulated.value());
        }
        return places;
    }
    [[nodiscard]] double placeAt(const std::vector<double> &places, double t) const
    {
        const double passes = std::clamp(t / m_shape.period, 0.0, static_cast<double>(places.size() - 1));
        const auto before = static_cast<std::size_t>(passes);
        const std::size_t after = std::min(before + 1, places.size() - 1);
        return places[before] + (passes - static_cast<double>(before)) * (places[after] - places[before]);
    }
    /// s that its order waited behind an answer that the line had lost.
    [[nodiscard]] double waitOf(const LoopRun &run, const std::vector<double> &places, double shift) const
    {
        double wait = 0.0;
        for (int round = 0; round < roundsOfWait; ++round) {
            double product = 0.0;
            double square = noSlope;
            for (std::size_t i = 0; i < run.way.size(); ++i) {
                const double at = run.way.t[i] - shift - wait;
                const double place = placeAt(places, at);
                const double slope = (place - placeAt(places, at - m_shape.period)) / m_shape.period;
                product += (place - run.way.y[i]) * slope;
                square += slope * slope;
            }
            wait = std::clamp(wait + product / square, 0.0, longestWait);
        }
        return wait;
    }
    /// A place is a whole count, and the part of one at which it stood is not known: up to half of one is no error.
    void add(const LoopRun &run, const LoopSearch::Unknowns &x, std::vector<double> &left) const
    {
        const std::vector<double> places = placesOf(run, x);
        const std::size_t first = left.size();
        double shift = delayOf(x[Shift]);
        shift += run.hasWaited() ? waitOf(run, places, shift) : 0.0;
        double sum = 0.0;
        for (std::size_t i = 0; i < run.way.size(); ++i) {
            left.push_back((placeAt(places, run.way.t[i] - shift) - run.way.y[i]) / run.step);
            sum += left.back();
        }
        const double part = halfACount / std::abs(run.step);
        const double off = std::clamp(sum / static_cast<double>(run.way.size()), -part, part);
        for (std::size_t i = first; i < left.size(); ++i)
            left[i] -= off;
    }

    std::span<const LoopRun> m_runs;
    const LoopLaw &m_law;
    LoopShape m_shape;
};

} // namespace

Result<LoopFit> fitLoop(std::span<const LoopRun> runs, const LoopLaw &law, const TwoPointFit &first)
{
    std::size_t samples = 0;
    for (const LoopRun &run : runs)
        samples += run.way.size();
    if (runs.size() < fewestRuns)
        return fail(Fault::OutOfRange, say("too few steps to tell what the gains of this loop do"));
    const SteppedFit fit(runs, law);
    const LoopSearch::Remainder remainder
        = [&fit](const LoopSearch::Unknowns &x, std::vector<double> &left) { fit.remainder(x, left); };
    std::optional<LoopSearch::Minimum> best;
    for (const double push : likelyPushes(runs.front(), first)) {
        for (const LikelyStart &start : likelyStarts) {
            LoopSearch::Unknowns x{};
            x[Push] = std::log(start.push * push / law.scale.p);
            x[Drag] = std::log(start.drag > 0.0 ? start.drag : std::clamp(first.drag, 0.5, 100.0));
            x[Friction] = std::log(start.friction);
            x[Shift] = first.delay / delayUnit;
            x[Braking] = usualBraking; // below 1 nothing would change with it
            const auto found = LoopSearch::from(x, remainder);
            if (!best || found.squares < best->squares)
                best = found;
        }
    }
    const auto &x = best->values;
    LoopFit result;
    result.plant = plantOf(x);
    result.shift = delayOf(x[Shift]);
    result.winding = windingOf(x[Winding]);
    result.d = law.scale.d * exponential(x[Damping]);
    result.tauError = result.plant.tau * best->errors[Drag];
    result.gainError = result.plant.gain * std::hypot(best->errors[Push], best->errors[Drag]);
    result.shiftError = delayUnit * best->errors[Shift];
    result.pushError = best->errors[Push];
    result.dError = law.isKnown ? 0.0 : result.d * best->errors[Damping];
    std::vector<double> left;
    fit.remainder(x, left);
    double squares = 0.0;
    for (std::size_t i = 0; i < samples; ++i)
        squares += left[i] * left[i];
    result.residual = std::sqrt(squares / static_cast<double>(samples));
    return result;
}

} // namespace mb::tuning
