// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotcursors.h"
#include "widgets/plots/plotstack.h"

#include <QAccessible>
#include <QKeyEvent>
#include <QWheelEvent>
#include <cmath>

namespace mb {
namespace {

constexpr double ShortestWindow = 1e-3;
constexpr double LongestWindow = 86400.0;

} // namespace

void PlotStack::setWindow(double seconds)
{
    const double window = std::clamp(seconds, ShortestWindow, LongestWindow);
    if (qFuzzyCompare(window, m_window))
        return;
    m_window = window;
    m_from = m_to - window;
    touch();
    Q_EMIT windowChanged(window);
}

void PlotStack::setLive(bool live)
{
    if (m_live == live)
        return;
    m_live = live;
    touch();
    announce();
    Q_EMIT liveChanged(live);
}

void PlotStack::setRange(double from, double to)
{
    if (!(to > from))
        return;
    m_from = from;
    m_to = to;
    setLive(false);
    if (!qFuzzyCompare(m_window, to - from)) {
        m_window = to - from;
        Q_EMIT windowChanged(m_window);
    }
    touch();
}

std::pair<double, double> PlotStack::range() const
{
    return {m_from, m_to};
}

void PlotStack::fit()
{
    for (const auto &strip : m_strips) {
        strip->fixed.reset();
        strip->range.reset();
        strip->secondFixed.reset();
        strip->secondRange.reset();
    }
    double first = std::numeric_limits<double>::infinity();
    double last = -first;
    for (const auto &[id, trace] : m_traces) {
        if (const auto *fixed = dynamic_cast<const FixedTrace *>(trace.source.get());
            fixed && !fixed->points().empty()) {
            first = std::min(first, fixed->points().front().key);
            last = std::max(last, fixed->points().back().key);
        }
    }
    if (last > first)
        setRange(first, last);
    touch();
}

void PlotStack::setValueRange(int strip, std::optional<std::pair<double, double>> range)
{
    ensureStrip(strip);
    Strip &changed = *m_strips.at(static_cast<std::size_t>(strip));
    changed.fixed = range;
    changed.range.reset();
    touch();
}

void PlotStack::setCursorsShown(bool shown)
{
    if (shown == m_cursors->visible())
        return;
    const double span = m_to - m_from;
    m_cursors->setKey(false, m_from + span / 3);
    m_cursors->setKey(true, m_from + span * 2 / 3);
    m_cursors->setVisible(shown);
    touch();
    Q_EMIT cursorsChanged();
}

bool PlotStack::cursorsShown() const
{
    return m_cursors->visible();
}

void PlotStack::setCursorKeys(double a, double b)
{
    m_cursors->setKey(false, a);
    m_cursors->setKey(true, b);
    touch();
    Q_EMIT cursorsChanged();
}

std::pair<double, double> PlotStack::cursorKeys() const
{
    return {m_cursors->key(false), m_cursors->key(true)};
}

void PlotStack::connectMouse()
{
    connect(m_plot, &QCustomPlot::mouseWheel, this, &PlotStack::wheel);
    connect(m_plot, &QCustomPlot::mousePress, this, &PlotStack::mousePress);
    connect(m_plot, &QCustomPlot::mouseMove, this, &PlotStack::mouseMove);
    connect(m_plot, &QCustomPlot::mouseRelease, this, &PlotStack::mouseRelease);
    connect(m_plot, &QCustomPlot::mouseDoubleClick, this, &PlotStack::backToLive);
}

int PlotStack::stripAt(const QPoint &position) const
{
    for (std::size_t i = 0; i < m_strips.size(); ++i) {
        if (m_strips[i]->rect->outerRect().contains(position))
            return static_cast<int>(i);
    }
    return -1;
}

double PlotStack::keyAt(int x) const
{
    return m_strips.empty() ? 0.0 : m_strips.front()->rect->axis(QCPAxis::atBottom)->pixelToCoord(x);
}

void PlotStack::wheel(QWheelEvent *event)
{
    const double factor = std::pow(0.85, event->angleDelta().y() / 120.0);
    const QPoint at = event->position().toPoint();
    const int strip = stripAt(at);
    if (event->modifiers().testFlag(Qt::ControlModifier) && strip >= 0) {
        zoomValue(strip, factor, at.y());
    } else if (event->modifiers().testFlag(Qt::ShiftModifier)) {
        pan((m_to - m_from) * -event->angleDelta().y() / 1200.0);
    } else {
        zoomTime(factor, m_live ? std::nullopt : std::optional(keyAt(at.x())));
    }
    event->accept();
}

void PlotStack::zoomTime(double factor, std::optional<double> around)
{
    const double window = std::clamp((m_to - m_from) * factor, ShortestWindow, LongestWindow);
    if (m_live)
        return setWindow(window);
    const double fixed = around.value_or((m_from + m_to) / 2);
    const double from = fixed - (fixed - m_from) * window / (m_to - m_from);
    setRange(from, from + window);
}

void PlotStack::zoomValue(int strip, double factor, double aroundPixel)
{
    Strip &zoomed = *m_strips.at(static_cast<std::size_t>(strip));
    for (const bool second : {false, true}) {
        const double around = zoomed.axis(second).pixelToCoord(aroundPixel);
        const QCPRange range = zoomed.axis(second).range();
        (second ? zoomed.secondFixed : zoomed.fixed)
            = {around - (around - range.lower) * factor, around + (range.upper - around) * factor};
    }
    touch();
}

void PlotStack::pan(double seconds)
{
    setRange(m_from + seconds, m_to + seconds);
}

void PlotStack::backToLive()
{
    for (const auto &strip : m_strips) {
        strip->fixed.reset();
        strip->secondFixed.reset();
    }
    setLive(true);
    touch();
}

void PlotStack::mousePress(QMouseEvent *event)
{
    setFocus(Qt::MouseFocusReason);
    if (event->button() != Qt::LeftButton)
        return;
    if (event->modifiers().testFlag(Qt::ShiftModifier))
        return beginBox(event->pos());
    m_draggedTrigger = overTrigger(event->pos());
    m_draggedCursor = m_draggedTrigger ? std::nullopt : m_cursors->hit(event->pos().x());
    m_lastCursor = m_draggedCursor.value_or(m_lastCursor);
    m_drag = event->pos();
}

void PlotStack::mouseMove(QMouseEvent *event)
{
    if (m_box->isVisible()) {
        m_box->setGeometry(QRect(m_boxStart, event->pos()).normalized());
        return;
    }
    const bool overCursor = m_draggedCursor || m_cursors->hit(event->pos().x());
    const bool overHandle = m_draggedTrigger || (!m_drag && overTrigger(event->pos()));
    m_plot->setCursor(overHandle ? Qt::SizeVerCursor
            : overCursor         ? Qt::SizeHorCursor
            : m_drag             ? Qt::ClosedHandCursor
                                 : Qt::ArrowCursor);
    if (m_draggedTrigger)
        return dragTrigger(event->pos());
    if (m_draggedCursor) {
        m_cursors->setKey(*m_draggedCursor, std::clamp(keyAt(event->pos().x()), m_from, m_to));
        touch();
        Q_EMIT cursorsChanged();
        return;
    }
    constexpr int Threshold = 4;
    if (!m_drag || (m_live && (event->pos() - *m_drag).manhattanLength() < Threshold))
        return;
    pan(keyAt(m_drag->x()) - keyAt(event->pos().x()));
    m_drag = event->pos();
    // The axis must follow before the next move is measured against it.
    for (const auto &strip : m_strips)
        strip->rect->axis(QCPAxis::atBottom)->setRange(m_from, m_to);
}

void PlotStack::mouseRelease(QMouseEvent *event)
{
    if (m_box->isVisible())
        endBox(event->pos());
    m_drag.reset();
    m_draggedTrigger = false;
    m_draggedCursor.reset();
    m_plot->unsetCursor();
}

bool PlotStack::timeKey(int key)
{
    const double step = (m_to - m_from) * 0.1;
    switch (key) {
    case Qt::Key_Plus: zoomTime(0.8, {}); return true;
    case Qt::Key_Minus: zoomTime(1.25, {}); return true;
    case Qt::Key_Left: pan(-step); return true;
    case Qt::Key_Right: pan(step); return true;
    case Qt::Key_Home:
    case Qt::Key_End: backToLive(); return true;
    case Qt::Key_0: fit(); return true;
    case Qt::Key_P: setLive(!m_live); return true;
    case Qt::Key_L: setCursorsShown(!cursorsShown()); return true;
    case Qt::Key_N:
        Q_EMIT noteRequested(cursorsShown() ? m_cursors->key(m_lastCursor) : m_live ? m_now : (m_from + m_to) / 2);
        return true;
    default: return valueKey(key);
    }
}

void PlotStack::keyPressEvent(QKeyEvent *event)
{
    const bool plain = !(event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
    if (!cursorKey(*event) && (!plain || !timeKey(event->key())))
        QWidget::keyPressEvent(event);
}

void PlotStack::announce()
{
    setAccessibleDescription(summary());
    QAccessibleEvent event(this, QAccessible::DescriptionChanged);
    QAccessible::updateAccessibility(&event);
}

void PlotStack::focusInEvent(QFocusEvent *event)
{
    QWidget::focusInEvent(event);
    announce();
    update();
}

void PlotStack::focusOutEvent(QFocusEvent *event)
{
    QWidget::focusOutEvent(event);
    update();
}

void PlotStack::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    touch();
}

void PlotStack::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    touch();
}

} // namespace mb
