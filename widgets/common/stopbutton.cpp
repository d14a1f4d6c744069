// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/stopbutton.h"

#include <QMouseEvent>
#include <QPainter>

namespace mb {

StopButton::StopButton(const ThemeSource &theme, QWidget *parent)
    : QAbstractButton(parent)
    , m_theme(theme)
    , m_keys(tr("Space · Esc"))
{
    setFocusPolicy(Qt::NoFocus);
    setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
    setText(tr("STOP"));
    setAccessibleName(tr("Stop every motor"));
    setToolTip(tr("Stop every motor  Space, Esc, Pause"));
    followTheme(theme, *this);
    // Only assistive and programmatic presses come this way: the mouse is served below.
    connect(this, &QAbstractButton::pressed, this, &StopButton::stopPressed);
}

QSize StopButton::sizeHint() const
{
    return {m_theme.theme().u(208), m_theme.theme().u(40)};
}

QSize StopButton::minimumSizeHint() const
{
    return {m_theme.theme().u(160), m_theme.theme().u(40)};
}

void StopButton::mousePressEvent(QMouseEvent *)
{
    setDown(true);
    Q_EMIT stopPressed();
}

void StopButton::mouseReleaseEvent(QMouseEvent *)
{
    setDown(false);
}

void StopButton::changeEvent(QEvent *event)
{
    QAbstractButton::changeEvent(event);
    if (event->type() == QEvent::EnabledChange && testAttribute(Qt::WA_ForceDisabled))
        setEnabled(true);
}

void StopButton::paintEvent(QPaintEvent *)
{
    const Theme &theme = m_theme.theme();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(isDown() ? theme.stop.darker(125) : theme.stop);
    painter.drawRoundedRect(rect(), theme.u(4), theme.u(4));

    const QFont big = theme.font(TextRole::Stop, font());
    const QFont caption = theme.font(TextRole::Caption, font());
    const int wordWidth = QFontMetrics(big).horizontalAdvance(text());
    const int keysWidth = QFontMetrics(caption).horizontalAdvance(m_keys);
    const int gap = theme.u(12);
    const bool fits = wordWidth + gap + keysWidth + theme.u(16) <= width();
    const int x = (width() - wordWidth - (fits ? gap + keysWidth : 0)) / 2;
    painter.setPen(theme.onFill);
    painter.setFont(big);
    painter.drawText(QRect(x, 0, wordWidth + 1, height()), Qt::AlignVCenter, text());
    if (!fits)
        return;
    painter.setFont(caption);
    painter.drawText(QRect(x + wordWidth + gap, 0, keysWidth + 1, height()), Qt::AlignVCenter, m_keys);
}

} // namespace mb
