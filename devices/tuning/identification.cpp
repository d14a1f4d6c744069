// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/identification.h"

#include "experiment/figures.h"
#include "tuning/crosscheck.h"
#include "tuning/pushedge.h"
#include "tuning/rollout.h"
#include "tuning/windingheat.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

namespace mb::tuning {
namespace {

constexpr double beforePush = 0.05; ///< s of rest that a record begins with
constexpr double restSeconds = 0.25;
constexpr std::size_t leastRestSamples = 5;
constexpr double clearOfNoise = 3.0; ///< σ, and a count, that a motion is
constexpr double mostCost = 3.0;
constexpr double mostAsymmetry = 0.10;
constexpr double mostCrossCheck = 0.15;
constexpr double leastCounts = 50.0;
constexpr double mostFrictionShare = 0.7; ///< of the smallest push
constexpr double nearLimit = 0.98;
constexpr double brokenGrowth = 1.5; ///< times what is usual
constexpr double leastPause = 0.04;  ///< s
constexpr double sameSize = 0.15;
constexpr double heatOfItself
    = 0.25; ///< of what a push and the brake after it leave in the winding, while it speeds up

/// While the duty still grows, nothing is fitted.
Trace without(const Trace &trace, double from, double to)
{
    Trace rest;
    for (std::size_t i = 0; i < trace.size(); ++i) {
        if (trace.t[i] <= from || trace.t[i] >= to)
            rest.add(trace.t[i], trace.y[i]);
    }
    return rest;
}

double meanOver(const Trace &trace, double from, double to, double otherwise)
{
    const Trace part = trace.part(from, to);
    if (part.isEmpty())
        return otherwise;
    double sum = 0.0;
    for (const double value : part.y)
        sum += value;
    return sum / static_cast<double>(part.size());
}

/// The supply before the first push; 0 where it is not told.
double restVoltage(const Trial &trial)
{
    const Signal *const bus = trial.signal("bus_voltage");
    return bus ? meanOver(bus->trace, -1.0, 0.0, bus->trace.isEmpty() ? 0.0 : bus->trace.y.front()) : 0.0;
}

/// A device that is led to its duty in steps waits on its way where the order of one of them is lost: such a push is none of one duty.
/// It goes where the others are enough without it: of both sizes and both ways.
void leaveOutBroken(std::vector<PushRecord> &records)
{
    std::vector<double> growths;
    for (const PushRecord &record : records)
        growths.push_back(record.growth / std::abs(record.duty));
    const double usual = median(growths);
    const auto isBroken = [&](const PushRecord &record) {
        return record.growth > brokenGrowth * usual * std::abs(record.duty) + leastPause;
    };
    const auto isAlike = [](const PushRecord &one, const PushRecord &other) {
        return std::abs(one.duty - other.duty) < sameSize * std::abs(one.duty);
    };
    std::vector<PushRecord> whole;
    std::copy_if(records.begin(), records.end(), std::back_inserter(whole), std::not_fn(isBroken));
    const bool enough = std::ranges::all_of(records, [&](const PushRecord &one) {
        return std::ranges::any_of(whole, [&](const PushRecord &other) { return isAlike(one, other); });
    });
    if (enough)
        records = std::move(whole);
}

/// σ of its positions while it was about to be pushed.
std::optional<double> restNoiseOf(const Trial &trial)
{
    const Signal *const position = trial.signal("position");
    const Trace rest = position && !trial.holds.empty()
        ? position->trace.part(trial.holds.front().from - restSeconds, trial.holds.front().from)
        : Trace();
    if (rest.size() < leastRestSamples)
        return std::nullopt;
    double mean = 0.0;
    double squares = 0.0;
    const double first = rest.y.front(); // a position that does not change has no noise, however large it is
    for (const double y : rest.y)
        mean += (y - first) / static_cast<double>(rest.size());
    for (const double y : rest.y)
        squares += (y - first - mean) * (y - first - mean);
    return std::sqrt(squares / static_cast<double>(rest.size() - 1));
}

/// What its orders took until the motor was seen to move their way, each.
void addLatencies(const Trial &trial, double noise, std::vector<double> &latencies)
{
    const Signal *const position = trial.signal("position");
    const double sign = trial.stimulus.to > 0.0 ? 1.0 : -1.0;
    for (const Span &hold : trial.holds) {
        const Trace before = position ? position->trace.part(hold.from - beforePush, hold.from) : Trace();
        if (before.isEmpty())
            continue;
        const Trace after = position->trace.part(hold.from, hold.to);
        for (std::size_t i = 0; i < after.size(); ++i) {
            if (sign * (after.y[i] - before.y.back()) >= 1.0 + clearOfNoise * noise) {
                latencies.push_back(after.t[i] - hold.from);
                break;
            }
        }
    }
}

bool growsSlowly(const std::vector<Trial> &pushes)
{
    return std::ranges::any_of(pushes, [](const Trial &trial) {
        return std::ranges::any_of(trial.holds, [&](const Span &hold) {
            const Edge edge = edgeOf(trial, hold.from, 0.0);
            return edge.whole > edge.at;
        });
    });
}

} // namespace

std::vector<PushRecord> pushesOf(const Trial &trial, double friction)
{
    std::vector<PushRecord> records;
    const Signal *const position = trial.signal("position");
    const Signal *const duty = trial.signal("duty");
    const Signal *const bus = trial.signal("bus_voltage");
    const double rest = restVoltage(trial);
    const double target = trial.stimulus.to;
    for (const Span &hold : trial.holds) {
        if (!position || target == 0.0)
            break;
        const auto [edge, whole, steps] = edgeOf(trial, hold.from, friction);
        PushRecord record;
        record.steps = steps;
        record.position = without(position->trace.part(std::min(edge, hold.from) - beforePush, hold.to, edge),
            hold.from - edge, whole - edge);
        record.growth = whole - edge;
        record.duty = duty ? meanOver(duty->trace, whole + 0.01, hold.to, target) : target;
        if (bus && rest > 0.0)
            record.duty *= meanOver(bus->trace, 0.5 * (edge + hold.to), hold.to, rest) / rest;
        if (!record.position.isEmpty() && std::abs(record.position.y.back() - record.position.y.front()) >= leastCounts)
            records.push_back(std::move(record));
    }
    return records;
}

/// Once without friction, and once more with what was found: where a duty grows slowly, it tells when the motor was free.
Result<MotorFound> identify(const std::vector<Trial> &pushes, double cycle)
{
    MotorFound found;
    found.restNoise = pushes.empty() ? std::nullopt : restNoiseOf(pushes.front());
    std::vector<double> latencies;
    for (const Trial &trial : pushes) {
        addLatencies(trial, found.restNoise.value_or(0.0), latencies);
        if (found.supply == 0.0)
            found.supply = restVoltage(trial);
        const Signal *const velocity = trial.signal("velocity");
        const Signal *const position = trial.signal("position");
        if (!found.filter && velocity && position)
            found.filter = fingerprint(position->trace, velocity->trace);
    }
    if (!latencies.empty())
        found.latency = median(std::move(latencies));
    for (int pass = 0; pass < 2; ++pass) {
        std::vector<PushRecord> records;
        double heat = 0.0;
        for (const Trial &trial : pushes) {
            for (PushRecord &record : pushesOf(trial, found.line.friction)) {
                record.heat = heat + heatOfItself * record.duty * record.duty;
                heat = heatThatStays * (heat + record.duty * record.duty);
                records.push_back(std::move(record));
            }
        }
        leaveOutBroken(records);
        std::vector<double> duties;
        for (const PushRecord &record : records)
            duties.push_back(record.duty);
        MB_TRY(const auto fit, fitPushes(records, cycle));
        found.pushes = fit;
        MB_TRY(const auto line, fitGain(duties, fit.speeds));
        found.line = line;
        std::vector<RollOut> rolls;
        for (const Trial &trial : pushes) {
            const auto more = rollOutsOf(trial, fit, line.friction);
            rolls.insert(rolls.end(), more.begin(), more.end());
        }
        found.heat = heat / heatThatStays;
        const double warm = 1.0 + fit.warming * found.heat;
        found.braking
            = brakingOf(rolls, fit.tau * sagged(fit.sag, 0.0) * warm, line.gain * line.friction).value_or(1.0);
        if (!growsSlowly(pushes))
            break;
    }
    return found;
}

namespace {

/// Another way to the same lag: it decides nothing, and is told where it comes out elsewhere.
void addCrossCheck(const MotorFound &found, const std::vector<Trial> &pushes, std::vector<Gate> &gates)
{
    std::vector<PushRecord> records;
    for (const Trial &trial : pushes) {
        for (PushRecord &record : pushesOf(trial, found.line.friction))
            records.push_back(std::move(record));
    }
    leaveOutBroken(records);
    const auto lag = lagByRegression(records, found.pushes);
    if (!lag)
        return;
    const double off = *lag / found.pushes.tau - 1.0;
    Gate gate{"cross-check",
        say("a regression of mean speeds makes the lag %1, %2 beside what was fitted", millisecondsText(*lag),
            percentText(off)),
        true, {}};
    gate.warns = std::abs(off) > mostCrossCheck;
    gates.push_back(std::move(gate));
}

} // namespace

std::vector<Gate> gatesOf(const MotorFound &found, const std::vector<Trial> &pushes)
{
    double smallest = 1.0;
    bool limited = false;
    for (const Trial &trial : pushes) {
        smallest = std::min(smallest, std::abs(trial.stimulus.to));
        limited = limited || trial.has(flag::currentLimit)
            || (trial.envelope.current
                && trial.metrics.peakCurrent.value_or(0.0) >= nearLimit * *trial.envelope.current);
    }
    const double cost = std::round(found.pushes.cost * 100.0) / 100.0;
    std::vector<Gate> gates;
    gates.push_back(
        {"fit", say("residual %1 of what counts and clocks explain, at most 3", cost), found.pushes.cost <= mostCost});
    gates.push_back({"friction",
        say("friction takes %1 duty of pushes of %2", percentText(found.line.friction), percentText(smallest)),
        found.line.friction <= mostFrictionShare * smallest, say("allow more duty")});
    gates.push_back(
        {"asymmetric load", say("the two directions differ by %1, at most 10 %", percentText(found.line.asymmetry())),
            found.line.asymmetry() <= mostAsymmetry, say("see whether a load always pulls one way")});
    addCrossCheck(found, pushes, gates);
    gates.push_back({"current limit",
        limited ? say("the current limit cut into the pushes") : say("no push met the current limit"), !limited});
    return gates;
}

} // namespace mb::tuning
