// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/historychunk.h"

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

    void run(Micros from, Micros to)
    {
        const Position end = m_history.end();
        const Micros stop = startOf(to) + m_width;
        Position position = m_history.search(startOf(from));
        if (position != 0)
            add(m_history.previous(position), joined);
        while (position != end) {
            const Micros start = startOf(m_history.timeAt(position));
            if (start >= stop)
                break;
            const Position next = m_history.search(start + m_width, position);
            column(position, next);
            position = next;
        }
        if (position != end)
            add(position, mayBreak);
    }

private:
    static constexpr bool mayBreak = false;
    static constexpr bool joined = true;

    [[nodiscard]] Micros startOf(Micros time) const
    {
        const Micros rest = time % m_width;
        return time - (rest < 0 ? rest + m_width : rest);
    }

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
    const auto width = std::chrono::duration_cast<std::chrono::microseconds>(columnWidth(from, to, pixels));
    Columns(*this, width.count(), out).run(toMicros(from), toMicros(to));
}

} // namespace mb
