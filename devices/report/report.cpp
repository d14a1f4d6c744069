// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/report.h"

#include "files/qttext.h"
#include "report/htmltext.h"
#include "report/sweepsection.h"
#include "report/trialsection.h"
#include "report/tuningsection.h"
#include "report/unitsection.h"
#include "report/visitsection.h"

#include <algorithm>
#include <utility>

namespace mb {
namespace {

/// Colours are those of the light theme; sizes are pixels, so that page and PDF agree.
const QString sheet = QStringLiteral(R"(
body { font-family: 'Noto Sans', 'DejaVu Sans', sans-serif; font-size: 12px; color: #171C22; background-color: #FFFFFF; }
h1 { font-size: 24px; font-weight: bold; margin-top: 0px; margin-bottom: 2px; }
h2 { font-size: 16px; font-weight: bold; color: #3D49C4; margin-top: 14px; margin-bottom: 3px; }
p { margin-top: 3px; margin-bottom: 5px; }
.dim { color: #47525E; } .key { color: #5F6A76; font-size: 10px; }
.ok { color: #0A7547; } .caution { color: #8F5A00; } .danger { color: #8F0F22; } .accent { color: #3D49C4; }
table.rows { border-collapse: collapse; margin-top: 4px; margin-bottom: 6px; }
.rows th { font-size: 10px; color: #47525E; font-weight: normal; border-bottom: 1px solid #7D8894; padding: 2px 6px 2px 0px; }
.rows td { border-bottom: 1px solid #E0E4EA; padding: 2px 6px 2px 0px; }
table.demo { background-color: #4A55C4; } .demo td { color: #FFFFFF; font-weight: bold; padding: 6px 10px 6px 10px; }
)");

/// For a page on a screen; a PDF has pages of its own.
const QString screenSheet
    = QStringLiteral("@media screen { body { max-width: 720px; margin: 24px auto; padding: 0 16px; } "
                     "svg { max-width: 100%; height: auto; } }");

QString demoBanner()
{
    return QStringLiteral("<table class=\"demo\" width=\"100%\" cellspacing=\"0\" bgcolor=\"#4A55C4\"><tr><td>")
        + ReportText::tr("DEMO: this unit is simulated. Nothing here was measured on a motor.")
        + QStringLiteral("</td></tr></table>\n");
}

QString headHtml(const ReportUnit &unit, const Report &report, const QString &title, bool first)
{
    QString html = QStringLiteral("<h1%1>%2</h1>\n")
                       .arg(first ? QString() : QStringLiteral(" style=\"page-break-before: always\""), escaped(title));
    html += paragraph(ReportText::tr("Made on %1 with %2").arg(timeText(report.time), escaped(report.program)), "dim");
    return unit.simulated ? html + demoBanner() : html;
}

QString unitHtml(const ReportUnit &unit, const Report &report, bool first)
{
    QString html = headHtml(unit, report, ReportText::tr("Report on %1").arg(nameOf(unit)), first);
    html += identityHtml(unit, report);
    html += lastVisitHtml(unit, report);
    bool onFirstPage = true;
    const auto newPage = [&onFirstPage](const QString &section) {
        QString placed
            = onFirstPage ? section : QStringLiteral("<div style=\"page-break-before: always\"></div>") + section;
        onFirstPage = false;
        return placed;
    };
    for (const KeptTuning &tuning : unit.tunings)
        html += newPage(tuningHtml(tuning, unit, report));
    if (const QString sweep = sweepHtml(unit); !sweep.isEmpty())
        html += newPage(sweep);
    for (const KeptTrial &trial : unit.trials)
        html += newPage(trialHtml(trial, unit, report));
    if (const QString history = historyHtml(unit); !history.isEmpty())
        html += history; // which goes on where there is room
    html += visitsHtml(unit, report);
    if (const QString parameters = parametersHtml(unit, report); !parameters.isEmpty())
        html += newPage(parameters);
    if (unit.tunings.empty() && unit.trials.empty() && unit.history.empty() && unit.visits.empty())
        html += paragraph(ReportText::tr("There are no trials of this unit in the notebook."), "dim");
    return html;
}

/// What a document of A4 begins with, up to its body.
QString headOf(const Report &report, const QString &title)
{
    QString html = QStringLiteral("<!DOCTYPE html>\n<html><head><meta charset=\"utf-8\">\n<title>") + escaped(title)
        + QStringLiteral("</title>\n");
    if (report.isSimulated())
        html += QStringLiteral("<meta name=\"simulated\" content=\"true\">\n");
    return html + QStringLiteral("<style>") + sheet + QStringLiteral("</style>\n<style media=\"screen\">") + screenSheet
        + QStringLiteral("</style></head>\n<body>\n");
}

QString namesIn(const Report &report)
{
    QStringList names;
    for (const ReportUnit &unit : report.units)
        names << nameOf(unit);
    return names.join(QStringLiteral(", "));
}

/// The self-test of the last service, or the newest step.
const KeptTrial *stepOf(const ReportUnit &unit)
{
    const auto tested = std::ranges::find_if(unit.trials,
        [&unit](const KeptTrial &kept) { return !unit.visits.empty() && unit.visits.back().trial == kept.number; });
    if (tested != unit.trials.end())
        return &*tested;
    return unit.trials.empty() ? nullptr : &unit.trials.back();
}

QString cardOf(const ReportUnit &unit, const Report &report, bool first)
{
    QString html = headHtml(unit, report, ReportText::tr("Service card of %1").arg(nameOf(unit)), first);
    html += identityHtml(unit, report) + lastVisitHtml(unit, report);
    if (const KeptTrial *step = stepOf(unit))
        html += stepHtml(*step);
    return html + changedParametersHtml(unit, report);
}

} // namespace

void ReportUnit::describe(const ReportUnit &who)
{
    family = who.family;
    identity = who.identity;
    selector = who.selector;
    simulated = who.simulated;
    parameters = who.parameters;
}

bool Report::isSimulated() const
{
    return std::ranges::any_of(units, [](const ReportUnit &unit) { return unit.simulated; });
}

QString cardHtmlOf(const Report &report)
{
    QString html = headOf(report, ReportText::tr("Service card of %1").arg(namesIn(report)));
    for (const ReportUnit &unit : report.units)
        html += cardOf(unit, report, &unit == &report.units.front());
    return html + QStringLiteral("</body></html>\n");
}

QString htmlOf(const Report &report)
{
    QString html = headOf(report, ReportText::tr("Report on %1").arg(namesIn(report)));
    for (const ReportUnit &unit : report.units)
        html += unitHtml(unit, report, &unit == &report.units.front());
    return html + QStringLiteral("</body></html>\n");
}

QString labelHtmlOf(const Report &report)
{
    QString html = QStringLiteral("<!DOCTYPE html>\n<html><head><meta charset=\"utf-8\"><title>")
        + ReportText::tr("Labels")
        + QStringLiteral("</title>\n<style>@page { size: 62mm 29mm; margin: 2mm } "
                         "body { font-family: sans-serif; font-size: 12px; margin: 0 } "
                         "p { margin: 0 } .big { font-size: 18px; font-weight: bold }</style></head>\n<body>\n");
    bool first = true;
    for (const ReportUnit &unit : report.units) {
        if (unit.visits.empty())
            continue;
        const service::Visit &visit = unit.visits.back();
        html += std::exchange(first, false) ? QStringLiteral("<div>\n")
                                            : QStringLiteral("<div style=\"page-break-before: always\">\n");
        html += paragraph(strong(escaped(nameOf(unit))) + QStringLiteral(" ")
                + escaped(unit.simulated ? ReportText::tr("simulated") : QString()),
            "big");
        html += paragraph(escaped(visit.serial.empty() ? visit.unit : visit.serial));
        html += paragraph(ReportText::tr("Firmware %1").arg(escaped(visit.to.empty() ? visit.from : visit.to)));
        html += paragraph(resultHtml(visit.outcome) + QStringLiteral(" ") + timeText(visit.time))
            + QStringLiteral("</div>\n");
    }
    return html + QStringLiteral("</body></html>\n");
}

} // namespace mb
