// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/proof.h"

#include "experiment/figures.h"
#include "experiment/verdict.h"
#include "model/family.h"
#include "model/loopparameters.h"
#include "tuning/adviser.h"
#include "tuning/leastsquares.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mb::tuning {
namespace {

constexpr double stepOfFreeSpeed = 0.3;
constexpr double stepOfLimit = 0.6;
constexpr double stepOfFriction = 0.6; ///< duty of a velocity step over friction: its integral overcomes it in two lags
constexpr double mostOfFreeSpeed = 0.5; ///< or there is nothing to speed up with
constexpr double stepDuty = 0.5;        ///< that P alone makes of a position step, at its start
constexpr double deadbands = 10.0;      ///< that a position step is clear of friction by
constexpr int fewCurrents = 6;
constexpr int manyCurrents = 30;
constexpr double noiseOfOne = 0.06;  ///< of a step of a current, σ with which one would be enough
constexpr double stillSeconds = 0.5; ///< share of a proof in which friction holds the motor before its target
constexpr double windupOverFriction = 1.5;
constexpr double leastWindup = 0.1; ///< duty
constexpr double edgesOfOne = 4.0;  ///< of LoopScale::velocityEdges
constexpr double goodEnough = 4.0;  ///< counts
constexpr double goodSteps = 100.0; ///< of these a position step has at least
constexpr double moreOvershoot = 0.05;
constexpr double mostOvershoot = 0.075;  ///< whatever was predicted
constexpr std::size_t fewestOfDroop = 8; ///< positions that tell how it speeds up
constexpr double blurOfNoise = 2.0;      ///< σ, by which a peak of many samples is beyond its curve
constexpr double mostBlur = 0.05;        ///< of the step
constexpr double moreSettle = 2.0;       ///< times
constexpr double laterSettle = 0.15;     ///< s
constexpr double quietNoise = 0.005;     ///< of the step, with which settling can still be measured
constexpr double endOfHold = 0.25;
constexpr double leastError = 0.02; ///< of the step
constexpr double proofSettles
    = 2.5; ///< predicted times to settle that a proof holds its step: twice may pass until it has settled
constexpr double proofCreeps = 2.0;    ///< times of the integral, in which it creeps to its target, at least
constexpr double slowProof = 1.2;      ///< s, that a slow one waits at most beyond what was predicted
constexpr double proofRest = 0.3;      ///< s longer
constexpr double leastProof = 0.7;     ///< s
constexpr double countedProof = 2.0;   ///< s, of a velocity that is counted over edges: swinging grows slowly
constexpr double longestProof = 5.0;   ///< s
constexpr double unknownSettle = 1.5;  ///< s, where none was predicted
constexpr double currentSettles = 4.0; ///< of a current loop
constexpr double leastCurrent = 0.08;  ///< s that it is held
constexpr double longestCurrent = 0.2; ///< s
constexpr double roomOfProof = 0.85;   ///< of what is left one way
constexpr double leastDeadbands = 3.0;
constexpr double leastReadings = 10.0;  ///< of a speed; of a position as many times what is good enough
constexpr double leastOfFriction = 0.3; ///< duty of a velocity step over friction
constexpr double stopsLate = 0.1;       ///< s, after which a stop is in force, at most

void addNumber(const Family &family, std::optional<ParameterIndex> index, double number, ScaledGains &into)
{
    if (!index)
        return;
    const Parameter &parameter = family.parameters[index->value];
    if (const auto raw = toRaw(parameter, number)) {
        std::erase_if(into.rows, [&](const ScaledGains::Row &row) { return row.key == parameter.key; });
        std::erase_if(into.changes, [&](const ParameterChange &change) { return change.index == *index; });
        into.rows.push_back({std::string(parameter.key), *raw, number, parameter.role});
        into.changes.push_back({*index, *raw});
    }
}

/// On any of its axes, in any of its slots.
bool hasRole(const Family &family, Role role)
{
    return parameterOf(family, Mode::Position, 1, 0, role).has_value();
}

/// With room for its overshoot; a limit that nobody knows bounds nothing.
double withinLimit(double step, const std::optional<double> &limit)
{
    return std::round(limit ? std::min(step, stepOfLimit * *limit) : step);
}

/// Duty that moves it on and from rest.
double helpOf(const PlantModel &plant)
{
    return std::max(helpOverFriction * plant.friction, plant.breakaway);
}

/// Enough for friction and some load, not enough to fly past the target.
double windupOf(const PlantModel &plant)
{
    return std::min(windupOverFriction * plant.friction + leastWindup, 1.0);
}

} // namespace

