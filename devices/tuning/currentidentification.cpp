// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/currentidentification.h"

#include "experiment/figures.h"
#include "experiment/localfit.h"
#include "experiment/verdict.h"
#include "model/family.h"
#include "tuning/autotunerun.h"
#include "tuning/leastsquares.h"
#include "tuning/proposals.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mb::tuning {
namespace {

constexpr double firstForce = 0.03; ///< duty
constexpr double moreEachTime = 2.0;
constexpr double mostForce = 0.4;
constexpr double forceTime = 0.12;        ///< s of a push
constexpr double clearCurrent = 1.5;      ///< A, many of the steps that a current is told in
constexpr double currentRoom = 0.5;       ///< of the limit
constexpr double lighterForce = 0.6;      ///< of the stronger pushes
constexpr double electricalTime = 0.5e-3; ///< s, L/R while nobody knows it
constexpr double currentDelays = 1.5;     ///< periods of the device's loop
constexpr double afterEdge = 2e-3;        ///< s, when the current has risen
constexpr std::size_t fewestCurrents = 8; ///< samples of a push
constexpr double mostUnlike = 0.15;
constexpr double mostDoubt = 0.1;
constexpr double restAhead = 0.2; ///< s before a push, in which nothing flows

using Squares = LeastSquares<2>;

/// What one push adds up to since its current has risen.
struct Sums {
    double current = 0.0; ///< A·s
    double way = 0.0;     ///< counts
    double driven = 0.0;  ///< duty·s, less where the supply sagged
};

double edgeOfPush(const Trial &trial, const Span &hold)
{
    const Trace given = trial.signal("duty")->trace.part(hold.from - 0.02, hold.to);
    for (std::size_t i = 0; i < given.size(); ++i) {
        if (given.y[i] / trial.stimulus.to >= 0.5)
            return given.t[i];
    }
    return hold.to;
}

/// Each moment of it is a row of `all`; nothing where it has too few.
std::optional<Sums> addPush(const Trial &trial, const Span &hold, double rest, Squares &all)
{
    const Signal *const bus = trial.signal("bus_voltage");
    const Trace &duty = trial.signal("duty")->trace;
    const Trace &position = trial.signal("position")->trace;
    const Trace drawn = trial.signal("current")->trace.part(edgeOfPush(trial, hold) + afterEdge, hold.to);
    if (drawn.size() < fewestCurrents)
        return std::nullopt;
    Sums sums;
    for (std::size_t i = 1; i < drawn.size(); ++i) {
        const double step = drawn.t[i] - drawn.t[i - 1];
        const double sag = bus && rest > 0.0 ? valueAt(bus->trace, drawn.t[i]) / rest : 1.0;
        sums.current += 0.5 * (drawn.y[i] + drawn.y[i - 1]) * step;
        sums.driven += valueAt(duty, drawn.t[i]) * sag * step;
        sums.way = valueAt(position, drawn.t[i]) - valueAt(position, drawn.t.front());
        all.add({sums.current, sums.way}, sums.driven);
    }
    return sums;
}

bool isComplete(const Trial &trial)
{
    return trial.signal("duty") && trial.signal("current") && trial.signal("position")
        && !trial.signal("position")->trace.isEmpty() && !trial.signal("duty")->trace.isEmpty();
}

/// What the current of a push makes of its motor's speed, counts/s²: of a parabola through its positions.
std::optional<std::pair<double, double>> speedingUp(const Trial &trial, const Span &hold)
{
    const double from = edgeOfPush(trial, hold) + afterEdge;
    const Trace drawn = trial.signal("current")->trace.part(from, hold.to);
    const double half = 0.5 * (hold.to - from);
    const auto bent = fitParabola(trial.signal("position")->trace, from + half, half, 0);
    if (drawn.isEmpty() || !bent)
        return std::nullopt;
    const double current = std::accumulate(drawn.y.begin(), drawn.y.end(), 0.0) / static_cast<double>(drawn.size());
    return std::pair(std::abs(current), 2.0 * bent->c * std::copysign(1.0, current));
}

/// A, the step of a reading: of the smallest difference first, then of ever larger readings, which tell it ever finer.
double readingOf(const std::vector<Trial> &pushes)
{
    std::vector<double> all;
    double step = 0.0;
    for (const Trial &trial : pushes) {
        const Trace &current = trial.signal("current")->trace;
        const double least = resolutionOf(current);
        step = step == 0.0 || (least > 0.0 && least < step) ? least : step;
        for (const double value : current.y)
            all.push_back(std::abs(value));
    }
    std::ranges::sort(all);
    for (const double value : all) {
        if (step > 0.0 && value > 0.5 * step)
            step = value / std::round(value / step);
    }
    return step;
}

MessageNumber amperes(double current)
{
    return {std::round(current * 1000.0) / 1000.0, -1, "A"};
}

double supplyOf(const Trial &trial)
{
    const Signal *const bus = trial.signal("bus_voltage");
    return bus && !bus->trace.isEmpty() ? bus->trace.y.front() : 0.0;
}

} // namespace

