// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/gainsearch.h"

#include "tuning/currentsearch.h"
#include "tuning/margins.h"
#include "tuning/windingheat.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace mb::tuning {
namespace {

constexpr std::array<double, 3> factors{1.16, 1.06, 1.02};
constexpr int roundsOfAFactor = 6;
constexpr std::size_t starts = 4; ///< of the grid, that are followed downhill
constexpr double passesOfDelay = 20.0;
constexpr double mostPasses = 1200.0;        ///< of one step
constexpr double quickestOfSetPoints = 1.95; ///< natural frequency over theirs; 2 is the bound
constexpr double longerSteps = 2.0;          ///< of an integral that adds whole steps: where it rests shows late
constexpr double restOfCounts = 1.5;         ///< s, until a velocity that waits for its counts is known to be 0
constexpr int restingPasses = 25;            ///< of a loop without an integral, after which nothing happens any more

/// A motor that is not quite as thought, and what it may overshoot by.
struct Doubt {
    double gain;
    double tau;
    double friction;
    double moreOvershoot; ///< than SearchTask::overshoot
    double weight;        ///< of its integral
};
constexpr std::array<Doubt, 3> doubts{{
    {1.0, 1.0, 1.0, 0.0, 0.5},
    {1.0, 1.08, 1.15, 0.02, 0.25}, // hot, with a supply that sags, or with grease that is cold
    {1.02, 0.96, 0.87, 0.02, 0.25},
}};
/// Of a model that its own steps have corrected.
constexpr std::array<Doubt, 3> smallDoubts{{
    {1.0, 1.0, 1.0, 0.0, 0.6},
    {1.0, 1.03, 1.05, 0.01, 0.2},
    {1.01, 0.98, 0.95, 0.01, 0.2},
}};
/// Where a loop of whole steps comes to rest is a matter of luck: what is good on the average is wanted.
constexpr std::array<Doubt, 8> wholeDoubts{{
    {1.0, 1.0, 1.0, 0.0, 0.16},
    {1.0, 1.1, 1.2, 0.02, 0.12},
    {1.03, 0.95, 0.8, 0.02, 0.12},
    {1.01, 1.02, 1.05, 0.01, 0.12},
    {0.99, 0.97, 1.0, 0.01, 0.12},
    {1.005, 1.03, 0.95, 0.01, 0.12},
    {0.995, 0.99, 1.08, 0.01, 0.12},
    {1.015, 1.0, 0.9, 0.01, 0.12},
}};
/// So is where a velocity that is counted over a few edges finds the next of them.
constexpr std::array<Doubt, 8> countedDoubts{{
    {1.0, 1.0, 1.0, 0.0, 0.16},
    {1.0, 1.06, 1.1, 0.02, 0.06},
    {1.0075, 0.985, 0.95, 0.01, 0.13},
    {1.002, 1.005, 1.015, 0.01, 0.13},
    {0.998, 0.995, 0.985, 0.01, 0.13},
    {1.004, 1.01, 1.0, 0.01, 0.13},
    {0.996, 0.99, 1.025, 0.01, 0.13},
    {1.001, 1.015, 0.975, 0.01, 0.13},
}};
constexpr double heatOfATuning = 0.8; ///< squares of duty
constexpr double mostOvershootWhenWarm = 0.035;
constexpr double overshootPrice = 40.0; ///< of the integral, for each unit beyond
constexpr double never = std::numeric_limits<double>::infinity();

constexpr std::array<double, 9> responses{0.6, 0.8, 1.0, 1.3, 1.9, 3.0, 4.5, 7.0, 11.0}; ///< delays
constexpr std::array<double, 6> integralTimes{0.35, 0.5, 0.7, 1.0, 1.4, 2.0};            ///< lags of the motor
constexpr std::array<double, 4> dampings{0.6, 0.8, 1.0, 1.4};
constexpr std::array<double, 3> integralWeights{0.03, 0.08, 0.2};
constexpr int frequencies = 7;
constexpr double nextFrequency = 1.4;
constexpr double quickest = 0.5; ///< over the delay
constexpr double lessened = 0.998;
constexpr int mostLessenings = 20;

struct Found {
    ContinuousGains gains;
    double price = never;
};

std::span<const Doubt> doubtsOf(const SearchTask &task)
{
    return task.shape.integralStep > 0.0 ? std::span<const Doubt>(wholeDoubts)
        : task.shape.windowCounts > 0.0  ? std::span<const Doubt>(countedDoubts)
        : task.isProven                  ? std::span<const Doubt>(smallDoubts)
                                         : std::span<const Doubt>(doubts);
}

/// Where it comes to rest depends on where its counts fall.
bool isLuck(const LoopShape &shape)
{
    return shape.integralStep > 0.0 || shape.windowCounts > 0.0;
}

/// Of each step.
double secondsOf(const PlantModel &plant, double response, const SearchTask &task)
{
    const double longer = task.shape.integralStep > 0.0 ? longerSteps : 1.0;
    return std::clamp((6.0 * (plant.delay + response) + 3.0 * plant.tau) * longer, 0.8, 4.0);
}

class Search {
public:
    Search(Mode loop, const PlantModel &plant, const Design &start, const SearchTask &task)
        : m_loop(loop)
        , m_plant(plant)
        , m_steep(atLeastAsSteep(plant, task.steepest))
        , m_task(task)
        , m_start(start)
        , m_seconds(secondsOf(plant, start.response, task))
        , m_rest(task.shape.windowCounts > 0.0 ? restOfCounts : 0.0)
        , m_doubts(doubtsOf(task))
        , m_nextPhase(isLuck(task.shape) ? 1.0 / static_cast<double>(m_doubts.size()) : 0.0)
        , m_near(loop == Mode::Position ? nearTarget / std::abs(task.step) : 0.0)
    {
        if (task.shape.integralStep == 0.0)
            m_task.shape.period = std::max({task.shape.period, plant.delay / passesOfDelay, m_seconds / mostPasses});
    }

