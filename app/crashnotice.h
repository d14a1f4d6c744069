// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QFrame>

namespace mb {

/// Above the pages after a crash: what was open then can be opened again, and what happened can be read.
class CrashNotice : public QFrame {
    Q_OBJECT
public:
    /// `report`: its file; empty when there is none.
    CrashNotice(const QString &words, const QString &report, const ThemeSource &theme, QWidget *parent = nullptr);

Q_SIGNALS:
    void restoreWanted();
    /// Read, restored or not: it is not shown again.
    void dismissed();

private:
    void showReport(const QString &file);

    const ThemeSource &m_theme;
};

} // namespace mb
