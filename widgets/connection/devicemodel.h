// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/workbench.h"

#include <QAbstractItemModel>

namespace mb {

/// Links and the devices on them, from the workbench's snapshots. Rows keep their place and identity from snapshot to
/// snapshot, so that selection and expansion survive a scan.
class DeviceModel final : public QAbstractItemModel {
    Q_OBJECT
public:
    enum Role {
        GlyphRole = Qt::UserRole, ///< int of GlyphState
        LineRole,                 ///< second line
        BadgeRole,
        DeviceRole, ///< quint32, 0 on a link row
        DetailRole, ///< right-hand text of a link row: load
    };

    explicit DeviceModel(Workbench &workbench, QObject *parent = nullptr);

    [[nodiscard]] QModelIndex indexOf(DeviceId device) const;
    [[nodiscard]] DeviceId deviceAt(const QModelIndex &index) const;
    /// Only devices whose title, name, serial or badge contains the text.
    void setFilter(const QString &text);

    [[nodiscard]] QModelIndex index(int row, int column, const QModelIndex &parent = {}) const override;
    [[nodiscard]] QModelIndex parent(const QModelIndex &index) const override;
    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;

private:
    struct LinkRow {
        std::string address;
        std::vector<DeviceId> devices;
    };

    void follow();
    void followLinks(const Snapshot &shot);
    void followDevices(int row, const Snapshot &shot);
    [[nodiscard]] bool passes(const DeviceView &device) const;
    [[nodiscard]] QVariant linkData(const LinkView &link, int role) const;
    [[nodiscard]] QVariant deviceData(const DeviceView &device, int role) const;

    Workbench &m_workbench;
    QString m_filter;
    std::vector<LinkRow> m_rows;
};

} // namespace mb
