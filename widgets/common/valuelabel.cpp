// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/valuelabel.h"

#include "widgets/common/numberformat.h"
#include "widgets/common/spoken.h"

#include <QPainter>

namespace mb {
namespace {

constexpr int narrowerUntil = 60; ///< values: some seconds of a device

} // namespace

ValueLabel::ValueLabel(
    const ThemeSource &theme, Look look, const QString &caption, const QString &unit, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
    , m_look(look)
    , m_caption(caption)
    , m_unit(unit)
    , m_value(UnknownMark)
    , m_widest(formatNumber(-88888))
{
    setSizePolicy(look == Look::Row ? QSizePolicy::Preferred : QSizePolicy::Fixed, QSizePolicy::Fixed);
    m_broadest = QFontMetrics(valueFont()).horizontalAdvance(m_value);
    setSpoken(*this, m_caption, m_value + QLatin1Char(' ') + m_unit);
    followTheme(theme, *this);
}

void ValueLabel::setWidest(const QString &widest)
{
    m_widest = widest;
    updateGeometry();
}

void ValueLabel::followBreadth(const QString &value)
{
    const int width = QFontMetrics(valueFont()).horizontalAdvance(value);
    m_narrower = width < m_broadest ? m_narrower + 1 : 0;
    if (width <= m_broadest && m_narrower < narrowerUntil)
        return;
    m_broadest = width;
    m_narrower = 0;
    update();
}

void ValueLabel::setValue(const QString &value)
{
    if (m_look == Look::Line) // the only one that draws its caption by it
        followBreadth(value);
    if (value == m_value)
        return;
    const int before = fieldWidth();
    m_value = value;
    updateAccessibleText();
    if (fieldWidth() != before)
        updateGeometry();
    update();
}

void ValueLabel::clear()
{
    setValue(UnknownMark);
    m_broadest = QFontMetrics(valueFont()).horizontalAdvance(m_value);
}

void ValueLabel::setLive(const LiveText &live)
{
    if (!live.unit.isEmpty())
        setUnit(live.unit);
    if (live.isKnown())
        setValue(live.number);
    else
        clear();
}

void ValueLabel::setUnit(const QString &unit)
{
    if (unit == m_unit)
        return;
    m_unit = unit;
    updateAccessibleText();
    updateGeometry();
    update();
}

void ValueLabel::setTone(Tone tone)
{
    if (tone == m_tone)
        return;
    m_tone = tone;
    update();
}

void ValueLabel::setStale(bool stale)
{
    m_stale = stale;
    update();
}

void ValueLabel::updateAccessibleText()
{
    if (accessibleName() != m_caption)
        setAccessibleName(m_caption);
    setSpokenLive(*this, m_value + QLatin1Char(' ') + m_unit);
}

QFont ValueLabel::valueFont() const
{
    const TextRole role = m_look == Look::Card ? TextRole::Large
        : m_look == Look::Line                 ? TextRole::Emphasis
                                               : TextRole::Body;
    return m_theme.theme().font(role, font());
}

QFont ValueLabel::captionFont() const
{
    return m_theme.theme().font(m_look == Look::Row ? TextRole::Body : TextRole::Caption, font());
}

int ValueLabel::fieldWidth() const
{
    const QFontMetrics metrics(valueFont());
    return std::max(metrics.horizontalAdvance(m_widest), metrics.horizontalAdvance(m_value));
}

QSize ValueLabel::sizeHint() const
{
    const Theme &theme = m_theme.theme();
    const QFontMetrics caption(captionFont());
    const QFontMetrics units(theme.font(TextRole::Caption, font()));
    const int unit = units.horizontalAdvance(m_unit) + theme.u(4);
    const int value = fieldWidth() + unit;
    const int heading = caption.horizontalAdvance(m_caption);
    const int line = QFontMetrics(valueFont()).height();
    switch (m_look) {
    case Look::Card: return {std::max(value, heading), caption.height() + line};
    case Look::Line: return {heading + theme.u(6) + value, std::max(line, theme.u(24))};
    case Look::Row: return {heading + theme.u(12) + value, std::max(line, theme.u(24))};
    }
    return {};
}

QSize ValueLabel::minimumSizeHint() const
{
    return m_look == Look::Row ? QSize(fieldWidth(), sizeHint().height()) : sizeHint();
}

void ValueLabel::paintEvent(QPaintEvent *)
{
    const Theme &theme = m_theme.theme();
    QPainter painter(this);
    const bool known = m_value != UnknownMark;
    const QColor color = m_stale || !isEnabled() ? theme.faint : known ? theme.tone(m_tone) : theme.dim;
    switch (m_look) {
    case Look::Card: return paintCard(painter, color);
    case Look::Line: return paintLine(painter, color);
    case Look::Row: return paintRow(painter, color);
    }
}

void ValueLabel::paintCard(QPainter &painter, const QColor &color) const
{
    const Theme &theme = m_theme.theme();
    const QFontMetrics caption(captionFont());
    painter.setFont(captionFont());
    painter.setPen(theme.dim);
    painter.drawText(QRect(0, 0, width(), caption.height()), Qt::AlignVCenter, m_caption);
    // On a common baseline, value first. Left: a card has room behind the unit, so nothing else moves.
    const QFontMetrics metrics(valueFont());
    const int baseline = caption.height() + metrics.ascent();
    painter.setFont(valueFont());
    painter.setPen(color);
    painter.drawText(0, baseline, m_value);
    if (m_value == UnknownMark)
        return;
    painter.setFont(captionFont());
    painter.setPen(theme.dim);
    painter.drawText(metrics.horizontalAdvance(m_value) + theme.u(4), baseline, m_unit);
}

void ValueLabel::paintLine(QPainter &painter, const QColor &color) const
{
    const Theme &theme = m_theme.theme();
    const QFontMetrics metrics(valueFont());
    const int baseline = (height() + metrics.ascent() - metrics.descent()) / 2;
    painter.setFont(captionFont());
    painter.setPen(theme.dim);
    painter.drawText(fieldWidth() - m_broadest, baseline, m_caption); // beside its number, not beside the number before
    const int left = QFontMetrics(captionFont()).horizontalAdvance(m_caption) + theme.u(6);
    painter.setFont(valueFont());
    painter.setPen(color);
    painter.drawText(left + fieldWidth() - metrics.horizontalAdvance(m_value), baseline, m_value);
    painter.setFont(theme.font(TextRole::Caption, font()));
    painter.setPen(theme.dim);
    painter.drawText(left + fieldWidth() + theme.u(4), baseline, m_unit);
}

void ValueLabel::paintRow(QPainter &painter, const QColor &color) const
{
    const Theme &theme = m_theme.theme();
    const QFontMetrics metrics(valueFont());
    const bool withUnit = !m_unit.isEmpty() && m_value != UnknownMark;
    const QString shown = withUnit ? m_value + QChar(QChar::Nbsp) + m_unit : m_value;
    const int taken = metrics.horizontalAdvance(shown);
    painter.setFont(captionFont());
    painter.setPen(theme.dim);
    const int room = std::max(0, width() - taken - theme.u(8));
    painter.drawText(QRect(0, 0, room, height()), Qt::AlignVCenter,
        QFontMetrics(captionFont()).elidedText(m_caption, Qt::ElideRight, room));
    painter.setFont(valueFont());
    painter.setPen(color);
    painter.drawText(rect(), Qt::AlignVCenter | Qt::AlignRight, shown);
}

} // namespace mb
