// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/workbench.h"
#include "widgets/service/verdictof.h"

#include <QTimer>
#include <QWidget>

class QCheckBox;
class QLabel;

namespace mb {

class CountTiles;
class HoldButton;
class ProductionHead;
class ThemeSource;
class UnitChecks;
class UnitList;
class VerdictView;
namespace service {
struct QueueRow;
}

/// Production: one recipe on one link, unit after unit without a click, PASS or FAIL over the whole page. A self-test turns a
/// motor only while it is armed here. GUI thread.
class ProductionPage : public QWidget {
    Q_OBJECT
public:
    ProductionPage(
        Workbench &workbench, std::span<const Family *const> families, const ThemeSource &theme, QWidget *parent);

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
    void goToSerial();
    void setSound(bool on);
    [[nodiscard]] VerdictView &verdict() { return *m_verdict; }
    [[nodiscard]] HoldButton &armButton();
    /// What a small window or large letters leave no room for is left out, so it is always this small.
    [[nodiscard]] QSize minimumSizeHint() const override;

Q_SIGNALS:
    void leaveRequested();
    /// So many tones: one for PASS, three for any other verdict, two before a motor turns.
    void sounded(int times);

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void connectHead();
    void arm(bool on);
    void startOrEnd();
    void retry(const service::QueueRow &row);
    QWidget *buildBench();
    QWidget *buildUnits();
    QWidget *buildFoot();
    void askRecipe();
    void follow();
    void followBench();
    void showRecipe(const ServiceView &view);
    void ended(const service::Visit &visit);
    void sound(int times);
    void beep(int times);

    Workbench &m_workbench;
    std::span<const Family *const> m_families;
    const ThemeSource &m_theme;
    std::shared_ptr<const service::RecipeMatter> m_matter;
    SetAside m_setAside;
    bool m_announced = false; ///< that a motor turns in a moment
    bool m_isActive = true;   ///< somebody looks at this program
    bool m_isOrdered = false; ///< a start or an end, and not answered
    QTimer m_renewal;
    QCheckBox *m_sound = nullptr;
    ProductionHead *m_head = nullptr;
    UnitChecks *m_checks = nullptr;
    QLabel *m_motion = nullptr;
    VerdictView *m_verdict = nullptr;
    CountTiles *m_tiles = nullptr;
    QWidget *m_side = nullptr;
    QWidget *m_foot = nullptr;
    UnitList *m_units = nullptr;
};

} // namespace mb
