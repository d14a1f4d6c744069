// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/windingfit.h"

#include "tuning/currentloop.h"
#include "tuning/marquardt.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr int partsOfPass = 5;
constexpr std::size_t waits = 16;
constexpr double mostPasses = 2.0;      ///< between the earliest and the latest of them
constexpr std::size_t fewestOfStep = 6; ///< of a step
constexpr int windingRounds = 12;
constexpr double sameLag = 1e-3;       ///< of the logarithm of a lag
constexpr double strangeSquares = 9.0; ///< times the squares of the usual step
constexpr double fittedTime = 0.02;    ///< s of each step
constexpr double usualLag = 0.5e-3;    ///< s
constexpr double usualSpread = 0.7;    ///< of its logarithm
constexpr double usualLate = 0.4e-3;   ///< s
constexpr double lateSpread = 0.5e-3;  ///< s
constexpr double gainSpread = 0.03;
constexpr double leastNoise = 0.004;    ///< of the step: no step is like the other
constexpr double mostLagDoubt = 0.4;    ///< of the lag, that is still worth knowing
constexpr double leastLagDoubt = 0.12;  ///< a model of a winding is no better than that
constexpr double mostLeft = 0.03;       ///< of the step, beyond the noise
constexpr double shortestSeen = 0.2e-3; ///< s, that a loop of half a millisecond can tell

using Fit = Marquardt<3>;

/// One step, seconds since its order and shares of it; and how likely it waited so long for the next pass of the loop.
struct WindingStep {
    Trace seen;
    std::array<double, waits> likely{};
};

std::vector<WindingStep> windingStepsOf(const std::vector<Trial> &trials)
{
    std::vector<WindingStep> steps;
    for (const Trial &trial : trials) {
        const Signal *const current = trial.signal("current");
        const double step = trial.stimulus.to - trial.stimulus.from;
        for (std::size_t i = 0; current && step != 0.0 && i < trial.holds.size(); ++i) {
            const double from = trial.holds[i].from;
            WindingStep one;
            one.seen = current->trace.part(from, std::min(from + fittedTime, trial.holds[i].to), from);
            for (double &value : one.seen.y)
                value = (value - trial.stimulus.from) / step;
            one.likely.fill(1.0 / waits);
            if (one.seen.size() >= fewestOfStep)
                steps.push_back(std::move(one));
        }
    }
    return steps;
}

/// Orders come at any time between two passes of the loop: which time that was of each step is weighed by how well it explains it
/// (expectation), and the winding by all of them (maximization), in turn.
class WindingSteps {
public:
    WindingSteps(const SteppedLoop &stepped, const PlantModel &plant)
        : m_stepped(stepped)
        , m_plant(plant)
        , m_steps(windingStepsOf(stepped.trials))
        , m_step(m_steps.empty() ? 1.0
                                 : std::abs(stepped.trials.front().stimulus.to - stepped.trials.front().stimulus.from))
        , m_noise(std::max(plant.noise / m_step, leastNoise))
    {
    }
    [[nodiscard]] std::size_t size() const { return m_steps.size(); }

