// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/operation.h"
#include "widgets/common/workbench.h"

#include <QWidget>

class QTableWidget;

namespace mb {

class ThemeSource;

/// What was said while firmware was written, a line each with its time; can be saved. GUI thread.
class UpdateLog : public QWidget {
    Q_OBJECT
public:
    UpdateLog(Workbench &workbench, const ThemeSource &theme, QWidget *parent);

    void clear();
    /// `who`: which unit it is about; empty where that is plain.
    void add(const LogLine &line, const QString &who = {});
    [[nodiscard]] int count() const;
    /// As it is saved: time, tab, text.
    [[nodiscard]] QString text() const;

private:
    void build();
    void askSave();
    [[nodiscard]] QString timeOf(Instant time) const;

    Workbench &m_workbench;
    const ThemeSource &m_theme;
    QTableWidget *m_lines = nullptr;
};

} // namespace mb
