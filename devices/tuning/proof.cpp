// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/proof.h"

#include "model/family.h"
#include "tuning/envelope.h"
#include "tuning/figures.h"
#include "tuning/gains.h"

#include <algorithm>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr double stepOfFreeSpeed = 0.3;
constexpr double stepOfLimit = 0.6;
constexpr double stepDuty = 0.5;   ///< that P alone makes of a position step, at its start
constexpr double deadbands = 10.0; ///< that a position step is clear of friction by
constexpr double helpOfFriction = 1.25;
constexpr double goodEnough = 4.0; ///< counts
constexpr double moreOvershoot = 0.05;
constexpr double moreSettle = 2.0;   ///< times
constexpr double laterSettle = 0.15; ///< s
constexpr double mostNoise = 0.005;  ///< of the step, with which settling can still be measured
constexpr double leastError = 0.02;  ///< of the step

void addNumber(const Family &family, const std::string &key, double number, ScaledGains &into)
{
    const auto index = findParameter(family.parameters, key);
    if (!index)
        return;
    if (const auto raw = toRaw(family.parameters[index->value], number)) {
        into.rows.push_back({key, *raw, number});
        into.changes.push_back({*index, *raw});
    }
}

} // namespace

double proofStep(Mode loop, const PlantModel &plant, const ContinuousGains &gains, const Envelope &envelope)
{
    const double duty = envelope.duty.value_or(1.0);
    if (loop == Mode::Position) {
        const double step
            = std::max(gains.p > 0.0 ? stepDuty * duty / gains.p : 0.0, deadbands * deadband(plant, gains));
        return std::round(std::min(step, stepOfLimit * envelope.travel.value_or(step)));
    }
    const double free = plant.gain * std::max(duty - plant.friction, 0.0);
    const double step = stepOfFreeSpeed * free;
    return std::round(std::min(step, stepOfLimit * envelope.speed.value_or(step)));
}

bool hasFrictionHelp(const Family &family)
{
    const LoopGains &loop = *loopOf(family, Mode::Position);
    return std::find(loop.names.begin(), loop.names.end(), "nominal_forward") != loop.names.end();
}

double restingError(const Family &family, const PlantModel &plant, const ContinuousGains &gains)
{
    const LoopScale &scale = *family.loop;
    if (gains.i <= 0.0)
        return deadband(plant, gains);
    return scale.integralStep / scale.fullDuty / (gains.i * scale.cycle);
}

void addFrictionHelp(const Family &family, int axis, int slot, const PlantModel &plant, ScaledGains &into)
{
    if (!hasFrictionHelp(family))
        return;
    const LoopGains &loop = *loopOf(family, Mode::Position);
    const double push = std::round(helpOfFriction * plant.friction * family.loop->fullDuty);
    const auto key = [&](std::string_view name) {
        return gainKey(family, std::string(loop.prefix) + std::string(name), axis, slot);
    };
    addNumber(family, key("nominal_forward"), push, into);
    addNumber(family, key("nominal_reverse"), -push, into);
    addNumber(family, key("allowable_error"), goodEnough, into);
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

std::string judgeProof(const Metrics &measured, const Metrics &predicted, double step, double resting)
{
    if (!measured.rise || !measured.overshoot)
        return "the response could not be measured";
    const double overshoot = predicted.overshoot.value_or(0.0) + moreOvershoot;
    if (*measured.overshoot > overshoot)
        return "it overshot by " + percentText(*measured.overshoot) + ", predicted were "
            + percentText(predicted.overshoot.value_or(0.0));
    const double settle = moreSettle * predicted.settle.value_or(*measured.rise * 4.0) + laterSettle;
    const bool blurred = !measured.settle && measured.noise.value_or(0.0) > mostNoise; // noise alone leaves the band
    if (!blurred && (!measured.settle || *measured.settle > settle))
        return measured.settle ? "it took " + millisecondsText(*measured.settle) + " to settle, predicted were "
                + millisecondsText(predicted.settle.value_or(0.0))
                               : "it did not settle";
    const double error = std::max(leastError, 1.2 * resting / std::abs(step));
    if (std::abs(measured.sse.value_or(0.0)) > error)
        return "it came to rest " + percentText(std::abs(*measured.sse)) + " of the step away from its target";
    return {};
}

} // namespace mb::tuning
