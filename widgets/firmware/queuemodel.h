// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/firmware/queuelines.h"

#include <QAbstractTableModel>
#include <QStyledItemDelegate>

#include <set>

namespace mb {

/// The units of a queue as a table; each has a tick in its first column while it may be chosen. GUI thread.
class QueueModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Serial, Unit, Versions, StepNow, Share, Time, Outcome, Columns };
    static constexpr int ShareRole = Qt::UserRole + 1; ///< int, percent; invalid: nothing

    explicit QueueModel(const ThemeSource &theme, QObject *parent = nullptr);

    void setLines(std::vector<QueueLine> lines);
    [[nodiscard]] const std::vector<QueueLine> &lines() const { return m_lines; }
    /// Off: ticks stand, and cannot be changed.
    void setChoosing(bool on);
    void tick(DeviceId device, bool on);
    void tickAll(bool on);
    /// Those that are here and ticked.
    [[nodiscard]] std::vector<DeviceId> ticked() const;
    [[nodiscard]] int rowOf(std::uint32_t queueRow) const;
    /// Where the unit of this line stands now, also where it has come into the queue, or its device is gone; -1: nowhere.
    [[nodiscard]] int placeOf(const QueueLine &line) const;

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role) override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex &index) const override;

Q_SIGNALS:
    void tickedChanged();

private:
    [[nodiscard]] QString text(const QueueLine &line, int column) const;
    [[nodiscard]] QVariant look(const QueueLine &line, int column, int role) const;

    const ThemeSource &m_theme;
    std::vector<QueueLine> m_lines;
    std::set<DeviceId> m_ticked;
    bool m_choosing = true;
};

/// Draws the column Share as a bar with its percent.
class ShareDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    explicit ShareDelegate(const ThemeSource &theme, QObject *parent = nullptr);
    void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override;

private:
    const ThemeSource &m_theme;
};

} // namespace mb
