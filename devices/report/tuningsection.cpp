// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/tuningsection.h"

#include "experiment/envelope.h"
#include "files/qttext.h"
#include "model/family.h"
#include "report/htmltext.h"
#include "report/metricwords.h"
#include "report/modelfigures.h"
#include "report/svgplot.h"
#include "report/trialsection.h"
#include "tuning/designnotes.h"
#include "tuning/uncertainty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace mb {
namespace {

using namespace tuning;

constexpr std::array<std::string_view, 5> provenMetrics{"rise", "settle", "overshoot", "sse", "peak_current"};
constexpr int stepHeight = 170; // px
constexpr int bodeHeight = 110;
constexpr int bodePoints = 200;
constexpr double decades = 1.3;       ///< of the Bode plot, either side of the crossover
constexpr double shownSettles = 4.0;  ///< predicted times to settle that a step is drawn for
constexpr double shortestShown = 0.2; ///< s

const QString neutral = QStringLiteral("#171C22");
const QString forwards = QStringLiteral("#1F8FD6");
const QString backwards = QStringLiteral("#B0508C");
const QString pale = QStringLiteral("#8A94A0");

QString verdictHtml(const TuneReport &report)
{
    switch (report.result) {
    case TuneResult::Kept: return strong(ReportText::tr("Kept"), "ok");
    case TuneResult::Proposed: return strong(ReportText::tr("Proposed, nothing was written"), "accent");
    case TuneResult::RolledBack:
        return strong(isPutBack(report) ? ReportText::tr("Put back") : ReportText::tr("Not kept"), "caution");
    case TuneResult::Refused: return strong(ReportText::tr("Refused"), "caution");
    case TuneResult::Stopped: return strong(ReportText::tr("Stopped"), "danger");
    }
    return {};
}

QString modelHtml(const TuneReport &report, const Report &whole)
{
    HtmlTable table(QStringLiteral("lrrl"),
        {ReportText::tr("Model"), ReportText::tr("Value"), QStringLiteral("±"), ReportText::tr("Unit")});
    for (const ModelFigure &found : modelFigures(report, whole.phrase))
        table.add({found.name, strong(figure(found.value, found.digits)),
            found.error ? figure(*found.error, 2) : QString(), found.unit});
    QString html = table.html();
    if (report.profile)
        html += paragraph(profileWords(figure(report.profile->speed, 4, QStringLiteral("counts/s")),
                              figure(report.profile->acceleration, 4, QStringLiteral("counts/s²"))),
            "dim");
    if (const std::optional<MotorFound> &motor = report.motor)
        html += paragraph(ReportText::tr("Velocity filter of the device: %1")
                              .arg(motor->filter ? filterWords(motor->filter->kind,
                                       figure(1e3 * motor->filter->window, 3, QStringLiteral("ms")))
                                                 : figure(std::nullopt)),
            "dim");
    return html;
}

QString gatesHtml(const TuneReport &report, const Report &whole)
{
    QString html;
    for (const Gate &gate : report.gates) {
        const QString detail = escaped(worded(whole.phrase, gate.detail));
        html += (!gate.passed        ? strong(ReportText::tr("failed"), "danger")
                        : gate.warns ? strong(ReportText::tr("to be looked at"), "caution")
                                     : strong(ReportText::tr("passed"), "ok"))
            + QStringLiteral(" ") + detail + QStringLiteral("<br>");
    }
    return html.isEmpty() ? html : paragraph(ReportText::tr("What the model was judged by:"), "dim") + paragraph(html);
}

QString gainsHtml(const TuneReport &report, const ReportUnit &unit, const Report &whole)
{
    if (report.proposed.rows.empty())
        return {};
    HtmlTable table(QStringLiteral("lrrr"),
        {ReportText::tr("Gain"), ReportText::tr("Before"), ReportText::tr("Proposed"), ReportText::tr("Raw")});
    for (const ScaledGains::Row &row : report.proposed.rows) {
        std::optional<double> from;
        for (const auto &[key, value] : report.before) {
            if (key == row.key)
                from = value;
        }
        table.add({gainLabel(unit, row.key, whole), figure(from, 6), strong(figure(row.number, 6)),
            QString::number(row.raw)});
    }
    QString html = table.html();
    for (const Message &note : designNotes(report, unit.family))
        html += paragraph(escaped(worded(whole.phrase, note)), "dim");
    return html;
}

QString proofHtml(const TuneReport &report)
{
    if (!report.predicted)
        return {};
    HtmlTable table(
        QStringLiteral("lrr"), {ReportText::tr("Proof"), ReportText::tr("Predicted"), ReportText::tr("Measured")});
    for (const MetricKey &key : metricKeys()) {
        const auto predicted = report.predicted->metrics.*key.value;
        const auto measured = report.measured.*key.value;
        if (std::ranges::find(provenMetrics, key.key) != provenMetrics.end())
            table.add(
                {metricWords(key.key).name, metricText(key.key, predicted), strong(metricText(key.key, measured))});
    }
    if (report.margins) {
        const Margins &margins = *report.margins;
        table.add({ReportText::tr("Sensitivity peak Ms"), figure(margins.ms, 3), QString()});
        table.add({ReportText::tr("Gain margin"), figure(20.0 * std::log10(margins.gain), 3, QStringLiteral("dB")),
            QString()});
        table.add({ReportText::tr("Phase margin"), figure(margins.phase, 3, QStringLiteral("°")), QString()});
    }
    return table.html();
}

Trace moved(const Trace &trace, double origin, double sign, double end)
{
    Trace result;
    for (std::size_t i = 0; i < trace.size() && trace.t[i] <= end; ++i)
        result.add(trace.t[i], sign * (trace.y[i] - origin));
    return result;
}

/// Where the step would lie with the model off by its ±; empty where nobody knows that.
PredictionBand bandOf(const TuneReport &report, double seconds)
{
    const PlantErrors errors = errorsOf(report);
    if (report.step == 0.0 || (errors.gain == 0.0 && errors.tau == 0.0 && errors.delay == 0.0))
        return {};
    const LoopShape &shape = report.predicted->shape;
    const ContinuousGains &gains = report.proposed.made;
    const Prediction predicted = predictStep(report.loop, report.plant, gains, 0.0, report.step, seconds, shape);
    return tuning::bandOf(
        predicted, report.loop, report.plant, errors, gains, report.step, shape.mostDuty, shape.period);
}

/// What was predicted and, where it was proven, both directions over it.
QString stepSvg(const TuneReport &report)
{
    if (!report.predicted)
        return {};
    double end = std::max(shownSettles * report.predicted->metrics.settle.value_or(0.5), shortestShown);
    SvgPane pane{qt(unitOf(report.loop)), {}, stepHeight};
    for (const Trial &trial : report.proof) {
        for (const Span &hold : trial.holds)
            end = std::min(end, hold.to - hold.from);
    }
    for (const Trial &trial : report.proof) {
        const double sign = trial.stimulus.to < trial.stimulus.from ? -1.0 : 1.0;
        pane.curves.push_back(
            {sign > 0.0 ? ReportText::tr("forwards") : ReportText::tr("backwards"), sign > 0.0 ? forwards : backwards,
                {}, moved(trial.folded(measuredOf(trial.mode)), trial.stimulus.from, sign, end)});
    }
    pane.curves.push_back({ReportText::tr("predicted"), neutral, QStringLiteral("2,3"),
        moved(report.predicted->measured, 0.0, 1.0, end)});
    const PredictionBand band = bandOf(report, end);
    pane.curves.push_back({ReportText::tr("band: ± of the model"), pale, QStringLiteral("1,3"), band.low});
    pane.curves.push_back({{}, pale, QStringLiteral("1,3"), band.high});
    std::erase_if(pane.curves, [](const SvgCurve &curve) { return curve.trace.isEmpty(); });
    SvgPlot plot;
    plot.label = ReportText::tr("s since the edge");
    plot.mark = report.simulated ? QStringLiteral("DEMO") : QString();
    plot.description = ReportText::tr("The step of the proof, predicted and measured");
    plot.panes.push_back(std::move(pane));
    return svgOf(plot);
}

QString bodeSvg(const TuneReport &report)
{
    if (!report.margins || !(report.margins->crossover > 0.0))
        return {};
    Trace magnitude;
    Trace phase;
    double turns = 0.0;
    double before = 0.0;
    for (int i = 0; i <= bodePoints; ++i) {
        const double omega = report.margins->crossover * std::pow(10.0, decades * (2.0 * i / bodePoints - 1.0));
        const std::complex<double> loop = openLoop(report.loop, report.plant, report.proposed.made, omega);
        const double angle = std::arg(loop) * 180.0 / std::numbers::pi;
        if (i > 0 && std::abs(angle - before) > 180.0)
            turns += angle > before ? -360.0 : 360.0;
        before = angle;
        const double hertz = omega / (2.0 * std::numbers::pi);
        magnitude.add(hertz, 20.0 * std::log10(std::abs(loop)));
        if (angle + turns > -360.0)
            phase.add(hertz, angle + turns);
    }
    SvgPlot plot;
    plot.logarithmic = true;
    plot.label = QStringLiteral("Hz");
    plot.mark = report.simulated ? QStringLiteral("DEMO") : QString();
    plot.description = ReportText::tr("Magnitude and phase of the open loop");
    plot.panes.push_back({ReportText::tr("magnitude of the loop, dB"), {{{}, neutral, {}, magnitude}}, bodeHeight});
    plot.panes.push_back({ReportText::tr("phase of the loop, °"), {{{}, neutral, {}, phase}}, bodeHeight});
    return svgOf(plot);
}

QString figureBlock(const QString &svg)
{
    return svg.isEmpty() ? QString() : QStringLiteral("<div>") + svg + QStringLiteral("</div>\n");
}

QStringList proposalCells(
    const QString &name, const Design &design, const Metrics &metrics, const Margins &margins, const Report &whole)
{
    QStringList bounds;
    for (const std::string_view bound : design.bounds)
        bounds << worded(whole.phrase, Message::label(bound));
    const QString response
        = design.response > 0.0 ? figure(1e3 * design.response, 3, QStringLiteral("ms")) : figure(std::nullopt);
    return {name, response, metricText("rise", metrics.rise), metricText("settle", metrics.settle),
        metricText("overshoot", metrics.overshoot), figure(margins.ms, 3), bounds.join(QStringLiteral(", "))};
}

/// Side by side, the chosen one strong: numbers of one's own and gains that were there stand below the three.
QString proposalsHtml(const TuneReport &report, const Report &whole)
{
    if (report.proposals.empty())
        return {};
    HtmlTable table(QStringLiteral("lrrrrrl"),
        {ReportText::tr("Proposal"), ReportText::tr("Response"), metricWords("rise").name, metricWords("settle").name,
            metricWords("overshoot").name, QStringLiteral("Ms"), ReportText::tr("Bounded by")});
    const auto add = [&table](QStringList cells, bool isChosen) {
        for (QString &cell : cells)
            cell = isChosen ? strong(escaped(cell)) : escaped(cell);
        table.add(cells);
    };
    const auto isChosen = [&report](const Proposal &one) {
        return report.design && one.gains.made == report.proposed.made
            && one.design.response == report.design->response;
    };
    for (const Proposal &one : report.proposals) {
        const QString name = worded(whole.phrase, Message::label(toString(one.aim)));
        add(proposalCells(name, one.design, one.predicted.metrics, one.margins, whole), isChosen(one));
    }
    if (report.design && report.predicted && report.margins && std::ranges::none_of(report.proposals, isChosen))
        add(proposalCells(ReportText::tr("chosen"), *report.design, report.predicted->metrics, *report.margins, whole),
            true);
    return table.html();
}

} // namespace