Result<Ohm> fitOhm(const std::vector<Trial> &pushes)
{
    Squares all;
    std::vector<Sums> each;
    Ohm ohm;
    for (const Trial &trial : pushes) {
        if (!isComplete(trial))
            return fail(Fault::OutOfRange,
                say("the unit tells no duty, no current or no position, so its resistance is not known"));
        ohm.supply = ohm.supply > 0.0 ? ohm.supply : supplyOf(trial);
        for (const Span &hold : trial.holds) {
            if (const auto sums = addPush(trial, hold, supplyOf(trial), all))
                each.push_back(*sums);
        }
    }
    const auto solved = all.solve();
    if (!solved || each.empty() || !(solved->values[0] > 0.0))
        return fail(Fault::OutOfRange, say("the current did not follow the duty, so its resistance is not known"),
            say("see that the motor is connected"));
    ohm.gain = 1.0 / solved->values[0];
    ohm.back = solved->values[1];
    ohm.backError = solved->errors[1];
    ohm.gainError = ohm.gain * solved->errors[0] / solved->values[0];
    for (const Sums &sums : each) {
        const double gain = sums.current / (sums.driven - solved->values[1] * sums.way);
        ohm.scatter = std::max(ohm.scatter, std::abs(gain / ohm.gain - 1.0));
    }
    return ohm;
}

PickUp pickUpOf(const std::vector<Trial> &pushes)
{
    Squares all;
    LeastSquares<1> withoutFriction;
    for (const Trial &trial : pushes) {
        for (const Span &hold : trial.holds) {
            const auto seen = isComplete(trial) ? speedingUp(trial, hold) : std::nullopt;
            if (!seen)
                continue;
            all.add({seen->first, -1.0}, seen->second);
            withoutFriction.add({seen->first}, seen->second);
        }
    }
    PickUp pickUp;
    if (const auto two = all.solve(); two && two->values[0] > two->errors[0] && two->values[1] >= 0.0)
        pickUp = {two->values[0], two->values[1] / two->values[0]};
    else if (const auto one = withoutFriction.solve())
        pickUp = {std::max(one->values[0], 0.0), 0.0};
    return pickUp;
}

double currentNoise(const std::vector<Trial> &pushes)
{
    double squares = 0.0;
    std::size_t count = 0;
    for (const Trial &trial : pushes) {
        const Signal *const current = trial.signal("current");
        const Trace rest = current ? current->trace.part(-restAhead, 0.0) : Trace();
        const double middle = median(rest.y);
        for (const double value : rest.y)
            squares += (value - middle) * (value - middle);
        count += rest.size();
    }
    return count > 0 ? std::sqrt(squares / static_cast<double>(count)) : 0.0;
}

Task<void> CurrentIdentification::identify(AutotuneRun &run)
{
    co_await probe(run);
    if (run.isOver())
        co_return {};
    co_await push(run);
    if (run.isOver())
        co_return {};
    co_return conclude(run);
}

/// Pushes that grow until the current is clear of its noise, and end well below its limit.
Task<void> CurrentIdentification::probe(AutotuneRun &run)
{
    co_await run.readEnvelope();
    const double most = std::min(mostForce, run.envelope().duty.value_or(1.0));
    const double room = currentRoom * run.envelope().current.value_or(1e3);
    for (double duty = std::min(firstForce, most);; duty = std::min(moreEachTime * duty, most)) {
        auto pushing = run.push({duty, forceTime, 1});
        const Trial trial = co_await std::move(pushing);
        if (run.isOver())
            co_return {};
        const double peak = trial.metrics.peakCurrent.value_or(0.0);
        if (peak > room)
            co_return fail(Fault::OutOfRange,
                say("a push of %1 duty drew %2 A, more than half of what is allowed", percentText(duty),
                    std::round(peak * 10.0) / 10.0),
                say("allow more current"));
        m_duty = duty;
        if (peak >= clearCurrent || moreEachTime * peak > room || duty >= most)
            co_return {};
    }
}

/// Of two sizes, both ways.
Task<void> CurrentIdentification::push(AutotuneRun &run)
{
    for (const double size : {m_duty, lighterForce * m_duty}) {
        for (const double sign : {1.0, -1.0}) {
            auto pushing = run.push({sign * size, forceTime, 1});
            m_pushes.push_back(co_await std::move(pushing));
            if (run.isOver())
                co_return {};
        }
    }
    co_return {};
}

Result<void> CurrentIdentification::conclude(AutotuneRun &run) const
{
    MB_TRY(const auto ohm, fitOhm(m_pushes));
    const double doubt = ohm.gainError / ohm.gain;
    MotorFound found;
    found.line.gain = ohm.gain;
    found.line.gainError = ohm.gainError;
    found.pushes.tau = electricalTime;
    found.supply = ohm.supply;
    found.unit = "A per duty";
    std::vector<Gate> gates{
        {"resistance", say("the pushes differ by %1 in their resistance, at most 15 %", percentText(ohm.scatter)),
            ohm.scatter <= mostUnlike, say("see whether brushes and plugs make contact")},
        {"fit", say("the resistance is known within %1, at most 10 %", percentText(doubt)), doubt <= mostDoubt,
            say("allow more current or duty")}};
    const double step = currentStep(ohm.gain, run.envelope());
    const double noise = currentNoise(m_pushes);
    gates.push_back({"resolution",
        say("a step of %1 stands in noise of %2, at most %3; the mean of %4 tells it", amperes(step), amperes(noise),
            amperes(mostNoise(step)), currentRepeats(noise, step)),
        noise <= mostNoise(step), say("this unit is for motors of more current")});
    PlantModel plant{ohm.gain, electricalTime, currentDelays * run.device().family().loop->cycle, 0.0};
    plant.backDuty = std::max(ohm.back, 0.0);
    plant.noise = noise;
    const PickUp pickUp = pickUpOf(m_pushes);
    plant.pickUp = pickUp.rate;
    plant.idle = pickUp.idle;
    plant.reading = readingOf(m_pushes);
    return run.take({std::move(found), plant, std::move(gates), std::nullopt});
}

} // namespace mb::tuning
