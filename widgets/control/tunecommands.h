// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/control/statusline.h"

namespace mb {

class CommandButton;
class Segmented;
class TuneSteps;

/// The bar above the Tune page: what state the motor is in, experiment or live view, and the orders to stop and to run.
class TuneCommands : public QWidget {
    Q_OBJECT
public:
    struct State {
        PageStatus status;
        bool writes = false;  ///< Run writes gains first
        int together = 1;     ///< axes that Run is about
        bool moving = false;  ///< the motor that is shown
        bool mayStop = false; ///< that, or an experiment
        int stopsAxis = 0;    ///< others go on; 0: all that moves ends
    };

    explicit TuneCommands(const ThemeSource &theme, QWidget *parent);

    void show(const State &state);
    /// Without a signal.
    void setLive(bool live);
    [[nodiscard]] bool isLive() const;
    /// Without room the tabs below have the views, and the button that stops is its sign.
    void setFolded(bool folded);
    [[nodiscard]] TuneSteps &steps() const { return *m_steps; }
    /// The last in the order of Tab.
    [[nodiscard]] CommandButton *runButton() const { return m_run; }

Q_SIGNALS:
    void runRequested();
    void stopRequested();
    void liveChosen(bool live);

protected:
    void resizeEvent(QResizeEvent *) override { fitSteps(); }

private:
    void fitSteps();

    const ThemeSource &m_theme;
    TuneSteps *m_steps = nullptr;
    StatusLine *m_status = nullptr;
    CommandButton *m_stop = nullptr;
    CommandButton *m_run = nullptr;
    Segmented *m_view = nullptr;
    bool m_folded = false;
};

} // namespace mb
