// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "telemetry/telemetry.h"

#include <array>
#include <memory>

/// Recordings made by hand.
namespace mb::test {

using namespace std::chrono_literals;

inline constexpr std::array<Channel, 3> channels{{{"velocity", "counts/s", "Velocity", Quantity::Velocity},
    {"position", "counts", "Position", Quantity::Position}, {"current", "A", "Current", Quantity::Current}}};

inline constexpr ChannelIndex velocity{0};
inline constexpr ChannelIndex position{1};
inline constexpr ChannelIndex current{2};

inline std::shared_ptr<Telemetry> telemetry()
{
    return std::make_shared<Telemetry>(channels);
}

inline Instant ms(std::int64_t milliseconds)
{
    return Instant(std::chrono::milliseconds(milliseconds));
}

inline void put(Telemetry &to, ChannelIndex channel, std::int64_t milliseconds, double value)
{
    to.append({channel, ms(milliseconds), value});
    to.commit();
}

} // namespace mb::test
