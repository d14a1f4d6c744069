// SPDX-License-Identifier: GPL-3.0-or-later
#include "telemetry/historychunk.h"

#include <algorithm>
#include <bit>

namespace mb {

/// One answer of History::columns() while it is written.
class History::Columns {
public:
    Columns(const History &history, Micros width, std::vector<Point> &out)
        : m_history(history)
        , m_width(width)
        , m_out(out)
        , m_break(history.m_breaks.begin())
    {
    }

    /// The columns of [start, stop), and the one sample before them when nothing has been written yet.
    void cover(Micros start, Micros stop)
    {
        Position position = m_history.search(start);
        if (position != 0 && m_out.empty())
            add(m_history.previous(position), joined);
        const Position end = m_history.end();
        while (position != end) {
            const Micros begin = startOf(m_history.timeAt(position), m_width);
            if (begin >= stop)
                break;
            const Position next = m_history.search(begin + m_width, position);
            column(position, next);
            position = next;
        }
        m_after = position;
    }

    /// The one sample after what cover() covered last.
    void close()
    {
        if (m_after != m_history.end())
            add(m_after, mayBreak);
    }

    [[nodiscard]] static Micros startOf(Micros time, Micros width)
    {
        const Micros rest = time % width;
        return time - (rest < 0 ? rest + width : rest);
    }

private:
    static constexpr bool mayBreak = false;
    static constexpr bool joined = true;

    void column(Position from, Position to)
    {
        if (m_history.indexOf(to) - m_history.indexOf(from) <= 4) {
            for (Position position = from; position != to; position = m_history.next(position))
                add(position, mayBreak);
            return;
        }
        const Node node = m_history.range(from, to);
        const Position last = m_history.previous(to);
        const auto [left, right] = std::minmax(node.lowAt, node.highAt);
        add(from, mayBreak);
        if (left != from)
            add(left, joined);
        if (right != from && right != left)
            add(right, joined);
        if (last != right)
            add(last, joined);
    }

    void add(Position position, bool toPrevious)
    {
        if (!toPrevious && isBroken(position))
            m_out.push_back({m_out.back().time});
        m_out.push_back(m_history.pointAt(position));
    }

    /// Positions come in order, so the search goes on where it was.
    [[nodiscard]] bool isBroken(Position position)
    {
        const auto end = m_history.m_breaks.end();
        if (m_out.empty() || m_break == end)
            return false;
        if (m_break->before < position)
            m_break
                = std::partition_point(m_break, end, [position](const Break &gap) { return gap.before < position; });
        return m_break != end && m_break->before == position;
    }

    const History &m_history;
    Micros m_width;
    std::vector<Point> &m_out;
    BreakIterator m_break;
    Position m_after = 0;
};

Duration History::columnWidth(Instant from, Instant to, int pixels)
{
    const Micros pixel = (toMicros(to) - toMicros(from)) / std::max(pixels, 1);
    if (pixel <= 1)
        return std::chrono::microseconds(1);
    const auto spare = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(pixel))) - 7;
    return std::chrono::microseconds(spare > 0 ? pixel >> spare << spare : pixel);
}

void History::columns(Instant from, Instant to, int pixels, std::vector<Point> &out) const
{
    out.clear();
    if (isEmpty() || to < from || pixels <= 0)
        return;
    const Micros width = columnWidth(from, to, pixels) / std::chrono::microseconds(1);
    Columns columns(*this, width, out);
    columns.cover(Columns::startOf(toMicros(from), width), Columns::startOf(toMicros(to), width) + width);
    columns.close();
}

void History::columns(Instant from, Instant to, int pixels, ColumnWindow &window) const
{
    const Micros width = columnWidth(from, to, pixels) / std::chrono::microseconds(1);
    if (window.m_history != this || window.m_generation != m_generation || window.m_width != width)
        window.m_to = window.m_from; // nothing of it is right any more
    std::swap(window.m_points, window.m_before);
    window.m_points.clear();
    if (isEmpty() || to < from || pixels <= 0) {
        window.m_history = nullptr;
        return;
    }
    const Micros start = Columns::startOf(toMicros(from), width);
    const Micros stop = Columns::startOf(toMicros(to), width) + width;
    Columns columns(*this, width, window.m_points);
    columns.cover(reuse(window, columns, start, stop), stop);
    columns.close();
    window.m_history = this;
    window.m_generation = m_generation;
    window.m_width = width;
    window.m_from = start;
    window.m_to = std::min(stop, Columns::startOf(m_lastTime, width)); // the last column may still grow
}

History::Micros History::reuse(ColumnWindow &window, Columns &columns, Micros start, Micros stop) const
{
    const Micros from = std::max(start, window.m_from);
    const Micros to = std::min(stop, window.m_to);
    if (from >= to)
        return start;
    const auto &before = window.m_before;
    // Gap points have the time of the sample before them, but go with the one after them.
    const auto firstAt = [&before](Micros time) {
        auto found = std::lower_bound(before.begin(), before.end(), toInstant(time),
            [](const Point &point, Instant instant) { return point.time < instant; });
        if (found != before.begin() && std::prev(found)->isGap())
            --found;
        return found;
    };
    const auto first = firstAt(from);
    if (start < from)
        columns.cover(start, from);
    else if (first != before.begin())
        window.m_points.push_back(*std::prev(first));
    window.m_points.insert(window.m_points.end(), first, firstAt(to));
    return to;
}

} // namespace mb
