// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "settings/comparison.h"
#include "widgets/common/icons.h"
#include "widgets/common/settingsarchive.h"

#include <QListWidget>

#include <vector>

namespace mb {

/// One state of a unit that can be compared with another.
struct UnitState {
    enum class Kind { Now, Snapshot, Defaults };
    Kind kind = Kind::Now;
    std::int64_t number = 0; ///< of a snapshot
    QString title;
    QString time; ///< of day; empty where there is none
    settings::Side side;
    QString detail; ///< how it came about, and how much is known
    Symbol symbol = Symbol::Chip;
};

/// The states of one unit, newest first, under the days that they are of, and between them the writes that led from one to the
/// next: who wrote what from where. A click chooses state B, a click with Shift state A.
class TimelineList : public QListWidget {
    Q_OBJECT
public:
    TimelineList(const ThemeSource &theme, QWidget *parent);

    /// `states` in the order of their display: now first, the defaults last. Changes as an archive lists them.
    void show(const Family &family, const std::vector<UnitState> &states, const SettingsTimeline &timeline);
    /// Marks two of the states, by their place, and says how much each differs from the first.
    void mark(int a, int b);

Q_SIGNALS:
    void chosen(int state, bool asA);

protected:
    void mousePressEvent(QMouseEvent *event) override;

private:
    void addHead(const QString &text);
    void addDay(const QDate &day);
    void addState(int place);
    void addChange(const Family &family, const settings::SettingsChange &change);
    void addChangesSince(const Family &family, const SettingsTimeline &timeline, double time, std::size_t &left);
    [[nodiscard]] QString countText(int place, int a) const;

    const ThemeSource &m_theme;
    std::vector<UnitState> m_states;
    QDate m_day;
    bool m_asA = false;
};

/// "console", "window": where a write came from.
[[nodiscard]] QString originText(settings::Origin origin);

} // namespace mb
