// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plots/curvelegend.h"

#include <QWidget>

class QLabel;

namespace mb {

class PlotStack;
class TrialPair;

/// Above the plot of trials: what its lines are, and what is done with the two that it shows.
class TrialsHead : public QWidget {
    Q_OBJECT
public:
    TrialsHead(PlotStack &stack, const ThemeSource &theme, QWidget *parent);
    void show(const TrialPair &pair, const std::vector<CurveLegend::Entry> &legend);

Q_SIGNALS:
    void flipRequested();
    void pinRequested();

private:
    CurveLegend *m_legend = nullptr;
    QLabel *m_words = nullptr;
};

} // namespace mb
