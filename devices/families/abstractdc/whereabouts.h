// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "model/deviceprofile.h"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace mb::abstractdc {

/// What a position tells of a restart, for which a drive has no word (README.md#restarts).
enum class Restart {
    No,
    Maybe, ///< near 0 after a silence, or where it was not before: it may have lost its power, or its cable was out or it turned
    Proven, ///< near 0 after a silence with its line open, and it had stood far from there: so it has lost its power
    Seen,   ///< near 0 while it answers, and no shaft gets there so fast
};

/// Where a drive was last, and where its velocity loop passed last: what is found there has neither restarted nor been moved
/// (README.md#restarts), and the mean speed since that pass is what the loop measures next (README.md#first-pass). Kept in its profile for
/// the next run of the program. Engine thread.
class Whereabouts {
public:
    using Counters = std::map<std::string, std::int64_t>;
    /// Counts/s.
    struct SpeedRange {
        double low = 0.0;
        double high = 0.0;
        [[nodiscard]] double middle() const { return (low + high) / 2.0; }
        [[nodiscard]] double halfWidth() const { return (high - low) / 2.0; }
    };
    /// Counts, between switching on and the first question.
    static constexpr std::int64_t turnedByHand = 100;
    /// Counts that its shaft has to be away from 0, for its power to be missed surely.
    static constexpr std::int64_t provesPower = 300;

    /// `count` writes DeviceProfile::counters, and the profile to the disk; the profile outlives this.
    Whereabouts(const DeviceProfile &profile, std::function<void(const Counters &values)> count);

    /// It does not answer any more, and may restart or pass meanwhile; it `stood` where it was.
    void silent(bool lineOpen, bool stood);
    /// A position that it tells, in counts, before it is judged: No of all but the first one of this run or after a silence.
    [[nodiscard]] Restart heard(std::int32_t position, Instant now);
    /// The same once it is believed; `passing`: the velocity loop has the motor.
    void located(double position, Instant time, bool passing);
    /// It counts from 0 since then.
    void restarted(Instant time);
    /// It stands there: that is kept.
    void stands();
    /// With `now`, the speed that the velocity loop measures in its first pass. Where it is not known when it passed last, anything from 0 to
    /// the means since it was heard first, from 0 or from where it was.
    [[nodiscard]] SpeedRange entrySpeed(double now) const;
    /// Seen or No: from one position to the next one, between which a shaft gets no farther than `reach`.
    [[nodiscard]] static Restart between(double before, double position, double reach);

private:
    struct Seen {
        double position = 0.0;
        Instant time{};
    };
    struct Place {
        std::int64_t position = 0;
        bool stood = false;
    };
    /// Nothing where that is the place and the moment of now.
    [[nodiscard]] std::optional<double> meanSince(const Seen &seen) const;
    /// Where it passed last, or the worst that is taken for it; nothing before it is heard.
    [[nodiscard]] std::optional<Seen> lastPass() const;
    [[nodiscard]] std::int64_t counted(std::string_view key) const;

    const DeviceProfile &m_profile;
    std::function<void(const Counters &)> m_count;
    Seen m_last;
    std::optional<Seen> m_first;   ///< heard since it was silent
    std::optional<Seen> m_passed;  ///< as far as this program knows
    bool m_knowsPass = false;      ///< that was the last time
    std::optional<Place> m_before; ///< the silence
    bool m_wasSilent = false;      ///< while its line was open: it is off, or its cable is out
};

} // namespace mb::abstractdc
