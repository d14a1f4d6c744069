// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QTableView>

#include <vector>

namespace mb {

class TrafficDelegate;

/// A table of the Bus page: narrow rows painted by TrafficDelegate, one column that takes the room that is left.
class TrafficView : public QTableView {
    Q_OBJECT
public:
    /// `widths` at 10 pt, of every column; the one that stretches keeps at least its own.
    TrafficView(const ThemeSource &theme, const QString &name, std::vector<int> widths, int stretching,
        QWidget *parent = nullptr);
    void setModel(QAbstractItemModel *model) override;
    /// Columns that are left out, the first first, where the stretching one would become too narrow.
    void setSpare(std::vector<int> columns) { m_spare = std::move(columns); }
    /// A column that takes half of what the stretching one has beyond its least.
    void setSharing(int column) { m_sharing = column; }
    [[nodiscard]] bool isAtEnd() const;

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void layOut();

    const ThemeSource &m_theme;
    std::vector<int> m_widths;
    int m_stretching;
    std::vector<int> m_spare;
    int m_sharing = -1;
};

} // namespace mb
