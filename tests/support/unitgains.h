// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/device.h"
#include "simulation/simulator.h"
#include "support/simulatedsession.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace mb::test {

/// A gain as the simulated unit itself has it, whatever the program takes it for: asked over the wire, or out of the unit where the
/// wire cannot tell. Nothing where it does not answer.
[[nodiscard]] inline std::optional<std::int64_t> rawInUnit(
    VirtualClock &clock, Device &device, const Simulator &unit, std::string_view key)
{
    if (const auto raw = unit.gain(key))
        return raw;
    const auto index = findParameter(device.parameters().table(), key);
    const auto read
        = index ? run(clock, device.read(*index)) : Result<std::int64_t>(fail(Fault::OutOfRange, say("no such key")));
    return read ? std::optional(*read) : std::nullopt;
}

} // namespace mb::test