    /// The winding with which the steps are best explained.
    [[nodiscard]] Fit::Minimum fit()
    {
        Fit::Minimum best{{0.0, 1e3 * usualLate, 0.0}, {}, 0.0};
        leaveOutStrangers(best.values);
        for (int round = 0; round < windingRounds; ++round) {
            weigh(best.values);
            const double before = best.values[0];
            best = Fit::from(
                best.values, [this](const Fit::Unknowns &at, std::vector<double> &left) { over(at, left); });
            if (round > 0 && std::abs(best.values[0] - before) < sameLag)
                break;
        }
        return best;
    }
    /// Of the step, what is left over of a sample beyond its noise.
    [[nodiscard]] double left(const Fit::Unknowns &at) const
    {
        double sum = 0.0;
        double count = 0.0;
        const std::vector<double> response = responseAt(at);
        for (const WindingStep &step : m_steps) {
            for (std::size_t wait = 0; wait < waits; ++wait)
                sum += step.likely[wait] * squaresOf(step, response, lateAt(at, wait));
            count += static_cast<double>(step.seen.size());
        }
        return m_noise * std::sqrt(std::max(sum / std::max(count, 1.0) - 1.0, 0.0));
    }

private:
    [[nodiscard]] std::vector<double> responseAt(const Fit::Unknowns &at) const
    {
        PlantModel motor = m_plant;
        motor.tau = usualLag * std::exp(std::clamp(at[0], -3.0, 3.0));
        motor.gain = m_plant.gain * std::exp(at[2]);
        motor.reading = 0.0; // noise takes the steps of the reading out of a mean
        return currentResponse(motor, m_stepped.gains, m_stepped.shape, m_step, fittedTime, partsOfPass);
    }
    [[nodiscard]] double lateAt(const Fit::Unknowns &at, std::size_t wait) const
    {
        return 1e-3 * at[1] + m_stepped.shape.period * mostPasses * ((static_cast<double>(wait) + 0.5) / waits - 0.5);
    }
    /// Share of the step, so long after the pass that first knew of it.
    [[nodiscard]] double valueOf(const std::vector<double> &response, double t) const
    {
        const double place = t / m_stepped.shape.period * partsOfPass; // 0: it begins
        if (place <= 0.0)
            return 0.0;
        const auto whole = std::min(static_cast<std::size_t>(place), response.size() - 1);
        const double from = whole > 0 ? response[whole - 1] : 0.0;
        return (from + std::min(place - static_cast<double>(whole), 1.0) * (response[whole] - from)) / m_step;
    }
    [[nodiscard]] double offAt(
        const WindingStep &step, std::size_t i, const std::vector<double> &response, double late) const
    {
        return (step.seen.y[i] - valueOf(response, step.seen.t[i] - late)) / m_noise;
    }
    [[nodiscard]] double squaresOf(const WindingStep &step, const std::vector<double> &response, double late) const
    {
        double sum = 0.0;
        for (std::size_t i = 0; i < step.seen.size(); ++i) {
            const double off = offAt(step, i, response, late);
            sum += off * off;
        }
        return sum;
    }
    /// A step whose order was lost came with a later one.
    void leaveOutStrangers(const Fit::Unknowns &at)
    {
        const std::vector<double> response = responseAt(at);
        std::vector<double> costs;
        for (const WindingStep &step : m_steps)
            costs.push_back(squaresOf(step, response, lateAt(at, waits / 2)) / static_cast<double>(step.seen.size()));
        const double most = strangeSquares * median(costs) + 1.0;
        std::size_t next = 0;
        m_steps.erase(
            std::remove_if(m_steps.begin(), m_steps.end(), [&](const WindingStep &) { return costs[next++] > most; }),
            m_steps.end());
    }
    void weigh(const Fit::Unknowns &at)
    {
        const std::vector<double> response = responseAt(at);
        for (WindingStep &step : m_steps) {
            for (std::size_t wait = 0; wait < waits; ++wait)
                step.likely[wait] = squaresOf(step, response, lateAt(at, wait));
            const double least = *std::ranges::min_element(step.likely);
            double sum = 0.0;
            for (double &value : step.likely)
                sum += value = std::exp(0.5 * (least - value));
            for (double &value : step.likely)
                value /= sum;
        }
    }
    void over(const Fit::Unknowns &at, std::vector<double> &left) const
    {
        left.clear();
        const std::vector<double> response = responseAt(at);
        for (const WindingStep &step : m_steps) {
            for (std::size_t wait = 0; wait < waits; ++wait) {
                const double weight = std::sqrt(step.likely[wait]);
                for (std::size_t i = 0; i < step.seen.size(); ++i)
                    left.push_back(weight * offAt(step, i, response, lateAt(at, wait)));
            }
        }
        left.push_back(at[0] / usualSpread);
        left.push_back((at[1] - 1e3 * usualLate) / (1e3 * lateSpread));
        left.push_back(at[2] / gainSpread);
    }

    const SteppedLoop &m_stepped;
    const PlantModel &m_plant;
    std::vector<WindingStep> m_steps;
    double m_step;  ///< A
    double m_noise; ///< of the step
};

} // namespace

std::optional<WindingFit> fitWinding(const SteppedLoop &stepped, const PlantModel &plant)
{
    WindingSteps steps(stepped, plant);
    if (steps.size() == 0)
        return std::nullopt;
    const Fit::Minimum minimum = steps.fit();
    WindingFit fit;
    fit.lag = usualLag * std::exp(minimum.values[0]);
    fit.left = steps.left(minimum.values);
    // a sample counts once for each wait; what it leaves over tells no more of its error for that
    fit.lagError = minimum.errors[0] * std::sqrt(1.0 * waits);
    fit.late = 1e-3 * minimum.values[1];
    fit.gain = std::exp(minimum.values[2]);
    return fit;
}

std::optional<PlantModel> withWindingOf(const SteppedLoop &stepped, const PlantModel &plant)
{
    const auto fit = fitWinding(stepped, plant);
    if (!fit || !(fit->lagError > 0.0) || fit->lagError > mostLagDoubt || fit->left > mostLeft)
        return std::nullopt;
    PlantModel known = plant;
    known.tau = std::max(fit->lag, shortestSeen);
    known.lagDoubt = std::max(fit->lagError, leastLagDoubt);
    return known;
}

} // namespace mb::tuning
