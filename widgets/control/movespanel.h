// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"
#include "widgets/control/groupmotion.h"

#include <QWidget>

#include <map>
#include <vector>

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;

namespace mb {

class CommandButton;

/// Moves that devices keep and begin together (Capabilities::bufferedMoves): one row a device of the link and family that is
/// selected, with its own target. Shows itself only where the family has them.
class MovesPanel : public QWidget {
    Q_OBJECT
public:
    MovesPanel(Workbench &workbench, Arming &arming, const ThemeSource &theme, QWidget *parent = nullptr);

    /// Whether `family` has something for this panel.
    [[nodiscard]] static bool serves(const Family &family) { return family.capabilities.bufferedMoves; }
    /// The device that is selected.
    void follow(const DeviceView &lead);
    void prepare();
    void startTogether() { m_group.start(); }
    void hold();

Q_SIGNALS:
    /// The motion comes from here now.
    void taken();

private:
    struct Row {
        DeviceId device;
        QCheckBox *takesPart = nullptr;
        QLineEdit *target = nullptr;
        QLabel *state = nullptr;
    };
    /// What somebody has entered for one device, also while it is not there.
    struct Entered {
        bool takesPart = false;
        QString target = QStringLiteral("0");
    };
    void buildKind();
    void buildButtons();
    void rebuild(const std::vector<const DeviceView *> &devices);
    void showStates();
    [[nodiscard]] QString hint() const;
    [[nodiscard]] SetPoint setPointOf(double target) const;
    [[nodiscard]] std::optional<std::vector<GroupMotion::Member>> members() const;

    Workbench &m_workbench;
    Arming &m_arming;
    const ThemeSource &m_theme;
    GroupMotion m_group;
    DeviceId m_lead;
    QComboBox *m_kind = nullptr;
    QCheckBox *m_profiled = nullptr;
    QGridLayout *m_grid = nullptr;
    QWidget *m_table = nullptr;
    std::vector<Row> m_rows;
    std::map<DeviceId, Entered> m_entered;
    CommandButton *m_prepare = nullptr;
    CommandButton *m_start = nullptr;
    CommandButton *m_hold = nullptr;
    QLabel *m_hint = nullptr;
};

} // namespace mb
