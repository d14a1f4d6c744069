// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/pagerates.h"
#include "widgets/common/selection.h"
#include "widgets/control/arming.h"
#include "widgets/control/statusline.h"
#include "widgets/control/tuneparts.h"

#include <QWidget>

#include <memory>

class QStackedWidget;

namespace mb {

class EmptyState;
class TuneAxes;
struct TuneChoice;
class TuneChoices;
class TuneExperiments;
class TuneForm;
class TuneFrame;
class TuneGains;
class TuneMotion;

/// Tunes the loop of one motor by experiments: stimulus above, gains at the left, what the trials did at the right. Its live
/// view drives the motor by hand: mode, set-point, what happens now. Of a board with several axes it is about the selected
/// one; Run starts several at the same moment by hand, and tries them one after the other. Follows workbench, arming and
/// selection; what it does for them is in the parts that it is made of.
class TunePage : public QWidget {
    Q_OBJECT
public:
    TunePage(Workbench &workbench, Selection &selection, Arming &arming, const ThemeSource &theme, QWidget *parent);
    ~TunePage() override;

    [[nodiscard]] PageStatus status() const;

    /// The live view instead of the experiments.
    void showLive(bool live);
    [[nodiscard]] bool isLive() const;
    /// Writes what is staged for the running slot, then runs the experiment. In the live view starts, or applies what is
    /// chosen to a motor that moves.
    void run();
    /// Writes the gains that are staged; does not start anything.
    void write();
    void halt();

    [[nodiscard]] TuneForm &form() { return *m_form; }
    [[nodiscard]] TuneAxes &axes() { return *m_axes; }
    [[nodiscard]] TuneGains &gains() { return *m_gains; }
    [[nodiscard]] TuneColumn &column() { return *m_parts.column; }
    [[nodiscard]] TunePlot &plot() { return *m_parts.plot; }
    [[nodiscard]] TrialsView &trials() { return *m_parts.trials; }
    [[nodiscard]] StimulusBar &stimulus() { return *m_parts.stimulus; }
    [[nodiscard]] TuneFrame &frame() { return *m_frame; }

protected:
    void showEvent(QShowEvent *) override { follow(); }
    void hideEvent(QHideEvent *) override { wishRates(nullptr); }

private:
    void buildParts(const ThemeSource &theme);
    void makeParts(const ThemeSource &theme);
    void connectOrders();
    void connectChanges();

    void selectionChanged();
    void follow();
    void wishRates(const DeviceView *view);
    void followDevice(const DeviceView &view);
    void showCommands();
    void showSteps(const DeviceView &view, const TuneChoice &chosen);
    void showEmpty(const DeviceView *view);
    void zero();

    Workbench &m_workbench;
    PageRates m_rates{m_workbench};
    Selection &m_selection;
    Arming &m_arming;
    QStackedWidget *m_stack = nullptr;
    EmptyState *m_empty = nullptr;
    TuneFrame *m_frame = nullptr;
    QStackedWidget *m_work = nullptr;
    TuneParts m_parts;
    std::unique_ptr<TuneChoices> m_choices;
    std::unique_ptr<TuneMotion> m_motion;
    std::unique_ptr<TuneAxes> m_axes;
    std::unique_ptr<TuneGains> m_gains;
    std::unique_ptr<TuneExperiments> m_experiments;
    std::unique_ptr<TuneForm> m_form;
};

} // namespace mb
