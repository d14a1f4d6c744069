// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/gainrules.h"

#include "async/message.h"
#include "tuning/margins.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr double slower = 1.05;
constexpr int mostSlowings = 120;
constexpr double offGain = 1.2;
constexpr double offDelay = 1.3;
constexpr double dampingOfPosition = 1.0;
constexpr double profileShare = 0.8; ///< of what the motor can

struct AimName {
    Aim aim;
    std::string_view name;
};
constexpr std::array<AimName, 3> aims{
    {{Aim::Calm, MB_LABEL("calm")}, {Aim::Normal, MB_LABEL("normal")}, {Aim::Brisk, MB_LABEL("brisk")}}};

ContinuousGains rule(Mode loop, const PlantModel &plant, double response, double integralWeight)
{
    if (loop == Mode::Position && integralWeight > 0.0)
        return positionRuleWithIntegral(plant, 1.0 / response, dampingOfPosition, integralWeight);
    if (loop == Mode::Position)
        return positionRule(plant, 1.0 / response, dampingOfPosition);
    return loop == Mode::Current ? currentRule(plant, response) : velocityRule(plant, response);
}

bool isNoisy(const ContinuousGains &gains, const LoopBounds &bounds)
{
    return bounds.period > 0.0 && gains.d / bounds.period > bounds.derivativeShare * (1.0 + 1e-9); // of one count
}

bool isLikeARelay(const ContinuousGains &gains, const LoopBounds &bounds)
{
    return bounds.largestError > 0.0 && gains.p * bounds.largestError > bounds.strongestError;
}

} // namespace

std::string_view toString(Aim aim)
{
    return std::ranges::find(aims, aim, &AimName::aim)->name;
}

std::optional<Aim> aimFromString(std::string_view text)
{
    for (const AimName &known : aims) {
        if (known.name == text)
            return known.aim;
    }
    return std::nullopt;
}

ContinuousGains velocityRule(const PlantModel &plant, double response)
{
    const double lag = response + plant.delay;
    const double p = plant.tau / (plant.gain * lag);
    return {p, p / std::min(plant.tau, 4.0 * lag), 0.0, 0.0};
}

ContinuousGains positionRule(const PlantModel &plant, double omega, double zeta)
{
    const double d = (2.0 * zeta * omega * plant.tau - 1.0) / plant.gain;
    const double natural = d > 0.0 ? omega : std::min(omega, 1.0 / (2.0 * zeta * plant.tau));
    return {plant.tau * natural * natural / plant.gain, 0.0, std::max(d, 0.0), 0.0};
}

ContinuousGains positionRuleWithIntegral(const PlantModel &plant, double omega, double zeta, double alpha)
{
    const double scale = plant.tau * omega / plant.gain;
    return {scale * omega * (1.0 + 2.0 * zeta * alpha), scale * omega * omega * alpha,
        std::max((plant.tau * omega * (2.0 * zeta + alpha) - 1.0) / plant.gain, 0.0), 0.0};
}

ContinuousGains currentRule(const PlantModel &plant, double lambda)
{
    const double i = 1.0 / (plant.gain * (lambda + plant.delay));
    return {plant.tau * i, i, 0.0, 0.0};
}

double responseOf(Mode loop, Aim aim, const PlantModel &plant)
{
    const auto step = static_cast<std::size_t>(aim);
    if (loop == Mode::Current)
        return std::array<double, 3>{0.003, 0.002, 0.0015}[step];
    if (loop == Mode::Position)
        return plant.delay / std::array<double, 3>{0.1, 0.2, 0.25}[step];
    return plant.delay * std::array<double, 3>{3.0, 1.5, 1.0}[step];
}

ProfileLimits profileLimits(const PlantModel &plant, double duty)
{
    const double speed = profileShare * plant.gain * std::max(duty - plant.friction, 0.0);
    return {speed, plant.tau > 0.0 ? speed / plant.tau : 0.0};
}

bool hasMargin(
    Mode loop, const PlantModel &plant, const ContinuousGains &gains, double mostMs, double mostMsOff, int points)
{
    PlantModel off = plant;
    off.gain *= offGain;
    off.delay *= offDelay;
    return marginsOf(loop, plant, gains, points).ms <= mostMs && marginsOf(loop, off, gains, points).ms <= mostMsOff;
}

bool isWithin(const ContinuousGains &gains, const LoopBounds &bounds)
{
    return !isNoisy(gains, bounds) && !isLikeARelay(gains, bounds);
}

Design design(
    Mode loop, const PlantModel &plant, double response, const LoopBounds &bounds, double mostMs, double mostMsOff)
{
    Design result;
    result.response = result.asked = response;
    const auto bound = [&result](std::string_view name) {
        if (std::ranges::find(result.bounds, name) == result.bounds.end())
            result.bounds.push_back(name);
    };
    for (int round = 0; round < mostSlowings; ++round, result.response *= slower) {
        result.gains = rule(loop, plant, result.response, bounds.integralWeight);
        if (isNoisy(result.gains, bounds))
            bound(designBounds[0]);
        else if (isLikeARelay(result.gains, bounds))
            bound(designBounds[1]);
        else if (!hasMargin(loop, plant, result.gains, mostMs, mostMsOff))
            bound(designBounds[2]);
        else
            break;
    }
    return result;
}

double deadband(const PlantModel &plant, const ContinuousGains &gains)
{
    return gains.p > 0.0 ? plant.friction / gains.p : 0.0;
}

double conflictArea(const PlantModel &plant, const ContinuousGains &gains, double response, double step)
{
    if (gains.i <= 0.0 || step == 0.0)
        return 0.0;
    const double area = ((1.0 - gains.f * plant.gain) / plant.gain + plant.friction / std::abs(step)) / gains.i;
    return std::max(response + plant.delay - area, 0.0);
}

} // namespace mb::tuning
