// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/mainwindow.h"

#include <QDir>
#include <QTimer>

#include <functional>
#include <vector>

namespace mb {

/// Drives the demo through every page by itself, as a person would, and writes a picture of each; prints their names, and at last the samples
/// that each device sent and lost. Ends the program: status 0 when every step was reached, 1 when one was not within its time.
class Tour : public QObject {
    Q_OBJECT
public:
    Tour(Workbench &workbench, MainWindow &window, ThemeSource &theme, const QString &folder);
    void start();

private:
    struct Step {
        QString name;
        std::function<void()> act;
        std::function<bool()> done; ///< polled; the next step follows
        std::chrono::milliseconds limit;
    };

    void plan();
    void planOverview();
    void planParameters();
    void planMotion();
    void planTrials();
    void planDesign();
    void tellOvershoot() const;
    void tryGains(double p, double i);
    void planPlots();
    void planAxes();
    void stepAxes(double target);
    void planFirmware();
    void planEnd();
    /// Waits until `done`.
    void add(const QString &name, std::function<void()> act, std::function<bool()> done,
        std::chrono::milliseconds limit = std::chrono::seconds(20));
    /// Lets `time` pass, so that live pages have something to show.
    void pause(std::chrono::milliseconds time);
    /// A picture of the window in the present theme, and one in the other.
    void picture(const QString &name);
    void look();
    void begin(std::size_t step);
    void finish(int status);
    void tellLosses() const;
    void save(const QString &name, bool dark);
    void drive();
    [[nodiscard]] bool comesToSpeed();
    [[nodiscard]] const DeviceView *device(int DemoUnits::*unit) const;
    [[nodiscard]] const DeviceView *board() const;

    Workbench &m_workbench;
    MainWindow &m_window;
    ThemeSource &m_theme;
    QDir m_folder;
    std::vector<Step> m_steps;
    std::size_t m_current = 0;
    Instant m_begunAt{};
    Instant m_drivenAt{};
    QTimer m_poll;
    int m_pictures = 0;
    double m_foundOvershoot = 0.0; ///< of the unit that has something to tune, share of its step
    double m_tunedOvershoot = 0.0;
};

} // namespace mb
