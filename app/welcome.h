// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/start/story.h"

#include <QObject>

namespace mb {

class FirmwareShelf;
class Guide;
class GuideStrip;
class MainWindow;
class Settings;
class StartPage;
class ThemeSource;
class Workbench;

/// Connects the start page and the guide to the window: stories open the simulated bench, steps lead to their pages, firmware
/// on disk to the page Firmware. Lives as long as the window.
class Welcome : public QObject {
    Q_OBJECT
public:
    Welcome(MainWindow &window, Workbench &workbench, const ThemeSource &theme, Settings &settings);

    [[nodiscard]] Guide &guide() { return *m_guide; }
    [[nodiscard]] StartPage &start() { return *m_start; }

private:
    void connectStart();
    void connectStrip();
    void begin(const Story &story);
    void show(StoryPlace place);
    void offer();

    MainWindow &m_window;
    Workbench &m_workbench;
    Settings &m_settings;
    StartPage *m_start = nullptr;
    Guide *m_guide = nullptr;
    GuideStrip *m_offer = nullptr; ///< on the overview, where it moves nothing else
    GuideStrip *m_strip = nullptr;
    FirmwareShelf *m_shelf = nullptr;
    bool m_begun = false; ///< the story that is offered
};

} // namespace mb
