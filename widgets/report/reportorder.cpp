// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/report/reportorder.h"

#include "async/seconds.h"
#include "files/filebytes.h"
#include "model/family.h"
#include "transport/linkaddress.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/filechoice.h"
#include "widgets/common/guarded.h"
#include "widgets/common/trialnotebook.h"
#include "widgets/report/reportpdf.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>

namespace mb {
namespace {

QString proposedName(const ReportUnit &unit)
{
    const QString who
        = unit.identity.serial.empty() ? QString::number(unit.identity.address) : qt(unit.identity.serial);
    return QStringLiteral("%1-%2.pdf").arg(qt(unit.identity.family.empty() ? "unit" : unit.identity.family), who);
}

} // namespace

ReportUnit reportUnitOf(const DeviceView &view)
{
    ReportUnit unit;
    unit.family = view.family;
    unit.identity = view.identity;
    unit.selector = view.selector;
    unit.simulated = isSimulatedLink(view.link);
    unit.unit = view.unit;
    unit.parameters = view.parameters;
    return unit;
}

QString htmlOf(const Report &report, ReportForm form)
{
    return form == ReportForm::Label ? labelHtmlOf(report) : htmlOf(report);
}

ReportOrder::ReportOrder(Workbench &workbench, QWidget &page)
    : QObject(&page)
    , m_workbench(workbench)
    , m_page(page)
{
}

void ReportOrder::ask(const ReportUnit &unit, const ReportWish &wish)
{
    askWhereToSave(m_page, tr("Write report"), tr("PDF (*.pdf)") + QStringLiteral(";;") + tr("HTML (*.html)"),
        proposedName(unit), [this, unit, wish](const QString &path) { write(unit, wish, path); });
}

void ReportOrder::write(const ReportUnit &unit, const ReportWish &wish, const QString &path)
{
    const QString suffix = QFileInfo(path).suffix().toLower();
    if (suffix != QLatin1String("pdf") && suffix != QLatin1String("html"))
        return finish(path,
            fail(Fault::OutOfRange, say("%1 has a name that ends in no kind of report", path.toStdString()),
                say("end it in .pdf or .html")));
    make(unit, wish, [this, path](const Result<Report> &report) {
        finish(path, report ? save(*report, path) : Result<void>(fail(report.error())));
    });
}

void ReportOrder::make(const ReportUnit &subject, const ReportWish &wish, std::function<void(Result<Report>)> made)
{
    ReportWish matter = wish;
    matter.unit = subject.unit;
    m_workbench.trials().gather(
        matter, guarded(this, [this, subject, made = std::move(made)](Result<std::vector<ReportUnit>> units) {
            if (!units)
                return made(fail(units.error()));
            Report report;
            report.time = unixSeconds(m_workbench);
            report.program
                = (QCoreApplication::applicationName() + QLatin1Char(' ') + QCoreApplication::applicationVersion())
                      .toStdString();
            report.phrase = [](const Message &message) { return messageText(message, QLatin1Char('.')); };
            report.units = std::move(*units);
            for (ReportUnit &found : report.units)
                found.describe(subject);
            made(std::move(report));
        }));
}

Result<void> ReportOrder::save(const Report &report, const QString &path) const
{
    if (m_form == ReportForm::Label
        && std::ranges::all_of(report.units, [](const ReportUnit &u) { return u.visits.empty(); }))
        return fail(
            Fault::OutOfRange, say("this unit was never served, so there is nothing for a label"), say("write a page"));
    const QString html = htmlOf(report, m_form);
    const QByteArray bytes = path.endsWith(QStringLiteral(".pdf"), Qt::CaseInsensitive) ? pdfOf(html) : html.toUtf8();
    return saveFile(path.toStdString(), bytes);
}

void ReportOrder::finish(const QString &path, const Result<void> &result)
{
    if (result)
        m_workbench.report(Severity::Good, {}, tr("the report is in %1").arg(path));
    else
        m_workbench.report(Severity::Danger, {}, tr("no report: %1").arg(errorText(result.error())));
    Q_EMIT written(path, result.has_value());
}

} // namespace mb
