// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/trialsection.h"

#include "experiment/envelope.h"
#include "experiment/verdict.h"
#include "files/qttext.h"
#include "model/family.h"
#include "report/htmltext.h"
#include "report/metricwords.h"
#include "report/svgplot.h"

#include <algorithm>
#include <limits>

namespace mb {
namespace {

using tuning::Trial;

constexpr int measuredHeight = 150; // px
constexpr int effortHeight = 62;

tuning::Trace scaled(tuning::Trace trace, double factor)
{
    for (double &value : trace.y)
        value *= factor;
    return trace;
}

/// What was asked: of a step its target from the edge on, of others what the device was told.
tuning::Trace targetOf(const Trial &trial, const tuning::Trace &measured)
{
    tuning::Trace target;
    if (measured.isEmpty() || trial.mode == Mode::Duty)
        return target;
    if (trial.stimulus.edges().empty()) {
        for (const double t : measured.t)
            target.add(t, trial.stimulus.at(t));
        return target;
    }
    double hold = std::numeric_limits<double>::infinity();
    for (const tuning::Span &span : trial.holds)
        hold = std::min(hold, span.to - span.from);
    target.add(measured.t.front(), trial.stimulus.from);
    target.add(0.0, trial.stimulus.from);
    target.add(0.0, trial.stimulus.to);
    target.add(std::min(hold, measured.t.back()), trial.stimulus.to);
    if (hold < measured.t.back()) {
        target.add(hold, trial.stimulus.from);
        target.add(measured.t.back(), trial.stimulus.from);
    }
    return target;
}

/// `whole`: with the effort below.
QString plotOf(const KeptTrial &kept, bool whole = true)
{
    const Trial &trial = kept.trial;
    SvgPlot plot;
    plot.label = ReportText::tr("s since the edge");
    plot.mark = trial.simulated ? QStringLiteral("DEMO") : QString();
    plot.description = ReportText::tr("Trial %1: %2").arg(kept.number).arg(stimulusWords(trial));
    const std::string_view channel = trial.mode == Mode::Duty ? "velocity" : tuning::measuredOf(trial.mode);
    const tuning::Trace measured = trial.folded(channel);
    SvgPane main;
    main.height = measuredHeight;
    main.label = trial.mode == Mode::Duty ? QStringLiteral("counts/s") : qt(unitOf(trial.mode));
    const QString name = trial.mode == Mode::Duty ? modeWord(Mode::Velocity) : modeWord(trial.mode);
    main.curves.push_back(
        {ReportText::tr("target"), QStringLiteral("#171C22"), QStringLiteral("5,4"), targetOf(trial, measured)});
    if (main.curves.back().trace.isEmpty())
        main.curves.clear();
    main.curves.push_back({ReportText::tr("%1, measured").arg(name), QStringLiteral("#1F8FD6"), {}, measured});
    plot.panes.push_back(std::move(main));
    if (const tuning::Trace duty = trial.folded("duty"); whole && duty.size() > 1)
        plot.panes.push_back(
            {ReportText::tr("duty, %"), {{{}, QStringLiteral("#1B2A8C"), {}, scaled(duty, 100.0)}}, effortHeight});
    if (const tuning::Trace current = trial.folded("current"); whole && current.size() > 1)
        plot.panes.push_back(
            {ReportText::tr("current, %1").arg(qt(unitForm(Quantity::Current, trial.signal("current")->unit).text)),
                {{{}, QStringLiteral("#B0508C"), {}, current}}, effortHeight});
    return svgOf(plot);
}

QString metricsTable(const Trial &trial)
{
    const bool repeated = trial.errors != tuning::Metrics();
    HtmlTable table(repeated ? QStringLiteral("lrr") : QStringLiteral("lr"),
        repeated ? QStringList{ReportText::tr("Metric"), ReportText::tr("Value"), QStringLiteral("±")}
                 : QStringList{ReportText::tr("Metric"), ReportText::tr("Value")});
    for (const tuning::MetricKey &key : tuning::metricKeys()) {
        QStringList cells{metricWords(key.key).name, metricText(key.key, trial.metrics.*key.value)};
        if (repeated)
            cells << metricText(key.key, trial.errors.*key.value);
        table.add(cells);
    }
    return table.html();
}

/// As the window has it.
QString parameterFigure(const Parameter *row, std::optional<double> value)
{
    const auto raw = row && value ? toRaw(*row, *value) : Result<std::int64_t>(0);
    if (!row || !value || !raw)
        return figure(value, 6);
    return escaped(shownText(*row, *raw)).replace(QLatin1Char('-'), QChar(0x2212));
}

/// The gains themselves, and what else of their set is not as it was delivered.
QString gainsTable(const Trial &trial, const ReportUnit &unit, const Report &report)
{
    struct Tried {
        std::string key;
        std::optional<double> value;
        std::optional<double> fallback;
        const Parameter *parameter = nullptr;
        Role rank = Role::None; ///< what is no gain comes last
    };
    std::vector<Tried> gains;
    int usual = 0;
    for (const auto &[key, value] : trial.gains) {
        Tried row{key, value, {}, nullptr, Role::Limit};
        if (const auto index = unit.family ? findParameter(unit.family->parameters, key) : std::nullopt) {
            const Parameter &parameter = unit.family->parameters[index->value];
            row.fallback = parameter.fallback;
            row.parameter = &parameter;
            row.rank = isGain(parameter) ? parameter.role : Role::Limit;
        }
        if (!isGain(row.rank) && value && value == row.fallback)
            ++usual;
        else
            gains.push_back(row);
    }
    if (gains.empty())
        return {};
    std::ranges::stable_sort(gains, [](const Tried &a, const Tried &b) { return a.rank < b.rank; });
    HtmlTable table(
        QStringLiteral("lrr"), {ReportText::tr("Gain"), ReportText::tr("Value"), ReportText::tr("Default")});
    for (const Tried &row : gains)
        table.add({gainLabel(unit, row.key, report), strong(parameterFigure(row.parameter, row.value)),
            parameterFigure(row.parameter, row.fallback)});
    return usual == 0 ? table.html()
                      : table.html()
            + paragraph(ReportText::tr("Parameters of this set that have their default: %1").arg(usual), "dim");
}

QString envelopeWords(const Envelope &envelope)
{
    QStringList parts;
    if (envelope.travel)
        parts << ReportText::tr("travel ± %1").arg(figure(*envelope.travel, 6, QStringLiteral("counts")));
    if (envelope.speed)
        parts << ReportText::tr("speed %1").arg(figure(*envelope.speed, 6, QStringLiteral("counts/s")));
    if (envelope.current)
        parts << ReportText::tr("current %1").arg(figure(*envelope.current, 3, QStringLiteral("A")));
    if (envelope.duty) {
        const QString duty = figure(*envelope.duty * 100.0, 3, QStringLiteral("%"));
        parts << (envelope.current ? ReportText::tr("duty %1")
                                   : ReportText::tr("duty %1, which stands in for a limit of current"))
                     .arg(duty);
    }
    return parts.join(QStringLiteral(", "));
}

} // namespace

QString gainLabel(const ReportUnit &unit, const std::string &key, const Report &report)
{
    const auto index = unit.family ? findParameter(unit.family->parameters, key) : std::nullopt;
    if (!index)
        return escaped(key);
    const Parameter &parameter = unit.family->parameters[index->value];
    const QString label = worded(report.phrase, Message::label(parameter.label));
    return escaped(label) + QStringLiteral(" <span class=\"key\">") + escaped(key) + QStringLiteral("</span>");
}

QString trialHtml(const KeptTrial &kept, const ReportUnit &unit, const Report &report)
{
    const Trial &trial = kept.trial;
    QString html = heading(2, ReportText::tr("Trial %1, %2 loop").arg(kept.number).arg(modeWord(trial.mode)));
    if (trial.mode == Mode::Duty)
        html = heading(2, ReportText::tr("Trial %1, open loop").arg(kept.number));
    QStringList words{timeText(kept.time), stimulusWords(trial)};
    if (unit.family && unit.family->capabilities.axes > 1)
        words << ReportText::tr("axis %1").arg(trial.axis);
    if (unit.family && unit.family->capabilities.gainSlots > 1)
        words << ReportText::tr("gain slot %1").arg(trial.slot);
    words << ReportText::tr("firmware %1").arg(trial.firmware.empty() ? figure(std::nullopt) : qt(trial.firmware));
    html += paragraph(escaped(words.join(QStringLiteral(" · "))), "dim");
    QString ending = strong(escaped(endingWords(trial)), trial.reason == tuning::EndReason::Done ? "ok" : "danger");
    if (!trial.detail.empty())
        ending += QStringLiteral(": ") + escaped(worded(report.phrase, trial.detail));
    ending += QStringLiteral(" · ")
        + (trial.stopped ? ReportText::tr("motor seen stopped") : ReportText::tr("stop not confirmed"))
        + QStringLiteral(" · ") + ReportText::tr("%1 samples, %2 lost").arg(trial.samples).arg(trial.lost);
    for (const std::string &flag : trial.flags) {
        const QString word = worded(report.phrase, Message::label(tuning::flagLabel(flag)));
        if (flag != tuning::flag::aborted) // that was said
            ending += QStringLiteral(" · ") + strong(escaped(word), "caution");
    }
    html += paragraph(ending);
    if (const QString plot = plotOf(kept); !plot.isEmpty())
        html += QStringLiteral("<div>") + plot + QStringLiteral("</div>\n");
    else
        html += paragraph(ReportText::tr("Nothing was recorded."), "dim");
    html += beside(metricsTable(trial), gainsTable(trial, unit, report));
    if (const QString envelope = envelopeWords(trial.envelope); !envelope.isEmpty())
        html += paragraph(ReportText::tr("It ran within: %1.").arg(escaped(envelope)), "dim");
    if (!kept.note.empty())
        html += paragraph(ReportText::tr("Note: %1").arg(escaped(kept.note)));
    return html;
}

QString stepHtml(const KeptTrial &kept)
{
    const Trial &trial = kept.trial;
    QString html = heading(2, ReportText::tr("Trial %1, %2 loop").arg(kept.number).arg(modeWord(trial.mode)));
    html += paragraph(escaped(timeText(kept.time) + QStringLiteral(" · ") + stimulusWords(trial)), "dim");
    if (const QString plot = plotOf(kept, false); !plot.isEmpty())
        html += QStringLiteral("<div>") + plot + QStringLiteral("</div>\n");
    QStringList heads;
    QStringList values;
    for (const char *const key : {"rise", "overshoot", "settle", "sse", "peak_current"}) {
        heads << metricWords(key).name;
        values << metricText(key, tuning::metricOf(trial.metrics, key));
    }
    HtmlTable table(QStringLiteral("rrrrr"), heads);
    table.add(values);
    return html + table.html();
}

QString historyHtml(const ReportUnit &unit)
{
    if (unit.history.empty())
        return {};
    HtmlTable table(QStringLiteral("rlllrrrl"),
        {ReportText::tr("No."), ReportText::tr("Time"), ReportText::tr("Loop"), ReportText::tr("Stimulus"),
            ReportText::tr("Rise"), ReportText::tr("Overshoot"), ReportText::tr("Settling"), ReportText::tr("End")});
    int rows = 0;
    for (auto kept = unit.history.rbegin(); kept != unit.history.rend() && rows < historyRows; ++kept, ++rows) {
        const Trial &trial = kept->trial;
        const QString number = QString::number(kept->number);
        table.add({kept->star ? strong(number + QStringLiteral("*")) : number, timeText(kept->time),
            modeWord(trial.mode), escaped(stimulusWords(trial)), metricText("rise", trial.metrics.rise),
            metricText("overshoot", trial.metrics.overshoot), metricText("settle", trial.metrics.settle),
            escaped(endingWords(trial))
                + (kept->note.empty() ? QString() : QStringLiteral("<br>") + escaped(kept->note))});
    }
    QString html = heading(2, ReportText::tr("History of the unit")) + table.html();
    if (const auto all = static_cast<int>(unit.history.size()); all > rows)
        html += paragraph(ReportText::tr("The newest %1 of %2 trials.").arg(rows).arg(all), "dim");
    return html;
}

} // namespace mb
