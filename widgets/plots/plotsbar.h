// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plots/plotstack.h"

#include <functional>

class QComboBox;

namespace mb {

class CommandButton;
class IconButton;
class RecordingControl;
class Segmented;
class WrapLayout;
class Workbench;

/// Above the plots: pause, record, which view, how much time, and the tools. GUI thread.
class PlotsBar : public QWidget {
    Q_OBJECT
public:
    using Fill = std::function<void(QMenu &)>;
    /// What the menus of layouts and exports hold is asked each time.
    PlotsBar(
        Workbench &workbench, PlotStack &stack, const ThemeSource &theme, Fill layouts, Fill exports, QWidget *parent);

    [[nodiscard]] RecordingControl &recording() { return *m_recording; }
    /// 0 time, 1 against, 2 spectrum; as on the page.
    void showView(int view);
    /// The buttons' orders, for keys.
    void togglePause();
    void toggleTrigger();
    void showTrigger(bool armed);

Q_SIGNALS:
    void viewChosen(int view);
    void referencesWanted();
    void triggerToggled(bool on);

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void buildView();
    void buildTools(const Fill &layouts, const Fill &exports);

    PlotStack &m_stack;
    const ThemeSource &m_theme;
    WrapLayout *m_row = nullptr;
    CommandButton *m_pause = nullptr;
    RecordingControl *m_recording = nullptr;
    Segmented *m_view = nullptr;
    QComboBox *m_window = nullptr;
    IconButton *m_trigger = nullptr;
    CommandButton *m_export = nullptr;
};

} // namespace mb
