// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/lampface.h"

#include "widgets/common/icons.h"
#include "widgets/common/stateglyph.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace mb {

LampFace::LampFace(const Theme &theme, const QFont &body, const LampStatus &status, bool holding)
    : m_theme(theme)
    , m_body(body)
    , m_status(status)
    , m_holding(holding)
{
}

QString LampFace::word() const
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

QString LampFace::clock() const
{
    if (m_status.state != LampState::Armed || !m_status.remaining)
        return {};
    const auto seconds = std::max<qint64>(0, m_status.remaining->count());
    return QStringLiteral("%1:%2").arg(seconds / 60).arg(seconds % 60, 2, 10, QLatin1Char('0'));
}

QString LampFace::detail() const
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

int LampFace::textWidth(const QString &word, const QString &time, const QString &detail) const
{
    const Theme &theme = m_theme;
    const QFontMetrics bold(theme.font(TextRole::Emphasis, m_body));
    const QFontMetrics caption(theme.font(TextRole::Caption, m_body));
    int width = theme.u(12 + 16 + 8 + 12) + bold.horizontalAdvance(word);
    if (hasTwoLines() && word == this->word())
        return std::max(width, theme.u(12 + 16 + 8 + 12) + caption.horizontalAdvance(detail));
    if (!time.isEmpty())
        width += theme.u(8) + bold.horizontalAdvance(time);
    if (!detail.isEmpty())
        width += theme.u(8) + caption.horizontalAdvance(detail);
    return width;
}

QSize LampFace::preferred() const
{
    const int usual = std::max({textWidth(tr("ARMED"), QStringLiteral("8:88"), tr("#88 velocity")),
        textWidth(tr("STOPPED"), {}, tr("hold to re-arm")), textWidth(tr("SAFE"), {}, tr("nothing to arm"))});
    return {std::max(m_theme.u(200), usual), m_theme.u(40)};
}

QSize LampFace::least() const
{
    const Theme &theme = m_theme;
    const QFontMetrics bold(theme.font(TextRole::Emphasis, m_body));
    const QFontMetrics caption(theme.font(TextRole::Caption, m_body));
    const int words = std::max({bold.horizontalAdvance(tr("SAFE")), bold.horizontalAdvance(tr("MOVING")),
        bold.horizontalAdvance(tr("STOPPED")), bold.horizontalAdvance(tr("STOPPING")),
        bold.horizontalAdvance(tr("ARMED")) + theme.u(8) + bold.horizontalAdvance(QStringLiteral("8:88")),
        caption.horizontalAdvance(tr("hold to arm")), caption.horizontalAdvance(tr("hold to re-arm")),
        caption.horizontalAdvance(tr("nothing to arm")), caption.horizontalAdvance(tr("keep holding"))});
    return {theme.u(12 + 16 + 8 + 12) + words, theme.u(40)};
}

void LampFace::paintPlate(QPainter &painter, const QSize &size, double progress) const
{
    const Theme &theme = m_theme;
    const QRectF box = QRectF(QPointF(), size).adjusted(0.5, 0.5, -0.5, -0.5);
    QPainterPath face;
    face.addRoundedRect(box, theme.u(4), theme.u(4));
    const bool stopped = m_status.state == LampState::Stopped || m_status.state == LampState::Stopping;
    painter.fillPath(face,
        isLive(m_status)                           ? theme.armed
            : m_status.state == LampState::MayTurn ? theme.stop
            : m_status.armable                     ? theme.control
                                                   : theme.head);
    if (m_holding) {
        painter.save();
        painter.setClipRect(QRectF(0, 0, size.width() * progress, size.height()));
        painter.fillPath(face, theme.armed);
        painter.restore();
    }
    const QColor edge = isLive(m_status)       ? theme.armed
        : m_status.state == LampState::MayTurn ? theme.stop
        : stopped                              ? theme.danger
        : m_status.armable                     ? theme.outline
                                               : theme.line;
    painter.strokePath(face, QPen(edge, stopped ? 2 : 1));
}

