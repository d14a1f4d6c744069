// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"
#include "widgets/monitor/framefilter.h"

#include <QAbstractTableModel>

#include <deque>
#include <map>
#include <memory>
#include <span>

namespace mb {

/// The newest frames of one link that pass the filter. fetch() takes what came since the last call; frames that came faster than
/// they were fetched are counted in skipped().
class FrameModel final : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Time, Delta, Dir, Id, Message, Address, Decoded, Data, ColumnCount };

    FrameModel(const ThemeSource &theme, QObject *parent = nullptr);

    void setSource(std::shared_ptr<const TrafficLog> log, std::vector<const Family *> families, Instant origin);
    void setFilter(const FrameFilter &filter);
    /// Yields whether anything was added.
    bool fetch();
    void clear();
    [[nodiscard]] const FrameRow &row(int index) const
    {
        return m_rows[m_shown[static_cast<std::size_t>(index)] - m_firstRow];
    }
    [[nodiscard]] std::uint64_t seen() const { return m_seen; }
    [[nodiscard]] std::uint64_t skipped() const { return m_skipped; }

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] FrameRow decode(const TrafficRecord &record);
    [[nodiscard]] QString text(const FrameRow &row, int column) const;
    [[nodiscard]] QVariant color(const FrameRow &row, int column) const;
    void trim();

    const ThemeSource &m_theme;
    std::shared_ptr<const TrafficLog> m_log;
    std::vector<const Family *> m_families;
    Instant m_origin{};
    FrameFilter m_filter;
    std::deque<FrameRow> m_rows;       ///< everything kept
    std::uint64_t m_firstRow = 0;      ///< number of m_rows.front()
    std::deque<std::uint64_t> m_shown; ///< numbers of the rows that pass
    std::map<std::uint32_t, Instant> m_last;
    std::uint64_t m_fetched = 0;
    std::uint64_t m_seen = 0;
    std::uint64_t m_skipped = 0;
    std::vector<TrafficRecord> m_batch;
};

} // namespace mb
