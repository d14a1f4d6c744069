// SPDX-License-Identifier: GPL-3.0-or-later
#include "telemetry/linecolumns.h"

#include <algorithm>
#include <bit>

namespace mb {

LineColumns::LineColumns(const SampleTape &tape, const LineBreaks &breaks, Micros width, std::vector<Point> &out)
    : m_tape(tape)
    , m_breaks(breaks)
    , m_width(width)
    , m_out(out)
    , m_break(breaks.begin())
{
}

Micros LineColumns::widthOf(Micros from, Micros to, int pixels)
{
    const Micros pixel = (to - from) / std::max(pixels, 1);
    if (pixel <= 1)
        return 1;
    const auto spare = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(pixel))) - 7;
    return spare > 0 ? pixel >> spare << spare : pixel;
}

Micros LineColumns::startOf(Micros time, Micros width)
{
    const Micros rest = time % width;
    return time - (rest < 0 ? rest + width : rest);
}

void LineColumns::cover(Micros start, Micros stop)
{
    TapePosition position = m_tape.search(start);
    if (position != 0 && m_out.empty())
        join(m_tape.previous(position));
    const TapePosition end = m_tape.end();
    while (position != end) {
        const Micros begin = startOf(m_tape.timeAt(position), m_width);
        if (begin >= stop)
            break;
        const TapePosition next = m_tape.search(begin + m_width, position);
        column(position, next);
        position = next;
    }
    m_after = position;
}

void LineColumns::close()
{
    if (m_after != m_tape.end())
        add(m_after);
}

void LineColumns::column(TapePosition from, TapePosition to)
{
    if (m_tape.indexOf(to) - m_tape.indexOf(from) <= 4) {
        for (TapePosition position = from; position != to; position = m_tape.next(position))
            add(position);
        return;
    }
    const Extent extent = m_tape.range(from, to);
    const TapePosition last = m_tape.previous(to);
    const auto [left, right] = std::minmax(extent.lowAt, extent.highAt);
    add(from);
    if (left != from)
        join(left);
    if (right != from && right != left)
        join(right);
    if (last != right)
        join(last);
}

void LineColumns::add(TapePosition position)
{
    if (isBroken(position))
        m_out.push_back({m_out.back().time});
    join(position);
}

bool LineColumns::isBroken(TapePosition position)
{
    if (m_out.empty() || m_break == m_breaks.end())
        return false;
    if (m_break->before < position)
        m_break = m_breaks.from(position, m_break);
    return m_break != m_breaks.end() && m_break->before == position;
}

} // namespace mb
