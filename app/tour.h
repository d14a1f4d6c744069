// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/mainwindow.h"
#include "app/tourscript.h"

#include <QDir>
#include <QTimer>

#include <functional>
#include <vector>

namespace mb {

class ServiceTour;

/// Drives the demo through every page by itself, as a person would, and writes a picture of each; prints their names, and at last the samples
/// that each device sent and lost. Ends the program: status 0 when every step was reached, 1 when one was not within its time.
class Tour : public QObject, private TourScript {
    Q_OBJECT
public:
    /// Pictures dark and light, or, `inOneTheme`, as the window is.
    Tour(Workbench &workbench, MainWindow &window, ThemeSource &theme, const QString &folder, bool inOneTheme = false);
    void start();

private:
    struct Step {
        QString name;
        std::function<void()> act;
        std::function<bool()> done; ///< polled; the next step follows
        std::chrono::milliseconds limit;
    };

    using TourScript::add;
    using TourScript::picture;
    void add(const QString &name, std::function<void()> act, std::function<bool()> done,
        std::chrono::milliseconds limit) override;
    void pause(std::chrono::milliseconds time) override;
    void picture(const QString &name, bool grey) override;
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
    void look();
    void begin(std::size_t step);
    void finish(int status);
    void tellLosses() const;
    void save(const QString &name, bool grey);
    void drive();
    [[nodiscard]] bool comesToSpeed();
    [[nodiscard]] const DeviceView *device(int DemoUnits::*unit) const;
    [[nodiscard]] const DeviceView *board() const;

    Workbench &m_workbench;
    MainWindow &m_window;
    ThemeSource &m_theme;
    QDir m_folder;
    bool m_inOneTheme;
    std::vector<Step> m_steps;
    std::size_t m_current = 0;
    Instant m_begunAt{};
    Instant m_drivenAt{};
    QTimer m_poll;
    int m_pictures = 0;
    ServiceTour *m_service = nullptr;
    double m_foundOvershoot = 0.0; ///< of the unit that has something to tune, share of its step
    double m_tunedOvershoot = 0.0;
};

} // namespace mb
