// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

#include <optional>

namespace mb::abstractdc {

/// What the velocity loop takes for the speed in its first pass: the mean since it passed last, however long ago, or since the
/// drive was switched on (README.md#first-pass). Where that moment is not known it was when it was heard first, at the latest, at 0 or
/// there or where it is known to have passed before: anything from 0 to those means.
class EntrySpeed {
public:
    /// Counts/s.
    struct Range {
        double low = 0.0;
        double high = 0.0;
        [[nodiscard]] double middle() const { return (low + high) / 2.0; }
        [[nodiscard]] double halfWidth() const { return (high - low) / 2.0; }
    };

    struct Seen {
        double position = 0.0;
        Instant time{};
    };

    /// A position, counts; `passing`: the velocity loop has the motor.
    void located(double position, Instant time, bool passing);
    /// It counts from 0 since then.
    void restarted(Instant time);
    /// It was silent, and may have restarted or passed meanwhile.
    void forget();
    /// With `now`, the speed that the next pass measures.
    [[nodiscard]] Range range(double now) const;

    /// It passed last there, as an earlier run has seen.
    void recall(const Seen &passed);
    /// Where it passed last, or the worst that is taken for it; nothing before it is heard.
    [[nodiscard]] std::optional<Seen> lastPass() const;

private:
    /// Nothing where that is the place and the moment of now.
    [[nodiscard]] std::optional<double> meanSince(const Seen &seen) const;

    std::optional<Seen> m_first;  ///< heard since it was silent
    std::optional<Seen> m_passed; ///< as far as this program knows
    bool m_known = false;         ///< that was the last time
    Seen m_last;
};

} // namespace mb::abstractdc
