// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/axestour.h"
#include "app/motiontour.h"
#include "app/servicetour.h"
#include "app/tuningtour.h"

namespace mb {

/// Drives the demo through every page by itself, as a person would, and writes a picture of each; prints their names, and at last the samples
/// that each device sent and lost. Ends the program: status 0 when every step was reached, 1 when one was not within its time.
class Tour {
public:
    /// Pictures dark and light, or, `inOneTheme`, as the window is.
    Tour(Workbench &workbench, MainWindow &window, ThemeSource &theme, const QString &folder, bool inOneTheme = false);
    void start();

private:
    void planOverview();
    void planParameters();
    void planFirmware();
    void planLog();
    void tellLosses();

    TourStage m_stage;
    TuningTour m_tuning;
    MotionTour m_motion;
    AxesTour m_axes;
    ServiceTour m_service;
};

} // namespace mb