double proofStep(Mode loop, const PlantModel &plant, const ContinuousGains &gains, const Envelope &envelope)
{
    const double duty = envelope.duty.value_or(1.0);
    if (loop == Mode::Position) {
        const double step = std::max({gains.p > 0.0 ? stepDuty * duty / gains.p : 0.0,
            deadbands * deadband(plant, gains), goodSteps * goodEnough});
        return withinLimit(step, envelope.travel);
    }
    const double free = plant.gain * std::max(duty - plant.friction, 0.0);
    const double clear = stepOfFriction * plant.gain * plant.friction;
    return withinLimit(std::clamp(clear, stepOfFreeSpeed * free, mostOfFreeSpeed * free), envelope.speed);
}

int currentRepeats(double noise, double step)
{
    const double over = noise / (noiseOfOne * std::abs(step)); // the noise of a mean goes with the root of their number
    return static_cast<int>(std::clamp(std::ceil(over * over), 1.0 * fewCurrents, 1.0 * manyCurrents));
}

double mostNoise(double step)
{
    return noiseOfOne * std::abs(step) * std::sqrt(1.0 * manyCurrents);
}

bool hasFrictionHelp(const Family &family)
{
    return hasRole(family, Role::LeastForward);
}

RestingError restingError(
    Mode loop, const LoopShape &shape, const PlantModel &plant, const ContinuousGains &gains, double seconds)
{
    using Below = RestingError::Below;
    if (loop == Mode::Position && shape.leastOutput > plant.friction)
        return {shape.goodEnough, Below::Allowed};
    const double held = deadband(plant, gains);
    if (gains.i <= 0.0)
        return {held, Below::Motor};
    const double unmoved = shape.integralStep / (gains.i * shape.period);
    if (loop != Mode::Position)
        return {unmoved, Below::Integral};
    const double late = plant.friction / (gains.p + gains.i * stillSeconds * seconds);
    if (late >= unmoved)
        return {late, Below::Time};
    return unmoved < held ? RestingError{unmoved, Below::Integral} : RestingError{held, Below::Motor};
}

void addFrictionHelp(const Family &family, Mode loop, int axis, int slot, const PlantModel &plant, ScaledGains &into)
{
    const bool isPosition = loop == Mode::Position;
    const auto row = [&](Role role) { return parameterOf(family, loop, axis, slot, role); };
    if (const auto windup = isPosition ? row(Role::IntegralLimit) : std::nullopt)
        addNumber(family, windup, std::round(windupOf(plant) * family.loop->fullDuty), into);
    if (!hasFrictionHelp(family))
        return;
    const double push = isPosition ? std::round(helpOf(plant) * family.loop->fullDuty) : 0.0;
    addNumber(family, row(Role::LeastForward), push, into);
    addNumber(family, row(Role::LeastReverse), 0.0 - push, into);
    if (isPosition)
        addNumber(family, row(Role::AllowableError), goodEnough, into);
}

void freeIntegral(const Family &family, Mode loop, int axis, int slot, ScaledGains &into)
{
    if (into.made.i == 0.0)
        return;
    addNumber(family, parameterOf(family, loop, axis, slot, Role::IntegralZone), 0.0, into);
    const bool isHelped
        = std::ranges::any_of(into.rows, [](const ScaledGains::Row &row) { return row.role == Role::AllowableError; });
    if (!isHelped)
        addNumber(family, parameterOf(family, loop, axis, slot, Role::AllowableError), 0.0, into);
}

bool hasOutputLimits(const Family &family)
{
    return hasRole(family, Role::MostForward);
}

