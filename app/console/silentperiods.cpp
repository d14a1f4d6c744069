// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/silentperiods.h"

#include <algorithm>
#include <utility>

namespace mb::console {

SilentPeriods::SilentPeriods(std::size_t channels, Counted counted)
    : m_counted(std::move(counted))
    , m_rows(channels)
{
}

void SilentPeriods::learn(Row &row, Duration interval)
{
    const int weight = std::min(row.intervals, window - 1);
    row.period = (row.period * weight + interval) / (weight + 1);
    ++row.intervals;
}

void SilentPeriods::sample(ChannelIndex channel, Instant time)
{
    Row &row = m_rows[channel.value];
    const bool first = row.last == Instant{};
    const Duration interval = time - row.last;
    if (std::exchange(row.silent, false))
        m_missed += row.intervals < 2 ? 0 : missedBy(row, channel, (interval + row.period / 2) / row.period - 1);
    else if (!first && interval > Duration::zero())
        learn(row, interval);
    row.last = time;
    row.countedThen = m_counted(channel);
}

void SilentPeriods::setHeard(bool heard)
{
    for (Row &row : m_rows)
        row.silent = row.silent || (!heard && row.last != Instant{});
}

std::uint64_t SilentPeriods::missed(Instant now) const
{
    std::uint64_t sum = m_missed;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const Row &row = m_rows[i];
        if (row.silent && row.intervals >= 2)
            sum += missedBy(row, ChannelIndex{static_cast<std::uint16_t>(i)}, (now - row.last) / row.period);
    }
    return sum;
}

std::uint64_t SilentPeriods::missedBy(const Row &row, ChannelIndex channel, std::int64_t periods) const
{
    const auto known = static_cast<std::int64_t>(m_counted(channel) - row.countedThen);
    return static_cast<std::uint64_t>(std::max<std::int64_t>(0, periods - known));
}

} // namespace mb::console
