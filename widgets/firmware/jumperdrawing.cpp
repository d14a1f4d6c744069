// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/firmware/jumperdrawing.h"

#include <QPainter>

#include <array>

namespace mb {
namespace {

// The drawing's own units; it is scaled to the width.
constexpr QSizeF page{300, 168};
constexpr QRectF board{112, 8, 180, 152};
constexpr QRectF adapter{8, 28, 62, 104};
constexpr double pin = 4.0;
constexpr QPointF aux1{216, 52};
constexpr QPointF aux2{246, 52};

struct Wire {
    const char *from;
    const char *to;
    double fromY;
    double toY;
    Tone tone;
};
constexpr std::array<Wire, 4> wires{{
    {"3V3", "3V3", 48, 48, Tone::Danger},
    {"TX", "RX", 70, 92, Tone::Accent},
    {"RX", "TX", 92, 70, Tone::Ok},
    {"GND", "GND", 114, 114, Tone::Dim},
}};
constexpr double adapterX = 62;
constexpr double boardX = 122;

} // namespace

JumperDrawing::JumperDrawing(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    setObjectName(QStringLiteral("jumperDrawing"));
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    setClosed(true);
    connect(&theme, &ThemeSource::changed, this, qOverload<>(&QWidget::update));
}

void JumperDrawing::setClosed(bool closed)
{
    m_closed = closed;
    setAccessibleName(closed
            ? tr("Drawing: the jumper connects AUX1 and AUX2; adapter TX to board RX, RX to TX, 3.3 V, GND")
            : tr("Drawing: the jumper between AUX1 and AUX2 is taken out"));
    update();
}

QSize JumperDrawing::sizeHint() const
{
    const int width = m_theme.theme().u(page.width());
    return {width, heightForWidth(width)};
}

int JumperDrawing::heightForWidth(int width) const
{
    const double most = m_theme.theme().u(page.width() * 1.4);
    return static_cast<int>(std::min<double>(width, most) * page.height() / page.width());
}

void JumperDrawing::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double scale = std::min(width() / page.width(), height() / page.height());
    painter.scale(scale, scale);
    QFont small = font();
    small.setPixelSize(11);
    painter.setFont(small);
    paintBoard(painter);
    paintAdapter(painter);
    paintWires(painter);
    paintJumper(painter);
}

void JumperDrawing::paintBoard(QPainter &painter) const
{
    const Theme &theme = m_theme.theme();
    painter.setPen(QPen(theme.outline, 1.5));
    painter.setBrush(theme.control);
    painter.drawRoundedRect(board, 6, 6);
    painter.setPen(theme.dim);
    painter.drawText(
        QRectF(board.left(), board.bottom() - 24, board.width(), 20), Qt::AlignCenter, QStringLiteral("QuadQuad2Drv"));
    painter.setPen(QPen(theme.outline, 1));
    painter.setBrush(theme.panel);
    painter.drawRect(QRectF(190, 88, 44, 40)); // the chip
    painter.setBrush(theme.outline);
    painter.drawEllipse(QPointF(196, 94), 2, 2);
}

void JumperDrawing::paintAdapter(QPainter &painter) const
{
    const Theme &theme = m_theme.theme();
    painter.setPen(QPen(theme.outline, 1.5));
    painter.setBrush(theme.panel);
    painter.drawRoundedRect(adapter, 4, 4);
    painter.setPen(theme.dim);
    painter.drawText(QRectF(adapter.left() - 6, adapter.top() - 22, adapter.width() + 40, 18),
        Qt::AlignLeft | Qt::AlignBottom, tr("adapter, 3.3 V"));
}

void JumperDrawing::paintWires(QPainter &painter) const
{
    const Theme &theme = m_theme.theme();
    for (const Wire &wire : wires) {
        const QPointF from(adapterX, wire.fromY);
        const QPointF to(boardX, wire.toY);
        painter.setPen(QPen(theme.tone(wire.tone), 2, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(from, to);
        painter.setPen(QPen(theme.outline, 1));
        painter.setBrush(theme.canvas);
        painter.drawEllipse(from, pin, pin);
        painter.drawEllipse(to, pin, pin);
        painter.setPen(theme.text);
        painter.drawText(QRectF(adapter.left() + 4, wire.fromY - 9, adapterX - adapter.left() - 10, 18),
            Qt::AlignVCenter | Qt::AlignLeft, QLatin1String(wire.from));
        painter.drawText(
            QRectF(boardX + 8, wire.toY - 9, 34, 18), Qt::AlignVCenter | Qt::AlignLeft, QLatin1String(wire.to));
    }
}

void JumperDrawing::paintJumper(QPainter &painter) const
{
    const Theme &theme = m_theme.theme();
    // A cap over both pins, or beside them with the way it went.
    const QPointF offset = m_closed ? QPointF() : QPointF(0, -30);
    const QRectF cap = QRectF(aux1.x() - 9, aux1.y() - 9, aux2.x() - aux1.x() + 18, 18).translated(offset);
    painter.setPen(QPen(theme.outline, 1));
    painter.setBrush(theme.canvas);
    painter.drawEllipse(aux1, pin, pin);
    painter.drawEllipse(aux2, pin, pin);
    if (m_closed) {
        painter.setPen(QPen(theme.accent, 2));
        painter.setBrush(theme.accent);
        painter.drawRoundedRect(cap, 4, 4);
        painter.setPen(QPen(theme.onFill, 2));
        painter.drawLine(aux1, aux2);
    } else {
        painter.setPen(QPen(theme.accent, 1.5, Qt::DashLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(cap, 4, 4);
        const QPointF foot((aux1.x() + aux2.x()) / 2, aux1.y() - 4);
        const QPointF head(foot.x(), cap.bottom() + 3);
        painter.setPen(QPen(theme.accent, 1.5));
        painter.drawLine(foot, head);
        painter.drawLine(head, head + QPointF(-3, 4));
        painter.drawLine(head, head + QPointF(3, 4));
    }
    painter.setPen(theme.text);
    painter.drawText(QRectF(aux1.x() - 26, aux1.y() + 10, 36, 18), Qt::AlignCenter, QStringLiteral("AUX1"));
    painter.drawText(QRectF(aux2.x() - 10, aux2.y() + 10, 36, 18), Qt::AlignCenter, QStringLiteral("AUX2"));
}

} // namespace mb
