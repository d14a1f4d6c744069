// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

#include <optional>

namespace mb::abstractdc {

/// What the velocity loop takes for the speed in its first pass: the mean since it passed last, however long ago, or since the
/// drive was switched on (README.md#first-pass). Where that moment is not known, anything from 0 to the mean since it was heard first.
class EntrySpeed {
public:
    /// Counts/s.
    struct Range {
        double low = 0.0;
        double high = 0.0;
        [[nodiscard]] double middle() const { return (low + high) / 2.0; }
        [[nodiscard]] double halfWidth() const { return (high - low) / 2.0; }
    };

    /// A position, counts; `passing`: the velocity loop has the motor.
    void located(double position, Instant time, bool passing);
    /// It counts from 0 since then.
    void restarted(Instant time);
    /// Nothing is known any more, as after silence.
    void forget() { *this = {}; }
    /// With `now`, the speed that the next pass measures.
    [[nodiscard]] Range range(double now) const;

private:
    struct Seen {
        double position = 0.0;
        Instant time{};
    };
    std::optional<Seen> m_from;
    bool m_known = false; ///< it did pass there
    Seen m_last;
};

} // namespace mb::abstractdc
