// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/chip.h"

#include "widgets/common/numberformat.h"
#include "widgets/common/spoken.h"

#include <QPainter>
#include <QPainterPath>
#include <cmath>

namespace mb {

Chip::Chip(const ThemeSource &theme, QWidget *parent)
    : QAbstractButton(parent)
    , m_theme(theme)
{
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setFocusPolicy(Qt::TabFocus);
    setAttribute(Qt::WA_Hover);
    connect(&theme, &ThemeSource::changed, this, &Chip::changed);
}

void Chip::changed()
{
    updateGeometry();
    update();
}

template <typename Value> void Chip::keep(Value &member, Value value)
{
    if (member == value)
        return;
    member = std::move(value);
    changed();
}

void Chip::setGlyph(std::optional<GlyphState> state)
{
    keep(m_glyph, state);
}

void Chip::setTitle(const QString &title)
{
    keep(m_title, title);
}

void Chip::setParts(std::vector<Part> parts)
{
    keep(m_parts, std::move(parts));
}

void Chip::setEdge(std::optional<Tone> edge)
{
    keep(m_edge, edge);
}

void Chip::setFlat(bool flat)
{
    keep(m_flat, flat);
}

QFont Chip::titleFont() const
{
    QFont bold = partFont();
    bold.setBold(!m_flat);
    return bold;
}

QFont Chip::partFont() const
{
    QFont small = font();
    small.setPointSizeF(m_theme.theme().bodyPointSize * 0.92);
    return small;
}

int Chip::partWidth(const Part &part) const
{
    if (part.kind == Part::Kind::Bar)
        return m_theme.theme().u(40);
    const QFontMetrics metrics(partFont());
    return std::max(metrics.horizontalAdvance(part.text), metrics.horizontalAdvance(part.widest));
}

QSize Chip::sizeHint() const
{
    const Theme &theme = m_theme.theme();
    int width = theme.u(10 + 10) + QFontMetrics(titleFont()).horizontalAdvance(m_title);
    if (m_glyph)
        width += theme.u(12 + 6);
    for (const Part &part : m_parts)
        width += theme.u(6) + partWidth(part);
    return {width, theme.u(32)};
}

void Chip::paintFrame(QPainter &painter) const
{
    const Theme &theme = m_theme.theme();
    QPainterPath frame;
    frame.addRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), theme.u(4), theme.u(4));
    if (!m_flat || underMouse())
        painter.fillPath(frame, underMouse() ? theme.hover : theme.window);
    if (m_edge == Tone::Caution)
        painter.fillPath(frame, theme.bannerCaution);
    if (hasFocus())
        painter.strokePath(frame, QPen(theme.accent, 2));
    else if (!m_flat)
        painter.strokePath(frame, QPen(m_edge ? theme.tone(*m_edge) : theme.line, 1));
}

int Chip::paintPart(QPainter &painter, const Part &part, int x) const
{
    const Theme &theme = m_theme.theme();
    const int size = partWidth(part);
    if (part.kind == Part::Kind::Bar) {
        const QRect bar(x, (height() - theme.u(8)) / 2, size, theme.u(8));
        const int filled = static_cast<int>(std::lround(std::clamp(part.level, 0.0, 1.0) * size));
        painter.fillRect(bar, theme.dark ? theme.hover : theme.line);
        painter.fillRect(
            QRect(bar.left(), bar.top(), std::max(part.level > 0 ? 1 : 0, filled), bar.height()), theme.dim);
        return size;
    }
    painter.setFont(partFont());
    painter.setPen(part.strong ? theme.text : theme.dim);
    painter.drawText(QRect(x, 0, size + 1, height()), Qt::AlignVCenter | Qt::AlignRight, part.text);
    return size;
}

void Chip::paintEvent(QPaintEvent *)
{
    const Theme &theme = m_theme.theme();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintFrame(painter);
    int x = theme.u(10);
    if (m_glyph) {
        const double side = theme.u(12);
        paintGlyph(painter, QRectF(x, (height() - side) / 2, side, side), *m_glyph, glyphColor(*m_glyph, theme));
        x += theme.u(12 + 6);
    }
    const int titleWidth = QFontMetrics(titleFont()).horizontalAdvance(m_title);
    painter.setFont(titleFont());
    painter.setPen(m_edge ? theme.tone(*m_edge) : m_flat ? theme.dim : theme.text);
    painter.drawText(QRect(x, 0, titleWidth + 1, height()), Qt::AlignVCenter, m_title);
    x += titleWidth;
    for (const Part &part : m_parts)
        x += theme.u(6) + paintPart(painter, part, x + theme.u(6));
}

LinkChip::LinkChip(const ThemeSource &theme, QWidget *parent)
    : Chip(theme, parent)
{
}

void LinkChip::setStatus(const LinkStatus &status)
{
    m_status = status;
    std::vector<Part> parts;
    QString spoken = status.word;
    if (!status.word.isEmpty()) {
        parts.push_back({status.word});
    } else {
        if (status.load) {
            const double load = std::isnan(*status.load) ? 0.0 : std::round(*status.load * 100.0);
            const QString percent = std::isnan(*status.load) ? QString(UnknownMark) : tr("%1 %").arg(load);
            parts.push_back({{}, false, {}, Part::Kind::Bar, load / 100.0});
            parts.push_back({percent, true, tr("%1 %").arg(88)});
            spoken = tr("load %1").arg(percent);
        } else if (!status.rate.isEmpty()) {
            parts.push_back({status.rate, true});
            spoken = status.rate;
        }
        if (status.lost) {
            const QString lost = tr("lost %1").arg(formatCount(*status.lost));
            parts.push_back({lost, false, tr("lost %1").arg(0)});
            spoken += QStringLiteral(", ") + lost;
        }
    }
    setGlyph(status.state);
    setTitle(status.name);
    setParts(std::move(parts));
    setEdge(status.healthy ? std::nullopt : std::optional(Tone::Caution));
    setSpoken(*this, tr("Link %1: %2").arg(status.name, glyphWord(status.state)), accessibleDescription());
    setSpokenLive(*this, spoken);
    setToolTip(status.tooltip);
}

} // namespace mb
