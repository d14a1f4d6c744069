// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/battery.h"
#include "widgets/control/arming.h"

#include <QDialog>

#include <functional>

class QLabel;
class QTableWidget;

namespace mb {

class CommandButton;
class CurvePlot;

/// What a battery would be now, for the device that it is about.
struct BatteryOffer {
    DeviceId device;
    tuning::Battery battery;
    QString unit;    ///< of the target
    QString whyNot;  ///< it cannot be run; empty: it can
    QString motor{}; ///< its title
};

/// Steps of several sizes in both directions with the gains in force, one after the other: what will happen before it does, a row for each
/// as it ends, the worst of every metric, all responses over each other. Every step is a trial of the notebook. Not modal: STOP and its
/// keys work all the time, and end it. Closing ends it after the step that runs.
class BatteryDialog : public QDialog {
    Q_OBJECT
public:
    /// `offer` is asked when it is shown, and again when it is run: what stands on the page then is what moves the motor, once it is shown.
    BatteryDialog(Arming &arming, std::function<BatteryOffer()> offer, const ThemeSource &theme, QWidget *parent);

    /// Says what it would run; not while it runs.
    void showOffer();
    /// The page may say something else: shows that, unless it runs or says what came of it.
    void followOffer();
    /// As if its button was pressed: starts what is shown, where the device is armed; where the offer is another, shows that instead. Places
    /// are the same to a fiftieth of the way between them, for a motor rests a few counts from where it was.
    void run();
    [[nodiscard]] bool isRunning() const { return m_running; }
    [[nodiscard]] const std::vector<tuning::Trial> &trials() const { return m_trials; }
    [[nodiscard]] QString words() const;
    [[nodiscard]] QTableWidget &table() { return *m_table; }
    [[nodiscard]] CurvePlot &plot() { return *m_plot; }

private:
    void buildTable();
    QWidget *namesOfWays(const ThemeSource &theme);
    [[nodiscard]] QString offered() const;
    void take(BatteryOffer offer);
    void next();
    void ended(const Result<tuning::Trial> &trial, std::uint64_t armingNumber);
    void addRow(const tuning::Trial &trial);
    void showWorst();
    void markBold(int row, int column);
    void showCurves();
    void follow();
    void say(const QString &words);

    Arming &m_arming;
    std::function<BatteryOffer()> m_offer;
    const ThemeSource &m_theme;
    BatteryOffer m_now;       ///< that is shown
    bool m_isRefused = false; ///< another was to be run
    std::vector<tuning::Trial> m_trials;
    bool m_running = false;
    QLabel *m_words = nullptr;
    CommandButton *m_start = nullptr;
    QTableWidget *m_table = nullptr;
    CurvePlot *m_plot = nullptr;
};

} // namespace mb
