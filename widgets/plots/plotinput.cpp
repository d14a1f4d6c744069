// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotinput.h"

#include "widgets/common/clamped.h"
#include "widgets/plots/plotcursors.h"

#include <QDropEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QRubberBand>
#include <QWheelEvent>
#include <cmath>

namespace mb {
namespace {

constexpr int SmallestBox = 6; ///< pixels; less is a click that slipped

} // namespace

PlotInput::PlotInput(QWidget &stack, PlotFrame &plot, PlotStrips &strips, PlotView &view, const ThemeSource &theme)
    : QObject(&stack)
    , m_stack(stack)
    , m_plot(plot)
    , m_strips(strips)
    , m_view(view)
    , m_theme(theme)
    , m_box(new QRubberBand(QRubberBand::Rectangle, &plot))
{
    connect(&plot, &QCustomPlot::mouseWheel, this, &PlotInput::wheel);
    connect(&plot, &QCustomPlot::mousePress, this, &PlotInput::mousePress);
    connect(&plot, &QCustomPlot::mouseMove, this, &PlotInput::mouseMove);
    connect(&plot, &QCustomPlot::mouseRelease, this, &PlotInput::mouseRelease);
    connect(&plot, &QCustomPlot::mouseDoubleClick, this, &PlotInput::backToLive);
    stack.installEventFilter(this);
}

void PlotInput::acceptDrops(const QString &mimeType)
{
    m_dropType = mimeType;
    m_stack.setAcceptDrops(true);
}

void PlotInput::backToLive()
{
    for (const auto &strip : m_strips.all())
        strip->release();
    m_view.setLive(true);
    Q_EMIT m_strips.changed();
}

bool PlotInput::eventFilter(QObject *watched, QEvent *event)
{
    switch (event->type()) {
    case QEvent::KeyPress: return key(static_cast<QKeyEvent &>(*event)) || QObject::eventFilter(watched, event);
    case QEvent::DragEnter:
    case QEvent::DragMove:
        if (auto &drag = static_cast<QDropEvent &>(*event); drag.mimeData()->hasFormat(m_dropType))
            drag.acceptProposedAction();
        return true;
    case QEvent::Drop: drop(static_cast<QDropEvent &>(*event)); return true;
    default: return QObject::eventFilter(watched, event);
    }
}

void PlotInput::drop(QDropEvent &event)
{
    int strip = -1;
    const QPoint at = m_plot.mapFrom(&m_stack, event.pos());
    for (std::size_t i = 0; i < m_strips.all().size(); ++i) {
        if (m_strips.all()[i]->rect().rect().contains(at))
            strip = static_cast<int>(i);
    }
    event.acceptProposedAction();
    Q_EMIT dropped(event.mimeData()->data(m_dropType), strip);
}

void PlotInput::wheel(QWheelEvent *event)
{
    const double factor = std::pow(0.85, event->angleDelta().y() / 120.0);
    const QPoint at = event->position().toPoint();
    const int strip = m_strips.stripAt(at);
    if (event->modifiers().testFlag(Qt::ControlModifier) && strip >= 0) {
        m_strips.at(strip).zoom(factor, at.y());
        Q_EMIT m_strips.changed();
    } else if (event->modifiers().testFlag(Qt::ShiftModifier)) {
        m_view.pan(m_view.span() * -event->angleDelta().y() / 1200.0);
    } else {
        m_view.zoom(factor, m_view.isLive() ? std::nullopt : std::optional(m_strips.keyAt(at.x())));
    }
    event->accept();
}

void PlotInput::zoomValues(double factor)
{
    for (const auto &strip : m_strips.all())
        strip->zoom(factor, strip->rect().center().y());
    Q_EMIT m_strips.changed();
}

void PlotInput::mousePress(QMouseEvent *event)
{
    m_stack.setFocus(Qt::MouseFocusReason);
    if (event->button() != Qt::LeftButton)
        return;
    if (event->modifiers().testFlag(Qt::ShiftModifier))
        return beginBox(event->pos());
    m_draggedTrigger = overTrigger(event->pos());
    m_draggedCursor = m_draggedTrigger ? std::nullopt : m_strips.cursors().hit(event->pos().x());
    m_lastCursor = m_draggedCursor.value_or(m_lastCursor);
    m_drag = event->pos();
}

void PlotInput::pointAt(const QPoint &at)
{
    const bool overCursor = m_draggedCursor || m_strips.cursors().hit(at.x());
    const bool overHandle = m_draggedTrigger || (!m_drag && overTrigger(at));
    m_plot.setCursor(overHandle ? Qt::SizeVerCursor
            : overCursor        ? Qt::SizeHorCursor
            : m_drag            ? Qt::ClosedHandCursor
                                : Qt::ArrowCursor);
}

void PlotInput::mouseMove(QMouseEvent *event)
{
    if (m_box->isVisible()) {
        m_box->setGeometry(QRect(m_boxStart, event->pos()).normalized());
        return;
    }
    pointAt(event->pos());
    if (m_draggedTrigger)
        return dragTrigger(event->pos());
    if (m_draggedCursor)
        return moveCursor(*m_draggedCursor, m_strips.keyAt(event->pos().x()));
    constexpr int Threshold = 4;
    if (!m_drag || (m_view.isLive() && (event->pos() - *m_drag).manhattanLength() < Threshold))
        return;
    m_view.pan(m_strips.keyAt(m_drag->x()) - m_strips.keyAt(event->pos().x()));
    m_drag = event->pos();
    // The axis must follow before the next move is measured against it.
    for (const auto &strip : m_strips.all())
        strip->keys().setRange(m_view.range().first, m_view.range().second);
}

void PlotInput::mouseRelease(QMouseEvent *event)
{
    if (m_box->isVisible())
        endBox(event->pos());
    m_drag.reset();
    m_draggedTrigger = false;
    m_draggedCursor.reset();
    m_plot.unsetCursor();
}

void PlotInput::moveCursor(bool second, double key)
{
    const auto [from, to] = m_view.range();
    m_strips.cursors().setKey(second, std::clamp(key, from, to));
    Q_EMIT cursorMoved();
}

void PlotInput::beginBox(const QPoint &at)
{
    m_boxStart = at;
    m_box->setGeometry(QRect(at, QSize()));
    m_box->show();
}

/// Across only: time. With some height: the values of the strip it began in, too.
void PlotInput::endBox(const QPoint &at)
{
    m_box->hide();
    const QRect box = QRect(m_boxStart, at).normalized();
    const int index = m_strips.stripAt(m_boxStart);
    if (box.width() < SmallestBox || index < 0)
        return;
    if (box.height() >= 2 * SmallestBox)
        m_strips.at(index).zoomInto(box.bottom(), box.top());
    m_view.setRange(m_strips.keyAt(box.left()), m_strips.keyAt(box.right()));
}

const PlotTrace *PlotInput::triggered() const
{
    return m_strips.trigger() ? m_strips.trace(m_strips.trigger()->trace) : nullptr;
}

bool PlotInput::overTrigger(const QPoint &at) const
{
    const PlotTrace *of = triggered();
    if (!of)
        return false;
    const PlotStrip &strip = m_strips.at(of->style.strip);
    const QRect box = strip.rect().rect();
    const double y = strip.axis(of->style.secondAxis).coordToPixel(m_strips.trigger()->level);
    const int reach = m_theme.theme().u(8);
    return std::abs(at.y() - clamped<double>(y, box.top(), box.bottom())) <= reach
        && std::abs(at.x() - box.left()) <= 2 * reach;
}

void PlotInput::dragTrigger(const QPoint &at)
{
    const PlotTrace *of = triggered();
    if (!of)
        return;
    const PlotStrip &strip = m_strips.at(of->style.strip);
    const int y = clamped(at.y(), strip.rect().top(), strip.rect().bottom());
    Q_EMIT triggerLevelMoved(strip.axis(of->style.secondAxis).pixelToCoord(y));
}

bool PlotInput::key(QKeyEvent &event)
{
    const bool plain = !(event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
    return cursorKey(event) || (plain && timeKey(event.key()));
}

bool PlotInput::timeKey(int key)
{
    const double step = m_view.span() * 0.1;
    const auto [from, to] = m_view.range();
    const PlotCursors &cursors = m_strips.cursors();
    switch (key) {
    case Qt::Key_Plus: m_view.zoom(0.8, {}); return true;
    case Qt::Key_Minus: m_view.zoom(1.25, {}); return true;
    case Qt::Key_Left: m_view.pan(-step); return true;
    case Qt::Key_Right: m_view.pan(step); return true;
    case Qt::Key_Home:
    case Qt::Key_End: backToLive(); return true;
    case Qt::Key_0: Q_EMIT fitRequested(); return true;
    case Qt::Key_P: m_view.setLive(!m_view.isLive()); return true;
    case Qt::Key_L: Q_EMIT cursorsToggled(); return true;
    case Qt::Key_N:
        Q_EMIT noteRequested(cursors.visible() ? cursors.key(m_lastCursor)
                : m_view.isLive()              ? m_view.now()
                                               : (from + to) / 2);
        return true;
    default: return valueKey(key);
    }
}

bool PlotInput::valueKey(int key)
{
    switch (key) {
    case Qt::Key_PageUp: zoomValues(0.8); return true;
    case Qt::Key_PageDown: zoomValues(1.25); return true;
    default: return false;
    }
}

/// While the cursors are shown the arrows move the one that was moved last, by a pixel, with Ctrl by ten; C changes to
/// the other.
bool PlotInput::cursorKey(QKeyEvent &event)
{
    if (!m_strips.cursors().visible() || event.modifiers().testFlag(Qt::ShiftModifier))
        return false;
    if (event.key() == Qt::Key_C && event.modifiers() == Qt::NoModifier) {
        m_lastCursor = !m_lastCursor;
        return true;
    }
    if (event.key() != Qt::Key_Left && event.key() != Qt::Key_Right)
        return false;
    const double pixel = m_view.span() / std::max(m_strips.width(), 1);
    const double step = pixel * (event.modifiers().testFlag(Qt::ControlModifier) ? 10 : 1);
    moveCursor(m_lastCursor, m_strips.cursors().key(m_lastCursor) + (event.key() == Qt::Key_Left ? -step : step));
    return true;
}

} // namespace mb