    /// Of one motor alone.
    [[nodiscard]] double errorOf(const ContinuousGains &gains) const
    {
        double overshoot = 0.0;
        return steps(m_plant, gains, never, overshoot, 0.0);
    }

    [[nodiscard]] Found best() const
    {
        std::vector<Found> all{{m_start.gains, price(m_start.gains, never)}};
        const auto look = [&](const ContinuousGains &gains) {
            if (const double its = price(gains, worstOf(all)); its < never)
                all.push_back({gains, its});
        };
        if (m_loop == Mode::Position)
            lookAtPositions(look);
        else
            lookAtVelocities(look);
        sort(all);
        Found found = all.front();
        for (std::size_t i = 0; i < std::min(starts, all.size()); ++i) {
            const Found other = downhill(all[i]);
            if (other.price < found.price)
                found = other;
        }
        return held(found);
    }

private:
    static void sort(std::vector<Found> &all)
    {
        std::ranges::sort(all, [](const Found &a, const Found &b) { return a.price < b.price; });
    }
    /// What one has to be better than to be followed.
    static double worstOf(std::vector<Found> &all)
    {
        if (all.size() < starts)
            return never;
        sort(all);
        return all[starts - 1].price;
    }

    template <class Look> void lookAtVelocities(const Look &look) const
    {
        for (const double response : responses) {
            const double p = std::min(m_plant.tau / (m_plant.gain * m_plant.delay * (1.0 + response)), mostOfError());
            for (const double share : integralTimes)
                look(ContinuousGains{p, p / (share * m_plant.tau), 0.0, 0.0});
        }
    }

    template <class Look> void lookAtPositions(const Look &look) const
    {
        const bool integrates = m_task.bounds.integralWeight > 0.0;
        for (const double damping : dampings) {
            double omega = quickestPosition(damping);
            for (int i = 0; i < frequencies; ++i, omega /= nextFrequency) {
                if (!integrates)
                    look(positionRule(m_plant, omega, damping));
                for (const double weight : integralWeights) {
                    if (integrates)
                        look(positionRuleWithIntegral(m_plant, omega, damping, weight));
                }
            }
        }
    }

