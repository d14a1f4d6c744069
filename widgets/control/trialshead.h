// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QWidget>

class QLabel;

namespace mb {

class PlotStack;
class TrialPair;

/// Above the plot of trials: which two are shown, and what is done with them.
class TrialsHead : public QWidget {
    Q_OBJECT
public:
    TrialsHead(PlotStack &stack, const ThemeSource &theme, QWidget *parent);
    void show(const TrialPair &pair);

Q_SIGNALS:
    void flipRequested();
    void pinRequested();

private:
    QLabel *m_words = nullptr;
};

} // namespace mb
