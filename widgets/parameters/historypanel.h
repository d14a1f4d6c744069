// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/workbench.h"
#include "widgets/parameters/timelinelist.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QSplitter;
class QTableWidget;
class QTableWidgetItem;

namespace mb {

class CommandButton;
class Segmented;

/// What a unit has had: its states on a time line at the left, two of them, A and B, against each other at the right. What is
/// ticked of B can be written to the device when A is what it has now. What belongs to one unit is never ticked.
class HistoryPanel : public QWidget {
    Q_OBJECT
public:
    HistoryPanel(Workbench &workbench, const ThemeSource &theme, QWidget *parent);

    /// What the device has now. Its time line is fetched when the unit is another one, or has changed.
    void showDevice(const DeviceView &device);
    /// Fetches the time line again: something was kept since.
    void reload();
    /// The values of B that are ticked, in the order that is safe to write.
    [[nodiscard]] std::vector<ParameterChange> ticked() const;

Q_SIGNALS:
    void restoreRequested(const QString &from);

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    QWidget *buildBar();
    QWidget *buildFoot();
    void take(const SettingsTimeline &timeline);
    void takeFile(const settings::ParameterSnapshot &snapshot);
    void rebuild();
    [[nodiscard]] std::int64_t newestUnlike(const settings::Side &side) const;
    void choose(int state, bool asA);
    void compareChosen();
    void fitNames();
    void addRow(const settings::SideDifference &difference, bool differs);
    void count();
    [[nodiscard]] const UnitState &stateAt(int place) const { return m_states[static_cast<std::size_t>(place)]; }
    [[nodiscard]] bool mayWrite() const;

    Workbench &m_workbench;
    const ThemeSource &m_theme;
    const Family *m_family = nullptr;
    std::string m_unit;
    std::uint64_t m_revision = 0;
    bool m_online = false;
    settings::Side m_now;
    std::vector<ParameterStore::Entry> m_entries;
    SettingsTimeline m_timeline;
    std::map<std::int64_t, settings::Side> m_files; ///< by number of the snapshot
    std::vector<UnitState> m_states;
    std::int64_t m_chosenA = 0; ///< number of a snapshot; 0 now, -1 defaults
    std::int64_t m_chosenB = -1;
    bool m_chose = false; ///< somebody did
    QComboBox *m_a = nullptr;
    QComboBox *m_b = nullptr;
    Segmented *m_which = nullptr;
    QSplitter *m_splitter = nullptr;
    TimelineList *m_line = nullptr;
    QTableWidget *m_table = nullptr;
    QLabel *m_ticked = nullptr;
    CommandButton *m_restore = nullptr;
};

} // namespace mb
