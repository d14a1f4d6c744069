// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/lamp.h"

#include "widgets/common/icons.h"
#include "widgets/common/spoken.h"
#include "widgets/common/stateglyph.h"

#include <QAccessible>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

namespace mb {

Lamp::Lamp(const ThemeSource &theme, QWidget *parent)
    : QAbstractButton(parent)
    , m_theme(theme)
{
    setFocusPolicy(Qt::NoFocus);
    setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
    updateAccessibleText(LampState::Safe);
    connect(&theme, &ThemeSource::changed, this, [this] {
        updateGeometry();
        update();
    });
    connect(this, &QAbstractButton::clicked, this, [this] { m_holding ? endHold(false) : press(); });
}

void Lamp::setStatus(const LampStatus &status)
{
    const LampState before = m_status.state;
    m_status = status;
    if (m_holding && (live() || !status.armable))
        endHold(false);
    updateAccessibleText(before);
    updateGeometry();
    update();
}

double Lamp::holdProgress() const
{
    if (!m_holding)
        return 0.0;
    return m_hold <= 0 ? 1.0 : std::min(1.0, static_cast<double>(m_held.elapsed()) / m_hold);
}

QString Lamp::word() const
{
    switch (m_status.state) {
    case LampState::Safe: return tr("SAFE");
    case LampState::Armed: return tr("ARMED");
    case LampState::Moving: return tr("MOVING");
    case LampState::Stopped: return tr("STOPPED");
    case LampState::Stopping: return tr("STOPPING");
    case LampState::MayTurn: return tr("MAY STILL TURN");
    }
    return {};
}

QString Lamp::clock() const
{
    if (m_status.state != LampState::Armed || !m_status.remaining)
        return {};
    const auto seconds = std::max<qint64>(0, m_status.remaining->count());
    return QStringLiteral("%1:%2").arg(seconds / 60).arg(seconds % 60, 2, 10, QLatin1Char('0'));
}

QString Lamp::detail() const
{
    if (m_holding)
        return tr("keep holding");
    if (!m_status.detail.isEmpty())
        return m_status.detail;
    switch (m_status.state) {
    case LampState::Safe: return m_status.armable ? tr("hold to arm") : tr("nothing to arm");
    case LampState::Stopped: return tr("hold to re-arm");
    case LampState::MayTurn: return tr("cut its power");
    case LampState::Armed:
    case LampState::Moving:
    case LampState::Stopping: break;
    }
    return {};
}

void Lamp::updateAccessibleText(LampState before)
{
    setSpoken(
        *this, tr("Arm button: %1").arg(word()), clock().isEmpty() ? detail() : clock() + QLatin1Char(' ') + detail());
    setToolTip(m_status.state == LampState::MayTurn ? detail() + QLatin1Char('\n')
                + tr("A motor was told to stop and was not seen to. Cut its power, or look at it.")
            : live() ? tr("Press to make it safe again")
                     : tr("Hold for one second to arm"));
    if (before != m_status.state) {
        QAccessibleEvent event(this, QAccessible::Alert);
        QAccessible::updateAccessibility(&event);
    }
}

void Lamp::press()
{
    if (live() || m_status.state == LampState::MayTurn)
        Q_EMIT disarmRequested();
    else if (m_status.armable)
        beginHold();
}

void Lamp::hold()
{
    if (!m_holding && !live() && m_status.state != LampState::MayTurn && m_status.armable)
        beginHold();
}

void Lamp::beginHold()
{
    m_holding = true;
    m_held.start();
    m_tick.start(std::clamp(m_hold / 10, 1, 16), Qt::PreciseTimer, this);
    Q_EMIT holdingChanged(true);
    updateGeometry();
    update();
}

void Lamp::endHold(bool complete)
{
    if (!m_holding)
        return;
    m_holding = false;
    m_tick.stop();
    update();
    Q_EMIT holdingChanged(false);
    if (complete)
        Q_EMIT armRequested();
}

void Lamp::mousePressEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton && !m_holding)
        press();
}

void Lamp::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton)
        letGo();
}

