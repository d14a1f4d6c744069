// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"
#include "widgets/common/workbench.h"

#include <QWidget>

class QProgressBar;

namespace mb {

class CommandButton;
class ElidedLabel;

/// A scan that takes long: what it looks for, how far it is, and a button that ends it. Hidden while there is none.
class ScanStrip : public QWidget {
    Q_OBJECT
public:
    ScanStrip(Workbench &workbench, const ThemeSource &theme, QWidget *parent);

private:
    void follow();

    Workbench &m_workbench;
    std::string m_link; ///< whose scan is shown
    ElidedLabel *m_step = nullptr;
    QProgressBar *m_progress = nullptr;
    CommandButton *m_cancel = nullptr;
};

} // namespace mb
