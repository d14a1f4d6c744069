// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connection/inspector.h"

#include "model/axis.h"
#include "widgets/common/axistext.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/livetext.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/valuelabel.h"
#include "widgets/common/wraplayout.h"
#include "widgets/connection/axiscells.h"
#include "widgets/connection/profilepanel.h"
#include "wire/fixedpoint.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

namespace mb {

Inspector::Inspector(Workbench &workbench, Selection &selection, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_selection(selection)
    , m_theme(theme)
{
    setObjectName(QStringLiteral("inspector"));
    setAccessibleName(tr("Inspector"));
    auto *column = new QVBoxLayout(this);
    const int pad = theme.theme().u(12);
    column->setContentsMargins(pad, pad, pad, pad);
    column->setSpacing(theme.theme().u(6));
    m_title = textLabel({}, TextRole::Title, Tone::Text, this);
    m_subtitle = textLabel({}, TextRole::Body, Tone::Dim, this);
    column->addWidget(m_title);
    column->addWidget(m_subtitle);
    buildActions(*column);
    buildLive(*column);
    buildIdentity(*column);
    buildParameters(*column);
    m_profile = new ProfilePanel(workbench, theme, this);
    column->addWidget(m_profile);
    column->addStretch();
    connect(&workbench, &Workbench::changed, this, &Inspector::follow);
    connect(&selection, &Selection::changed, this, &Inspector::follow);
    follow();
}

QSize Inspector::sizeHint() const
{
    return {std::max(m_theme.theme().u(248), layout()->minimumSize().width()), m_theme.theme().u(600)};
}

ValueLabel *Inspector::addRow(QVBoxLayout &column, const QString &caption)
{
    auto *label = new ValueLabel(m_theme, ValueLabel::Look::Row, caption, {}, this);
    column.addWidget(label);
    return label;
}

void Inspector::buildActions(QVBoxLayout &column)
{
    auto *both = new QWidget(this);
    auto *row = layoutIn<WrapLayout>(both, m_theme.theme().u(8)); // long words stand below each other
    m_identify = new CommandButton(m_theme, Symbol::Identify, tr("Identify"), this);
    m_identify->setToolTip(tr("Blink the lamps of this unit"));
    m_read = new CommandButton(m_theme, Symbol::Refresh, tr("Read all"), this);
    m_read->setToolTip(tr("Read every parameter of this unit"));
    row->addWidget(m_identify);
    row->addWidget(m_read);
    column.addWidget(both);
    connect(
        m_identify, &QPushButton::clicked, this, [this] { m_workbench.send(orders::Identify{m_selection.device()}); });
    connect(m_read, &QPushButton::clicked, this,
        [this] { m_workbench.send(orders::ReadParameters{m_selection.device()}); });
}

void Inspector::buildLive(QVBoxLayout &column)
{
    column.addWidget(separatorLine(Qt::Horizontal, this));
    column.addWidget(new SectionLabel(tr("Live"), this));
    m_axes = new AxisCells(m_theme, AxisCells::Look::Rows, this);
    m_axes->hide();
    column.addWidget(m_axes);
    connect(
        m_axes, &AxisCells::axisActivated, this, [this](int axis) { m_selection.select(m_selection.device(), axis); });
    const auto add = [&](const QString &caption, const QString &unit, std::string_view channel) {
        ValueLabel *label = addRow(column, caption);
        label->setUnit(unit);
        m_live.push_back({channel, label});
    };
    add(tr("position"), QStringLiteral("counts"), "position");
    add(tr("velocity"), QStringLiteral("counts/s"), "velocity");
    add(tr("current"), QStringLiteral("A"), "current");
    add(tr("duty"), QStringLiteral("%"), "duty");
    add(tr("bus"), QStringLiteral("V"), "bus_voltage");
    add(tr("case"), QStringLiteral("°C"), "temperature");
}

void Inspector::buildIdentity(QVBoxLayout &column)
{
    column.addWidget(separatorLine(Qt::Horizontal, this));
    column.addWidget(new SectionLabel(tr("Identity"), this));
    m_serial = addRow(column, tr("serial"));
    m_firmware = addRow(column, tr("firmware"));
    m_bootloader = addRow(column, tr("bootloader"));
    m_session = addRow(column, tr("session"));
    for (ValueLabel *label : {m_serial, m_firmware, m_bootloader, m_session})
        label->setWidest(QStringLiteral("2103343A79F2"));
}

void Inspector::buildParameters(QVBoxLayout &column)
{
    column.addWidget(separatorLine(Qt::Horizontal, this));
    column.addWidget(new SectionLabel(tr("State"), this));
    m_faults = addRow(column, tr("faults"));
    m_faults->setWidest(tr("over-temperature"));
    m_limits = addRow(column, tr("limits"));
    m_changed = addRow(column, tr("changed from default"));
    m_changed->setWidest(tr("%1 of %2").arg(88).arg(88));
    m_ram = addRow(column, tr("in RAM only"));
    m_ram->setWidest(QStringLiteral("88"));
}

void Inspector::follow()
{
    if (!isVisible())
        return;
    const DeviceView *device = m_workbench.snapshot().device(m_selection.device());
    m_identify->setEnabled(
        device && device->family->capabilities.identify && device->identity->state != DeviceState::Bootloader);
    m_read->setEnabled(device && device->identity->state == DeviceState::Online);
    if (!device) {
        m_profile->show(nullptr);
        m_axes->hide();
        m_title->setText(tr("No device selected"));
        m_subtitle->clear();
        for (ValueLabel *label : findChildren<ValueLabel *>()) {
            label->clear();
            label->setTone(Tone::Text);
        }
        return;
    }
    const int axis = m_selection.axis();
    m_title->setText(axis > 0 ? tr("%1 · %2").arg(titleOf(*device), axisTitle(axis)) : titleOf(*device));
    const LinkView *link = m_workbench.snapshot().link(device->link);
    const QString linkName = link ? QString::fromStdString(link->name) : QString();
    const QString name = givenName(*device);
    m_subtitle->setText(name.isEmpty() ? linkName : name + QStringLiteral(" · ") + linkName);
    showLive(*device);
    m_profile->show(device);
    const auto text = [](ValueLabel *label, const std::string &value) {
        if (value.empty())
            label->clear();
        else
            label->setValue(QString::fromStdString(value));
    };
    text(m_serial, device->identity->serial);
    text(m_firmware, device->identity->firmware);
    text(m_bootloader, device->identity->bootloader);
    text(m_session,
        device->identity->session ? QString::number(*device->identity->session, 16).toUpper().toStdString()
                                  : std::string());
    showParameters(*device);
}

void Inspector::showLive(const DeviceView &device)
{
    const bool several = hasAxes(*device.family);
    m_axes->setVisible(several && m_selection.axis() == 0);
    if (several)
        m_axes->show(device, m_workbench.presentOf(device.link));
    for (const LiveRow &row : m_live) {
        const std::string key = axisKey(m_selection.axis(), row.channel);
        row.label->setVisible(!several || device.telemetry->find(key)); // a board has these of its axes only
        row.label->setLive(liveText(device, key, m_workbench.presentOf(device.link)));
    }
}

void Inspector::showParameters(const DeviceView &device)
{
    const auto &faults = device.liveness.faults;
    const bool gone = glyphOf(device) == GlyphState::Gone;
    m_faults->setValue(gone  ? QString(UnknownMark)
            : faults.empty() ? tr("none")
                             : faultText(*device.family, faults.front()));
    m_faults->setTone(gone ? Tone::Dim : faults.empty() ? Tone::Ok : Tone::Danger);
    const QStringList alerts = alertsOf(device);
    m_limits->setVisible(!device.family->states.empty());
    m_limits->setValue(gone ? QString(UnknownMark) : alerts.isEmpty() ? tr("none") : alerts.first());
    m_limits->setTone(gone ? Tone::Dim : alerts.isEmpty() ? Tone::Ok : Tone::Caution);
    m_limits->setToolTip(statesText(device));
    int known = 0;
    int changed = 0;
    int ram = 0;
    for (std::size_t i = 0; i < device.parameters->size(); ++i) {
        const Parameter &parameter = device.family->parameters[i];
        const auto &entry = (*device.parameters)[i];
        if (!entry.raw || parameter.nature != Nature::Setting || parameter.access == Access::ReadOnly)
            continue;
        ++known;
        changed += *entry.raw != toFixed(parameter.fallback, parameter.one) ? 1 : 0;
        ram += entry.state == ParameterState::Ram ? 1 : 0;
    }
    if (known == 0) {
        m_changed->clear();
        m_ram->clear();
        return;
    }
    m_changed->setValue(tr("%1 of %2").arg(changed).arg(known));
    m_ram->setValue(QString::number(ram));
    m_ram->setTone(ram > 0 ? Tone::Caution : Tone::Text);
}

} // namespace mb
