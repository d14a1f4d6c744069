// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotview.h"

#include <algorithm>
#include <cmath>

namespace mb {
namespace {

constexpr double ShortestWindow = 1e-3;
constexpr double LongestWindow = 86400.0;

} // namespace

void PlotView::setWindow(double seconds)
{
    const double window = std::clamp(seconds, ShortestWindow, LongestWindow);
    if (qFuzzyCompare(window, m_window))
        return;
    m_window = window;
    m_from = m_to - window;
    Q_EMIT changed();
    Q_EMIT windowChanged(window);
}

void PlotView::setWhole(double from, double to)
{
    m_whole = {from, to};
    setRange(from, to);
}

void PlotView::setLive(bool live)
{
    if (live && m_whole)
        return setRange(m_whole->first, m_whole->second);
    if (std::exchange(m_live, live) == live)
        return;
    Q_EMIT changed();
    Q_EMIT liveChanged(live);
}

void PlotView::setRange(double from, double to)
{
    if (!(to > from))
        return;
    const double wider = std::max(0.0, ShortestWindow - (to - from)) / 2;
    m_from = from - wider;
    m_to = to + wider;
    setLive(false);
    // A window that is remembered is never shorter, by rounding neither.
    if (const double window = std::max(m_to - m_from, ShortestWindow); !qFuzzyCompare(m_window, window)) {
        m_window = window;
        Q_EMIT windowChanged(m_window);
    }
    Q_EMIT changed();
}

void PlotView::hold(std::optional<double> key, double before)
{
    if (key == m_held && before == m_heldBefore)
        return;
    m_held = key;
    m_heldBefore = before;
    Q_EMIT changed();
}

void PlotView::zoom(double factor, std::optional<double> around)
{
    const double window = std::clamp(span() * factor, ShortestWindow, LongestWindow);
    if (m_live)
        return setWindow(window);
    const double fixed = around.value_or((m_from + m_to) / 2);
    const double from = fixed - (fixed - m_from) * window / span();
    setRange(from, from + window);
}

void PlotView::pan(double seconds)
{
    setRange(m_from + seconds, m_to + seconds);
}

bool PlotView::follow(double now, int columns)
{
    // Whole pixel columns on absolute time: the trace scrolls without shimmering, and a long window is drawn only
    // as often as it moves by a pixel.
    const double column = m_window / std::max(columns, 1);
    const double end = m_held ? *m_held + m_window * (1.0 - m_heldBefore) : now;
    const double to = std::ceil(end / column) * column;
    if (to == m_to && m_to - m_from == m_window)
        return false;
    m_to = to;
    m_from = to - m_window;
    return true;
}

} // namespace mb