    /// P, with which the largest error makes no more output than it may.
    [[nodiscard]] double mostOfError() const
    {
        const LoopBounds &bounds = m_task.bounds;
        return bounds.largestError > 0.0 ? bounds.strongestError / bounds.largestError : never;
    }
    /// rad/s, that delay and noise allow.
    [[nodiscard]] double quickestPosition(double damping) const
    {
        const LoopBounds &bounds = m_task.bounds;
        const double delayed = quickest / m_plant.delay;
        if (bounds.period <= 0.0)
            return delayed;
        const double most = bounds.derivativeShare * bounds.period;
        return std::min(delayed, (1.0 + m_plant.gain * most) / (2.0 * damping * m_plant.tau));
    }

    /// One gain or two at a time, in ever smaller steps.
    [[nodiscard]] Found downhill(Found best) const
    {
        static constexpr std::array<std::array<int, 3>, 5> directions{
            {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 0}}};
        for (const double factor : factors) {
            for (int round = 0; round < roundsOfAFactor; ++round) {
                const double before = best.price;
                for (const auto &direction : directions) {
                    for (const double by : {factor, 1.0 / factor})
                        step(best, direction, by);
                }
                if (best.price >= before)
                    break;
            }
        }
        return best;
    }

    /// The peak of a sensitivity may lie between two points of the search: a little less of all gains, until the fine look holds.
    [[nodiscard]] Found held(Found found) const
    {
        const auto holds = [this](const ContinuousGains &gains) {
            return hasMargin(m_loop, m_steep, gains, m_task.mostMs, m_task.mostMsOff);
        };
        for (int i = 0; i < mostLessenings && !holds(found.gains); ++i) {
            for (const auto gain : {&ContinuousGains::p, &ContinuousGains::i, &ContinuousGains::d})
                found.gains.*gain *= lessened;
        }
        return holds(found.gains) ? found : Found{m_start.gains, 0.0};
    }

    void step(Found &best, const std::array<int, 3> &direction, double by) const
    {
        ContinuousGains tried = best.gains;
        tried.p *= direction[0] != 0 ? by : 1.0;
        tried.i *= direction[1] != 0 ? by : 1.0;
        tried.d *= direction[2] != 0 ? by : 1.0;
        if (tried == best.gains)
            return;
        if (const double its = price(tried, best.price); its < best.price)
            best = {tried, its};
    }

    /// Given up as soon as it is more than `most`.
    [[nodiscard]] double price(const ContinuousGains &gains, double most) const
    {
        if (!isAllowed(gains))
            return never;
        double sum = 0.0;
        double beyond = 0.0;
        double phase = 0.0;
        for (const Doubt &doubt : m_doubts) {
            PlantModel plant = m_plant;
            plant.gain *= doubt.gain;
            plant.tau *= doubt.tau;
            plant.friction *= doubt.friction;
            double overshoot = 0.0;
            sum += doubt.weight * steps(plant, gains, (most - sum) / doubt.weight, overshoot, phase);
            phase += m_nextPhase;
            beyond = std::max(beyond, overshoot - m_task.overshoot - doubt.moreOvershoot);
            if (sum >= most)
                return never;
        }
        if (m_plant.warming > 0.0 && m_loop == Mode::Velocity)
            beyond = std::max(beyond, overshootWhenWarm(gains) - mostOvershootWhenWarm);
        if (m_task.shape.setPointRate > 0.0)
            beyond = std::max(beyond, overshootUnled(gains) - m_task.overshoot);
        return sum * (1.0 + overshootPrice * beyond);
    }

    /// After about a minute of steps: what a tuning leaves, and what its user sees next.
    [[nodiscard]] double overshootWhenWarm(const ContinuousGains &gains) const
    {
        double overshoot = 0.0;
        (void)steps(warmed(m_plant, heatOfATuning), gains, never, overshoot, 0.0);
        return overshoot;
    }

    /// Of what a profile leads in its proof; somebody may give it steps.
    [[nodiscard]] double overshootUnled(const ContinuousGains &gains) const
    {
        SearchTask unled = m_task;
        unled.shape.setPointRate = 0.0;
        double overshoot = 0.0;
        (void)Search(m_loop, m_plant, m_start, unled).steps(m_plant, gains, never, overshoot, 0.0);
        return overshoot;
    }

