// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/signal.h"
#include "widgets/common/workbench.h"

#include <QAbstractItemModel>

namespace mb {

/// Links, the devices on them, the axes of devices that have several, and the channels of each, from the workbench's
/// snapshots. Rows keep their place and identity from snapshot to snapshot, so that selection and expansion survive a
/// scan. Channels, axes and devices can be dragged to a plot.
class DeviceModel final : public QAbstractItemModel {
    Q_OBJECT
public:
    enum class Kind { Link, Device, Axis, Channel };
    enum Role {
        GlyphRole = Qt::UserRole, ///< int of GlyphState
        LineRole,                 ///< second line; of an axis, what it is told
        BadgeRole,
        DeviceRole, ///< quint32, 0 on a link row
        DetailRole, ///< right-hand text: load of a link, value of an axis or a channel
        KindRole,   ///< int of Kind
        UsualRole,  ///< bool: the badge says nothing that needs attention
    };

    explicit DeviceModel(Workbench &workbench, QObject *parent = nullptr);

    /// The row of an axis; of the device itself for 0.
    [[nodiscard]] QModelIndex indexOf(DeviceId device, int axis = 0) const;
    [[nodiscard]] DeviceId deviceAt(const QModelIndex &index) const;
    /// 0 for links, for devices, and for what belongs to a device as a whole.
    [[nodiscard]] int axisAt(const QModelIndex &index) const;
    /// What a row puts into a plot: a channel itself, of an axis or a device what one looks at first.
    [[nodiscard]] std::vector<Signal> signalsAt(const QModelIndex &index) const;
    /// The link of a link row; nullptr: it is another row, or the link is gone.
    [[nodiscard]] const LinkView *linkAt(const QModelIndex &index) const;
    /// Rows come, go or move: what is current in a view then was chosen by nobody.
    [[nodiscard]] bool isChanging() const { return m_changing; }
    [[nodiscard]] static Kind kindOf(const QModelIndex &index);
    /// Only devices whose title, name, serial or badge contains the text.
    void setFilter(const QString &text);
    /// While held, no row that is there moves: new devices wait. What is gone still goes.
    void setHeld(bool held);
    /// Devices that wait for that.
    [[nodiscard]] int waiting() const { return m_waiting; }

    [[nodiscard]] QModelIndex index(int row, int column, const QModelIndex &parent = {}) const override;
    [[nodiscard]] QModelIndex parent(const QModelIndex &index) const override;
    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex &index) const override;
    [[nodiscard]] QStringList mimeTypes() const override;
    [[nodiscard]] QMimeData *mimeData(const QModelIndexList &indexes) const override;

private:
    struct DeviceRow {
        DeviceId id;
        const Family *family = nullptr;
    };
    struct LinkRow {
        std::string address;
        quint32 mark = 0; ///< never used twice
        std::vector<DeviceRow> devices;
    };

    void follow();
    void followLinks(const Snapshot &shot);
    void followDevices(int row, const Snapshot &shot);
    void tellChanged(const QModelIndex &parent);
    [[nodiscard]] bool passes(const DeviceView &device) const;
    [[nodiscard]] const LinkRow *linkOf(const QModelIndex &index) const;
    [[nodiscard]] const DeviceRow *rowOf(DeviceId device) const;
    [[nodiscard]] QVariant linkData(const LinkView &link, int role) const;
    [[nodiscard]] QVariant deviceData(const DeviceView &device, int role) const;
    [[nodiscard]] QVariant axisData(const DeviceView &device, int axis, int role) const;
    [[nodiscard]] QVariant channelData(const DeviceView &device, ChannelIndex channel, int role) const;
    [[nodiscard]] ChannelIndex channelAt(const QModelIndex &index) const;

    Workbench &m_workbench;
    QString m_filter;
    std::vector<LinkRow> m_rows;
    bool m_held = false;
    bool m_changing = false;
    int m_waiting = 0;
    quint32 m_lastMark = 0;
};

} // namespace mb
