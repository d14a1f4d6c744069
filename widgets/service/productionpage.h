// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/service/servicedesk.h"

#include <QTimer>
#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;

namespace mb {

class CommandButton;
class HoldButton;
class ThemeSource;
class VerdictView;
class Workbench;

/// Production: one recipe on one link, unit after unit without a click, PASS or FAIL over the whole page. A self-test turns a
/// motor only while it is armed here. GUI thread.
class ProductionPage : public QWidget {
    Q_OBJECT
public:
    ProductionPage(ServiceDesk &desk, Workbench &workbench, std::span<const Family *const> families,
        const ThemeSource &theme, QWidget *parent);

    /// False, with a notice of the line and the mistake, when it is none.
    bool openRecipe(const QString &path);
    /// Serves what is put on the chosen link, until it is left.
    void start();
    /// The last that failed, once more.
    void testAgain();
    /// The verdict was seen: ready for the next.
    void setAside();
    /// A serial number that was scanned or typed: that unit is served.
    void take(const QString &serial);
    void setSound(bool on) { m_sound = on; }
    [[nodiscard]] VerdictView &verdict() { return *m_verdict; }
    [[nodiscard]] HoldButton &armButton() { return *m_arm; }

Q_SIGNALS:
    void leaveRequested();

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    QWidget *buildHead();
    QWidget *buildBench();
    QWidget *buildUnits();
    QWidget *buildFoot();
    void askRecipe();
    void follow();
    void followLinks();
    void ended(const service::Visit &visit);
    void beep(int times);

    ServiceDesk &m_desk;
    Workbench &m_workbench;
    std::span<const Family *const> m_families;
    const ThemeSource &m_theme;
    std::shared_ptr<const service::RecipeMatter> m_matter;
    std::vector<std::uint32_t> m_setAside;
    bool m_sound = true;
    QTimer m_renewal;
    QLabel *m_recipe = nullptr;
    QLabel *m_motion = nullptr;
    QLabel *m_counts = nullptr;
    QComboBox *m_link = nullptr;
    CommandButton *m_start = nullptr;
    HoldButton *m_arm = nullptr;
    VerdictView *m_verdict = nullptr;
    QListWidget *m_units = nullptr;
    QLineEdit *m_serial = nullptr;
};

} // namespace mb
