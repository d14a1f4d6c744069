// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/workbench.h"

#include <QStatusBar>
#include <QTimer>

#include <optional>

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
    void take(const Notice &notice);
    void endMessage();
    void write(const Notice &notice);
    void showFootprint();

    Workbench &m_workbench;
    QLabel *m_message = nullptr;
    std::optional<Notice> m_grave; ///< that nobody has read yet
    QLabel *m_footprint = nullptr;
    QTimer m_messageTime{this};
    QTimer m_footprintTime;
};

} // namespace mb
