// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/kepttrial.h"
#include "model/family.h"
#include "widgets/common/displayunits.h"
#include "widgets/common/theme.h"

#include <QAbstractTableModel>

#include <array>
#include <string_view>
#include <vector>

namespace mb {

/// The trials of one loop as rows: sorted by any column, all or starred or clean ones. What is not known sorts last, whichever
/// way. Ten thousand of them are no burden: nothing is made for a row that nobody sees.
class TrialModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column {
        Star,
        Number,
        Time,
        Stimulus,
        GainP,
        GainI,
        GainD,
        GainF,
        Over,
        Settle,
        Rise,
        Peak,
        Flags,
        Note,
        Use, ///< takes the gains of its row
        ColumnCount
    };
    enum class Filter { All, Starred, Clean };
    static constexpr int NumberRole = Qt::UserRole; ///< of the trial

    explicit TrialModel(const ThemeSource &theme, QObject *parent = nullptr);

    /// Whose gains are shown; nullptr: nobody's.
    void setFamily(const Family *family);
    /// Rows that stay are the same rows to a view: a note that is being written there goes on.
    void setTrials(std::vector<KeptTrial> trials);
    void setUnits(const DisplayUnits &units);
    void setFilter(Filter filter);
    /// Which rows carry the letters A and B; 0: none. A view has to paint those rows anew.
    void setLetters(std::int64_t a, std::int64_t b);
    [[nodiscard]] const std::vector<KeptTrial> &trials() const { return m_trials; }
    [[nodiscard]] int countOf(Filter filter) const;
    [[nodiscard]] const KeptTrial *find(std::int64_t number) const;
    [[nodiscard]] const KeptTrial *at(int row) const;
    [[nodiscard]] int rowOf(std::int64_t number) const;
    /// The quickest to settle of those that ended well, overshoot no more than `overshoot`; nullptr: none.
    [[nodiscard]] const KeptTrial *best(double overshoot) const;
    /// Whether any trial has another gain than 0 in this column.
    [[nodiscard]] bool usesGain(int column) const;
    /// What stands in the column Use.
    [[nodiscard]] static QString useText();
    [[nodiscard]] static bool isClean(const tuning::Trial &trial);

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role) override;
    Qt::ItemFlags flags(const QModelIndex &index) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    void sort(int column, Qt::SortOrder order) override;

Q_SIGNALS:
    void starChosen(qint64 number, bool star);
    void noteWritten(qint64 number, const QString &note);

private:
    struct TriedGain {
        const Parameter *row;
        double value;
    };
    /// The gain of a column, GainP to GainF; nothing where the loop has none.
    [[nodiscard]] std::optional<TriedGain> gainOf(const tuning::Trial &trial, int column) const;
    void arrange();
    [[nodiscard]] std::vector<std::size_t> arranged(const std::vector<KeptTrial> &trials) const;
    void removeAllBut(const std::vector<KeptTrial> &trials, const std::vector<std::size_t> &rows);
    void move(std::vector<KeptTrial> trials, std::vector<std::size_t> rows);
    [[nodiscard]] std::optional<double> sortKey(const KeptTrial &kept) const;
    [[nodiscard]] QString textOf(const KeptTrial &kept, int column) const;

    const ThemeSource &m_theme;
    DisplayUnits m_units;
    std::array<std::vector<const Parameter *>, 4> m_gainRows; ///< of each of its columns
    std::vector<KeptTrial> m_trials;
    std::vector<std::size_t> m_rows;
    Filter m_filter = Filter::All;
    int m_sortColumn = Number;
    Qt::SortOrder m_order = Qt::DescendingOrder;
    std::int64_t m_a = 0;
    std::int64_t m_b = 0;
};

} // namespace mb
