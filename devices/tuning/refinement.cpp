// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/refinement.h"

#include "experiment/envelope.h"
#include "tuning/windingheat.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace mb::tuning {
namespace {

constexpr std::array<double, 4> finerFactors{1.12, 1.05, 1.02, 1.01};
constexpr int roundsOfFineness = 4;
constexpr double mostCorrection = 1.35;
constexpr double usualError = 0.1;      ///< that a number of the model is off by without more ado
constexpr double priceOfError = 1e-5;   ///< of that, in squares of the step
constexpr double clearlyBetter = 0.7;   ///< of what the model leaves over
constexpr double restBeforeStep = 0.05; ///< s
constexpr double leastFriction = 0.002; ///< duty, that may be found where none was
constexpr double shareOfPass = 0.25;    ///< to which an order's wait for its pass is told
constexpr double longestSag = 0.8;
constexpr double usualSag = 0.3; ///< that nobody has told before
constexpr double usualBrakingError = 0.3;
constexpr double sagOfFactor = 3.0; ///< for each share that the other numbers move by

double PlantModel::*const correctedNumbers[]
    = {&PlantModel::gain, &PlantModel::tau, &PlantModel::friction, &PlantModel::delay};

/// What the loop of a trial measures in each of its passes, from `begin` to `end`; it warms its winding meanwhile.
std::vector<double> passesOf(const SteppedLoop &stepped, const Trial &trial, const PlantModel &plant, double step,
    double begin, double end, double &heat)
{
    PlantModel motor = warmed(plant, heat);
    SimulatedLoop simulated(trial.mode, motor, stepped.gains, withoutClock(stepped.shape), 0.0);
    std::vector<double> passes;
    std::size_t hold = 0;
    bool wasUp = false;
    for (double t = begin; t < end; t += stepped.shape.period) {
        while (hold + 1 < trial.holds.size() && t >= trial.holds[hold + 1].from)
            ++hold;
        const bool up = t >= trial.holds[hold].from && t < trial.holds[hold].to;
        if (std::exchange(wasUp, up) != up) {
            heat *= up ? heatThatStays : 1.0;
            motor = warmed(plant, heat);
            simulated.turnInto(motor);
        }
        const double duty = simulated.pass(up ? step : 0.0);
        heat += heatOf(motor, duty, simulated.speed(), stepped.shape.period);
        passes.push_back(simulated.measured());
    }
    return passes;
}

/// Samples of a trial beside what its loop measures in each pass.
struct Seen {
    const Trace &measured;
    std::vector<double> passes;
    double begin;  ///< s, of the first pass
    double period; ///< s
    double from;
    double step;

