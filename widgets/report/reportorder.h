// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/report.h"
#include "widgets/common/workbench.h"

#include <QPointer>

namespace mb {

/// On what it is printed: pages, or labels of 62 × 29 mm, one for each unit that was served.
enum class ReportForm { Pages, Label };

/// What is known of a unit that is here now.
[[nodiscard]] ReportUnit reportUnitOf(const DeviceView &view);
/// The document in this form, as htmlOf() and labelHtmlOf() have it.
[[nodiscard]] QString htmlOf(const Report &report, ReportForm form);

/// The report of a page (Ctrl+P): asks for the file, gathers from notebook and snapshot, writes PDF or HTML whole or not at all, and
/// tells how it went. Lives as long as its page.
class ReportOrder : public QObject {
    Q_OBJECT
public:
    ReportOrder(Workbench &workbench, QWidget &page);

    /// Of what is asked for or written from now on.
    void setForm(ReportForm form) { m_form = form; }
    [[nodiscard]] ReportForm form() const { return m_form; }
    /// Gathers it, in words of the language of the window; answers later, or never when its page is gone.
    void make(const ReportUnit &unit, const ReportWish &wish, std::function<void(Result<Report>)> made);
    /// Of this unit as it is now, in words of the language of the window.
    void ask(const ReportUnit &unit, const ReportWish &wish);
    void ask(const DeviceView &view, const ReportWish &wish) { ask(reportUnitOf(view), wish); }
    /// The same into a file whose name ends in .pdf or .html.
    void write(const ReportUnit &unit, const ReportWish &wish, const QString &path);
    void write(const DeviceView &view, const ReportWish &wish, const QString &path)
    {
        write(reportUnitOf(view), wish, path);
    }

Q_SIGNALS:
    /// It is on the disk; or a notice has told why not.
    void written(const QString &path, bool good);

private:
    void finish(const QString &path, const Result<void> &result);
    [[nodiscard]] Result<void> save(const Report &report, const QString &path) const;

    Workbench &m_workbench;
    QWidget &m_page;
    ReportForm m_form = ReportForm::Pages;
};

} // namespace mb