void limitOutput(
    const Family &family, Mode loop, int axis, int slot, double duty, const KnownGains &now, ScaledGains &into)
{
    const auto ownOf = [&family, &now](const std::optional<ParameterIndex> &index) {
        const auto own = index
            ? std::ranges::find(now, family.parameters[index->value].key, &KnownGains::value_type::first)
            : now.end();
        return own == now.end() || !own->second ? std::numeric_limits<double>::infinity() : std::abs(*own->second);
    };
    const auto forward = parameterOf(family, loop, axis, slot, Role::MostForward);
    if (duty >= 1.0 || !forward || !family.loop)
        return;
    const double most = std::floor(duty * family.loop->fullDuty);
    if (most >= ownOf(forward)) // it is the slot's own limit, which may be of one direction
        return;
    for (const auto &[index, sign] :
        {std::pair(forward, 1.0), std::pair(parameterOf(family, loop, axis, slot, Role::MostReverse), -1.0)}) {
        if (index)
            addNumber(family, index, most > 0.0 ? sign * std::min(most, ownOf(index)) : 0.0, into);
    }
}

VelocityTaking velocityTaking(const Device &device, double speed, const std::optional<VelocityFilter> &found)
{
    const LoopScale &scale = *device.family().loop;
    double window = scale.velocityWindow;
    const auto index = findParameter(device.family().parameters, scale.velocityEdges);
    const auto edges = index ? device.parameters().entry(*index).raw : std::nullopt;
    const double counts = edges ? edgesOfOne * static_cast<double>(*edges) : 0.0;
    if (counts > 0.0 && speed != 0.0)
        window = std::max(counts / std::abs(speed), scale.cycle);
    if (window > 0.0)
        return {window, 0.5 * window, counts};
    if (!found)
        return {};
    return {found->kind == VelocityFilter::Kind::Rolling ? found->window : 0.0, found->delay, 0.0};
}

LoopShape shapeOf(
    const Family &family, Mode loop, const PlantModel &plant, const Envelope &envelope, const VelocityTaking &taking)
{
    const LoopScale &scale = *family.loop;
    LoopShape shape;
    shape.period = scale.cycle;
    shape.mostDuty = envelope.duty.value_or(1.0);
    shape.outputStep = 1.0 / scale.fullDuty;
    shape.integralStep = scale.integralStep / scale.fullDuty;
    shape.clock = scale.clock;
    shape.isCounted = loop != Mode::Current;
    if (loop == Mode::Velocity) {
        shape.window = std::min(taking.window, 2.0 * plant.delay);
        shape.windowCounts = taking.counts;
    }
    if (loop == Mode::Position && hasRole(family, Role::IntegralLimit))
        shape.integralMost = windupOf(plant);
    if (loop == Mode::Position && hasFrictionHelp(family)) {
        shape.leastOutput = helpOf(plant);
        shape.goodEnough = goodEnough;
    }
    return shape;
}

double proofHold(Mode loop, const ContinuousGains &gains, const Prediction &predicted)
{
    const double settle = predicted.metrics.settle.value_or(unknownSettle);
    if (loop == Mode::Current)
        return std::clamp(currentSettles * settle, leastCurrent, longestCurrent);
    const double creeps = loop == Mode::Velocity && gains.i > 0.0 ? gains.p / gains.i : 0.0;
    const double least = predicted.shape.windowCounts > 0.0 ? countedProof : leastProof;
    return std::clamp(std::max(std::min(proofSettles * settle, settle + slowProof), proofCreeps * creeps) + proofRest,
        least, longestProof);
}

double wayOfProof(const PlantModel &plant, double step, double hold, int repeats)
{
    return std::abs(step) * (repeats * hold + plant.tau + stopsLate);
}

int repeatsWithin(
    const std::optional<double> &room, Mode loop, const PlantModel &plant, double step, double hold, int asked)
{
    if (loop != Mode::Velocity || !room)
        return asked;
    int repeats = asked;
    while (repeats > 1 && wayOfProof(plant, step, hold, repeats) > roomOfProof * *room)
        --repeats;
    return repeats;
}

double leastProofStep(const Family &family, Mode loop, const PlantModel &plant, const ContinuousGains &gains)
{
    if (loop == Mode::Position)
        return std::max(leastDeadbands * deadband(plant, gains), leastReadings * goodEnough);
    return std::max(leastReadings / family.loop->velocityTime, leastOfFriction * plant.gain * plant.friction);
}