void Lamp::mouseMoveEvent(QMouseEvent *event)
{
    if (!rect().contains(event->pos()))
        endHold(false);
}

void Lamp::timerEvent(QTimerEvent *event)
{
    if (event->timerId() != m_tick.timerId())
        return QAbstractButton::timerEvent(event);
    if (holdProgress() >= 1.0)
        endHold(true);
    else
        update();
}

void Lamp::hideEvent(QHideEvent *event)
{
    endHold(false);
    QAbstractButton::hideEvent(event);
}

void Lamp::changeEvent(QEvent *event)
{
    const bool lost = event->type() == QEvent::ActivationChange && !isActiveWindow();
    if (lost || (event->type() == QEvent::EnabledChange && !isEnabled()))
        endHold(false);
    QAbstractButton::changeEvent(event);
}

int Lamp::textWidth(const QString &word, const QString &time, const QString &detail) const
{
    const Theme &theme = m_theme.theme();
    const QFontMetrics bold(theme.font(TextRole::Emphasis, font()));
    const QFontMetrics caption(theme.font(TextRole::Caption, font()));
    int width = theme.u(12 + 16 + 8 + 12) + bold.horizontalAdvance(word);
    if (hasTwoLines() && word == this->word())
        return std::max(width, theme.u(12 + 16 + 8 + 12) + caption.horizontalAdvance(detail));
    if (!time.isEmpty())
        width += theme.u(8) + bold.horizontalAdvance(time);
    if (!detail.isEmpty())
        width += theme.u(8) + caption.horizontalAdvance(detail);
    return width;
}

int Lamp::contentWidth() const
{
    return textWidth(word(), clock(), detail());
}

QSize Lamp::sizeHint() const
{
    // Wide enough for the usual texts of every state, so that the lamp keeps its place when the state changes.
    const int usual = std::max({textWidth(tr("ARMED"), QStringLiteral("8:88"), tr("#88 velocity")),
        textWidth(tr("STOPPED"), {}, tr("hold to re-arm")), textWidth(tr("SAFE"), {}, tr("nothing to arm"))});
    return {std::max({m_theme.theme().u(200), usual, contentWidth()}), m_theme.theme().u(40)};
}

QSize Lamp::minimumSizeHint() const
{
    const Theme &theme = m_theme.theme();
    const QFontMetrics bold(theme.font(TextRole::Emphasis, font()));
    const QFontMetrics caption(theme.font(TextRole::Caption, font()));
    const int words = std::max({bold.horizontalAdvance(tr("SAFE")), bold.horizontalAdvance(tr("MOVING")),
        bold.horizontalAdvance(tr("STOPPED")), bold.horizontalAdvance(tr("STOPPING")),
        bold.horizontalAdvance(tr("ARMED")) + theme.u(8) + bold.horizontalAdvance(QStringLiteral("8:88")),
        caption.horizontalAdvance(tr("hold to arm")), caption.horizontalAdvance(tr("hold to re-arm")),
        caption.horizontalAdvance(tr("nothing to arm")), caption.horizontalAdvance(tr("keep holding"))});
    return {theme.u(12 + 16 + 8 + 12) + words, theme.u(40)};
}

void Lamp::paintFace(QPainter &painter) const
{
    const Theme &theme = m_theme.theme();
    const QRectF box = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    QPainterPath face;
    face.addRoundedRect(box, theme.u(4), theme.u(4));
    const bool stopped = m_status.state == LampState::Stopped || m_status.state == LampState::Stopping;
    painter.fillPath(face,
        live()                                     ? theme.armed
            : m_status.state == LampState::MayTurn ? theme.stop
            : m_status.armable                     ? theme.control
                                                   : theme.head);
    if (m_holding) {
        painter.save();
        painter.setClipRect(QRectF(0, 0, width() * holdProgress(), height()));
        painter.fillPath(face, theme.armed);
        painter.restore();
    }
    const QColor edge = live()                 ? theme.armed
        : m_status.state == LampState::MayTurn ? theme.stop
        : stopped                              ? theme.danger
        : m_status.armable                     ? theme.outline
                                               : theme.line;
    painter.strokePath(face, QPen(edge, stopped ? 2 : 1));
}

