// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/workbench.h"

#include <QStatusBar>
#include <QTimer>

class QLabel;

namespace mb {

class ThemeSource;

/// The bar below the pages: what was told last, for a while or, where it is grave, until somebody has read it, by a click or on the page Log;
/// at the right the samples of all devices, those that were lost, and the memory of the program. GUI thread.
class StatusBar : public QStatusBar {
    Q_OBJECT
public:
    StatusBar(Workbench &workbench, const ThemeSource &theme, QWidget *parent);

    /// What it says was read.
    void forget();

protected:
    void mousePressEvent(QMouseEvent *) override { forget(); }

private:
    void showNotice(const Notice &notice);
    void showFootprint();

    Workbench &m_workbench;
    QLabel *m_message = nullptr;
    bool m_isGrave = false; ///< what it says
    QLabel *m_footprint = nullptr;
    QTimer m_messageTime;
    QTimer m_footprintTime;
};

} // namespace mb