Metrics worseOf(const std::vector<Trial> &trials)
{
    Metrics worst = trials.empty() ? Metrics() : trials.front().metrics;
    for (const Trial &trial : trials) {
        for (const MetricKey &key : metricKeys()) {
            auto &value = worst.*key.value;
            const auto &other = trial.metrics.*key.value;
            if (!value || !other)
                value.reset();
            else if (std::abs(*other) > std::abs(*value))
                value = other;
        }
    }
    return worst;
}

double droopOf(const std::vector<Trial> &trials, const PlantModel &plant, const ContinuousGains &gains)
{
    double acceleration = 0.0; // counts/s²
    double step = 0.0;         // A, of the reading
    for (const Trial &trial : trials) {
        if (const Signal *const current = trial.signal("current"))
            step = std::max(step, resolutionOf(current->trace));
        const Signal *const position = trial.signal("position");
        for (const Span &hold : trial.holds) {
            const Trace way = position ? position->trace.part(hold.from, hold.to) : Trace();
            if (way.size() < fewestOfDroop)
                continue;
            const double half = 0.5 * (way.t.back() - way.t.front()); // it may still turn from the step before
            const double bent = way.y.back() - 2.0 * valueAt(way, way.t.front() + half) + way.y.front();
            acceleration = std::max(acceleration, std::abs(bent) / (half * half));
        }
    }
    return (gains.i > 0.0 ? plant.backDuty * acceleration / gains.i : 0.0) + 0.5 * step;
}

std::optional<double> restOfCurrent(const std::vector<Trial> &trials)
{
    std::optional<double> worst;
    for (const Trial &trial : trials) {
        const Signal *const current = trial.signal("current");
        LeastSquares<1> rest;
        for (const Span &hold : trial.holds) {
            const Trace end
                = current ? current->trace.part(hold.to - endOfHold * (hold.to - hold.from), hold.to) : Trace();
            for (const double value : end.y)
                rest.add({1.0}, (trial.stimulus.to - value) / (trial.stimulus.to - trial.stimulus.from));
        }
        const auto mean = rest.solve();
        if (!mean)
            return std::nullopt;
        if (!worst || std::abs(mean->values[0]) > std::abs(*worst))
            worst = mean->values[0];
    }
    return worst;
}

ProofLimits proofLimits(const Metrics &predicted, double step, double resting)
{
    ProofLimits limits;
    limits.overshoot = std::min(predicted.overshoot.value_or(0.0) + moreOvershoot, mostOvershoot);
    if (predicted.settle)
        limits.settle = moreSettle * *predicted.settle + laterSettle;
    limits.error = std::max(leastError, 1.2 * resting / std::abs(step));
    return limits;
}

Message judgeProof(const Metrics &measured, const Metrics &predicted, double step, double resting)
{
    if (Message shortfall = shortfallOf(measured); !shortfall.empty())
        return shortfall;
    if (!measured.rise || !measured.overshoot)
        return say("the response could not be measured");
    const double blur = std::min(blurOfNoise * measured.noise.value_or(0.0), mostBlur);
    const ProofLimits limits = proofLimits(predicted, step, resting);
    const double overshoot = limits.overshoot + blur;
    if (*measured.overshoot > overshoot)
        return say("it overshot by %1, predicted were %2", percentText(*measured.overshoot),
            percentText(predicted.overshoot.value_or(0.0)));
    const double settle = limits.settle.value_or(moreSettle * *measured.rise * 4.0 + laterSettle);
    const bool blurred = !measured.settle && measured.noise.value_or(0.0) > quietNoise; // noise alone leaves the band
    if (!blurred && (!measured.settle || *measured.settle > settle))
        return measured.settle ? say("it took %1 to settle, predicted were %2", millisecondsText(*measured.settle),
                   millisecondsText(predicted.settle.value_or(0.0)))
                               : say("it did not settle");
    if (std::abs(measured.sse.value_or(0.0)) > limits.error)
        return say("it came to rest %1 of the step away from its target", percentText(std::abs(*measured.sse)));
    return {};
}

} // namespace mb::tuning
