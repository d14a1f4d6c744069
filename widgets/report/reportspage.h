// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/selection.h"
#include "widgets/common/workbench.h"
#include "widgets/report/reportentry.h"

#include <QWidget>

#include <optional>
#include <span>

class QComboBox;
class QLineEdit;
class QListWidget;
class QStackedWidget;
class QTextBrowser;
class QVBoxLayout;

namespace mb {

class CommandButton;
class ReportDrawings;
class ReportOrder;
class SearchField;
class Segmented;
class ThemeSource;

/// What can be handed out or looked up: a card of each unit that is here, its tunings and its trials, and the journal of service, newest
/// first; searched, looked at beside the list, written as PDF or HTML, as a page or as a label; the journal as a table. GUI thread.
class ReportsPage : public QWidget {
    Q_OBJECT
public:
    enum Filter { All, Cards, Tunings, Journal };

    ReportsPage(Workbench &workbench, const Selection &selection, std::span<const Family *const> families,
        const ThemeSource &theme, QWidget *parent);

    void setFilter(Filter filter);
    [[nodiscard]] QListWidget &list() { return *m_list; }
    /// The report that is looked at, as text; empty while there is none.
    [[nodiscard]] QString previewText() const;
    /// Writes what is looked at into a file whose name ends in .pdf or .html.
    void write(const QString &path);
    /// The entries of the journal that the list shows, into a table.
    void saveTable(const QString &path);
    [[nodiscard]] ReportOrder &order() { return *m_order; }

protected:
    void showEvent(QShowEvent *event) override;

private:
    QWidget *buildList();
    QWidget *buildPreview();
    void addNote(QVBoxLayout &column, QWidget *area);
    void addKeys();
    void follow();
    void askJournal();
    void followSelection();
    void fill();
    void preview();
    void lookAt(const ReportEntry &entry, int asked);
    void bindNote();
    void setForm(int form);
    void noteEdited();
    void keepNote(const std::string &visit, const QString &note, const QString &before);
    void exportChosen();
    void askTable();
    [[nodiscard]] bool isShown(const ReportEntry &entry) const;
    [[nodiscard]] const ReportEntry *chosen() const;

    Workbench &m_workbench;
    const Selection &m_selection;
    const ThemeSource &m_theme;
    std::span<const Family *const> m_families;
    QString m_asked; ///< of whom it was asked, to ask once
    std::vector<ReportEntry> m_entries;
    std::vector<ReportEntry> m_journal;
    std::optional<ReportEntry> m_chosen; ///< found again when the list is another
    DeviceId m_followed;                 ///< the selected device, once its card was chosen
    QStackedWidget *m_states = nullptr;
    SearchField *m_search = nullptr;
    Segmented *m_filter = nullptr;
    QListWidget *m_list = nullptr;
    QTextBrowser *m_text = nullptr;
    QLineEdit *m_note = nullptr;
    struct {
        std::string of; ///< id of the visit; empty: there is none
        QString kept;   ///< as the journal has it, or will have it
    } m_noted;
    ReportDrawings *m_drawings = nullptr;
    CommandButton *m_export = nullptr;
    CommandButton *m_table = nullptr;
    ReportOrder *m_order = nullptr;
    int m_shown = 0; ///< which preview is the newest that was asked for
};

} // namespace mb
