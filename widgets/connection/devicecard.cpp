// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connection/devicecard.h"

#include "widgets/common/axistext.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/livetext.h"
#include "widgets/common/losses.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/sparkline.h"
#include "widgets/common/spoken.h"
#include "widgets/common/stateglyph.h"
#include "widgets/common/valuelabel.h"
#include "widgets/common/wraplayout.h"
#include "widgets/connection/axiscells.h"
#include "widgets/connection/recentvalues.h"

#include <array>

namespace mb {

DeviceCard::DeviceCard(const ThemeSource &theme, QWidget *parent)
    : Card(theme, parent)
    , m_theme(theme)
{
    setActivatable(true);
    setGlyph(GlyphState::Gone);
    m_badge = badge({}, Tone::Caution, this);
    addHeadWidget(m_badge);
    buildLive();
    buildNote();
    m_rate = textLabel({}, TextRole::Caption, Tone::Dim, this);
    m_faultGlyph = new StateGlyph(theme, GlyphState::Done, this);
    m_faults = textLabel({}, TextRole::Caption, Tone::Text, this);
    foot().addWidget(m_rate);
    foot().addStretch();
    foot().addWidget(m_faultGlyph);
    foot().addWidget(m_faults);
}

void DeviceCard::buildLive()
{
    const Theme &theme = m_theme.theme();
    m_live = new QWidget(this);
    auto *column = layoutIn<QVBoxLayout>(m_live, theme.u(6));
    auto *values = new QWidget(m_live);
    auto *row = layoutIn<WrapLayout>(values, theme.u(6)); // a narrow card has them in two lines
    const auto add = [&](std::size_t place, const QString &caption, const QString &unit, const QString &widest) {
        m_values[place] = new ValueLabel(m_theme, ValueLabel::Look::Card, caption, unit, values);
        m_values[place]->setWidest(widest);
        row->addWidget(m_values[place]);
    };
    add(0, tr("velocity"), QStringLiteral("counts/s"), QStringLiteral("−88 888"));
    add(1, tr("current"), QStringLiteral("A"), QStringLiteral("−8.88"));
    add(2, tr("duty"), QStringLiteral("%"), QStringLiteral("−88.8"));
    column->addWidget(values);
    auto *captions = new QHBoxLayout;
    captions->addWidget(textLabel(tr("last 10 s"), TextRole::Caption, Tone::Dim, m_live));
    captions->addStretch();
    m_range = textLabel({}, TextRole::Caption, Tone::Dim, m_live);
    captions->addWidget(m_range);
    column->addLayout(captions);
    m_sparkline = new Sparkline(m_theme, TraceRole::Velocity, m_live);
    m_sparkline->setCapacity(recentPoints);
    m_sparkline->setMinimumHeight(theme.u(36));
    column->addWidget(m_sparkline, 1);
    body().addWidget(m_live, 1);
}

void DeviceCard::buildNote()
{
    m_note = new QWidget(this);
    auto *column = layoutIn<QVBoxLayout>(m_note);
    m_noteCause = textLabel({}, TextRole::Body, Tone::Text, m_note);
    m_noteRemedy = textLabel({}, TextRole::Body, Tone::Dim, m_note);
    m_noteCause->setWordWrap(true);
    m_noteRemedy->setWordWrap(true);
    m_update = new CommandButton(m_theme, tr("Update firmware"), m_note);
    m_update->setPrimary(true);
    column->addWidget(m_noteCause);
    column->addWidget(m_noteRemedy);
    column->addWidget(m_update, 0, Qt::AlignLeft);
    column->addStretch();
    body().addWidget(m_note, 1);
    connect(m_update, &QPushButton::clicked, this, &DeviceCard::updateRequested);
}

void DeviceCard::show(const DeviceView &device, Instant now, bool selected)
{
    const GlyphState state = glyphOf(device);
    setTitle(titleOf(device), hasAxes(*device.family) ? axesLine(device) : givenName(device));
    setGlyph(state);
    setSpokenLive(*this, lineOf(device));
    const bool ordinary = device.identity->state == DeviceState::Online;
    const bool boot = device.identity->state == DeviceState::Bootloader;
    m_badge->setText(ordinary ? device.liveness.mode ? modeText(*device.liveness.mode) : QString() : glyphWord(state));
    m_badge->setVisible(!m_badge->text().isEmpty());
    setStyleProperty(
        *m_badge, "badge", ordinary && !device.liveness.moving ? QStringLiteral("neutral") : QStringLiteral("caution"));
    m_live->setVisible(!boot && !hasAxes(*device.family));
    if (m_axes)
        m_axes->setVisible(!boot);
    m_note->setVisible(boot);
    m_update->setVisible(boot && device.family->update != nullptr);
    if (boot) {
        m_noteCause->setText(tr("No application runs. Settings, number and name are kept."));
        m_noteRemedy->setText(tr("An update makes it whole again. It is safe to power off."));
    } else if (hasAxes(*device.family)) {
        showAxes(device, now);
    } else {
        showValues(device, now);
        showSparkline(device, now);
    }
    showFoot(device);
    const bool fault = state == GlyphState::Fault;
    setEdge(selected   ? std::optional(Tone::Accent)
            : fault    ? std::optional(Tone::Danger)
            : ordinary ? std::nullopt
                       : std::optional(Tone::Caution));
}

void DeviceCard::showAxes(const DeviceView &device, Instant now)
{
    if (!m_axes) {
        m_axes = new AxisCells(m_theme, AxisCells::Look::Cells, this);
        body().insertWidget(0, m_axes, 1);
        connect(m_axes, &AxisCells::axisActivated, this, &DeviceCard::axisActivated);
    }
    m_axes->show(device, now);
}

void DeviceCard::showValues(const DeviceView &device, Instant now)
{
    constexpr std::array<std::string_view, 3> channels{"velocity", "current", "duty"};
    for (std::size_t i = 0; i < channels.size(); ++i) {
        const LiveText live = liveText(device, channels[i], now);
        m_values[i]->setStale(!device.liveness.heard);
        if (live.isKnown() || device.liveness.heard)
            m_values[i]->setLive(live);
    }
}

void DeviceCard::showSparkline(const DeviceView &device, Instant now)
{
    const auto channel = device.telemetry->find("velocity");
    if (!channel || !isVisible())
        return;
    m_sparkline->setValues(recentValues(device, "velocity", now));
    const Channel &row = device.telemetry->channels()[channel->value];
    if (const auto range = m_sparkline->range()) {
        const LiveText greatest = liveText(row, range->second);
        m_range->setText(range->first == range->second
                ? greatest.whole()
                : QStringLiteral("%1 … %2").arg(liveText(row, range->first).number, greatest.whole()));
    } else {
        m_range->setText(QString(UnknownMark));
    }
}

void DeviceCard::showFoot(const DeviceView &device)
{
    if (device.identity->state == DeviceState::Bootloader) {
        m_rate->setText(tr("boot %1 · no telemetry").arg(QString::fromStdString(device.identity->bootloader)));
        m_faultGlyph->hide();
        m_faults->setText({});
        return;
    }
    double rate = 0.0;
    for (const double one : device.rates)
        rate = std::max(rate, one);
    const std::uint64_t lost = samplesOf(device).lost;
    m_rate->setText(tr("%1 Hz   lost %2").arg(formatNumber(rate), formatCount(static_cast<qint64>(lost))));
    HealthText health = healthOf(device);
    m_faults->setToolTip(health.words);
    if (health.glyph == GlyphState::Done
        && !device.family->capabilities.watchdog) { // what nothing stops by itself is said first
        health = {GlyphState::Warning, Tone::Text, tr("no watchdog")};
        m_faults->setToolTip(tr("It keeps its last set-point if this program dies. A second process beside it, the "
                                "guardian, stops it then."));
    }
    m_faultGlyph->show();
    m_faultGlyph->setState(health.glyph);
    m_faults->setText(health.words);
}

} // namespace mb
