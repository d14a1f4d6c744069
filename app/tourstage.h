// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/mainwindow.h"
#include "app/picturesaver.h"
#include "model/family.h"

#include <QDir>
#include <QTimer>

#include <chrono>
#include <functional>
#include <vector>

namespace mb {

/// Where a tour plays: the steps of its script one after the other, the window that they act in, the units that they find, and the
/// pictures. Ends the program when a step is not reached within its time. GUI thread.
class TourStage : public QObject {
    Q_OBJECT
public:
    /// Pictures dark and light, or, `inOneTheme`, as the window is.
    TourStage(Workbench &workbench, MainWindow &window, ThemeSource &theme, const QString &folder, bool inOneTheme);

    /// Waits until `done`, which is polled; the next step follows.
    void add(const char *name, std::function<void()> act, std::function<bool()> done,
        std::chrono::milliseconds limit = std::chrono::seconds(20));
    /// Nothing to wait for.
    void act(const char *name, std::function<void()> act);
    void wait(const char *name, std::function<bool()> done, std::chrono::milliseconds limit = std::chrono::seconds(20));
    /// Lets `time` pass, so that live pages have something to show.
    void pause(std::chrono::milliseconds time);
    /// A picture of the window in its themes, when this time has passed; `grey`: each without its colours, too.
    void picture(const char *name, std::chrono::milliseconds after = {}, bool grey = false);
    /// The window with the unit under the Arm button.
    void arm(const char *name, std::function<const DeviceView *()> unit);

    /// Plays what was added, then tells `ended` the status: 0 when every step was reached, 1 when one was not.
    void play(std::function<void(int status)> ended);

    [[nodiscard]] Workbench &workbench() { return m_workbench; }
    [[nodiscard]] MainWindow &window() { return m_window; }
    template <class Page> [[nodiscard]] Page &page(PageId id) { return *qobject_cast<Page *>(m_window.page(id)); }
    /// nullptr: it is not there yet.
    [[nodiscard]] const DeviceView *device(int DemoUnits::*unit) const;
    /// The first that has several axes.
    [[nodiscard]] const DeviceView *board() const;
    void stopAll();

private:
    struct Step {
        const char *name;
        std::function<void()> act;
        std::function<bool()> done;
        std::chrono::milliseconds limit;
    };

    void look();
    void begin(std::size_t step);
    void finish(int status);
    void save(const char *name, bool grey);
    Workbench &m_workbench;
    MainWindow &m_window;
    ThemeSource &m_theme;
    QDir m_folder;
    bool m_inOneTheme;
    std::vector<Step> m_steps;
    std::function<void(int)> m_ended;
    std::size_t m_current = 0;
    Instant m_begunAt{};
    QTimer m_poll;
    PictureSaver m_saver;
    int m_pictures = 0;
};

/// Every value of the unit was read.
[[nodiscard]] bool isRead(const DeviceView &device);

} // namespace mb
