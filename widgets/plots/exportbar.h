// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/export.h"
#include "widgets/common/theme.h"

#include <QWidget>

class QProgressBar;

namespace mb {

class ExportJob;
class PlotBoard;
class Workbench;
struct ExportChoice;

/// Writes the samples of what is plotted: progress and a way to cancel while it does, hidden otherwise. One file at a time.
/// GUI thread.
class ExportBar : public QWidget {
    Q_OBJECT
public:
    ExportBar(Workbench &workbench, PlotBoard &board, const ThemeSource &theme, QWidget *parent);
    /// How it ends is reported.
    void exportSamples(const ExportChoice &choice);

private:
    [[nodiscard]] ExportPlan planFor(const ExportChoice &choice) const;
    void finished(const QString &path, const Result<ExportReport> &report);

    Workbench &m_workbench;
    PlotBoard &m_board;
    ExportJob *m_job;
    QProgressBar *m_progress;
};

} // namespace mb
