// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/twopointfit.h"

#include "tuning/marquardt.h"

#include <algorithm>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr double beforeOrder = 0.1; ///< s of rest that tell where it stood
constexpr double leastStep = 0.3;   ///< of the trial's
constexpr double leastWay = 3.0;    ///< counts
constexpr double lostAnswer = 1.9;  ///< times as long as from one sample to the next, until the first
constexpr double restShare = 0.8;   ///< of a hold, after which it rests
constexpr std::size_t fewestSamples = 8;
constexpr int stepsOfRamp = 10;
constexpr double lowestEnd = 0.5;
constexpr double highestEnd = 1.3;
constexpr double latest = 0.08;                                 ///< s
constexpr double likelyDelay = 0.004;                           ///< s
constexpr double farthest = 30.0;                               ///< of a logarithm
constexpr std::array<double, 3> likelyOmegas{10.0, 30.0, 90.0}; ///< rad/s
constexpr std::array<double, 3> likelyDrags{3.0, 12.0, 40.0};   ///< 1/s

double positive(double logarithm)
{
    return std::exp(std::clamp(logarithm, -farthest, farthest));
}

/// Fills in what a response leaves over of a run, and tells where the run ends, by linear least squares.
double leftOver(const LoopRun &run, double drag, double stiffness, double lead, double delay, std::vector<double> &left)
{
    double product = 0.0;
    double square = 0.0;
    std::vector<double> model;
    const double rise = run.rise();
    for (std::size_t i = 0; i < run.way.size(); ++i) {
        model.push_back(rampOfSecondOrder(drag, stiffness, lead, run.way.t[i] - delay, rise));
        product += model.back() * run.way.y[i] / run.step;
        square += model.back() * model.back();
    }
    const double end = std::clamp(square > 0.0 ? product / square : 1.0, lowestEnd, highestEnd);
    for (std::size_t i = 0; i < run.way.size(); ++i)
        left.push_back(end * model[i] - run.way.y[i] / run.step);
    return end;
}

bool differ(std::span<const LoopRun> runs, double LoopRun::*gain)
{
    const auto [least, most] = std::minmax_element(
        runs.begin(), runs.end(), [gain](const LoopRun &a, const LoopRun &b) { return a.*gain < b.*gain; });
    return (*most).*gain > 1.2 * (*least).*gain && (*most).*gain > 0.0;
}

void addRun(const Trace &position, const Span &span, double origin, double target, const Trial &trial, double p,
    double d, std::vector<LoopRun> &into)
{
    const Trace before = position.part(span.from - beforeOrder, span.from);
    if (before.isEmpty())
        return;
    const double stood = median(before.y);
    LoopRun run{p, d, target - stood, position.part(span.from, span.to, span.from), 0.0, origin - stood};
    for (double &y : run.way.y)
        y -= stood;
    const bool moved = run.way.size() >= fewestSamples && std::abs(run.way.y.back()) >= leastWay;
    if (moved && std::abs(run.step) >= leastStep * std::abs(trial.stimulus.to - trial.stimulus.from))
        into.push_back(std::move(run));
}

} // namespace

double delayOf(double number)
{
    return std::clamp(number * delayUnit, 0.0, latest);
}

double stepOfSecondOrder(double drag, double stiffness, double t)
{
    constexpr double nearlyOne = 1e-3;
    if (t <= 0.0)
        return 0.0;
    const double omega = std::sqrt(stiffness);
    const double zeta = drag / (2.0 * omega);
    if (std::abs(zeta - 1.0) < nearlyOne)
        return 1.0 - std::exp(-omega * t) * (1.0 + omega * t);
    if (zeta < 1.0) {
        const double swing = omega * std::sqrt(1.0 - zeta * zeta);
        return 1.0 - std::exp(-zeta * omega * t) * (std::cos(swing * t) + zeta * omega / swing * std::sin(swing * t));
    }
    const double root = std::sqrt(zeta * zeta - 1.0);
    const double slow = omega / (zeta + root);
    const double fast = omega * (zeta + root);
    return 1.0 - (fast * std::exp(-slow * t) - slow * std::exp(-fast * t)) / (fast - slow);
}

double rampOfSecondOrder(double drag, double stiffness, double lead, double t, double rise)
{
    if (rise <= 0.0)
        return stepOfSecondOrder(drag, stiffness, t);
    const double led = stepOfSecondOrder(drag, stiffness, t) - stepOfSecondOrder(drag, stiffness, t - rise);
    double sum = 0.0; // a ramp is many small steps
    for (int i = 0; i < stepsOfRamp; ++i)
        sum += stepOfSecondOrder(drag, stiffness, t - rise * (i + 0.5) / stepsOfRamp);
    return sum / stepsOfRamp + lead * led / rise;
}

