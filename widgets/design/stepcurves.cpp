// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/design/stepcurves.h"

#include "tuning/envelope.h"
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

bool isSame(const tuning::ScaledGains &a, const tuning::ScaledGains &b)
{
    return std::equal(a.rows.begin(), a.rows.end(), b.rows.begin(), b.rows.end(),
        [](const auto &one, const auto &other) { return one.key == other.key && one.raw == other.raw; });
}

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

} // namespace

StepCurves stepCurves(const tuning::TuneReport &report, const tuning::Proposal &proposal, const QString &name,
    const tuning::PredictionBand &band)
{
    const bool proven = isSame(report.proposed, proposal.gains);
    double end = shownSettles * std::max(proposal.predicted.metrics.settle.value_or(0.5), shortestShown);
    if (proven)
        end = std::min(end, shortestHold(report.proof));
    StepCurves step;
    step.curves.push_back(predictedCurve(proposal, name, band, end));
    step.note = StepText::tr("a step of %1").arg(formatSignificant(proposal.step, 4));
    if (!proven)
        return step;
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
    if (!report.proof.empty() && measured.overshoot)
        step.note += QStringLiteral(" · ")
            + StepText::tr("measured: %1 % over, settled after %2")
                  .arg(formatNumber(*measured.overshoot * 100.0, 1),
                      measured.settle ? formatDuration(*measured.settle) : QString(UnknownMark));
    return step;
}

} // namespace mb