    /// Squares of what is left over between two samples, of the step, where an order waits so long; given up beyond `most`.
    [[nodiscard]] double left(std::size_t first, std::size_t last, double later, double most) const
    {
        double sum = 0.0;
        for (std::size_t i = first; i < last && sum < most; ++i) {
            const double past = std::ceil((measured.t[i] - later - begin) / period);
            const double seen = past < 1.0 ? 0.0 : passes[std::min(static_cast<std::size_t>(past), passes.size()) - 1];
            const double off = (measured.y[i] - from - seen) / step;
            sum += off * off;
        }
        return sum;
    }
    /// The least of any wait up to `longest`.
    [[nodiscard]] double least(std::size_t first, std::size_t last, double longest, double share) const
    {
        double least = std::numeric_limits<double>::infinity();
        for (double later = 0.0; later <= longest; later += share * period)
            least = std::min(least, left(first, last, later, least));
        return least;
    }
};

/// The first sample of each step and of each way back, and the end.
std::vector<std::size_t> edgesOf(const Trial &trial, const Trace &measured)
{
    std::vector<std::size_t> edges{0}; // what rests before the first belongs to it
    const auto add = [&](double at) {
        const auto found = std::lower_bound(measured.t.begin(), measured.t.end(), at) - measured.t.begin();
        edges.push_back(static_cast<std::size_t>(found));
    };
    for (const Span &hold : trial.holds) {
        if (&hold != &trial.holds.front())
            add(hold.from);
        add(hold.to);
    }
    edges.push_back(measured.size());
    return edges;
}

/// Mean square of what is left over of a trial, in squares of its step; of a loop that was tried by its gains alone at the time the link takes
/// with which it is least; else each order waits for its pass, up to one: nobody knows when that comes.
double leftOfSteps(const SteppedLoop &stepped, const Trial &trial, const PlantModel &plant, double &heat)
{
    const Signal *const signal = trial.signal(measuredOf(trial.mode));
    if (!signal || trial.holds.empty() || trial.returns.empty())
        return 0.0;
    const double begin = trial.holds.front().from - restBeforeStep;
    const Trace measured = signal->trace.part(begin, trial.returns.back().to);
    if (measured.isEmpty())
        return 0.0;
    const double from = trial.mode == Mode::Position ? measured.y.front() : trial.stimulus.from;
    const double step = trial.stimulus.to - from;
    const double period = stepped.shape.period;
    const Seen seen{
        measured, passesOf(stepped, trial, plant, step, begin, measured.t.back(), heat), begin, period, from, step};
    double sum = 0.0;
    if (stepped.isTried) {
        sum = seen.least(0, measured.size(), stepped.mostLater, 0.5);
    } else {
        const std::vector<std::size_t> edges = edgesOf(trial, measured);
        for (std::size_t i = 0; i + 1 < edges.size(); ++i)
            sum += seen.least(edges[i], edges[i + 1], period, shareOfPass);
    }
    return sum / static_cast<double>(measured.size());
}

class Refinement {
public:
    Refinement(const SteppedLoop &stepped, const PlantModel &plant)
        : m_stepped(stepped)
        , m_start(plant)
        , m_best(plant)
    {
        m_start.friction = std::max(plant.friction, leastFriction);
        m_left = leftOverOf(m_best);
        m_cost = costOf(m_best);
    }
    void descend()
    {
        for (const double factor : finerFactors) {
            for (int round = 0; round < roundsOfFineness; ++round) {
                const double least = m_cost;
                for (double PlantModel::*const member : correctedNumbers) {
                    for (const double by : {factor, 1.0 / factor})
                        look(member, by);
                }
                if (m_stepped.isTried && m_stepped.shape.setPointRate == 0.0) { // led, it is braked by its profile
                    for (const double by : {factor, 1.0 / factor})
                        lookAtBraking(by);
                } else {
                    for (const double by : {factor - 1.0, 1.0 - factor})
                        lookAtSag(sagOfFactor * by);
                }
                if (m_cost >= least)
                    break;
            }
        }
    }
    [[nodiscard]] const PlantModel &best() const { return m_best; }
    [[nodiscard]] bool isClearlyBetter() const { return leftOverOf(m_best) < clearlyBetter * m_left; }

private:
    [[nodiscard]] double leftOverOf(const PlantModel &plant) const
    {
        double sum = 0.0;
        double heat = m_stepped.heat;
        for (const Trial &trial : m_stepped.trials)
            sum += leftOfSteps(m_stepped, trial, plant, heat);
        return sum / static_cast<double>(m_stepped.trials.size());
    }
    [[nodiscard]] double costOf(const PlantModel &plant) const
    {
        double cost = leftOverOf(plant);
        for (double PlantModel::*const member : correctedNumbers) {
            const double off = std::log(std::max(plant.*member, 1e-9) / std::max(m_start.*member, 1e-9)) / usualError;
            cost += priceOfError * off * off;
        }
        const double sagged = (plant.sag - m_start.sag) / usualSag;
        const double braked = std::log(plant.braking / m_start.braking) / usualBrakingError;
        return cost + priceOfError * (sagged * sagged + braked * braked);
    }
    void look(double PlantModel::*member, double by)
    {
        PlantModel plant = m_best;
        plant.*member = std::max(plant.*member, member == &PlantModel::friction ? leastFriction : 0.0) * by;
        const double off = plant.*member / std::max(m_start.*member, 1e-9);
        if (off <= mostCorrection && off >= 1.0 / mostCorrection)
            take(plant);
    }
    /// A large step sees a supply sag that pushes have not shown: its motor is not weaker near its target.
    void lookAtSag(double more)
    {
        PlantModel plant = m_best;
        plant.sag = std::clamp(plant.sag + more, 0.0, longestSag);
        if (plant.sag != m_best.sag)
            take(plant);
    }
    /// Steps that friction ends have hardly shown it.
    void lookAtBraking(double by)
    {
        PlantModel plant = m_best;
        plant.braking = std::clamp(plant.braking * by, 1.0, mostBraking);
        if (plant.braking != m_best.braking)
            take(plant);
    }
    void take(const PlantModel &plant)
    {
        if (const double its = costOf(plant); its < m_cost) {
            m_best = plant;
            m_cost = its;
        }
    }

    const SteppedLoop &m_stepped;
    PlantModel m_start;
    PlantModel m_best;
    double m_left = 0.0;
    double m_cost = 0.0;
};

} // namespace

double heatAfter(const SteppedLoop &stepped, const PlantModel &plant)
{
    double heat = stepped.heat;
    for (const Trial &trial : stepped.trials) {
        if (plant.warming > 0.0)
            (void)leftOfSteps(stepped, trial, plant, heat);
    }
    return heat;
}

std::optional<PlantModel> refinedBy(const SteppedLoop &stepped, const PlantModel &plant)
{
    if (stepped.trials.empty() || stepped.shape.period <= 0.0 || stepped.trials.front().mode == Mode::Current)
        return std::nullopt;
    Refinement refinement(stepped, plant);
    refinement.descend();
    return refinement.isClearlyBetter() ? std::optional(refinement.best()) : std::nullopt;
}

} // namespace mb::tuning