void LampFace::paintMark(QPainter &painter, int x, int height, const QColor &color) const
{
    const double side = m_theme.u(16);
    const QRectF mark(x, (height - side) / 2.0, side, side);
    switch (m_status.state) {
    case LampState::Moving:
    case LampState::Stopping: paintGlyph(painter, mark, GlyphState::Moving, color); break;
    case LampState::Stopped: paintGlyph(painter, mark, GlyphState::Fault, color); break;
    case LampState::MayTurn: paintGlyph(painter, mark, GlyphState::Warning, color); break;
    case LampState::Safe:
    case LampState::Armed: paintSymbol(painter, mark, isLive(m_status) ? Symbol::Arm : Symbol::Lock, color); break;
    }
}

/// Where one line is too narrow. The word is always whole; a longer detail is in the tooltip and in what is read aloud.
void LampFace::paintLines(QPainter &painter, const QSize &size, const QColor &color, const QColor &detailColor) const
{
    const Theme &theme = m_theme;
    paintMark(painter, theme.u(12), size.height(), color);
    const int x = theme.u(12 + 16 + 8);
    const int room = size.width() - x - theme.u(4);
    const QString head = clock().isEmpty() ? word() : word() + QLatin1Char(' ') + clock();
    const QFont bold = theme.font(TextRole::Emphasis, m_body);
    const QFont caption = theme.font(TextRole::Caption, m_body);
    const int tall = QFontMetrics(bold).height();
    const int low = detail().isEmpty() ? 0 : QFontMetrics(caption).height();
    const int top = (size.height() - tall - low) / 2;
    painter.setFont(bold);
    painter.setPen(color);
    if (QFontMetrics(bold).horizontalAdvance(head) > room) { // the long word takes both lines
        painter.drawText(QRect(x, 0, room, size.height()), Qt::AlignVCenter | Qt::TextWordWrap, head);
        return;
    }
    painter.drawText(QRect(x, top, room, tall), Qt::AlignVCenter, head);
    painter.setFont(caption);
    painter.setPen(detailColor);
    painter.drawText(QRect(x, top + tall, room, low), Qt::AlignVCenter,
        QFontMetrics(caption).elidedText(detail(), Qt::ElideRight, room));
}

void LampFace::paintContent(QPainter &painter, const QSize &size, const QColor &color, const QColor &detailColor) const
{
    if (hasTwoLines() || size.width() < contentWidth()) {
        paintLines(painter, size, color, detailColor);
        return;
    }
    const Theme &theme = m_theme;
    const QFont bold = theme.font(TextRole::Emphasis, m_body);
    const QFont caption = theme.font(TextRole::Caption, m_body);
    int x = (size.width() - contentWidth()) / 2 + theme.u(12);
    paintMark(painter, x, size.height(), color);
    x += theme.u(16 + 8);
    const auto put = [&](const QString &text, const QFont &textFont, const QColor &textColor) {
        if (text.isEmpty())
            return;
        painter.setFont(textFont);
        painter.setPen(textColor);
        painter.drawText(QRect(x, 0, size.width() - x, size.height()), Qt::AlignVCenter, text);
        x += QFontMetrics(textFont).horizontalAdvance(text) + theme.u(8);
    };
    put(word(), bold, color);
    put(clock(), bold, color);
    put(detail(), caption, detailColor);
}

void LampFace::paint(QPainter &painter, const QSize &size, double progress) const
{
    const Theme &theme = m_theme;
    paintPlate(painter, size, progress);
    if (isLive(m_status)) {
        paintContent(painter, size, theme.onArmed, theme.onArmed);
        return;
    }
    if (m_status.state == LampState::MayTurn) {
        paintContent(painter, size, theme.onFill, theme.onFill);
        return;
    }
    const bool stopped = m_status.state == LampState::Stopped || m_status.state == LampState::Stopping;
    const QColor word = stopped ? theme.danger : m_status.armable ? theme.text : theme.faint;
    paintContent(painter, size, word, m_status.armable ? theme.dim : theme.faint);
    if (!m_holding)
        return;
    painter.setClipRect(QRectF(0, 0, size.width() * progress, size.height()));
    paintContent(painter, size, theme.onArmed, theme.onArmed);
}

} // namespace mb
