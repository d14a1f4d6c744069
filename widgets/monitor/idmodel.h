// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"
#include "widgets/monitor/framefilter.h"

#include <QAbstractTableModel>
#include <QMap>
#include <QVector>

#include <deque>
#include <memory>

namespace mb {

/// One row for each identifier of a link: how often, how evenly, what it says now. Counted by the engine over every frame, so
/// nothing is missing though the chronological view was too slow. Rows keep their places: in order of identifier, or of
/// the column that was clicked, until the next click.
class IdModel final : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Id, Dir, Message, Address, Rate, Jitter, Count, Data, Value, Spark, ColumnCount };

    explicit IdModel(const ThemeSource &theme, QObject *parent = nullptr);

    void setSource(std::shared_ptr<const TrafficLog> log);
    void setDecoder(FrameDecoder decoder);
    /// Shows the identifiers of which a frame passed the filter when refresh() looked.
    void setFilter(FrameFilter filter);
    /// Takes the present counts. `now` ends the second that rates are of.
    void refresh(Instant now);

    [[nodiscard]] const TrafficRow &row(int index) const { return shown(index).traffic; }
    /// nullptr when nobody knows the frame.
    [[nodiscard]] const FrameMeaning *meaning(int index) const { return meaningOf(shown(index)); }
    /// The field that value and line of a row show; −1 when there is none.
    [[nodiscard]] int field(int index) const { return fieldOf(shown(index)); }
    /// For all rows with the same message.
    void chooseField(int index, const QString &name);
    /// Frames of identifiers that are too many to have rows.
    [[nodiscard]] std::uint64_t unlisted() const { return m_unlisted; }
    /// The identifier with most frames in the last second; nullptr when nothing came.
    [[nodiscard]] const TrafficRow *busiest() const;

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(
        int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    void sort(int column, Qt::SortOrder order = Qt::AscendingOrder) override;

private:
    struct Row {
        TrafficRow traffic;
        bool passed = false; ///< the filter, once since it was set
        mutable std::uint64_t decodedAt = 0;
        mutable std::optional<FrameMeaning> meaning;
        mutable int trailField = -1;
        mutable Instant trailEnd{};
        mutable std::deque<std::pair<Instant, double>> trail;
    };
    [[nodiscard]] const Row &shown(int index) const { return m_rows[m_shown[static_cast<std::size_t>(index)]]; }
    [[nodiscard]] const FrameMeaning *meaningOf(const Row &row) const;
    [[nodiscard]] int fieldOf(const Row &row) const;
    [[nodiscard]] bool before(std::size_t a, std::size_t b) const;
    void look(Row &row);
    void showPassed();
    [[nodiscard]] QString text(const Row &row, int column) const;
    [[nodiscard]] QString valueText(const Row &row) const;
    [[nodiscard]] QString tip(const Row &row, int column) const;
    [[nodiscard]] QVariant color(const Row &row, int column) const;
    [[nodiscard]] int changedLately(const TrafficRow &row) const;
    [[nodiscard]] QVariant spark(const Row &row) const;

    const ThemeSource &m_theme;
    std::shared_ptr<const TrafficLog> m_log;
    FrameDecoder m_decoder;
    FrameFilter m_filter;
    Instant m_now{};
    std::vector<TrafficRow> m_batch;
    std::vector<Row> m_rows;          ///< in the order of their appearance, as the log has them
    std::vector<std::size_t> m_shown; ///< places in m_rows
    QMap<QString, QString> m_fields;  ///< chosen: message → field
    int m_sortColumn = Id;
    Qt::SortOrder m_sortOrder = Qt::AscendingOrder;
    std::uint64_t m_unlisted = 0;
};

} // namespace mb
