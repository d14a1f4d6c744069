// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"
#include "widgets/common/workbench.h"

#include <QWidget>

class QStackedWidget;
class QTableView;

namespace mb {

class NoticeModel;
class SearchField;
class Segmented;

/// Everything that was done and happened, newest last, with filter and export.
class LogPage : public QWidget {
    Q_OBJECT
public:
    LogPage(Workbench &workbench, const ThemeSource &theme, QWidget *parent = nullptr);
    /// The whole log as text, one line each.
    [[nodiscard]] QString text() const;

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void buildBar();
    void buildTable();
    void askSave();

    Workbench &m_workbench;
    const ThemeSource &m_theme;
    NoticeModel *m_model = nullptr;
    QStackedWidget *m_states = nullptr;
    bool m_follows = true; ///< the newest line is in sight
    QTableView *m_table = nullptr;
    SearchField *m_search = nullptr;
    Segmented *m_severity = nullptr;
};

} // namespace mb
