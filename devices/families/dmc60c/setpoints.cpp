// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/setpoints.h"

#include "wire/fixedpoint.h"

#include <algorithm>
#include <cmath>

namespace mb::dmc60c {
namespace {

constexpr double targetLow = -8388608.0;
constexpr double targetHigh = 8388607.0;
constexpr double greatestTarget = 100.0;
constexpr double greatestVoltage = 28.0;
constexpr double targetOne = 65536.0;
constexpr double loopsPerSecond = 2000.0;

struct Scale {
    ControlMode mode = ControlMode::NoDrive;
    double low = 0.0;
    double high = 0.0;
    double one = 1.0; ///< raw value of 1.0
};

Result<Scale> scaleOf(Mode mode)
{
    switch (mode) {
    case Mode::Off: return Scale{};
    case Mode::Duty: return Scale{ControlMode::Voltage, -1.0, 1.0, fullDuty}; // README.md#duty: never 32768
    case Mode::Velocity:
        return Scale{ControlMode::Velocity, targetLow * velocityPerSecond, targetHigh * velocityPerSecond,
            1.0 / velocityPerSecond};
    case Mode::Position: return Scale{ControlMode::Position, targetLow, targetHigh, 1.0};
    case Mode::Current: return Scale{ControlMode::Current, -greatestTarget, greatestTarget, targetOne};
    case Mode::Voltage: return Scale{ControlMode::VoltageCompensated, -greatestVoltage, greatestVoltage, targetOne};
    case Mode::Follow: return Scale{ControlMode::Follower, 1.0, maxDeviceNumber, 1.0};
    case Mode::RampPosition:
    case Mode::RampVelocity: break;
    }
    return fail(Fault::Unsupported, say("a DMC60C has no mode '%1'", toString(mode)));
}

Result<std::int32_t> targetOf(const SetPoint &setPoint, const Scale &scale, int device)
{
    const std::string name(toString(setPoint.mode));
    if (!std::isfinite(setPoint.target))
        return fail(Fault::OutOfRange, say("%1 needs a number", name));
    if (setPoint.target < scale.low || setPoint.target > scale.high) {
        const std::string unit(unitOf(setPoint.mode));
        return fail(Fault::OutOfRange,
            say("%1 %2 is outside %3 … %4", name, setPoint.target, scale.low, MessageNumber{scale.high, -1, unit}));
    }
    if (setPoint.mode == Mode::Follow && setPoint.target != std::floor(setPoint.target))
        return fail(Fault::OutOfRange, say("follow needs the number of a device"));
    if (setPoint.mode == Mode::Follow && static_cast<int>(setPoint.target) == device)
        return fail(Fault::OutOfRange, say("a device cannot follow itself"));
    const auto raw = toFixed(setPoint.target, scale.one);
    return static_cast<std::int32_t>(
        std::clamp<std::int64_t>(raw, static_cast<std::int64_t>(targetLow), static_cast<std::int64_t>(targetHigh)));
}

/// Duty per second into duty units per loop of 500 µs. The slowest ramp is 1, because 0 is none.
Result<std::uint16_t> rampOf(double dutyPerSecond)
{
    if (!std::isfinite(dutyPerSecond) || dutyPerSecond < 0.0)
        return fail(Fault::OutOfRange, say("the ramp must be 0 (immediate) or a positive number of duty per second"));
    if (dutyPerSecond == 0.0)
        return std::uint16_t{0};
    return static_cast<std::uint16_t>(std::lround(std::clamp(dutyPerSecond * fullDuty / loopsPerSecond, 1.0, 65535.0)));
}

} // namespace

Result<Control> controlFor(const SetPoint &setPoint, int device)
{
    if (setPoint.axis != 1)
        return fail(Fault::Unsupported, say("a DMC60C has one axis"));
    if (setPoint.slot != 0 && setPoint.slot != 1)
        return fail(Fault::Unsupported, say("a DMC60C has the gain slots 0 and 1"));
    MB_TRY(const auto scale, scaleOf(setPoint.mode));
    if (setPoint.mode == Mode::Off)
        return Control{};
    MB_TRY(const auto target, targetOf(setPoint, scale, device));
    MB_TRY(const auto ramp, rampOf(setPoint.ramp));
    Control control;
    control.mode = scale.mode;
    control.target = target;
    control.ramp = ramp;
    control.slot = setPoint.slot;
    control.brake = setPoint.brake;
    control.reverseMotor = setPoint.reverseMotor;
    control.reverseSensor = setPoint.reverseSensor && setPoint.mode != Mode::Follow;
    control.overrideLimits = setPoint.overrideLimits;
    control.disableForwardLimit = setPoint.disableForwardLimit;
    control.disableReverseLimit = setPoint.disableReverseLimit;
    return control;
}

std::optional<Mode> modeOf(ControlMode mode)
{
    switch (mode) {
    case ControlMode::Voltage: return Mode::Duty;
    case ControlMode::Velocity: return Mode::Velocity;
    case ControlMode::Position: return Mode::Position;
    case ControlMode::Current: return Mode::Current;
    case ControlMode::VoltageCompensated: return Mode::Voltage;
    case ControlMode::Follower: return Mode::Follow;
    case ControlMode::NoDrive: return Mode::Off;
    }
    return std::nullopt;
}

} // namespace mb::dmc60c
