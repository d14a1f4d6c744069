// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/pollschedule.h"

#include <algorithm>

namespace mb::supermodified {

PollSchedule::Key PollSchedule::add(Duration period, Instant now)
{
    m_entries.push_back({++m_last, period, now});
    return m_last;
}

void PollSchedule::remove(Key key)
{
    std::erase_if(m_entries, [key](const Entry &entry) { return entry.key == key; });
}

void PollSchedule::setPeriod(Key key, Duration period, Instant now)
{
    for (Entry &entry : m_entries) {
        if (entry.key != key || entry.period == period)
            continue;
        entry.next = entry.period == Duration::zero() ? now : std::min(entry.next, now + period);
        entry.period = period;
    }
}

void PollSchedule::hasten(Key key, Instant now)
{
    for (Entry &entry : m_entries) {
        if (entry.key == key)
            entry.next = std::min(entry.next, now);
    }
}

std::vector<PollSchedule::Entry>::const_iterator PollSchedule::first() const
{
    // std::min_element keeps the first of equals, and take() moves who had a turn to the end
    const auto earlier = [](const Entry &a, const Entry &b) {
        const bool wantsA = a.period > Duration::zero();
        const bool wantsB = b.period > Duration::zero();
        return wantsA != wantsB ? wantsA : a.next < b.next;
    };
    return std::ranges::min_element(m_entries, earlier);
}

std::optional<Instant> PollSchedule::nextDue() const
{
    const auto entry = first();
    if (entry == m_entries.end() || entry->period == Duration::zero())
        return std::nullopt;
    return entry->next;
}

PollSchedule::Key PollSchedule::take(Instant now)
{
    const auto position = first() - m_entries.begin();
    Entry entry = m_entries[static_cast<std::size_t>(position)];
    m_entries.erase(m_entries.begin() + position);
    entry.next = std::max(entry.next + entry.period, now);
    m_entries.push_back(entry);
    return entry.key;
}

} // namespace mb::supermodified
