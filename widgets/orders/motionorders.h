// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/session.h"
#include "model/setpoint.h"
#include "model/setpointstream.h"

#include <chrono>

/// Orders to motors. STOP is none of them: it has its own lane (Workbench::stopAll). Timeout when the device is gone.
namespace mb::orders {

/// Drives it until its lease ends, which is renewed for as long as the motor is meant to turn, and glides to its target. Unsafe,
/// Refused, OutOfRange with the cause, and then nothing moves.
struct StartMotion {
    DeviceId device;
    SetPoint setPoint;
    std::chrono::milliseconds lease{};
    Glide glide{};
};

/// Another set-point of a motion that runs. Unsafe when none does.
struct UpdateMotion {
    DeviceId device;
    SetPoint setPoint;
    Glide glide{};
};

/// From now on its lease runs anew.
struct RenewMotion {
    DeviceId device;
};

/// Stops the motor, at any phase of a trial too. No errors: whether it stands is in the snapshot.
struct StopMotion {
    DeviceId device;
};

/// Starts the buffered moves of every device on the link of `device` at the same moment.
struct ReleaseMoves {
    DeviceId device;
};

/// Stops the motor, and lets its position count from 0 (Device::zeroPosition). An operation of the device.
struct ZeroPosition {
    DeviceId device;
};

/// The user has looked at the motors that may still turn: no stop is owed to them any more. No errors.
struct DismissStops { };

} // namespace mb::orders
