// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"
#include "widgets/monitor/framefilter.h"
#include "widgets/monitor/framerow.h"

#include <QAbstractTableModel>
#include <QTimer>

#include <array>
#include <deque>
#include <memory>

namespace mb {

/// The newest records of one link that pass the filter, oldest first. Frames are decoded only when a cell of theirs is asked for, or when the
/// filter asks. fetch() takes what came since the last call; what came faster than it was fetched is counted in skipped().
class FrameModel final : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Time, Delta, Dir, Id, Message, Address, Decoded, Data, ColumnCount };
    static constexpr std::size_t keptRows = 100000;

    explicit FrameModel(const ThemeSource &theme, QObject *parent = nullptr);

    void setSource(std::shared_ptr<const TrafficLog> log, LinkKind kind = LinkKind::Can);
    /// Applies to what is shown from now on; the filter looks again when it changed.
    void setDecoder(FrameDecoder decoder);
    [[nodiscard]] const FrameDecoder &decoder() const { return m_decoder; }
    /// The newest rows are looked through at once, older ones in the moments that follow.
    void setFilter(FrameFilter filter);
    /// Rows that pass are marked; an empty one marks none.
    void setSearch(FrameFilter search);
    /// The next row that passes the search, from `row` on; −1 when there is none.
    [[nodiscard]] int findFrom(int row, bool forward) const;
    /// While frozen the rows stay as they are; what comes is kept all the same and shown afterwards.
    void setFrozen(bool frozen);
    [[nodiscard]] bool isFrozen() const { return m_shownStore != &m_live; }
    /// Yields whether rows were added.
    bool fetch();
    /// Nobody has looked for a while: what was overwritten meanwhile is not counted as skipped.
    void rejoin() { m_joins = true; }
    void clear();

    [[nodiscard]] const FrameRow &row(int index) const;
    /// nullptr when nobody knows the frame. Valid until the next call.
    [[nodiscard]] const FrameMeaning *meaning(const FrameRow &row) const;
    /// Every record kept, whether it is shown or not.
    [[nodiscard]] const std::deque<FrameRow> &kept() const { return m_shownStore->rows; }
    /// Records that passed since the source was set, and those of them that were overwritten while somebody looked.
    [[nodiscard]] std::uint64_t seen() const { return m_fetched - m_begin; }
    [[nodiscard]] std::uint64_t skipped() const { return m_skipped; }
    /// Time zero of the column.
    [[nodiscard]] Instant origin() const { return m_origin; }

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(
        int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

Q_SIGNALS:
    /// Older rows were found that pass the filter, and stand before the others now.
    void olderFound();

private:
    struct Store {
        std::deque<FrameRow> rows;
        std::uint64_t first = 0; ///< number of rows.front() in this store
        [[nodiscard]] std::uint64_t end() const { return first + rows.size(); }
    };
    struct Cached {
        std::uint64_t number = 0;
        std::optional<FrameMeaning> meaning;
    };
    [[nodiscard]] bool passes(const FrameRow &row) const
    {
        return m_filter.passes({row.record, m_decoder, row.asked, row.packet()});
    }
    void keep(TrafficRecord record);
    void trim();
    void restart();
    void scanBack(std::size_t limit);
    [[nodiscard]] QString text(const FrameRow &row, int column) const;
    [[nodiscard]] QVariant color(const FrameRow &row, int column) const;
    [[nodiscard]] QVariant background(const FrameRow &row) const;

    const ThemeSource &m_theme;
    std::shared_ptr<const TrafficLog> m_log;
    FrameDecoder m_decoder;
    Instant m_origin{};
    FrameFilter m_filter;
    FrameFilter m_search;
    Store m_live;
    std::unique_ptr<Store> m_frozen;
    const Store *m_shownStore = &m_live;
    std::deque<std::uint64_t> m_shown; ///< numbers of the rows that pass
    std::uint64_t m_unscanned = 0;     ///< rows before this number were not looked through yet
    std::uint64_t m_begin = 0;
    std::uint64_t m_fetched = 0;
    std::uint64_t m_skipped = 0;
    bool m_joins = true; ///< the next fetch is the first of a series
    std::vector<TrafficRecord> m_batch;
    FrameSuccession m_succession{LinkKind::Can};
    mutable std::array<Cached, 512> m_meanings;
    QTimer m_scan;
};

} // namespace mb
