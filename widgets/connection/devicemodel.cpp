// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connection/devicemodel.h"

#include "widgets/common/devicetext.h"

#include <algorithm>

namespace mb {
namespace {

constexpr quintptr linkMark = ~quintptr{0};

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

bool DeviceModel::passes(const DeviceView &device) const
{
    const auto has = [this](const QString &text) { return text.contains(m_filter, Qt::CaseInsensitive); };
    return m_filter.isEmpty() || has(titleOf(device)) || has(QString::fromStdString(device.identity.name))
        || has(QString::fromStdString(device.identity.serial)) || has(badgeOf(device));
}

void DeviceModel::follow()
{
    const Snapshot &shot = m_workbench.snapshot();
    followLinks(shot);
    for (int row = 0; row < static_cast<int>(m_rows.size()); ++row)
        followDevices(row, shot);
    if (m_rows.empty())
        return;
    Q_EMIT dataChanged(index(0, 0), index(static_cast<int>(m_rows.size()) - 1, 0));
    for (int row = 0; row < static_cast<int>(m_rows.size()); ++row) {
        const QModelIndex link = index(row, 0);
        if (const int count = rowCount(link); count > 0)
            Q_EMIT dataChanged(index(0, 0, link), index(count - 1, 0, link));
    }
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
        const bool known = std::any_of(
            m_rows.begin(), m_rows.end(), [&](const LinkRow &row) { return row.address == link.address; });
        if (known)
            continue;
        const int row = static_cast<int>(m_rows.size());
        beginInsertRows({}, row, row);
        m_rows.push_back({link.address, {}});
        endInsertRows();
    }
}

void DeviceModel::followDevices(int row, const Snapshot &shot)
{
    LinkRow &link = m_rows[static_cast<std::size_t>(row)];
    const QModelIndex parent = index(row, 0);
    std::vector<DeviceId> wanted;
    for (const DeviceView &device : shot.devices) {
        if (device.link == link.address && passes(device))
            wanted.push_back(device.id);
    }
    for (int i = static_cast<int>(link.devices.size()) - 1; i >= 0; --i) {
        if (std::find(wanted.begin(), wanted.end(), link.devices[static_cast<std::size_t>(i)]) != wanted.end())
            continue;
        beginRemoveRows(parent, i, i);
        link.devices.erase(link.devices.begin() + i);
        endRemoveRows();
    }
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        if (i < link.devices.size() && link.devices[i] == wanted[i])
            continue;
        if (const auto old = std::find(link.devices.begin(), link.devices.end(), wanted[i]);
            old != link.devices.end()) {
            const int from = static_cast<int>(old - link.devices.begin());
            beginRemoveRows(parent, from, from);
            link.devices.erase(old);
            endRemoveRows();
        }
        beginInsertRows(parent, static_cast<int>(i), static_cast<int>(i));
        link.devices.insert(link.devices.begin() + static_cast<std::ptrdiff_t>(i), wanted[i]);
        endInsertRows();
    }
}

QModelIndex DeviceModel::indexOf(DeviceId device) const
{
    for (int row = 0; row < static_cast<int>(m_rows.size()); ++row) {
        const auto &devices = m_rows[static_cast<std::size_t>(row)].devices;
        const auto found = std::find(devices.begin(), devices.end(), device);
        if (found != devices.end())
            return index(static_cast<int>(found - devices.begin()), 0, index(row, 0));
    }
    return {};
}

DeviceId DeviceModel::deviceAt(const QModelIndex &index) const
{
    if (!index.isValid() || index.internalId() == linkMark)
        return {};
    return m_rows[index.internalId()].devices[static_cast<std::size_t>(index.row())];
}

QModelIndex DeviceModel::index(int row, int column, const QModelIndex &parent) const
{
    if (row < 0 || column != 0 || row >= rowCount(parent))
        return {};
    return createIndex(row, column, parent.isValid() ? static_cast<quintptr>(parent.row()) : linkMark);
}

QModelIndex DeviceModel::parent(const QModelIndex &index) const
{
    if (!index.isValid() || index.internalId() == linkMark)
        return {};
    return createIndex(static_cast<int>(index.internalId()), 0, linkMark);
}

int DeviceModel::rowCount(const QModelIndex &parent) const
{
    if (!parent.isValid())
        return static_cast<int>(m_rows.size());
    if (parent.internalId() != linkMark)
        return 0;
    return static_cast<int>(m_rows[static_cast<std::size_t>(parent.row())].devices.size());
}

int DeviceModel::columnCount(const QModelIndex &) const
{
    return 1;
}

QVariant DeviceModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    const Snapshot &shot = m_workbench.snapshot();
    if (index.internalId() == linkMark) {
        const LinkView *link = shot.link(m_rows[static_cast<std::size_t>(index.row())].address);
        return link ? linkData(*link, role) : QVariant();
    }
    const DeviceView *device = shot.device(deviceAt(index));
    return device ? deviceData(*device, role) : QVariant();
}

QVariant DeviceModel::linkData(const LinkView &link, int role) const
{
    switch (role) {
    case Qt::DisplayRole:
    case Qt::AccessibleTextRole: return QString::fromStdString(link.name);
    case Qt::ToolTipRole:
        return QString::fromStdString(link.reason.empty() ? link.address : link.address + '\n' + link.reason);
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
    case DeviceRole: return device.id.value;
    default: return {};
    }
}

} // namespace mb
