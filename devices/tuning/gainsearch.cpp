// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/gainsearch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace mb::tuning {
namespace {

constexpr std::array<double, 4> factors{1.4, 1.2, 1.08, 1.03};
constexpr int roundsOfAFactor = 12; ///< of each factor
constexpr double fewPasses = 400.0;
constexpr double overshootPrice = 200.0; ///< of the integral, for each unit beyond

/// A motor that is not quite as thought, and what it may overshoot by.
struct Doubt {
    double gain;
    double tau;
    double friction;
    double overshoot;
    double weight; ///< of its integral
};
constexpr std::array<Doubt, 3> doubts{{
    {1.0, 1.0, 1.0, 0.005, 0.6},
    {1.0, 1.15, 1.3, 0.02, 0.4}, // hot, with a supply that sags, or with grease that is cold
    {1.05, 1.0, 0.0, 0.04, 0.0}, // overcome before: the integral carries its friction from the last step
}};
constexpr double lessFriction = 0.7; ///< of a position loop: its friction is there at each start
constexpr double weakIntegral = 0.15;
constexpr double leastIntegral = 0.1; ///< of the rule's
constexpr double never = std::numeric_limits<double>::infinity();

struct Seen {
    double itae = 0.0;
    double overshoot = 0.0;
};

struct Found {
    ContinuousGains gains;
    double price = 0.0;
};

class Search {
public:
    Search(Mode loop, const PlantModel &plant, const Design &start, const SearchTask &task)
        : m_loop(loop)
        , m_plant(plant)
        , m_task(task)
        , m_start(start)
        , m_seconds(std::clamp(12.0 * (plant.delay + start.response) + 4.0 * plant.tau, 1.0, 6.0))
    {
        m_task.shape.period = std::clamp(m_task.shape.period, 1e-4, m_seconds / fewPasses);
    }

    [[nodiscard]] double price(const ContinuousGains &gains) const
    {
        if (!isAllowed(gains))
            return never;
        double itae = 0.0;
        double beyond = 0.0;
        for (const Doubt &doubt : doubts) {
            PlantModel plant = m_plant;
            plant.gain *= doubt.gain;
            plant.tau *= doubt.tau;
            plant.friction *= m_loop == Mode::Position && doubt.friction == 0.0 ? lessFriction : doubt.friction;
            const Seen seen = step(plant, gains);
            beyond += std::max(seen.overshoot - doubt.overshoot, 0.0);
            itae += seen.itae * doubt.weight;
        }
        return itae * (1.0 + overshootPrice * beyond);
    }

    /// Downhill, one gain at a time, in ever smaller steps.
    [[nodiscard]] Found from(const ContinuousGains &start) const
    {
        Found best{start, price(start)};
        for (const double factor : factors) {
            for (int round = 0; round < roundsOfAFactor && better(best, factor); ++round) { }
        }
        return best;
    }

private:
    [[nodiscard]] bool better(Found &best, double factor) const
    {
        const double before = best.price;
        for (const auto gain : {&ContinuousGains::i, &ContinuousGains::p, &ContinuousGains::d}) {
            for (const double by : {factor, 1.0 / factor}) {
                ContinuousGains tried = best.gains;
                tried.*gain *= by;
                const double its = tried.*gain != 0.0 ? price(tried) : never;
                if (its < best.price)
                    best = {tried, its};
            }
        }
        return best.price < before;
    }
    [[nodiscard]] Seen step(const PlantModel &plant, const ContinuousGains &gains) const
    {
        SimulatedLoop simulated(m_loop, plant, gains, m_task.shape, 0.0);
        Seen seen;
        const double near = m_task.shape.goodEnough / std::abs(m_task.step);
        for (double t = 0.0; t < m_seconds; t += m_task.shape.period) {
            (void)simulated.pass(m_task.step);
            const double value = simulated.value() / m_task.step;
            seen.itae += t * std::max(std::abs(1.0 - value) - near, 0.0) * m_task.shape.period;
            seen.overshoot = std::max(seen.overshoot, value - 1.0);
        }
        return seen;
    }

    [[nodiscard]] bool isAllowed(const ContinuousGains &gains) const
    {
        const bool quick = m_loop == Mode::Position ? gains.p > mostPositionGain() : gains.p > m_start.gains.p * 1.001;
        const bool weak = m_loop == Mode::Position
            && gains.i < leastIntegral * m_start.gains.i; // it has a purpose, and devices store whole steps
        return !quick && !weak && isWithin(gains, m_task.bounds)
            && hasMargin(m_loop, m_plant, gains, m_task.mostMs, m_task.mostMsOff);
    }
    [[nodiscard]] double mostPositionGain() const
    {
        const double omega = 1.0 / m_start.asked;
        return 1.001 * std::max(m_start.gains.p, m_plant.tau * omega * omega / m_plant.gain);
    }

    Mode m_loop;
    PlantModel m_plant;
    SearchTask m_task;
    const Design &m_start;
    double m_seconds;
};

} // namespace

Design searched(Mode loop, const PlantModel &plant, const Design &start, const SearchTask &task)
{
    if (task.step == 0.0 || loop == Mode::Current)
        return start;
    const Search search(loop, plant, start, task);
    Found best = search.from(start.gains);
    if (loop == Mode::Position && start.gains.i > 0.0) { // a strong integral and a weak one are valleys of their own
        ContinuousGains weak = start.gains;
        weak.i *= weakIntegral;
        if (const Found other = search.from(weak); other.price < best.price)
            best = other;
    }
    Design design = start;
    design.gains = best.gains;
    return design;
}

} // namespace mb::tuning
