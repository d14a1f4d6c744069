// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/report.h"
#include "widgets/common/workbench.h"

#include <QPointer>

namespace mb {

/// The report of a page (Ctrl+P): asks for the file, gathers from notebook and snapshot, writes PDF or HTML whole or not at all, and
/// tells how it went. Lives as long as its page.
class ReportOrder : public QObject {
    Q_OBJECT
public:
    ReportOrder(Workbench &workbench, QWidget &page);

    /// Gathers it, in words of the language of the window; answers later, or never when its page is gone.
    void make(const DeviceView &view, const ReportWish &wish, std::function<void(Result<Report>)> made);
    /// Of this unit as it is now, in words of the language of the window.
    void ask(const DeviceView &view, const ReportWish &wish);
    /// The same into a file whose name ends in .pdf or .html.
    void write(const DeviceView &view, const ReportWish &wish, const QString &path);

Q_SIGNALS:
    /// It is on the disk; or a notice has told why not.
    void written(const QString &path, bool good);

private:
    void finish(const QString &path, const Result<void> &result);
    [[nodiscard]] Result<void> save(const Report &report, const QString &path) const;

    Workbench &m_workbench;
    QWidget &m_page;
};

} // namespace mb
