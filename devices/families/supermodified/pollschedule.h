// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace mb::supermodified {

/// Whose turn it is on a line that carries one question at a time. Everybody has a wished period; whoever has been due the
/// longest is next. While the line is too slow for all wishes, those who want little get it, and the others share what is
/// left evenly, whatever they wish. Missed turns are not made up for.
class PollSchedule {
public:
    using Key = std::uint32_t;

    /// `period` zero: not asked for now.
    [[nodiscard]] Key add(Duration period, Instant now);
    void remove(Key key);
    /// A shorter period brings the next turn forward.
    void setPeriod(Key key, Duration period, Instant now);

    /// The next turn is due now.
    void hasten(Key key, Instant now);

    /// When the next turn is due; nothing when nobody wants one.
    [[nodiscard]] std::optional<Instant> nextDue() const;
    /// Whose turn it is, and gives the next one to somebody else; only when nextDue() is not later than `now`.
    [[nodiscard]] Key take(Instant now);

private:
    struct Entry {
        Key key = 0;
        Duration period{};
        Instant next{};
    };
    [[nodiscard]] std::vector<Entry>::const_iterator first() const;

    std::vector<Entry> m_entries;
    Key m_last = 0;
};

} // namespace mb::supermodified
