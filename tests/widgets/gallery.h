// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QImage>
#include <QWidget>

// One page of the gallery each. Not part of the product.
QWidget *chromePage(const mb::ThemeSource &theme);
QWidget *lampPage(const mb::ThemeSource &theme);
QWidget *controlsPage(const mb::ThemeSource &theme);
QWidget *statesPage(const mb::ThemeSource &theme);
QWidget *livePlotPage(const mb::ThemeSource &theme);
/// The Overview page with links that do not work; `empty`: with none open.
QWidget *doctorPage(const mb::ThemeSource &theme, bool empty);
QWidget *trialPlotPage(const mb::ThemeSource &theme);
/// The Design page with a frequency response, and the battery of steps, as a simulated unit gives them.
QWidget *responsePage(const mb::ThemeSource &theme);
QWidget *batteryPage(const mb::ThemeSource &theme);
/// The first sheet of the report of its tuning.
QImage reportPicture();
