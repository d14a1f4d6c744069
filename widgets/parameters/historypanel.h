// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/workbench.h"
#include "widgets/parameters/unitstates.h"

#include <QWidget>

class QComboBox;
class QLabel;

namespace mb {

class CommandButton;
class DifferenceTable;
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
    void restoreRequested();

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    QWidget *buildBar();
    QWidget *buildTimeline();
    void drawBadges();
    QWidget *buildFoot();
    void take(const SettingsTimeline &timeline);
    void rebuild();
    void choose(int state, bool asA);
    void compareChosen();
    void count();
    [[nodiscard]] bool isLive() const;
    [[nodiscard]] bool mayWrite() const { return m_ready == Ready::Yes && isLive() && !ticked().empty(); }

    Workbench &m_workbench;
    const ThemeSource &m_theme;
    /// Whether it can be written to now; Decide: somebody has to keep or revert what was written before.
    enum class Ready { No, Decide, Yes };
    [[nodiscard]] Ready readyOf(const DeviceView &device) const;

    std::string m_unit;
    std::uint64_t m_revision = 0;
    Ready m_ready = Ready::No;
    std::vector<ParameterStore::Entry> m_entries;
    UnitStates m_states;
    std::int64_t m_chosenA = UnitStates::present; ///< numbers of states
    std::int64_t m_chosenB = UnitStates::defaults;
    bool m_chose = false; ///< somebody did
    /// What the table compares: ticks are meant for that.
    struct Compared {
        std::string unit;
        std::int64_t a = 0;
        std::int64_t b = 0;
        friend bool operator==(const Compared &, const Compared &) = default;
    };
    Compared m_compared;
    QLabel *m_badgeA = nullptr;
    QLabel *m_badgeB = nullptr;
    QComboBox *m_a = nullptr;
    QComboBox *m_b = nullptr;
    Segmented *m_which = nullptr;
    TimelineList *m_line = nullptr;
    DifferenceTable *m_table = nullptr;
    QLabel *m_ticked = nullptr;
    CommandButton *m_restore = nullptr;
};

} // namespace mb
