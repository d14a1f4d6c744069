// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "families/abstractdc/protocol.h"
#include "telemetry/channel.h"

#include <cstdint>
#include <deque>
#include <optional>

namespace mb::abstractdc {

/// What position logs tell: whether one is a glitch (README.md#position: off by 65 535), whether the drive has restarted, how fast the
/// shaft turns, and whether it stands.
class MotionSense {
public:
    enum class Reading {
        Taken,
        Glitch, ///< one jump, not to be recorded. A second one to the same place is where the shaft is now
        Anew,   ///< it counts from 0 again, and no shaft gets there so fast (README.md#restarts)
    };
    [[nodiscard]] Reading add(std::int32_t position, Instant time);
    /// Nothing is known any more, as after silence.
    void forget();

    /// Counts/s over about the last 50 ms; nothing without samples of the last half second before `now`.
    [[nodiscard]] std::optional<double> velocity(Instant now) const;
    [[nodiscard]] std::optional<std::int32_t> position() const;
    /// At least two samples 50 ms apart, all younger than `since`, no further apart than a count.
    [[nodiscard]] bool standsSince(Instant since) const;
    [[nodiscard]] bool isMoving(Instant now) const;
    [[nodiscard]] std::uint64_t glitches() const { return m_glitches; }

private:
    struct Seen {
        std::int64_t position = 0; ///< counted on where the 32 bits of the drive wrap
        Instant time{};
    };
    [[nodiscard]] std::int64_t countedOn(std::int32_t position) const;
    [[nodiscard]] bool isJump(const Seen &seen) const;
    [[nodiscard]] bool isWhereDoubted(const Seen &seen) const;
    [[nodiscard]] bool isAnew(const Seen &seen) const;
    void take(const Seen &seen);

    std::deque<Seen> m_seen; ///< of the last quarter of a second, two at least
    std::optional<Seen> m_doubtful;
    std::uint64_t m_glitches = 0;
    double m_fastest = 0.0; ///< counts/s, of all that were seen
};

} // namespace mb::abstractdc
