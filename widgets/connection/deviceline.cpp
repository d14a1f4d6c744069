// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connection/deviceline.h"

#include "model/axis.h"
#include "widgets/common/axistext.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/livetext.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/valuelabel.h"

#include <algorithm>

namespace mb {
namespace {

/// A text that must not be cut, in a label that otherwise elides.
void showWhole(QLabel &label, const QString &text)
{
    label.setText(text);
    label.setMinimumWidth(label.fontMetrics().horizontalAdvance(text) + 1);
}

} // namespace

DeviceLine::DeviceLine(Workbench &workbench, Selection &selection, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_selection(selection)
    , m_theme(theme)
{
    setAccessibleName(tr("Selected device"));
    setMinimumHeight(theme.theme().u(40));
    auto *row = layoutIn<QHBoxLayout>(this, theme.theme().u(8), {theme.theme().u(16), 0, theme.theme().u(16), 0});
    buildIdentity(*row);
    buildValues(*row);
    connect(&workbench, &Workbench::changed, this, &DeviceLine::follow);
    connect(&selection, &Selection::changed, this, [this] { // numbers of another device may be shorter
        for (ValueLabel *label : {m_position, m_velocity, m_current, m_duty, m_bus, m_temperature})
            label->clear();
        follow();
    });
    hide();
}

void DeviceLine::setWanted(bool wanted)
{
    m_wanted = wanted;
    follow();
}

void DeviceLine::buildIdentity(QHBoxLayout &row)
{
    m_glyph = new StateGlyph(m_theme, GlyphState::Gone, this);
    m_title = textLabel({}, TextRole::Emphasis, Tone::Text, this);
    m_name = textLabel({}, TextRole::Body, Tone::Dim, this);
    m_identity = textLabel({}, TextRole::Body, Tone::Dim, this);
    row.addWidget(m_glyph);
    row.addWidget(m_title);
    row.addWidget(m_name);
    row.addSpacing(m_theme.theme().u(8));
    row.addWidget(m_identity, 1);
}

void DeviceLine::buildValues(QHBoxLayout &row)
{
    m_values = new QWidget(this);
    auto *values = layoutIn<QHBoxLayout>(m_values, m_theme.theme().u(12));
    const auto add = [&](const QString &caption, const QString &unit, const QString &widest) {
        auto *label = new ValueLabel(m_theme, ValueLabel::Look::Line, caption, unit, m_values);
        label->setWidest(widest);
        values->addWidget(label);
        return label;
    };
    m_position = add(tr("position"), QStringLiteral("counts"), QStringLiteral("−8 888 888"));
    m_position->hide();
    m_velocity = add(tr("velocity"), QStringLiteral("counts/s"), QStringLiteral("−888 888"));
    m_current = add(tr("current"), QStringLiteral("A"), QStringLiteral("−88.88"));
    m_duty = add(tr("duty"), QStringLiteral("%"), QStringLiteral("−100.0"));
    m_bus = add(tr("bus"), QStringLiteral("V"), QStringLiteral("88.88"));
    m_temperature = add(tr("case"), QStringLiteral("°C"), QStringLiteral("−88.8"));
    m_faultGlyph = new StateGlyph(m_theme, GlyphState::Done, m_values);
    m_faults = textLabel({}, TextRole::Body, Tone::Text, m_values);
    values->addWidget(m_faultGlyph);
    values->addWidget(m_faults);
    row.addWidget(m_values);
}

void DeviceLine::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    m_identity->setVisible(width() > m_theme.theme().u(640));
    follow();
}

QString DeviceLine::aboutOf(const DeviceView &device) const
{
    if (!hasAxes(*device.family))
        return givenName(device);
    return m_selection.axis() > 0 ? commandOfAxis(device, m_selection.axis()) : axesLine(device);
}

std::vector<ValueLabel *> DeviceLine::showValues(const DeviceView &device)
{
    std::vector<ValueLabel *> wanted;
    const Instant now = m_workbench.presentOf(device.link);
    const int axis = m_selection.axis();
    const bool several = hasAxes(*device.family);
    // Where it is narrow the last values go first; the inspector and the plots still have them.
    const auto show = [&](ValueLabel *label, std::string_view name, int from) {
        const std::string key = axisKey(axis, name);
        if ((several ? device.telemetry->find(key).has_value() : label != m_position)
            && width() > m_theme.theme().u(from))
            wanted.push_back(label);
        label->setLive(liveText(device, key, now));
    };
    show(m_position, "position", 700);
    show(m_velocity, "velocity", several ? 560 : 0);
    show(m_current, "current", 0);
    show(m_duty, "duty", 0);
    show(m_bus, "bus_voltage", 860);
    show(m_temperature, "temperature", 980);
    return wanted;
}

/// With large text what has no room is left out whole: a value without its number says nothing.
void DeviceLine::fitValues(const std::vector<ValueLabel *> &wanted)
{
    const int gap = m_theme.theme().u(12);
    int room = width() - m_theme.theme().u(16 + 16 + 5 * 8 + 60) // edges, spaces, and something of the name
        - m_glyph->sizeHint().width() - m_title->minimumWidth() - m_faultGlyph->sizeHint().width()
        - m_faults->minimumWidth() - 2 * gap;
    for (ValueLabel *label : {m_current, m_velocity, m_duty, m_position, m_bus, m_temperature}) {
        const bool isWanted = std::ranges::find(wanted, label) != wanted.end();
        room -= isWanted ? label->sizeHint().width() + gap : 0;
        label->setVisible(isWanted && room >= 0); // once: what is shown only to go again squeezes the others
    }
}

void DeviceLine::follow()
{
    const DeviceView *device = m_workbench.snapshot().device(m_selection.device());
    setVisible(m_wanted && device);
    if (!isVisible())
        return;
    m_glyph->setState(glyphOf(*device));
    showWhole(*m_title, motorTitle(*device, m_selection.axis()));
    m_name->setText(aboutOf(*device));
    m_name->setVisible(!m_name->text().isEmpty());
    const auto known
        = [](const std::string &text) { return text.empty() ? QString(UnknownMark) : QString::fromStdString(text); };
    m_identity->setText(tr("SN %1 · fw %2").arg(known(device->identity->serial), known(device->identity->firmware)));
    const auto wanted = showValues(*device);
    const HealthText health = healthOf(*device);
    m_faultGlyph->setState(health.glyph);
    showWhole(*m_faults, health.words);
    setTone(*m_faults, health.tone);
    m_faults->setToolTip(statesText(*device));
    fitValues(wanted);
}

} // namespace mb
