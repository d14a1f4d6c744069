// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/quadquad2drv/codec.h"
#include "model/device.h"

#include <array>
#include <memory>
#include <optional>

namespace mb::quadquad2drv {

/// What the motion data of a board say of its four axes (0…3): samples for its telemetry, and what is known of each. Engine thread.
class AxisSense {
public:
    explicit AxisSense(std::shared_ptr<Telemetry> telemetry)
        : m_telemetry(std::move(telemetry))
    {
    }

    /// `masks` are those that the data were sent with. Changes what is told of the axes in `states`.
    void take(const Motion &motion, const DataMasks &masks, Instant time, LiveStates &states);
    /// So many samples of every channel that the masks name did not come.
    void missed(const DataMasks &masks, std::uint64_t count);
    /// Counts, unwrapped; nothing before the board told it. Of changes, or of the low bits alone, it begins anywhere.
    [[nodiscard]] std::optional<std::int64_t> position(int axis) const;
    /// Counts, as a target of the board has them; nothing while it tells less than its whole counter.
    [[nodiscard]] std::optional<std::int32_t> place(int axis) const;
    /// Faster than the resolution of the velocity.
    [[nodiscard]] bool isTurning(int axis) const;
    /// The board was reset: its counters began anew.
    void forget();
    /// Liveness::faults.
    [[nodiscard]] std::vector<std::string> faults() const;
    [[nodiscard]] std::vector<FaultRecord> records() const;

private:
    struct Tracked {
        std::optional<std::int64_t> position; ///< unwrapped
        std::optional<std::int32_t> place;
        std::uint8_t status = 0;
    };
    void takeAxis(int axis, const AxisMotion &motion, std::uint8_t mask, Instant time);

    std::shared_ptr<Telemetry> m_telemetry;
    std::array<Tracked, axes> m_tracked;
};

} // namespace mb::quadquad2drv