double leftOf(const LoopRun &run)
{
    const Trace tail = run.way.part(restShare * run.way.t.back(), run.way.t.back());
    return (run.step - median(tail.y)) * run.p;
}

double halfWay(const LoopRun &run)
{
    for (std::size_t i = 1; i < run.way.size(); ++i) {
        const double before = run.way.y[i - 1] / run.step;
        const double now = run.way.y[i] / run.step;
        if (now >= 0.5 && now > before)
            return run.way.t[i - 1] + (run.way.t[i] - run.way.t[i - 1]) * (0.5 - before) / (now - before)
                - 0.5 * run.rise();
    }
    return run.way.t.back();
}

bool LoopRun::hasWaited() const
{
    std::vector<double> gaps;
    for (std::size_t i = 1; i < way.size(); ++i)
        gaps.push_back(way.t[i] - way.t[i - 1]);
    return !gaps.empty() && way.t.front() > lostAnswer * median(gaps);
}

std::vector<LoopRun> runsOf(const Trial &trial, double p, double d, double rate)
{
    std::vector<LoopRun> runs;
    const Signal *const position = trial.signal("position");
    for (const Span &span : trial.holds) {
        if (position)
            addRun(position->trace, span, trial.stimulus.from, trial.stimulus.to, trial, p, d, runs);
    }
    for (const Span &span : trial.returns) {
        if (position)
            addRun(position->trace, span, trial.stimulus.to, trial.stimulus.from, trial, p, d, runs);
    }
    for (LoopRun &run : runs)
        run.rate = rate;
    return runs;
}

std::optional<StepFit> fitStep(const LoopRun &run)
{
    using Search = Marquardt<3>;
    if (run.way.size() < fewestSamples || run.step == 0.0)
        return std::nullopt;
    const Search::Remainder remainder = [&run](const Search::Unknowns &x, std::vector<double> &left) {
        left.clear();
        const double drag = positive(x[0]); // nearly all of it is D
        const double stiffness = positive(x[1]);
        (void)leftOver(run, drag, stiffness, drag / stiffness, delayOf(x[2]), left);
    };
    std::optional<Search::Minimum> best;
    for (const double omega : likelyOmegas) {
        const auto found = Search::from({std::log(omega), 2.0 * std::log(omega), likelyDelay / delayUnit}, remainder);
        if (!best || found.squares < best->squares)
            best = found;
    }
    const double drag = positive(best->values[0]);
    const double omega = std::sqrt(positive(best->values[1]));
    std::vector<double> left;
    const double end = leftOver(run, drag, omega * omega, drag / (omega * omega), delayOf(best->values[2]), left);
    return StepFit{omega, drag / (2.0 * omega), end, std::sqrt(best->squares / static_cast<double>(run.way.size()))};
}

Result<TwoPointFit> fitTwoPoint(std::span<const LoopRun> runs)
{
    using Search = Marquardt<4>;
    std::size_t samples = 0;
    for (const LoopRun &run : runs)
        samples += run.way.size();
    if (runs.size() < 3 || samples < fewestSamples * runs.size())
        return fail(Fault::OutOfRange, say("too few steps to tell what the gains of this loop do"));
    if (!differ(runs, &LoopRun::p) || !differ(runs, &LoopRun::d))
        return fail(Fault::OutOfRange, say("steps with one pair of gains only do not tell what each of them does"));
    const Search::Remainder remainder = [runs](const Search::Unknowns &x, std::vector<double> &left) {
        left.clear();
        for (const LoopRun &run : runs) {
            const double damping = positive(x[1]) * run.d;
            const double stiffness = positive(x[0]) * run.p;
            (void)leftOver(run, positive(x[2]) + damping, stiffness, damping / stiffness, delayOf(x[3]), left);
        }
    };
    const auto first = fitStep(runs.front());
    const double omega = first ? first->omega : likelyOmegas[1];
    const double strongest
        = std::ranges::max_element(runs, [](const LoopRun &a, const LoopRun &b) { return a.d < b.d; })->d;
    std::optional<Search::Minimum> best;
    for (const double drag : likelyDrags) {
        const auto found = Search::from({std::log(omega * omega / runs.front().p), std::log(omega / strongest),
                                            std::log(drag), likelyDelay / delayUnit},
            remainder);
        if (!best || found.squares < best->squares)
            best = found;
    }
    TwoPointFit fit;
    fit.p = positive(best->values[0]);
    fit.d = positive(best->values[1]);
    fit.drag = positive(best->values[2]);
    fit.delay = delayOf(best->values[3]);
    fit.residual = std::sqrt(best->squares / static_cast<double>(samples));
    return fit;
}

} // namespace mb::tuning
