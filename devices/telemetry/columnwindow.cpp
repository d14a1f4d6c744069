// SPDX-License-Identifier: GPL-3.0-or-later
#include "telemetry/columnwindow.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace mb {

void ColumnWindow::show(
    const SampleTape &tape, const LineBreaks &breaks, std::uint64_t generation, Micros width, Micros from, Micros to)
{
    if (m_tape != &tape || m_generation != generation || m_width != width)
        m_to = m_from; // nothing of it is right any more
    std::swap(m_points, m_before);
    m_points.clear();
    const Micros start = LineColumns::startOf(from, width);
    const Micros stop = LineColumns::startOf(to, width) + width;
    LineColumns columns(tape, breaks, width, m_points);
    columns.cover(reuse(columns, start, stop), stop);
    columns.close();
    m_tape = &tape;
    m_generation = generation;
    m_width = width;
    m_from = start;
    m_to = std::min(stop, LineColumns::startOf(tape.lastTime(), width)); // the last column may still grow
}

void ColumnWindow::showNothing()
{
    m_points.clear();
    m_tape = nullptr;
}

Micros ColumnWindow::reuse(LineColumns &columns, Micros start, Micros stop)
{
    const Micros from = std::max(start, m_from);
    const Micros to = std::min(stop, m_to);
    if (from >= to)
        return start;
    // Gap points have the time of the sample before them, but go with the one after them.
    const auto firstAt = [this](Micros time) {
        auto found = std::lower_bound(m_before.begin(), m_before.end(), SampleTape::toInstant(time),
            [](const Point &point, Instant instant) { return point.time < instant; });
        if (found != m_before.begin() && std::prev(found)->isGap())
            --found;
        return found;
    };
    const auto first = firstAt(from);
    if (start < from)
        columns.cover(start, from);
    else if (first != m_before.begin())
        m_points.push_back(*std::prev(first));
    m_points.insert(m_points.end(), first, firstAt(to));
    return to;
}

} // namespace mb
