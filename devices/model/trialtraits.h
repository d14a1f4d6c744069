// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/setpoint.h"

#include <array>
#include <chrono>
#include <optional>
#include <span>
#include <string_view>

namespace mb {

/// Bounds that a trial on a motor stays in. What is missing is unknown, never infinite.
struct Envelope {
    std::optional<double> travel;  ///< counts, either side of the position at the start
    std::optional<double> speed;   ///< counts/s
    std::optional<double> current; ///< A
    std::optional<double> duty;    ///< fraction

    friend bool operator==(const Envelope &, const Envelope &) = default;
};

/// One bound of it, by the name that it has in JSON and in files.
struct EnvelopeBound {
    const char *key;
    std::optional<double> Envelope::*value;
    double most; ///< a larger one bounds nothing, so nobody can give it
};
inline constexpr std::array<EnvelopeBound, 4> envelopeBounds{{
    {"travel", &Envelope::travel, 1e12},
    {"speed", &Envelope::speed, 1e12},
    {"current", &Envelope::current, 1e4},
    {"duty", &Envelope::duty, 1.0},
}};
/// Whether this number bounds anything, wherever it was entered or read.
[[nodiscard]] constexpr bool isBound(const EnvelopeBound &bound, double value)
{
    return value > 0.0 && value <= bound.most;
}

/// A closed loop, and the parameters that make it.
struct LoopGains {
    Mode mode = Mode::Velocity;
    std::string_view prefix{};                 ///< of their keys, without the axis; '#' stands for the slot
    std::span<const std::string_view> names{}; ///< what follows it, in the order in which they are shown
    bool proportional = false;                 ///< its integral cannot be relied on: only P is tuned
};

/// What is known of a loop that has no duty command, and so no LoopScale: its gains are tried against each other
/// (tuning/twopointfit.h).
struct RawLoop {
    double cycle = 0.0;    ///< s between two passes of the loop
    double fullDuty = 0.0; ///< raw P times counts of error at full output …
    double integral = 1.0; ///< raw I times counts, summed up in each pass, that make as much output as one of P …
    std::string_view dialects{};    ///< … in units of these dialects, one after the other; not known in others
    std::string_view profileRate{}; ///< key of what its own profile is bounded by, counts/s
    std::string_view profileAcceleration{}; ///< the same, counts/s²
};

/// A setting of the device that bounds what a trial may do.
struct DeviceLimit {
    enum class Bounds { Position, Speed, Current, Duty };
    Bounds bounds = Bounds::Current;
    std::string_view key{};     ///< without the axis; '#' stands for the slot
    std::string_view enabled{}; ///< key of its switch; empty: always on
    double one = 1.0;           ///< the parameter's number for 1 count, count/s, A or full duty
};

/// What trials (devices/tuning) must know of a family: data, so that no story branches on a name.
struct TrialTraits {
    std::span<const LoopGains> loops{};
    std::span<const DeviceLimit> limits{};
    Envelope bench;           ///< of simulated units, for what nobody gives
    double rate = 100.0;      ///< samples per second asked for while a trial runs
    double currentRate = 0.0; ///< the same for a trial of a current loop; 0: no other
    RawLoop raw{};            ///< of its loops, where there is no duty command
    /// Between the set-points of a profile that glides and that this program leads; at most Capabilities::commandPeriod.
    std::chrono::milliseconds glideBeat{20};
    double nudge
        = 0.0; ///< counts of the move that checks the direction where there is no duty command; 0: a pulse of duty
    double nudgeTravel = 0.0;          ///< counts, either side, while it does
    double hottest = 80.0;             ///< °C, of its temperature channel
    double lowestBus = 0.0;            ///< V
    double highestBus = 1e3;           ///< V
    std::string_view never{};          ///< key that is no part of a trial
    std::string_view atBoot{};         ///< key that is fully in force after a restart only …
    std::string_view atBootDialects{}; ///< … in units of these dialects, one after the other
};

} // namespace mb
