// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"
#include "widgets/common/workbench.h"

#include <QAbstractTableModel>

namespace mb {

/// The log as a table: time, state, device, text.
class NoticeModel final : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Time, Glyph, Device, Text, ColumnCount };
    enum Role { SeverityRole = Qt::UserRole };

    NoticeModel(Workbench &workbench, const ThemeSource &theme, QObject *parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    /// What was said begins with the device that it was said of.
    void setNamed(bool named);
    [[nodiscard]] QString timeText(const Notice &notice) const;

private:
    Workbench &m_workbench;
    const ThemeSource &m_theme;
    std::vector<Notice> m_notices;
    bool m_named = false;
};

} // namespace mb
