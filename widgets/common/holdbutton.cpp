// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/holdbutton.h"

#include <QKeyEvent>
#include <QPainter>

namespace mb {

HoldButton::HoldButton(const ThemeSource &theme, Symbol symbol, const QString &text, QWidget *parent)
    : CommandButton(theme, symbol, text, parent)
    , m_theme(theme)
    , m_hold(*this, [this] {
        if (m_needed)
            m_hold.begin();
    })
{
    setAutoDefault(false);
    connect(this, &QAbstractButton::clicked, this, [this] {
        if (!m_needed)
            Q_EMIT activated();
    });
    connect(&m_hold, &HoldGesture::completed, this, &HoldButton::activated);
}

void HoldButton::setHoldNeeded(bool needed)
{
    if (needed == m_needed)
        return;
    m_needed = needed;
    m_hold.end();
    setDown(false);
}

void HoldButton::mouseReleaseEvent(QMouseEvent *event)
{
    if (m_needed)
        setDown(false); // held, never clicked
    CommandButton::mouseReleaseEvent(event);
}

bool HoldButton::holds(const QKeyEvent &key) const
{
    return m_needed && (key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter);
}

void HoldButton::keyPressEvent(QKeyEvent *event)
{
    if (!holds(*event))
        CommandButton::keyPressEvent(event);
    else if (!event->isAutoRepeat())
        m_hold.begin();
}

/// Space is the stop key: its release is no click of a button that the pointer is still on.
void HoldButton::keyReleaseEvent(QKeyEvent *event)
{
    if (m_needed && (event->key() == Qt::Key_Space || event->key() == Qt::Key_Select))
        event->accept();
    else if (!holds(*event))
        CommandButton::keyReleaseEvent(event);
    else if (!event->isAutoRepeat())
        m_hold.end();
}

void HoldButton::paintEvent(QPaintEvent *event)
{
    CommandButton::paintEvent(event);
    if (!m_hold.isUnderWay())
        return;
    QPainter painter(this);
    QColor fill = m_theme.theme().armed;
    fill.setAlphaF(0.45);
    painter.fillRect(QRectF(1, 1, (width() - 2) * m_hold.progress(), height() - 2), fill);
}

} // namespace mb
