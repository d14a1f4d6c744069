// SPDX-License-Identifier: GPL-3.0-or-later
#include "telemetry/telemetry.h"

#include <algorithm>

namespace mb {

namespace {

constexpr Duration rateWindow = std::chrono::seconds(1);
constexpr Duration silence = std::chrono::seconds(2);

double seconds(Duration duration)
{
    return std::chrono::duration<double>(duration).count();
}

} // namespace

Telemetry::Telemetry(std::span<const Channel> channels)
    : m_table(channels.data())
    , m_live(channels.size())
    , m_histories(channels.size())
    , m_generations(channels.size())
{
    m_pending.reserve(pendingMost);
}

void Telemetry::useTable(std::span<const Channel> channels)
{
    commit();
    const std::span<const Channel> before = this->channels();
    {
        const std::lock_guard lock(m_mutex);
        for (std::size_t i = 0; i < before.size(); ++i) {
            if (before[i].unit == channels[i].unit)
                continue;
            m_histories[i].clear();
            ++m_generations[i];
            m_live[i] = Live();
        }
        m_table.store(channels.data(), std::memory_order_release);
    }
    m_revision.fetch_add(1, std::memory_order_release);
}

void Telemetry::append(const Sample &sample)
{
    if (!std::isfinite(sample.value)) {
        lost(sample.channel, 1);
        return;
    }
    Live &live = m_live[sample.channel.value];
    live.measure(sample.time);
    live.latest = Point{sample.time, sample.value};
    if (m_keeps)
        push({sample.time, sample.value, 0, sample.channel, Kind::Measured});
    m_samples.notify(sample);
}

void Telemetry::lost(ChannelIndex channel, std::uint64_t count)
{
    push({{}, 0.0, count, channel, Kind::Break});
}

void Telemetry::breakLine(ChannelIndex channel)
{
    lost(channel, 0);
}

void Telemetry::push(const Pending &pending)
{
    if (m_pending.size() == pendingMost)
        commit();
    m_pending.push_back(pending);
}

void Telemetry::commit()
{
    if (m_pending.empty())
        return;
    {
        const std::lock_guard lock(m_mutex);
        for (const Pending &pending : m_pending) {
            History &history = m_histories[pending.channel.value];
            if (pending.kind == Kind::Measured)
                history.append(pending.time, pending.value);
            else
                history.breakLine(pending.lost);
        }
    }
    m_pending.clear();
    m_revision.fetch_add(1, std::memory_order_release);
}

void Telemetry::Live::measure(Instant time)
{
    if (!latest) {
        windowStart = time;
        return;
    }
    ++inWindow;
    const Duration elapsed = time - windowStart;
    if (elapsed < rateWindow)
        return;
    rate = static_cast<double>(inWindow) / seconds(elapsed);
    windowStart = time;
    inWindow = 0;
}

double Telemetry::rate(ChannelIndex channel, Instant now) const
{
    const Live &live = m_live[channel.value];
    if (!live.latest)
        return 0.0;
    double rate = live.rate;
    const Duration elapsed = live.latest->time - live.windowStart;
    if (rate == 0.0 && elapsed > Duration::zero()) // the first window
        rate = static_cast<double>(live.inWindow) / seconds(elapsed);
    const double silent = seconds(now - live.latest->time);
    return rate > 0.0 && silent <= std::max(seconds(silence), 3.0 / rate) ? rate : 0.0;
}

void Telemetry::columns(ChannelIndex channel, Instant from, Instant to, int pixels, std::vector<Point> &out) const
{
    const std::lock_guard lock(m_mutex);
    history(channel).columns(from, to, pixels, out);
}

void Telemetry::columns(ChannelIndex channel, Instant from, Instant to, int pixels, ColumnWindow &window) const
{
    const std::lock_guard lock(m_mutex);
    history(channel).columns(from, to, pixels, window);
}

std::optional<Point> Telemetry::first(ChannelIndex channel) const
{
    const std::lock_guard lock(m_mutex);
    return history(channel).first();
}

std::optional<Point> Telemetry::last(ChannelIndex channel) const
{
    const std::lock_guard lock(m_mutex);
    return history(channel).last();
}

std::optional<Point> Telemetry::at(ChannelIndex channel, Instant time) const
{
    const std::lock_guard lock(m_mutex);
    return history(channel).at(time);
}

std::optional<History::Extremes> Telemetry::extremes(ChannelIndex channel, Instant from, Instant to) const
{
    const std::lock_guard lock(m_mutex);
    return history(channel).extremes(from, to);
}

std::optional<History::Statistics> Telemetry::statistics(ChannelIndex channel, Instant from, Instant to) const
{
    const std::lock_guard lock(m_mutex);
    return history(channel).statistics(from, to);
}

void Telemetry::keepIn(const std::shared_ptr<ChunkStore> &store)
{
    m_keeps = store != nullptr;
    const std::lock_guard lock(m_mutex);
    for (History &history : m_histories)
        history.keepIn(store);
}

std::vector<History::Gap> Telemetry::gaps(ChannelIndex channel, Instant from, Instant to, Duration merge) const
{
    const std::lock_guard lock(m_mutex);
    return history(channel).gaps(from, to, merge);
}

std::size_t Telemetry::size(ChannelIndex channel) const
{
    const std::lock_guard lock(m_mutex);
    return history(channel).size();
}

std::uint64_t Telemetry::lost(ChannelIndex channel) const
{
    const std::lock_guard lock(m_mutex);
    return history(channel).lost();
}

std::size_t Telemetry::memoryUse() const
{
    const std::lock_guard lock(m_mutex);
    std::size_t bytes = m_pending.capacity() * sizeof(Pending) + m_live.capacity() * sizeof(Live);
    for (const History &history : m_histories)
        bytes += history.memoryUse();
    return bytes;
}

void Telemetry::clear()
{
    {
        const std::lock_guard lock(m_mutex);
        for (History &history : m_histories)
            history.clear();
        for (std::uint64_t &generation : m_generations)
            ++generation;
    }
    m_revision.fetch_add(1, std::memory_order_release);
}

std::uint64_t Telemetry::generation(ChannelIndex channel) const
{
    const std::lock_guard lock(m_mutex);
    return m_generations[channel.value];
}

std::size_t Telemetry::lowerBound(ChannelIndex channel, Instant from) const
{
    const std::lock_guard lock(m_mutex);
    return history(channel).lowerBound(from);
}

std::size_t Telemetry::read(
    ChannelIndex channel, std::size_t index, Instant to, std::size_t most, std::vector<Point> &out) const
{
    const std::lock_guard lock(m_mutex);
    return history(channel).read(index, to, most, out);
}

} // namespace mb
