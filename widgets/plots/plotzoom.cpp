// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotcursors.h"
#include "widgets/plots/plotstack.h"

#include <QDragEnterEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QRubberBand>
#include <cmath>

namespace mb {
namespace {

constexpr int SmallestBox = 6; ///< pixels; less is a click that slipped

} // namespace

void PlotStack::beginBox(const QPoint &at)
{
    m_boxStart = at;
    m_box->setGeometry(QRect(at, QSize()));
    m_box->show();
}

/// Across only: time. With some height: the values of the strip it began in, too.
void PlotStack::endBox(const QPoint &at)
{
    m_box->hide();
    const QRect box = QRect(m_boxStart, at).normalized();
    const int index = stripAt(m_boxStart);
    if (box.width() < SmallestBox || index < 0)
        return;
    Strip &strip = *m_strips.at(static_cast<std::size_t>(index));
    if (box.height() >= 2 * SmallestBox) {
        for (const bool second : {false, true})
            (second ? strip.secondFixed : strip.fixed)
                = {strip.axis(second).pixelToCoord(box.bottom()), strip.axis(second).pixelToCoord(box.top())};
    }
    setRange(keyAt(box.left()), keyAt(box.right()));
}

bool PlotStack::overTrigger(const QPoint &at) const
{
    const TraceStyle *of = m_trigger ? style(m_trigger->trace) : nullptr;
    if (!of)
        return false;
    const Strip &strip = *m_strips.at(static_cast<std::size_t>(of->strip));
    const QRect box = strip.rect->rect();
    const double y = strip.axis(of->secondAxis).coordToPixel(m_trigger->level);
    const int reach = m_theme.theme().u(8);
    return std::abs(at.y() - std::clamp<double>(y, box.top(), box.bottom())) <= reach
        && std::abs(at.x() - box.left()) <= 2 * reach;
}

void PlotStack::dragTrigger(const QPoint &at)
{
    const TraceStyle *of = m_trigger ? style(m_trigger->trace) : nullptr;
    if (!of)
        return;
    const Strip &strip = *m_strips.at(static_cast<std::size_t>(of->strip));
    const int y = std::clamp(at.y(), strip.rect->top(), strip.rect->bottom());
    Q_EMIT triggerLevelMoved(strip.axis(of->secondAxis).pixelToCoord(y));
}

void PlotStack::zoomValues(double factor)
{
    for (std::size_t i = 0; i < m_strips.size(); ++i)
        zoomValue(static_cast<int>(i), factor, m_strips[i]->rect->center().y());
}

bool PlotStack::valueKey(int key)
{
    switch (key) {
    case Qt::Key_PageUp: zoomValues(0.8); return true;
    case Qt::Key_PageDown: zoomValues(1.25); return true;
    default: return false;
    }
}

/// While the cursors are shown the arrows move the one that was moved last, by a pixel, with Ctrl by ten; C changes to
/// the other.
bool PlotStack::cursorKey(QKeyEvent &event)
{
    if (!cursorsShown() || event.modifiers().testFlag(Qt::ShiftModifier))
        return false;
    if (event.key() == Qt::Key_C && event.modifiers() == Qt::NoModifier) {
        m_lastCursor = !m_lastCursor;
        return true;
    }
    if (event.key() != Qt::Key_Left && event.key() != Qt::Key_Right)
        return false;
    const double pixel = (m_to - m_from) / std::max(plotWidth(), 1);
    const double step = pixel * (event.modifiers().testFlag(Qt::ControlModifier) ? 10 : 1);
    const double moved = m_cursors->key(m_lastCursor) + (event.key() == Qt::Key_Left ? -step : step);
    m_cursors->setKey(m_lastCursor, std::clamp(moved, m_from, m_to));
    touch();
    Q_EMIT cursorsChanged();
    return true;
}

void PlotStack::dragEnterEvent(QDragEnterEvent *event)
{
    if (!m_dropType.isEmpty() && event->mimeData()->hasFormat(m_dropType))
        event->acceptProposedAction();
}

void PlotStack::dragMoveEvent(QDragMoveEvent *event)
{
    event->acceptProposedAction();
}

void PlotStack::dropEvent(QDropEvent *event)
{
    int strip = -1;
    const QPoint at = m_plot->mapFrom(this, event->pos());
    for (std::size_t i = 0; i < m_strips.size(); ++i) {
        if (m_strips[i]->rect->rect().contains(at))
            strip = static_cast<int>(i);
    }
    event->acceptProposedAction();
    Q_EMIT dropped(event->mimeData()->data(m_dropType), strip);
}

} // namespace mb
