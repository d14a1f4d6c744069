// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/control/experimentplan.h"
#include "widgets/control/tunegains.h"
#include "widgets/control/tunemotion.h"
#include "widgets/control/tuneparts.h"

#include <utility>
#include <vector>

namespace mb {

class BatteryDialog;
struct BatteryOffer;
class ReportOrder;

/// The experiments of the Tune page: what is asked for, whether it may run, what came of it. Several axes take turns.
class TuneExperiments : public QObject {
    Q_OBJECT
public:
    /// What it needs of the page outlives it.
    struct Surroundings {
        Workbench &workbench;
        Arming &arming;
        TuneChoices &choices;
        TuneMotion &motion;
        TuneGains &gains;
    };
    /// `page`: what its dialogs stand above.
    TuneExperiments(const Surroundings &surroundings, const TuneParts &parts, const ThemeSource &theme, QWidget &page);

    /// Shows stimulus, envelope and trials of the motor in question, and what the envelope says to the stimulus.
    void follow(const DeviceView &view);
    [[nodiscard]] PageStatus status(const DeviceView &view, const QString &name) const;
    /// What is staged and no part of an experiment is written first.
    void run();
    /// Of several axes, those whose turn is still to come do not get it.
    void endTurns() { m_turns.clear(); }
    /// Opens the battery of steps up to the one that is chosen, with the gains in force; F7 there runs it.
    void showBattery();
    /// Asks for a file, and writes trials A and B into it, or all of the unit where none is shown.
    void writeReport();

Q_SIGNALS:
    /// An experiment has begun or ended.
    void changed();

private:
    [[nodiscard]] ExperimentWish wishOf(const DeviceView &view, int axis) const;
    [[nodiscard]] ExperimentCheck check(const DeviceView &view, const ExperimentWish &wish) const;
    void checkKinds(const DeviceView &view);
    void handOver(const DeviceView &view, int axis);
    void runNext();
    void ended(const Result<tuning::Trial> &trial, std::uint64_t armingNumber);
    [[nodiscard]] BatteryOffer batteryNow() const;

    Workbench &m_workbench;
    Arming &m_arming;
    TuneChoices &m_choices;
    TuneMotion &m_motion;
    TuneGains &m_gains;
    TuneParts m_parts;
    const ThemeSource &m_theme;
    QWidget &m_page;
    std::vector<std::pair<int, ExperimentWish>> m_turns; ///< axes whose turn is still to come, as it was ordered
    BatteryDialog *m_battery = nullptr;
    ReportOrder *m_report = nullptr;
};

} // namespace mb