    /// From rest, back, and once more: what the proof does. The mean of both integrals.
    [[nodiscard]] double steps(
        const PlantModel &plant, const ContinuousGains &gains, double most, double &overshoot, double phase) const
    {
        LoopShape shape = m_task.shape;
        shape.phase = phase;
        SimulatedLoop simulated(m_loop, plant, gains, shape, 0.0);
        const double period = m_task.shape.period;
        double itae = 0.0;
        for (const bool up : {true, false, true}) {
            const double target = up ? m_task.step : 0.0;
            int still = 0;
            const double seconds = up ? m_seconds : std::max(m_seconds, m_rest);
            for (double t = period; t < seconds; t += period) {
                const double before = simulated.value();
                (void)simulated.pass(target);
                const double value = simulated.value() / m_task.step;
                const double error = std::max(std::abs(1.0 - value) - m_near, 0.0);
                still = gains.i == 0.0 && simulated.value() == before ? still + 1 : 0;
                const bool rests = still > restingPasses;
                if (up) {
                    itae += 0.5 * error * (rests ? 0.5 * (m_seconds * m_seconds - t * t) : t * period);
                    overshoot = std::max(overshoot, value - 1.0);
                }
                if (itae >= most)
                    return itae;
                if (rests)
                    break;
            }
            if (simulated.value() == 0.0 && up)
                return never; // what does not move does not overshoot either
        }
        return itae;
    }

    [[nodiscard]] bool isAllowed(const ContinuousGains &gains) const
    {
        if (gains.p <= 0.0 || gains.p > mostGain())
            return false;
        for (const auto gain : {&ContinuousGains::p, &ContinuousGains::i, &ContinuousGains::d}) {
            if (gains.*gain != 0.0 && gains.*gain < m_task.least.*gain)
                return false;
        }
        return isWithin(gains, m_task.bounds)
            && hasMargin(m_loop, m_steep, gains, m_task.mostMs, m_task.mostMsOff, pointsOfSearch);
    }
    [[nodiscard]] double mostGain() const
    {
        double omega = m_task.isHeldToRule ? 1.0 / m_start.asked : never;
        if (m_task.setPoints > 0.0)
            omega = std::min(omega, quickestOfSetPoints / m_task.setPoints);
        if (m_task.quickest > 0.0)
            omega = std::min(omega, 1.0 / m_task.quickest);
        const bool position = m_loop == Mode::Position;
        const double natural = position ? m_steep.tau * omega * omega / m_steep.gain
            : m_task.isHeldToRule       ? 0.0
                                        : never;
        const bool isBounded = position && m_task.setPoints > 0.0 && !m_task.isHeldToRule;
        return 1.001 * (isBounded ? natural : std::max(m_start.gains.p, natural));
    }

    static constexpr int pointsOfSearch = 30; ///< of a decade

    Mode m_loop;
    PlantModel m_plant;
    PlantModel m_steep; ///< whose margins are held
    SearchTask m_task;
    const Design &m_start;
    double m_seconds;
    double m_rest; ///< s, of the way back, at least
    std::span<const Doubt> m_doubts;
    double m_nextPhase; ///< of a count and of its clock, from doubt to doubt, where that is luck
    double m_near;
};

} // namespace

Design searched(Mode loop, const PlantModel &plant, const Design &start, const SearchTask &task)
{
    if (task.step == 0.0)
        return start;
    if (loop == Mode::Current)
        return searchedCurrent(plant, start, task);
    const Found best = Search(loop, plant, start, task).best();
    Design design = start;
    design.gains = best.gains;
    return design;
}

double errorOfSteps(Mode loop, const PlantModel &plant, const ContinuousGains &gains, const SearchTask &task)
{
    if (loop == Mode::Current)
        return errorOfCurrents(plant, gains, task);
    Design start;
    start.response = responseOf(loop, Aim::Normal, plant);
    return Search(loop, plant, start, task).errorOf(gains);
}

} // namespace mb::tuning
