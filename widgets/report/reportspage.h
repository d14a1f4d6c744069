// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/report.h"
#include "widgets/common/workbench.h"

#include <QWidget>

class QListWidget;
class QStackedWidget;
class QTextBrowser;

namespace mb {

class CommandButton;
class ReportDrawings;
class ReportOrder;
class SearchField;
class ThemeSource;

/// What can be handed out about the units that are here: a card of each, its tunings and its trials, newest first; searched,
/// looked at beside the list, and written as PDF or HTML. GUI thread.
class ReportsPage : public QWidget {
    Q_OBJECT
public:
    ReportsPage(Workbench &workbench, const ThemeSource &theme, QWidget *parent);

    [[nodiscard]] QListWidget &list() { return *m_list; }
    /// The report that is looked at, as text; empty while there is none.
    [[nodiscard]] QString previewText() const;
    /// Writes what is looked at into a file whose name ends in .pdf or .html.
    void write(const QString &path);
    [[nodiscard]] ReportOrder &order() { return *m_order; }

protected:
    void showEvent(QShowEvent *event) override;

private:
    struct Entry {
        DeviceId device;
        ReportWish wish;
        double time = 0.0; ///< Unix, s; 0: the card of the unit
        QString title;
        QString about;
    };
    QWidget *buildList();
    QWidget *buildPreview();
    void addKeys();
    void follow();
    void take(DeviceId device, const ReportUnit &unit);
    void fill();
    void preview();
    void exportChosen();
    [[nodiscard]] const Entry *chosen() const;

    Workbench &m_workbench;
    const ThemeSource &m_theme;
    QString m_asked; ///< of whom it was asked, to ask once
    std::vector<Entry> m_entries;
    QStackedWidget *m_states = nullptr;
    SearchField *m_search = nullptr;
    QListWidget *m_list = nullptr;
    QTextBrowser *m_text = nullptr;
    ReportDrawings *m_drawings = nullptr;
    CommandButton *m_export = nullptr;
    ReportOrder *m_order = nullptr;
    int m_shown = 0; ///< which preview is the newest that was asked for
};

} // namespace mb
