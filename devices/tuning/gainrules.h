// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/message.h"
#include "model/setpoint.h"
#include "tuning/plantmodel.h"

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace mb::tuning {

constexpr double leastGainSteps = 50.0; ///< of a gain's integer, with which it can be set finely

enum class Aim { Calm, Normal, Brisk };
[[nodiscard]] std::string_view toString(Aim aim);
[[nodiscard]] std::optional<Aim> aimFromString(std::string_view text);

/// SIMC: the closed loop answers like a lag of `response` seconds behind the delay.
[[nodiscard]] ContinuousGains velocityRule(const PlantModel &plant, double response);
/// Pole placement of a PD loop: natural frequency `omega` rad/s, damping `zeta`. Without D (0) where the motor's own damping is
/// more than that; P is then what `zeta` allows.
[[nodiscard]] ContinuousGains positionRule(const PlantModel &plant, double omega, double zeta = 1.0);
/// The same with an integral of weight `alpha`, for loops that must hold a load.
[[nodiscard]] ContinuousGains positionRuleWithIntegral(
    const PlantModel &plant, double omega, double zeta, double alpha);
/// Lambda tuning of a current loop; `plant.tau` is L/R.
[[nodiscard]] ContinuousGains currentRule(const PlantModel &plant, double lambda);

/// The closed loop that an aim means: s of response in a velocity or current loop, 1/omega in a position loop.
[[nodiscard]] double responseOf(Mode loop, Aim aim, const PlantModel &plant);

/// What set-points may ask of a motor at this duty and still be followed: four fifths of what it can.
struct ProfileLimits {
    double speed = 0.0;        ///< counts/s
    double acceleration = 0.0; ///< counts/s²

    friend bool operator==(const ProfileLimits &, const ProfileLimits &) = default;
};
[[nodiscard]] ProfileLimits profileLimits(const PlantModel &plant, double duty);

/// What the loop of a device can carry.
struct LoopBounds {
    double period = 0.0;          ///< s, of the device's loop; 0: unknown
    double derivativeShare = 0.1; ///< of full duty that one count may make through D
    double strongestError = 3.0;  ///< full duties that P may make of the largest error
    double integralWeight = 0.0;  ///< of a position loop that must overcome friction by itself; 0: no integral
    double largestError = 0.0;    ///< in the unit of the loop; 0: unknown
};

/// What may keep a loop from being as quick as was asked for: labels of the table.
inline constexpr std::array<std::string_view, 3> designBounds{
    MB_LABEL("derivative noise"), MB_LABEL("largest error"), MB_LABEL("margin")};

/// Gains for this loop, and what kept them from being as quick as was asked for. `response` as of responseOf().
struct Design {
    ContinuousGains gains;
    double response = 0.0;                ///< s, as it came out
    double asked = 0.0;                   ///< s, as it was asked for
    std::vector<std::string_view> bounds; ///< of designBounds; empty: none
};
/// The sensitivity peak is at most `mostMs` on the model, and `mostMsOff` with 20 % more gain and 30 % more delay.
[[nodiscard]] bool hasMargin(Mode loop, const PlantModel &plant, const ContinuousGains &gains, double mostMs,
    double mostMsOff, int points = 400);
/// Neither one count nor the largest error makes more output than `bounds` allow.
[[nodiscard]] bool isWithin(const ContinuousGains &gains, const LoopBounds &bounds);
/// Within `bounds`, and with a sensitivity peak of `mostMs` at most on the model (and `mostMsOff` where the gain is 20 % and the
/// delay 30 % more than thought): slower until they hold.
[[nodiscard]] Design design(Mode loop, const PlantModel &plant, double response, const LoopBounds &bounds,
    double mostMs = 1.6, double mostMsOff = 1.9);

/// Duty that friction keeps the loop from using: the error at rest of a loop without I, in its unit.
[[nodiscard]] double deadband(const PlantModel &plant, const ContinuousGains &gains);
/// By how much the area under the error comes short of the unavoidable lag: what a feed-forward and an integral that fight each
/// other must give back as overshoot, in seconds of the step. 0: none.
[[nodiscard]] double conflictArea(const PlantModel &plant, const ContinuousGains &gains, double response, double step);

} // namespace mb::tuning
