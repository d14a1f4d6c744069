// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/statusstream.h"

#include <algorithm>
#include <utility>

namespace mb::dmc60c {
namespace {

constexpr int shortGapsNeeded = 4;
/// Nothing sends at such a pace: these frames waited for each other somewhere.
constexpr Duration shortestPeriod = std::chrono::microseconds(500);
/// Longer gaps are silence, not loss: the device may have stood in its bootloader.
constexpr int gapPeriods = 32;
constexpr Duration gapAtLeast = std::chrono::milliseconds(250);

} // namespace

StatusStream::StatusStream(std::shared_ptr<Telemetry> telemetry, std::vector<ChannelIndex> channels, Duration period)
    : m_telemetry(std::move(telemetry))
    , m_channels(std::move(channels))
    , m_initial(period)
    , m_period(period)
{
    m_held.reserve(relearn);
}

void StatusStream::add(Instant time, const Values &values)
{
    if (!m_last || m_unsure) {
        startAt(time);
        emit({time, values});
        return;
    }
    const Duration gap = time - *m_last;
    if (std::exchange(m_mayRestart, false) && m_held.empty() && gap < 2 * m_period - m_period / 32) {
        startAt(time); // longer than a period and shorter than two: it began anew, and nothing is missing
        emit({time, values});
        return;
    }
    const bool comesLate = gap * 2 < m_period && gapWithMissing() != m_held.rend();
    const std::int64_t periods = comesLate ? 0 : periodsSince(time);
    const Frame frame{time, values, periods};
    adjustPhase(time, periods);
    m_last = time;
    if (periods > 1 || gap > m_period + m_period / 4) {
        m_shortGaps = 0; // jitter: the long gap pays for the short ones
        m_shortSum = Duration::zero();
        hold(frame);
        return;
    }
    if (periods == 0 && wasLate(frame))
        return;
    releaseAsLoss(m_held.size());
    emit(frame);
    learnShorter(gap);
}

/// By the phase, which a late frame does not fool, and by the gap, which a device with a slow clock does not fool.
std::int64_t StatusStream::periodsSince(Instant time) const
{
    const std::int64_t byPhase = (time - m_phase + m_period / 2) / m_period;
    const std::int64_t byGap = (time - *m_last + m_period / 2) / m_period;
    return std::max<std::int64_t>(0, std::min(byPhase, std::max<std::int64_t>(byGap, 1)));
}

void StatusStream::adjustPhase(Instant time, std::int64_t periods)
{
    m_phase += periods * m_period;
    m_phase += (time - m_phase) / 4;
}

void StatusStream::learnShorter(Duration gap)
{
    if (gap * 4 >= m_period * 3 || gap < shortestPeriod) {
        m_shortGaps = 0;
        m_shortSum = Duration::zero();
        return;
    }
    m_shortSum += gap;
    if (++m_shortGaps < shortGapsNeeded)
        return;
    m_period = m_shortSum / shortGapsNeeded;
    startAt(*m_last);
}

bool StatusStream::gapsAreAlike() const
{
    // The first is a mixture of both periods.
    Duration least = Duration::max();
    Duration most = Duration::zero();
    for (std::size_t i = 1; i < m_held.size(); ++i) {
        const Duration gap = m_held[i].time - m_held[i - 1].time;
        least = std::min(least, gap);
        most = std::max(most, gap);
    }
    return most - least < m_period / 3;
}

void StatusStream::hold(const Frame &frame)
{
    m_held.push_back(frame);
    if (m_held.size() < relearn)
        return;
    if (m_confirmed || !gapsAreAlike()) {
        releaseAsLoss(m_held.size() - 1); // those of the last gap may still come
        return;
    }
    m_period = (m_held.back().time - m_held.front().time) / static_cast<std::int64_t>(m_held.size() - 1);
    const Instant last = m_held.back().time;
    release();
    startAt(last);
}

/// The last held one before which some are missing.
std::vector<StatusStream::Frame>::reverse_iterator StatusStream::gapWithMissing()
{
    return std::find_if(m_held.rbegin(), m_held.rend(), [](const Frame &held) { return held.periods > 1; });
}

/// One that looked lost, because this one or others before it come late.
bool StatusStream::wasLate(const Frame &frame)
{
    const auto gap = gapWithMissing();
    if (gap == m_held.rend())
        return false;
    --gap->periods;
    m_held.push_back({frame.time, frame.values});
    if (gapWithMissing() == m_held.rend()) {
        spread();
        releaseAsLoss(m_held.size());
    }
    return true;
}

/// Evenly behind the last one that came in time.
void StatusStream::spread()
{
    const auto count = static_cast<std::int64_t>(m_held.size());
    const Instant end = m_held.back().time;
    const Duration step = (end - m_emitted) / count;
    for (std::int64_t i = 0; i < count; ++i)
        m_held[static_cast<std::size_t>(i)].time = end - (count - 1 - i) * step;
}

/// The oldest `count` of them.
void StatusStream::releaseAsLoss(std::size_t count)
{
    const Duration silence = std::max<Duration>(gapPeriods * m_period, gapAtLeast);
    for (std::size_t i = 0; i < count; ++i) {
        const Frame &frame = m_held[i];
        const std::int64_t missing = frame.periods - 1;
        for (const ChannelIndex channel : m_channels) {
            if (missing > 0 && missing * m_period > silence)
                m_telemetry->breakLine(channel);
            else if (missing > 0)
                m_telemetry->lost(channel, static_cast<std::uint64_t>(missing));
        }
        emit(frame);
    }
    m_held.erase(m_held.begin(), m_held.begin() + static_cast<std::ptrdiff_t>(count));
    if (m_held.empty())
        m_confirmed = false;
}

void StatusStream::release()
{
    for (const Frame &frame : m_held)
        emit(frame);
    m_held.clear();
}

void StatusStream::emit(const Frame &frame)
{
    for (std::size_t i = 0; i < m_channels.size(); ++i)
        m_telemetry->append({m_channels[i], frame.time, frame.values[i]});
    m_emitted = frame.time;
}

void StatusStream::startAt(Instant time)
{
    m_last = time;
    m_phase = time;
    m_unsure = false;
    m_shortGaps = 0;
    m_shortSum = Duration::zero();
}

void StatusStream::setPeriod(Duration period)
{
    if (period <= Duration::zero())
        return;
    const bool known = period * 9 < m_period * 10 && m_period * 9 < period * 10; // perhaps learned, and now made exact
    m_period = period;
    m_confirmed = known;
    m_mayRestart = known;
    if (known)
        return; // the next frame tells whether one is missing, or was only late
    release();
    m_unsure = true;
}

void StatusStream::interrupt()
{
    releaseAsLoss(m_held.size());
    if (!m_last)
        return;
    for (const ChannelIndex channel : m_channels)
        m_telemetry->breakLine(channel);
    m_last.reset();
}

void StatusStream::restart()
{
    m_period = m_initial;
    release();
    interrupt();
}

} // namespace mb::dmc60c
