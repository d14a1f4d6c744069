// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connection/livestatebar.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/stateglyph.h"

#include <QPainter>

namespace mb {

LiveStateBar::LiveStateBar(Workbench &workbench, Selection &selection, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_selection(selection)
    , m_theme(theme)
{
    setObjectName(QStringLiteral("liveStates"));
    setAccessibleName(tr("Limits and pins"));
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    connect(&workbench, &Workbench::changed, this, &LiveStateBar::follow);
    connect(&selection, &Selection::changed, this, &LiveStateBar::follow);
    connect(&theme, &ThemeSource::changed, this, [this] { update(); });
    hide();
}

void LiveStateBar::setWanted(Wanted wanted)
{
    m_wanted = wanted;
    follow();
}

QSize LiveStateBar::sizeHint() const
{
    return {m_theme.theme().u(400), m_theme.theme().u(26)};
}

QSize LiveStateBar::minimumSizeHint() const
{
    return {1, m_theme.theme().u(26)};
}

bool LiveStateBar::isWantedFor(const DeviceView &device) const
{
    return m_wanted == Wanted::Always || (m_wanted == Wanted::IfSomethingHolds && m_held == device.id);
}

void LiveStateBar::follow()
{
    const DeviceView *device = m_workbench.snapshot().device(m_selection.device());
    if (device && (!alertsOf(*device).isEmpty() || device->kept.state != KeptMove::State::None))
        m_held = device->id;
    else if (!device || m_held != device->id || m_wanted == Wanted::Never)
        m_held = {};
    setVisible(device && !device->family->states.empty() && isWantedFor(*device));
    if (isHidden())
        return;
    QStringList hold = alertsOf(*device) + conditionsText(*device);
    hold.removeDuplicates();
    const QString words = glyphOf(*device) == GlyphState::Gone ? healthOf(*device).words
        : hold.isEmpty()                                       ? tr("no limit holds")
                                                               : hold.join(QStringLiteral(", "));
    const int axis = m_selection.axis();
    if (device->id == m_device && axis == m_axis && device->states == m_shown && words == m_words)
        return;
    m_device = device->id;
    m_axis = axis;
    m_shown = device->states;
    m_words = words;
    setAccessibleDescription(statesText(*device));
    setToolTip(statesText(*device));
    update();
}

/// Limits at the left, pins behind them; what has no room is in the tooltip.
void LiveStateBar::paintEvent(QPaintEvent *)
{
    const DeviceView *device = m_workbench.snapshot().device(m_selection.device());
    if (!device)
        return;
    const Theme &theme = m_theme.theme();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(theme.font(TextRole::Caption, font()));
    const int side = theme.u(12);
    int left = theme.u(16);
    const auto put = [&](GlyphState glyph, const QColor &color, const QString &words, const QColor &ink) {
        const int wide = side + theme.u(6) + painter.fontMetrics().horizontalAdvance(words);
        if (left + wide > width() - theme.u(12))
            return;
        paintGlyph(painter, QRectF(left, (height() - side) / 2.0, side, side), glyph, color);
        painter.setPen(ink);
        painter.drawText(QRect(left + side + theme.u(6), 0, wide, height()), Qt::AlignVCenter, words);
        left += wide + theme.u(16);
    };
    const bool alert = !alertsOf(*device).isEmpty();
    if (glyphOf(*device) == GlyphState::Gone)
        put(GlyphState::Gone, theme.outline, m_words, theme.faint);
    else
        put(alert ? GlyphState::Warning : GlyphState::Done, alert ? theme.caution : theme.ok, m_words,
            alert ? theme.text : theme.dim);
    for (std::size_t i = 0; i < device->family->states.size(); ++i) {
        const StateRow &row = device->family->states[i];
        const auto level = device->states[StateIndex{static_cast<std::uint16_t>(i)}];
        if (row.kind == StateKind::Input && isOfAxis(row, m_axis))
            put(level.value_or(false) ? GlyphState::InRam : GlyphState::Gone,
                level.value_or(false) ? theme.accent : theme.outline, stateLabel(row),
                level ? theme.text : theme.faint);
    }
}

} // namespace mb
