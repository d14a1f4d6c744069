// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/design/stepcurves.h"

#include "experiment/envelope.h"
#include "widgets/common/numberformat.h"

#include <QCoreApplication>

#include <algorithm>
#include <limits>

namespace mb {
namespace {

struct StepText {
    Q_DECLARE_TR_FUNCTIONS(mb::StepText)
};

constexpr double shownSettles = 4.0;   ///< predicted times to settle that a step is drawn for
constexpr double shortestShown = 0.05; ///< s, of one of them
constexpr double mostCompared = 1.6;   ///< of the step, that other gains are given room for
constexpr double headroom = 1.08;      ///< of the step, above which there is room for words
constexpr double settleBand = 0.02;
constexpr double belowLine = 0.7; ///< of the step

Curve curveOf(
    const QString &name, const TraceLook &look, const tuning::Trace &whole, double origin, double sign, double end)
{
    Curve curve;
    curve.name = name;
    curve.look = look;
    const tuning::Trace trace = whole.part(whole.isEmpty() ? 0.0 : whole.t.front(), end);
    for (std::size_t i = 0; i < trace.size(); ++i) {
        curve.x.append(trace.t[i]);
        curve.y.append(sign * (trace.y[i] - origin));
    }
    return curve;
}

double shortestHold(const std::vector<tuning::Trial> &trials)
{
    double shortest = std::numeric_limits<double>::infinity();
    for (const tuning::Trial &trial : trials) {
        for (const tuning::Span &hold : trial.holds)
            shortest = std::min(shortest, hold.to - hold.from);
    }
    return shortest;
}

Curve predictedCurve(
    const tuning::Proposal &proposal, const QString &name, const tuning::PredictionBand &band, double end)
{
    TraceLook dotted;
    dotted.role = TraceRole::Setpoint;
    dotted.dash = TraceDash::Dots;
    Curve curve = curveOf(StepText::tr("%1, predicted").arg(name), dotted, proposal.predicted.measured, 0.0, 1.0, end);
    const auto points = static_cast<std::size_t>(curve.x.size());
    if (band.low.size() >= points && band.high.size() >= points) {
        for (std::size_t i = 0; i < points; ++i) {
            curve.low.append(band.low.y[i]);
            curve.high.append(band.high.y[i]);
        }
    }
    return curve;
}

/// Both metrics of a response in one clause.
QString figures(const tuning::Metrics &metrics)
{
    QStringList parts;
    if (metrics.overshoot)
        parts << StepText::tr("%1 % over").arg(formatNumber(*metrics.overshoot * 100.0, 1));
    if (metrics.peakCurrent)
        parts << StepText::tr("%1 A peak").arg(formatNumber(*metrics.peakCurrent, 1));
    return parts.join(QStringLiteral(", "));
}

CurveMark wordsAt(double x, double y, const QString &text, Qt::Alignment side, bool strong)
{
    return {CurveMark::Kind::Words, x, y, 0.0, text, side, strong};
}

void markTarget(StepCurves &step, double target, double end)
{
    CurveMark band{CurveMark::Kind::Band, 0.0, (1.0 - settleBand) * target, (1.0 + settleBand) * target};
    band.tone = Tone::Ok;
    CurveMark words
        = wordsAt(end, (1.0 + settleBand) * target, StepText::tr("±2 %"), Qt::AlignLeft | Qt::AlignTop, false);
    words.tone = Tone::Ok;
    step.marks.push_back(band);
    step.marks.push_back({CurveMark::Kind::Level, 0.0, target});
    step.marks.push_back(words);
}

void markPrediction(StepCurves &step, const tuning::Proposal &proposal, const QString &name)
{
    const tuning::Metrics &metrics = proposal.predicted.metrics;
    const QString settles = metrics.settle ? StepText::tr("%1 settles %2").arg(name, formatDuration(*metrics.settle))
                                           : StepText::tr("%1 does not settle").arg(name);
    const double at = metrics.settle.value_or(0.0);
    const double value = metrics.settle ? (1.0 - settleBand) * proposal.step : proposal.step / 2.0;
    if (metrics.settle)
        step.marks.push_back({CurveMark::Kind::Span, at, 0.93 * proposal.step, value});
    step.marks.push_back(wordsAt(
        at, 0.9 * value, settles + QLatin1Char('\n') + figures(metrics), Qt::AlignRight | Qt::AlignBottom, true));
}

/// The place of the peak of the worst direction, and what both came to.
void markMeasured(StepCurves &step, const tuning::Metrics &measured, double target, const QString &settled)
{
    double x = 0.0;
    double peak = 0.0;
    for (const Curve &curve : step.curves) {
        for (int i = 0; &curve != &step.curves.front() && i < curve.x.size(); ++i) {
            if (curve.y[i] > peak) {
                peak = curve.y[i];
                x = curve.x[i];
            }
        }
    }
    QStringList words;
    if (measured.settle)
        words << settled;
    if (measured.overshoot && *measured.overshoot > settleBand / 2.0)
        words << StepText::tr("measured: peak %1, %2 % over")
                     .arg(formatSignificant(peak, 4), formatNumber(*measured.overshoot * 100.0, 1));
    if (!words.isEmpty()) // below the line, which they would cover
        step.marks.push_back(wordsAt(measured.settle.value_or(x), belowLine * target, words.join(QLatin1Char('\n')),
            Qt::AlignRight | Qt::AlignBottom, false));
    step.highest = std::max(step.highest, headroom * peak);
}

void addProof(StepCurves &step, const tuning::TuneReport &report, const tuning::Proposal &proposal, double end)
{
    for (const tuning::Trial &trial : report.proof) {
        const double sign = trial.stimulus.to < trial.stimulus.from ? -1.0 : 1.0;
        TraceLook look;
        look.role = report.loop == Mode::Velocity ? TraceRole::Velocity
            : report.loop == Mode::Current        ? TraceRole::Current
                                                  : TraceRole::Position;
        look.dash = sign > 0.0 ? TraceDash::Solid : TraceDash::Long;
        step.curves.push_back(
            curveOf(sign > 0.0 ? StepText::tr("measured, forwards") : StepText::tr("measured, backwards"), look,
                trial.folded(tuning::measuredOf(trial.mode)), trial.stimulus.from, sign, end));
    }
    const tuning::Metrics &measured = report.measured;
    if (report.proof.empty() || !measured.overshoot)
        return;
    const QString settled = measured.settle ? formatDuration(*measured.settle) : QString(UnknownMark);
    step.note = StepText::tr("measured: %1 % over, settled after %2")
                    .arg(formatNumber(*measured.overshoot * 100.0, 1), settled);
    markMeasured(step, measured, proposal.step, StepText::tr("measured: settles %1").arg(settled));
}

void compare(StepCurves &step, const ComparedGains &compared, double target, double end)
{
    TraceLook look;
    look.role = TraceRole::Neutral;
    look.dash = TraceDash::Long;
    Curve curve = curveOf(
        StepText::tr("%1, predicted").arg(compared.name), look, compared.proposal.predicted.measured, 0.0, 1.0, end);
    if (curve.y.isEmpty())
        return;
    const auto peak = std::ranges::max_element(curve.y);
    const auto at = curve.x[static_cast<int>(peak - curve.y.cbegin())];
    const QString figure = figures(compared.proposal.predicted.metrics);
    if (*peak > (1.0 + settleBand) * target && !figure.isEmpty())
        step.marks.push_back(wordsAt(at, std::min(*peak, mostCompared * target),
            StepText::tr("%1: %2").arg(compared.name, figure), Qt::AlignRight | Qt::AlignTop, false));
    step.highest = std::max(step.highest, std::min(*peak * headroom, mostCompared * target));
    step.behind.push_back(std::move(curve));
}

} // namespace

QString stepUnit(Mode loop)
{
    return loop == Mode::Velocity ? StepText::tr("counts/s")
        : loop == Mode::Current   ? StepText::tr("A")
                                  : StepText::tr("counts");
}

StepCurves stepCurves(const tuning::TuneReport &report, const tuning::Proposal &proposal, const QString &name,
    const tuning::PredictionBand &band, const std::optional<ComparedGains> &compared)
{
    const bool proven = tuning::isSameSet(report.proposed, proposal.gains);
    double end = shownSettles * std::max(proposal.predicted.metrics.settle.value_or(0.5), shortestShown);
    if (proven)
        end = std::min(end, shortestHold(report.proof));
    StepCurves step;
    step.highest = headroom * proposal.step;
    step.title = StepText::tr("Step of %1 %2").arg(formatSignificant(proposal.step, 4), stepUnit(report.loop));
    step.curves.push_back(predictedCurve(proposal, name, band, end));
    markTarget(step, proposal.step, end);
    markPrediction(step, proposal, name);
    if (proven)
        addProof(step, report, proposal, end);
    if (compared)
        compare(step, *compared, proposal.step, end);
    if (!step.curves.front().low.isEmpty())
        step.note += (step.note.isEmpty() ? QString() : QStringLiteral(" · ")) + StepText::tr("band: ± of the model");
    return step;
}

} // namespace mb