QString tuningHtml(const KeptTuning &kept, const ReportUnit &unit, const Report &whole)
{
    const TuneReport &report = kept.report;
    QString html = heading(2, ReportText::tr("Tuning of the %1 loop").arg(modeWord(report.loop)));
    QStringList words{timeText(kept.time)};
    if (unit.family && unit.family->capabilities.axes > 1)
        words << ReportText::tr("axis %1").arg(report.axis);
    if (unit.family && unit.family->capabilities.gainSlots > 1)
        words << ReportText::tr("gain slot %1").arg(report.slot);
    words << ReportText::tr("firmware %1").arg(report.firmware.empty() ? figure(std::nullopt) : qt(report.firmware))
          << figure(report.seconds, 3, QStringLiteral("s"));
    QStringList numbers;
    for (const std::int64_t number : report.trials) {
        const bool isKept = std::ranges::find(unit.history, number, &KeptTrial::number) != unit.history.end();
        numbers << (isKept ? QStringLiteral("%1") : ReportText::tr("%1 (forgotten)")).arg(number);
    }
    if (!numbers.isEmpty())
        words << ReportText::tr("trials %1").arg(numbers.join(QStringLiteral(", ")));
    html += paragraph(escaped(words.join(QStringLiteral(" · "))), "dim");
    html += paragraph(verdictHtml(report) + QStringLiteral(": ") + escaped(worded(whole.phrase, report.evidence)));
    if (report.plant.gain > 0.0)
        html += beside(modelHtml(report, whole), proofHtml(report));
    html += figureBlock(stepSvg(report));
    html += gainsHtml(report, unit, whole) + proposalsHtml(report, whole);
    return html + figureBlock(bodeSvg(report)) + gatesHtml(report, whole);
}

} // namespace mb
