// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "transport/link.h"

#include <cstdint>
#include <memory>

namespace mb {

/// A bus in memory: the host and every simulated unit have an end of it, as on a real one. Outlives its ends.
class SimulatedBus : NonCopyable {
public:
    virtual ~SimulatedBus() = default;

    /// A closed end for a simulated unit.
    [[nodiscard]] virtual std::unique_ptr<Link> makeEnd(const LinkAddress &address) = 0;
    /// The host's end: the same where all ends are alike, the master where there is one. After the units' ends.
    [[nodiscard]] virtual std::unique_ptr<Link> makeHost(const LinkAddress &address) { return makeEnd(address); }
    /// This fraction of frames, or of pieces of bytes, is heard by nobody, 0…1.
    virtual void setLoss(double fraction) = 0;
    /// An end drops out: bus-off on CAN, the cable on the others.
    virtual void dropOut(Link &end) = 0;
};

/// `bitrate` in bit/s; 0 is the usual one: 1 Mbit/s on CAN, 115200 on a half-duplex serial line, a clock
/// of 500 kHz on SPI. OutOfRange for a rate
/// that such a bus does not have, Unsupported for a kind that cannot be simulated.
[[nodiscard]] Result<std::unique_ptr<SimulatedBus>> makeSimulatedBus(
    LinkKind kind, Clock &clock, int bitrate, std::uint64_t seed);

} // namespace mb
