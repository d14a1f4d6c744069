// SPDX-License-Identifier: GPL-3.0-or-later
// What each row says.
#include "widgets/common/axistext.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"
#include "widgets/connection/devicemodel.h"
#include "widgets/plots/displayunits.h"

namespace mb {

QVariant DeviceModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    if (role == KindRole)
        return static_cast<int>(kindOf(index));
    const Snapshot &shot = m_workbench.snapshot();
    if (kindOf(index) == Kind::Link) {
        const LinkView *link = shot.link(linkOf(index)->address);
        return link ? linkData(*link, role) : QVariant();
    }
    const DeviceView *device = shot.device(deviceAt(index));
    if (!device)
        return {};
    if (role == DeviceRole)
        return device->id.value;
    switch (kindOf(index)) {
    case Kind::Axis: return axisData(*device, axisAt(index), role);
    case Kind::Channel: return channelData(*device, channelAt(index), role);
    default: return deviceData(*device, role);
    }
}

QVariant DeviceModel::linkData(const LinkView &link, int role) const
{
    switch (role) {
    case Qt::DisplayRole:
    case Qt::AccessibleTextRole: return QString::fromStdString(link.name);
    case Qt::ToolTipRole:
        return QString::fromStdString(link.address)
            + (link.reason.empty() ? QString() : QLatin1Char('\n') + messageText(link.reason));
    case LineRole:
        if (link.state == LinkState::Lost)
            return tr("lost");
        return link.bitrate >= 1'000'000 ? tr("%1 Mbit/s").arg(link.bitrate / 1e6)
            : link.bitrate > 0           ? tr("%1 kbit/s").arg(link.bitrate / 1e3)
                                         : QString();
    case DetailRole: return link.scanning ? tr("scanning") : tr("%1 %").arg(qRound(link.load * 100));
    case DeviceRole: return 0U;
    default: return {};
    }
}

QVariant DeviceModel::deviceData(const DeviceView &device, int role) const
{
    switch (role) {
    case Qt::DisplayRole: return titleOf(device);
    case Qt::AccessibleTextRole: return titleOf(device) + QStringLiteral(", ") + lineOf(device);
    case Qt::ToolTipRole: return tooltipOf(device);
    case GlyphRole: return static_cast<int>(glyphOf(device));
    case LineRole: return lineOf(device);
    case BadgeRole: return badgeOf(device);
    case UsualRole: return device.identity.state == DeviceState::Online;
    default: return {};
    }
}

QVariant DeviceModel::axisData(const DeviceView &device, int axis, int role) const
{
    const QString command = commandOfAxis(device, axis);
    const QString value = valueOfAxis(device, axis, m_workbench.presentOf(device.link));
    switch (role) {
    case Qt::DisplayRole: return axisTitle(axis);
    case Qt::AccessibleTextRole:
        return QStringList{titleOf(device), axisTitle(axis), glyphWord(glyphOfAxis(device, axis)), command, value}.join(
            QStringLiteral(", "));
    case Qt::ToolTipRole:
        return tr("%1 of %2: %3, now %4\nIts pages show this axis; drag it to a plot.")
            .arg(axisTitle(axis), titleOf(device), command, value);
    case GlyphRole: return static_cast<int>(glyphOfAxis(device, axis));
    case LineRole: return command;
    case DetailRole: return numberOfAxis(device, axis, m_workbench.presentOf(device.link));
    default: return {};
    }
}

QVariant DeviceModel::channelData(const DeviceView &device, ChannelIndex channel, int role) const
{
    const Channel &row
        = device.telemetry ? device.telemetry->channels()[channel.value] : device.family->channels[channel.value];
    switch (role) {
    case Qt::DisplayRole: return channelName(row);
    case Qt::AccessibleTextRole: return signalName(device, channel);
    case Qt::ToolTipRole: return tr("%1\nDouble click or Enter plots it; drag it to a plot.").arg(qt(row.key));
    case DetailRole: {
        const auto value
            = device.telemetry ? liveValue(device, row.key, m_workbench.presentOf(device.link)) : std::nullopt;
        const ShownUnit unit = shownUnit(row.quantity, row.unit, {});
        return value ? formatValue(*value * unit.scale, unit.decimals, unit.text) : QString(UnknownMark);
    }
    default: return {};
    }
}

} // namespace mb
