// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

namespace mb::tuning {

/// How far the newest values of a row lie apart, over any time up to its end: asked again and again while the row grows, it never goes
/// over the row again. Times do not decrease.
template <class Time, class Value> class RecentExtremes {
public:
    void add(const Time &time, const Value &value)
    {
        const auto push = [&](std::vector<Seen> &seen, const auto &outlasts) {
            while (!seen.empty() && !outlasts(seen.back().value))
                seen.pop_back();
            seen.push_back({time, value});
        };
        push(m_least, [&value](const Value &before) { return before < value; });
        push(m_greatest, [&value](const Value &before) { return value < before; });
    }
    /// Of those at `since` and later; nothing where there are none.
    [[nodiscard]] std::optional<Value> spread(const Time &since) const
    {
        const auto from = [&since](const std::vector<Seen> &seen) {
            return std::lower_bound(
                seen.begin(), seen.end(), since, [](const Seen &each, const Time &time) { return each.time < time; });
        };
        const auto least = from(m_least);
        if (least == m_least.end())
            return std::nullopt;
        return from(m_greatest)->value - least->value;
    }

private:
    struct Seen {
        Time time;
        Value value;
    };
    std::vector<Seen> m_least;    ///< each less than all after it
    std::vector<Seen> m_greatest; ///< each greater than all after it
};

} // namespace mb::tuning
