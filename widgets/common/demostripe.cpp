// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/demostripe.h"

#include <QPainter>

namespace mb {

DemoStripe::DemoStripe(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    setSources(tr("simulated bench"), {});
    followTheme(theme, *this);
}

void DemoStripe::setSources(const QString &simulated, const QStringList &recordings)
{
    QStringList parts;
    if (!simulated.isEmpty())
        parts += tr("Demo  ·  %1  ·  no real motor is connected").arg(simulated);
    if (!recordings.isEmpty())
        parts += tr("Replay  ·  %1  ·  shows what was recorded, moves no motor")
                     .arg(recordings.join(QStringLiteral(", ")));
    const QString text = parts.join(QStringLiteral("     "));
    if (text == m_text)
        return;
    m_text = text;
    m_word = simulated.isEmpty() ? text.isEmpty() ? QString() : tr("Replay") : tr("Demo");
    setAccessibleName(m_text);
    updateGeometry();
    update();
}

void DemoStripe::setCompact(bool compact)
{
    m_compact = compact;
    setSizePolicy(compact ? QSizePolicy::Fixed : QSizePolicy::Preferred, QSizePolicy::Preferred);
    setToolTip(compact ? m_text : QString());
    updateGeometry();
    update();
}

QSize DemoStripe::sizeHint() const
{
    const Theme &theme = m_theme.theme();
    if (!m_compact)
        return {theme.u(400), theme.u(22)};
    const QFontMetrics metrics(theme.font(TextRole::Section, font()));
    return {metrics.horizontalAdvance(m_word) + theme.u(32), theme.u(22)};
}

void DemoStripe::paintEvent(QPaintEvent *)
{
    if (m_text.isEmpty())
        return;
    const Theme &theme = m_theme.theme();
    QPainter painter(this);
    painter.fillRect(rect(), theme.demo);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.demoAlternate);
    const int band = theme.u(14);
    for (int x = -height(); x < width(); x += 2 * band) {
        const QPoint corners[] = {{x, height()}, {x + height(), 0}, {x + height() + band, 0}, {x + band, height()}};
        painter.drawPolygon(corners, 4);
    }
    QFont text = theme.font(TextRole::Section, font());
    painter.setFont(text);
    painter.setPen(theme.onFill);
    const int room = width() - theme.u(16);
    painter.drawText(rect(), Qt::AlignCenter,
        m_compact ? m_word : QFontMetrics(painter.font()).elidedText(m_text, Qt::ElideRight, room));
}

} // namespace mb
