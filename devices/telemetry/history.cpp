// SPDX-License-Identifier: GPL-3.0-or-later
#include "telemetry/history.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace mb {

void History::append(Instant time, double value)
{
    if (!std::isfinite(value)) {
        breakLine(1);
        return;
    }
    Micros micros = SampleTape::toMicros(time);
    if (micros < m_tape.lastTime()) {
        micros = m_tape.lastTime();
        ++m_clamped;
    }
    const TapePosition position = m_tape.append(micros, value);
    if (m_broken)
        m_breaks.add(position, m_lost);
    m_broken = false;
    ++m_revision;
}

void History::breakLine(std::uint64_t lost)
{
    m_lost += lost;
    m_broken = true;
    ++m_revision;
}

void History::clear()
{
    m_tape.clear();
    m_breaks.clear();
    m_lost = 0;
    m_clamped = 0;
    m_broken = false;
    ++m_generation;
    ++m_revision;
}

std::optional<Point> History::first() const
{
    return isEmpty() ? std::nullopt : std::optional(m_tape.pointAt(0));
}

std::optional<Point> History::last() const
{
    return isEmpty() ? std::nullopt : std::optional(m_tape.pointAt(m_tape.previous(m_tape.end())));
}

Duration History::columnWidth(Instant from, Instant to, int pixels)
{
    return std::chrono::microseconds(
        LineColumns::widthOf(SampleTape::toMicros(from), SampleTape::toMicros(to), pixels));
}

void History::columns(Instant from, Instant to, int pixels, std::vector<Point> &out) const
{
    out.clear();
    if (isEmpty() || to < from || pixels <= 0)
        return;
    const Micros start = SampleTape::toMicros(from);
    const Micros stop = SampleTape::toMicros(to);
    const Micros width = LineColumns::widthOf(start, stop, pixels);
    LineColumns columns(m_tape, m_breaks, width, out);
    columns.cover(LineColumns::startOf(start, width), LineColumns::startOf(stop, width) + width);
    columns.close();
}

void History::columns(Instant from, Instant to, int pixels, ColumnWindow &window) const
{
    if (isEmpty() || to < from || pixels <= 0) {
        window.showNothing();
        return;
    }
    const Micros start = SampleTape::toMicros(from);
    const Micros stop = SampleTape::toMicros(to);
    window.show(m_tape, m_breaks, m_generation, LineColumns::widthOf(start, stop, pixels), start, stop);
}

std::optional<Point> History::at(Instant time) const
{
    const TapePosition after = m_tape.search(SampleTape::toMicros(time) + 1);
    return after == 0 ? std::nullopt : std::optional(m_tape.pointAt(m_tape.previous(after)));
}

std::optional<History::Extremes> History::extremes(Instant from, Instant to) const
{
    const TapePosition begin = m_tape.search(SampleTape::toMicros(from));
    const TapePosition after = m_tape.search(SampleTape::toMicros(to) + 1, begin);
    if (begin >= after)
        return std::nullopt;
    const Extent extent = m_tape.range(begin, after);
    return Extremes{extent.low, extent.high};
}

std::optional<History::Statistics> History::statistics(Instant from, Instant to) const
{
    const TapePosition begin = m_tape.search(SampleTape::toMicros(from));
    const TapePosition after = m_tape.search(SampleTape::toMicros(to) + 1, begin);
    if (begin >= after)
        return std::nullopt;
    const SampleTape::Moments moments = m_tape.moments(begin, after);
    const Extent extent = m_tape.range(begin, after);
    const double variance = moments.squares / moments.count;
    Statistics found;
    found.count = m_tape.indexOf(after) - m_tape.indexOf(begin);
    found.mean = moments.mean;
    found.deviation = std::sqrt(variance);
    found.rms = std::sqrt(moments.mean * moments.mean + variance);
    found.low = extent.low;
    found.high = extent.high;
    // A gap before the first of them lies outside.
    found.lost = m_breaks.lostBetween(m_breaks.from(begin + 1), m_breaks.from(after));
    return found;
}

std::vector<History::Gap> History::gaps(Instant from, Instant to, Duration merge) const
{
    std::vector<Gap> found;
    const Micros stop = SampleTape::toMicros(to);
    // Nothing is missing before the first sample.
    auto first = m_breaks.from(std::max(m_tape.search(SampleTape::toMicros(from)), TapePosition{1}));
    while (first != m_breaks.end()) {
        const Micros begin = m_tape.timeAt(m_tape.previous(first->before));
        if (begin > stop)
            break;
        // A gap begins with the sample before its break, so the break at the limit itself still belongs to the group.
        const TapePosition limit = m_tape.search(begin + SampleTape::toMicros(Instant(merge)), first->before);
        const auto following = m_breaks.from(limit + 1);
        found.push_back(
            {SampleTape::toInstant(begin), SampleTape::toInstant(m_tape.timeAt(std::prev(following)->before)),
                m_breaks.lostBetween(first, following)});
        first = following;
    }
    return found;
}

std::size_t History::lowerBound(Instant from) const
{
    return m_tape.indexOf(m_tape.search(SampleTape::toMicros(from)));
}

std::size_t History::read(std::size_t index, Instant to, std::size_t most, std::vector<Point> &out) const
{
    out.clear();
    if (index >= m_tape.size())
        return index;
    const Micros stop = SampleTape::toMicros(to);
    TapePosition position = m_tape.positionAt(index);
    auto gap = m_breaks.from(position);
    const TapePosition after = m_tape.end();
    for (std::size_t count = 0; count < most && position != after && m_tape.timeAt(position) <= stop; ++count) {
        if (gap != m_breaks.end() && gap->before == position) {
            if (index > 0)
                out.push_back({SampleTape::toInstant(m_tape.timeAt(m_tape.previous(position)))});
            ++gap;
        }
        out.push_back(m_tape.pointAt(position));
        position = m_tape.next(position);
        ++index;
    }
    return index;
}

} // namespace mb
