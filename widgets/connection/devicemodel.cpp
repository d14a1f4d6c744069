// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connection/devicemodel.h"

#include "model/axis.h"
#include "widgets/common/axistext.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/displayunits.h"
#include "widgets/common/linkload.h"
#include "widgets/common/livetext.h"
#include "widgets/common/numberformat.h"

#include <QMimeData>

#include <algorithm>

namespace mb {
namespace {

/// What an index carries: 26 bits of link mark or device, 4 bits of axis, 2 bits of kind.
struct Place {
    DeviceModel::Kind kind = DeviceModel::Kind::Link;
    int axis = 0;
    quint32 value = 0;
};
constexpr int axisShift = 26;
constexpr int kindShift = 30;
constexpr quint32 valueMask = (1U << axisShift) - 1U;
constexpr quint32 axisMask = 0xFU;

quintptr pack(const Place &place)
{
    return static_cast<quint32>(place.kind) << kindShift | static_cast<quint32>(place.axis) << axisShift
        | (place.value & valueMask);
}

Place unpack(const QModelIndex &index)
{
    const auto bits = static_cast<quint32>(index.internalId());
    return {static_cast<DeviceModel::Kind>(bits >> kindShift), static_cast<int>(bits >> axisShift & axisMask),
        bits & valueMask};
}

/// The channels of an axis, or of the device as a whole, in table order.
std::vector<ChannelIndex> channelsOf(const Family &family, int axis)
{
    std::vector<ChannelIndex> all;
    for (std::uint16_t i = 0; i < family.channels.size(); ++i) {
        if (axisOf(family.channels[i].key) == axis)
            all.push_back({i});
    }
    return all;
}

int axesOf(const Family &family)
{
    return hasAxes(family) ? family.capabilities.axes : 0;
}

} // namespace

DeviceModel::DeviceModel(Workbench &workbench, QObject *parent)
    : QAbstractItemModel(parent)
    , m_workbench(workbench)
{
    connect(&workbench, &Workbench::changed, this, &DeviceModel::follow);
    follow();
}

void DeviceModel::setFilter(const QString &text)
{
    m_filter = text.trimmed();
    follow();
}

void DeviceModel::setHeld(bool held)
{
    m_held = held;
    follow();
}

bool DeviceModel::passes(const DeviceView &device) const
{
    const auto has = [this](const QString &text) { return text.contains(m_filter, Qt::CaseInsensitive); };
    return m_filter.isEmpty() || has(titleOf(device)) || has(QString::fromStdString(device.identity->name))
        || has(QString::fromStdString(device.identity->serial)) || has(badgeOf(device));
}

void DeviceModel::follow()
{
    const Snapshot &shot = m_workbench.snapshot();
    m_waiting = 0;
    m_changing = true;
    followLinks(shot);
    for (int row = 0; row < static_cast<int>(m_rows.size()); ++row)
        followDevices(row, shot);
    m_changing = false;
    tellChanged({});
}

void DeviceModel::tellChanged(const QModelIndex &parent)
{
    const int count = rowCount(parent);
    if (count == 0)
        return;
    Q_EMIT dataChanged(index(0, 0, parent), index(count - 1, 0, parent));
    for (int row = 0; row < count; ++row)
        tellChanged(index(row, 0, parent));
}

void DeviceModel::followLinks(const Snapshot &shot)
{
    for (int row = static_cast<int>(m_rows.size()) - 1; row >= 0; --row) {
        if (shot.link(m_rows[static_cast<std::size_t>(row)].address))
            continue;
        beginRemoveRows({}, row, row);
        m_rows.erase(m_rows.begin() + row);
        endRemoveRows();
    }
    for (const LinkView &link : shot.links) {
        const bool known = std::ranges::any_of(m_rows, [&](const LinkRow &row) { return row.address == link.address; });
        if (known)
            continue;
        const int row = static_cast<int>(m_rows.size());
        beginInsertRows({}, row, row);
        m_rows.push_back({link.address, ++m_lastMark, {}});
        endInsertRows();
    }
}

void DeviceModel::followDevices(int row, const Snapshot &shot)
{
    LinkRow &link = m_rows[static_cast<std::size_t>(row)];
    const QModelIndex parent = index(row, 0);
    std::vector<DeviceRow> wanted;
    for (const DeviceView &device : shot.devices) {
        if (device.link == link.address && passes(device))
            wanted.push_back({device.id, device.family});
    }
    const auto isIn
        = [](const std::vector<DeviceRow> &rows, DeviceId id) { return std::ranges::find(rows, id, &DeviceRow::id); };
    for (int i = static_cast<int>(link.devices.size()) - 1; i >= 0; --i) {
        if (isIn(wanted, link.devices[static_cast<std::size_t>(i)].id) != wanted.end())
            continue;
        beginRemoveRows(parent, i, i);
        link.devices.erase(link.devices.begin() + i);
        endRemoveRows();
    }
    if (m_held) {
        m_waiting += static_cast<int>(wanted.size() - link.devices.size());
        return;
    }
    for (int i = 0; i < static_cast<int>(wanted.size()); ++i) {
        const DeviceRow &next = wanted[static_cast<std::size_t>(i)];
        const auto place = link.devices.begin() + i;
        const auto old = std::ranges::find(link.devices, next.id, &DeviceRow::id);
        if (old == place && old != link.devices.end())
            continue;
        if (old == link.devices.end()) {
            beginInsertRows(parent, i, i);
            link.devices.insert(place, next);
            endInsertRows();
        } else {
            const int from = static_cast<int>(old - link.devices.begin());
            beginMoveRows(parent, from, from, parent, i);
            std::rotate(place, old, old + 1);
            endMoveRows();
        }
    }
}

DeviceModel::Kind DeviceModel::kindOf(const QModelIndex &index)
{
    return unpack(index).kind;
}

const DeviceModel::DeviceRow *DeviceModel::rowOf(DeviceId device) const
{
    for (const LinkRow &link : m_rows) {
        for (const DeviceRow &row : link.devices) {
            if (row.id == device)
                return &row;
        }
    }
    return nullptr;
}

const DeviceModel::LinkRow *DeviceModel::linkOf(const QModelIndex &index) const
{
    const Place place = unpack(index);
    if (place.kind == Kind::Link)
        return &m_rows[static_cast<std::size_t>(index.row())];
    const auto found = std::ranges::find(m_rows, place.value, &LinkRow::mark);
    return found == m_rows.end() ? nullptr : &*found;
}

QModelIndex DeviceModel::indexOf(DeviceId device, int axis) const
{
    const auto isIt = [device](const DeviceRow &row) { return row.id == device; };
    for (const LinkRow &link : m_rows) {
        const auto found = std::ranges::find_if(link.devices, isIt);
        if (found == link.devices.end())
            continue;
        if (axis > 0 && axis <= axesOf(*found->family))
            return createIndex(axis - 1, 0, pack({Kind::Axis, axis, device.value}));
        return createIndex(static_cast<int>(found - link.devices.begin()), 0, pack({Kind::Device, 0, link.mark}));
    }
    return {};
}

const LinkView *DeviceModel::linkAt(const QModelIndex &index) const
{
    const bool isLink = index.isValid() && kindOf(index) == Kind::Link;
    return isLink ? m_workbench.snapshot().link(linkOf(index)->address) : nullptr;
}

DeviceId DeviceModel::deviceAt(const QModelIndex &index) const
{
    if (!index.isValid())
        return {};
    const Place place = unpack(index);
    if (place.kind == Kind::Link)
        return {};
    if (place.kind != Kind::Device)
        return {place.value};
    const LinkRow *link = linkOf(index);
    return link ? link->devices[static_cast<std::size_t>(index.row())].id : DeviceId{};
}

int DeviceModel::axisAt(const QModelIndex &index) const
{
    return index.isValid() ? unpack(index).axis : 0;
}

ChannelIndex DeviceModel::channelAt(const QModelIndex &index) const
{
    const Place place = unpack(index);
    const Family &family = *rowOf({place.value})->family;
    const int before = place.axis == 0 ? axesOf(family) : 0;
    return channelsOf(family, place.axis)[static_cast<std::size_t>(index.row() - before)];
}

std::vector<Signal> DeviceModel::signalsAt(const QModelIndex &index) const
{
    const DeviceView *device = m_workbench.snapshot().device(deviceAt(index));
    if (!device || !device->telemetry || device->identity->state == DeviceState::Bootloader)
        return {};
    if (kindOf(index) == Kind::Channel)
        return {{device->id, channelAt(index)}};
    return usualSignals(*device, axisAt(index));
}

QModelIndex DeviceModel::index(int row, int column, const QModelIndex &parent) const
{
    if (row < 0 || column != 0 || row >= rowCount(parent))
        return {};
    if (!parent.isValid())
        return createIndex(row, column, pack({}));
    const Place place = unpack(parent);
    switch (place.kind) {
    case Kind::Link: return createIndex(row, column, pack({Kind::Device, 0, linkOf(parent)->mark}));
    case Kind::Device: {
        const DeviceId device = deviceAt(parent);
        const bool axis = row < axesOf(*rowOf(device)->family);
        return createIndex(
            row, column, pack(axis ? Place{Kind::Axis, row + 1, device.value} : Place{Kind::Channel, 0, device.value}));
    }
    case Kind::Axis: return createIndex(row, column, pack({Kind::Channel, place.axis, place.value}));
    case Kind::Channel: break;
    }
    return {};
}

QModelIndex DeviceModel::parent(const QModelIndex &index) const
{
    if (!index.isValid())
        return {};
    const Place place = unpack(index);
    switch (place.kind) {
    case Kind::Link: break;
    case Kind::Device: {
        const LinkRow *link = linkOf(index);
        return link ? createIndex(static_cast<int>(link - m_rows.data()), 0, pack({})) : QModelIndex();
    }
    case Kind::Axis: return indexOf({place.value});
    case Kind::Channel: return indexOf({place.value}, place.axis);
    }
    return {};
}

int DeviceModel::rowCount(const QModelIndex &parent) const
{
    if (!parent.isValid())
        return static_cast<int>(m_rows.size());
    const Place place = unpack(parent);
    if (place.kind == Kind::Link)
        return static_cast<int>(linkOf(parent)->devices.size());
    const DeviceRow *device = rowOf(deviceAt(parent));
    if (place.kind == Kind::Channel || !device)
        return 0;
    const auto channels = static_cast<int>(channelsOf(*device->family, place.axis).size());
    return place.kind == Kind::Device ? axesOf(*device->family) + channels : channels;
}

int DeviceModel::columnCount(const QModelIndex &) const
{
    return 1;
}

Qt::ItemFlags DeviceModel::flags(const QModelIndex &index) const
{
    const Qt::ItemFlags usual = QAbstractItemModel::flags(index);
    return index.isValid() && kindOf(index) != Kind::Link ? usual | Qt::ItemIsDragEnabled : usual;
}

QStringList DeviceModel::mimeTypes() const
{
    return {QLatin1String(signalMimeType)};
}

QMimeData *DeviceModel::mimeData(const QModelIndexList &indexes) const
{
    return indexes.isEmpty() ? nullptr : carry(signalsAt(indexes.front()));
}

QVariant DeviceModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    if (role == KindRole)
        return static_cast<int>(kindOf(index));
    const Snapshot &shot = m_workbench.snapshot();
    if (kindOf(index) == Kind::Link) {
        const LinkView *link = linkAt(index);
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
    case LineRole: return link.state == LinkState::Lost ? tr("lost") : bitrateText(link);
    case DetailRole: return link.scanning ? tr("scanning") : formatValue(loadOf(link) * 100, 0, QStringLiteral("%"));
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
    case UsualRole: return device.identity->state == DeviceState::Online;
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
    const Channel &row = device.channels()[channel.value];
    switch (role) {
    case Qt::DisplayRole: return channelName(row);
    case Qt::AccessibleTextRole: return signalName(device, channel);
    case Qt::ToolTipRole: return tr("%1\nDouble click or Enter plots it; drag it to a plot.").arg(qt(row.key));
    case DetailRole:
        return device.telemetry ? liveText(device, row.key, m_workbench.presentOf(device.link)).whole()
                                : QString(UnknownMark);
    default: return {};
    }
}

} // namespace mb
