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

enum Unknown : std::size_t { Push, Drag, Friction, Shift, Braking, Damping, End };
constexpr std::size_t unknownCount = 7;
using LoopSearch = Marquardt<unknownCount>;

constexpr std::size_t fewestRuns = 3;
constexpr double mostBraking = 2.5; ///< times
constexpr double farPush = 5.0;     ///< times what one step alone tells
constexpr double farthestLog = 20.0;
constexpr double usualLeft = 0.02; ///< of a step: what doubts of the unknowns are weighed against
constexpr double unknownEnd = 1e3; ///< of what is taken for full duty, at most
constexpr std::array<double, 3> ledOmegas{12.0, 35.0, 100.0}; ///< rad/s, of a loop that is led
constexpr int stillPasses = 10;

/// What is likely before anything is measured: the middle and σ of an unknown.
struct Likely {
    Unknown which;
    double middle;
    double sigma;
};
constexpr std::array<Likely, 5> likely{{
    {Drag, 2.3, 1.5},      // 0.1 s
    {Friction, -3.0, 1.5}, // 5 % of full duty
    {Shift, 0.4, 0.5},
    {Braking, 0.0, 0.4},
    {End, 0.0, 0.7},
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
        for (const Likely &one : likely) {
            const double sigma = one.which == End && m_law.isKnown ? knownSigma : one.sigma;
            left.push_back(usualLeft * (x[one.which] - one.middle) / sigma);
        }
        left.push_back(usualLeft * x[Damping] / (m_law.isKnown ? knownSigma : 1.0));
    }

private:
    void add(const LoopRun &run, const LoopSearch::Unknowns &x, std::vector<double> &left) const
    {
        const ContinuousGains gains{run.p * m_law.scale.p, 0.0, run.d * m_law.scale.d * exponential(x[Damping]), 0.0};
        LoopShape shape = m_shape;
        shape.mostDuty = std::min(exponential(x[End]), unknownEnd);
        shape.setPointRate = run.rate;
        SimulatedLoop simulated(Mode::Position, plantOf(x), gains, shape, 0.0);
        simulated.beginAt(run.from);
        const double shift = delayOf(x[Shift]);
        double before = 0.0;
        double value = 0.0;
        double t = 0.0; // of `value`
        int still = 0;
        for (std::size_t i = 0; i < run.way.size(); ++i) {
            const double at = run.way.t[i] - shift;
            for (; t < at && still < stillPasses; t += shape.period) {
                before = value;
                (void)simulated.pass(run.step);
                value = simulated.value();
                still = value == before && t >= run.rise() ? still + 1 : 0;
            }
            const double share = at >= t ? 1.0 : std::clamp(1.0 - (t - at) / shape.period, 0.0, 1.0);
            left.push_back((before + share * (value - before) - run.way.y[i]) / run.step);
        }
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
            const auto found = LoopSearch::from(x, remainder);
            if (!best || found.squares < best->squares)
                best = found;
        }
    }
    const auto &x = best->values;
    LoopFit result;
    result.plant = plantOf(x);
    result.shift = delayOf(x[Shift]);
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
