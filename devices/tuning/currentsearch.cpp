// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/currentsearch.h"

#include "tuning/currentloop.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace mb::tuning {
namespace {

constexpr double unseenOfReading = 0.5;   ///< of a step of the reading, that an overshoot is not read
constexpr double mostUnseen = 0.045;      ///< of the step
constexpr double moreMs = 1.1;            ///< times the sensitivity, as far as a lag that was seen may be off
constexpr double heldSeconds = 0.08;      ///< s, as long as its proof holds a step at least
constexpr double priceOfOvershoot = 40.0; ///< of the integral, for each unit beyond
constexpr double beyondReach = std::numeric_limits<double>::infinity();
constexpr double quickestLambda = 0.4e-3; ///< s
constexpr double slowestLambda = 8e-3;    ///< s
constexpr int halvings = 9;
constexpr std::array<double, 6> slowerThanAllowed{1.0, 1.1, 1.25, 1.5, 2.0, 3.0};
constexpr double shortestZero = 0.03e-3; ///< s, P over I
constexpr double nextZero = 1.25;
constexpr int zeros = 21;
constexpr std::array<double, 3> finerSteps{1.12, 1.05, 1.02};
constexpr int roundsOfAStep = 5;
constexpr int pointsOfDecade = 30; ///< of a decade

/// What is not known of a motor well enough to rely on it: where a current comes to rest that is read in coarse steps is a matter of luck.
struct WindingDoubt {
    double gain;
    double pickUp;
    double reading;
    double moreOvershoot; ///< than SearchTask::overshoot
};
constexpr std::array<WindingDoubt, 4> windingDoubts{
    {{1.0, 1.0, 1.0, 0.0}, {1.015, 0.93, 1.002, 0.02}, {0.985, 1.07, 0.998, 0.02}, {1.005, 1.15, 1.001, 0.02}}};

struct FoundCurrent {
    ContinuousGains gains;
    double price = beyondReach;
};

/// That a winding may have, s, the likeliest first.
std::array<double, 3> lagsOf(const PlantModel &plant)
{
    if (plant.lagDoubt <= 0.0)
        return {plant.tau, std::min(plant.tau, shortestLag), std::max(plant.tau, longestLag)};
    return {plant.tau, plant.tau / (1.0 + plant.lagDoubt), plant.tau * (1.0 + plant.lagDoubt)};
}

class CurrentSearch {
public:
    CurrentSearch(const PlantModel &plant, const Design &start, const SearchTask &task)
        : m_plant(plant)
        , m_start(start)
        , m_task(task)
        , m_lags(lagsOf(plant))
        , m_overshoot(std::max(task.overshoot, std::min(unseenOfReading * plant.reading / task.step, mostUnseen)))
    {
    }

    [[nodiscard]] FoundCurrent best() const
    {
        FoundCurrent found{m_start.gains, price(m_start.gains, beyondReach)};
        double zero = shortestZero;
        for (int i = 0; i < zeros; ++i, zero *= nextZero) {
            const double least = quickestAllowed(zero);
            for (const double slower : slowerThanAllowed)
                look(gainsAt(zero, slower * least), found);
        }
        descend(found);
        return found;
    }

private:
    /// P over I in seconds, and the response that I is made for.
    [[nodiscard]] ContinuousGains gainsAt(double zero, double lambda) const
    {
        PlantModel as = m_plant;
        as.tau = zero;
        return currentRule(as, lambda);
    }
    /// Least error is mostly where the sensitivities end.
    [[nodiscard]] double quickestAllowed(double zero) const
    {
        double low = quickestLambda;
        double high = slowestLambda;
        for (int i = 0; i < halvings; ++i) {
            const double middle = std::sqrt(low * high);
            (isAllowed(gainsAt(zero, middle)) ? high : low) = middle;
        }
        return high;
    }
    void descend(FoundCurrent &found) const
    {
        for (const double factor : finerSteps) {
            for (int round = 0; round < roundsOfAStep; ++round) {
                const double before = found.price;
                for (const double by : {factor, 1.0 / factor}) {
                    const ContinuousGains at = found.gains;
                    look({at.p * by, at.i, 0.0, 0.0}, found);
                    look({at.p, at.i * by, 0.0, 0.0}, found);
                    look({at.p * by, at.i * by, 0.0, 0.0}, found);
                    look({at.p * by * by, at.i * by, 0.0, 0.0}, found);
                }
                if (found.price >= before)
                    break;
            }
        }
    }

    void look(const ContinuousGains &gains, FoundCurrent &found) const
    {
        if (const double its = price(gains, found.price); its < found.price)
            found = {gains, its};
    }

    [[nodiscard]] bool isAllowed(const ContinuousGains &gains) const
    {
        if (gains.p < m_task.least.p || gains.i < m_task.least.i || !isWithin(gains, m_task.bounds))
            return false;
        for (const double lag : m_lags) {
            const double more = m_plant.lagDoubt > 0.0 && lag != m_plant.tau ? moreMs : 1.0;
            PlantModel plant = m_plant;
            plant.tau = lag;
            if (!hasMargin(Mode::Current, plant, gains, more * m_task.mostMs, more * m_task.mostMsOff, pointsOfDecade))
                return false;
        }
        return true;
    }

    /// Given up as soon as it is more than `most`.
    [[nodiscard]] double price(const ContinuousGains &gains, double most) const
    {
        if (gains.p <= 0.0 || gains.i <= 0.0)
            return beyondReach;
        constexpr std::array<double, 3> weights{0.5, 0.25, 0.25};
        double sum = 0.0;
        double beyond = 0.0;
        for (std::size_t i = 0; i < weights.size(); ++i) {
            for (const WindingDoubt &doubt : windingDoubts) {
                PlantModel plant = m_plant;
                plant.tau = m_lags[i];
                plant.gain *= doubt.gain;
                plant.pickUp *= doubt.pickUp;
                plant.reading *= doubt.reading;
                const double weight = weights[i] / static_cast<double>(windingDoubts.size());
                const CurrentError error
                    = errorOfCurrent(plant, gains, m_task.shape, m_task.step, heldSeconds, (most - sum) / weight);
                sum += weight * error.itae;
                const double more = i > 0 ? std::max(doubt.moreOvershoot, 0.02) : doubt.moreOvershoot;
                beyond = std::max(beyond, error.overshoot - m_overshoot - more);
                if (sum >= most)
                    return beyondReach;
            }
        }
        const double whole = sum * (1.0 + priceOfOvershoot * beyond);
        return whole < most && isAllowed(gains) ? whole : beyondReach;
    }

    PlantModel m_plant;
    const Design &m_start;
    const SearchTask &m_task;
    std::array<double, 3> m_lags;
    double m_overshoot; ///< of the step, that costs nothing
};

} // namespace

Design searchedCurrent(const PlantModel &plant, const Design &start, const SearchTask &task)
{
    const FoundCurrent best = CurrentSearch(plant, start, task).best();
    Design design = start;
    design.gains = best.gains;
    return design;
}

double errorOfCurrents(const PlantModel &plant, const ContinuousGains &gains, const SearchTask &task)
{
    return errorOfCurrent(plant, gains, task.shape, task.step, heldSeconds, beyondReach).itae;
}

} // namespace mb::tuning