void Lamp::paintMark(QPainter &painter, int x, const QColor &color) const
{
    const double side = m_theme.theme().u(16);
    const QRectF mark(x, (height() - side) / 2.0, side, side);
    switch (m_status.state) {
    case LampState::Moving:
    case LampState::Stopping: paintGlyph(painter, mark, GlyphState::Moving, color); break;
    case LampState::Stopped: paintGlyph(painter, mark, GlyphState::Fault, color); break;
    case LampState::MayTurn: paintGlyph(painter, mark, GlyphState::Warning, color); break;
    case LampState::Safe:
    case LampState::Armed: paintSymbol(painter, mark, live() ? Symbol::Arm : Symbol::Lock, color); break;
    }
}

/// Where one line is too narrow. The word is always whole; a longer detail is in the tooltip and in what is read aloud.
void Lamp::paintLines(QPainter &painter, const QColor &color, const QColor &detailColor) const
{
    const Theme &theme = m_theme.theme();
    paintMark(painter, theme.u(12), color);
    const int x = theme.u(12 + 16 + 8);
    const int room = width() - x - theme.u(4);
    const QString head = clock().isEmpty() ? word() : word() + QLatin1Char(' ') + clock();
    const QFont bold = theme.font(TextRole::Emphasis, font());
    const QFont caption = theme.font(TextRole::Caption, font());
    const int tall = QFontMetrics(bold).height();
    const int low = detail().isEmpty() ? 0 : QFontMetrics(caption).height();
    const int top = (height() - tall - low) / 2;
    painter.setFont(bold);
    painter.setPen(color);
    if (QFontMetrics(bold).horizontalAdvance(head) > room) { // the long word takes both lines
        painter.drawText(QRect(x, 0, room, height()), Qt::AlignVCenter | Qt::TextWordWrap, head);
        return;
    }
    painter.drawText(QRect(x, top, room, tall), Qt::AlignVCenter, head);
    painter.setFont(caption);
    painter.setPen(detailColor);
    painter.drawText(QRect(x, top + tall, room, low), Qt::AlignVCenter,
        QFontMetrics(caption).elidedText(detail(), Qt::ElideRight, room));
}

void Lamp::paintContent(QPainter &painter, const QColor &color, const QColor &detailColor) const
{
    if (isNarrow()) {
        paintLines(painter, color, detailColor);
        return;
    }
    const Theme &theme = m_theme.theme();
    const QFont bold = theme.font(TextRole::Emphasis, font());
    const QFont caption = theme.font(TextRole::Caption, font());
    int x = (width() - contentWidth()) / 2 + theme.u(12);
    paintMark(painter, x, color);
    x += theme.u(16 + 8);
    const auto put = [&](const QString &text, const QFont &textFont, const QColor &textColor) {
        if (text.isEmpty())
            return;
        painter.setFont(textFont);
        painter.setPen(textColor);
        painter.drawText(QRect(x, 0, width() - x, height()), Qt::AlignVCenter, text);
        x += QFontMetrics(textFont).horizontalAdvance(text) + theme.u(8);
    };
    put(word(), bold, color);
    put(clock(), bold, color);
    put(detail(), caption, detailColor);
}

void Lamp::paintEvent(QPaintEvent *)
{
    const Theme &theme = m_theme.theme();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintFace(painter);
    if (live()) {
        paintContent(painter, theme.onArmed, theme.onArmed);
        return;
    }
    if (m_status.state == LampState::MayTurn) {
        paintContent(painter, theme.onFill, theme.onFill);
        return;
    }
    const bool stopped = m_status.state == LampState::Stopped || m_status.state == LampState::Stopping;
    const QColor word = stopped ? theme.danger : m_status.armable ? theme.text : theme.faint;
    paintContent(painter, word, m_status.armable ? theme.dim : theme.faint);
    if (!m_holding)
        return;
    painter.setClipRect(QRectF(0, 0, width() * holdProgress(), height()));
    paintContent(painter, theme.onArmed, theme.onArmed);
}

} // namespace mb
