// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/resolutionmeter.h"

#include "widgets/common/numberformat.h"

#include <QPainter>

#include <array>

namespace mb {
namespace {

constexpr std::array<std::int64_t, 4> limits{10, 50, 500, 5000};
constexpr std::int64_t coarse = 50;
constexpr std::int64_t useless = 10;
constexpr std::int64_t thousand = 1000;
constexpr std::int64_t longest = 10000; ///< shown in full below this

} // namespace

ResolutionMeter::ResolutionMeter(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    followTheme(theme, *this);
    setSteps(0);
}

int ResolutionMeter::barsOf(std::int64_t steps)
{
    int bars = 0;
    for (const std::int64_t limit : limits)
        bars += steps > limit ? 1 : 0;
    return bars;
}

Tone ResolutionMeter::toneOf(std::int64_t steps)
{
    if (steps == 0)
        return Tone::Faint;
    return steps < useless ? Tone::Danger : steps < coarse ? Tone::Caution : Tone::Ok;
}

void ResolutionMeter::setSteps(std::int64_t steps)
{
    m_steps = steps;
    setAccessibleName(m_steps == 0 ? tr("Resolution: off") : tr("Resolution: %1 steps").arg(formatCount(m_steps)));
    setToolTip(m_steps == 0
            ? QString()
            : tr("The device knows this value as %1 whole steps: the smallest change is %2 %.")
                  .arg(formatCount(m_steps), formatSignificant(100.0 / static_cast<double>(m_steps), 2)));
    update();
}

QString ResolutionMeter::words() const
{
    if (m_steps == 0)
        return UnknownMark;
    if (m_steps < longest)
        return tr("%1 LSB").arg(formatCount(m_steps));
    return tr("%1 k LSB").arg(formatCount(m_steps / thousand));
}

QSize ResolutionMeter::sizeHint() const
{
    const QFontMetrics caption(m_theme.theme().font(TextRole::Caption, font()));
    const int width = m_theme.theme().u(4 * 12 + 6) + caption.horizontalAdvance(tr("%1 LSB").arg(formatCount(9999)));
    return {width, std::max(caption.height(), m_theme.theme().u(24))};
}

void ResolutionMeter::paintEvent(QPaintEvent *)
{
    const Theme &theme = m_theme.theme();
    QPainter painter(this);
    const int bars = barsOf(m_steps);
    const QSize bar(theme.u(8), theme.u(10));
    const Tone tone = toneOf(m_steps);
    for (int i = 0; i < 4; ++i) {
        const QRect box(i * theme.u(12), (height() - bar.height()) / 2, bar.width(), bar.height());
        painter.fillRect(box, i < bars ? theme.tone(tone) : theme.line);
        if (i == 0 && bars == 0 && m_steps > 0) { // too little for one bar, yet not off
            painter.setPen(theme.tone(tone));
            painter.drawRect(box.adjusted(0, 0, -1, -1));
        }
    }
    painter.setFont(theme.font(TextRole::Caption, font()));
    painter.setPen(tone == Tone::Ok ? theme.dim : theme.tone(tone));
    painter.drawText(rect().adjusted(theme.u(4 * 12 + 2), 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft, words());
}

} // namespace mb
