// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/modelfigures.h"

#include "files/qttext.h"
#include "report/htmltext.h"
#include "tuning/modelnumbers.h"

namespace mb {
namespace {

using namespace tuning;

constexpr double percent = 100.0;
constexpr double milli = 1e3;

/// Each way alone, in V where the supply is told.
void addBreakaway(const MotorFound &motor, std::vector<ModelFigure> &figures)
{
    const bool inVolts = motor.supply > 0.0;
    const double scale = inVolts ? motor.supply : percent;
    const QString unit = inVolts ? QStringLiteral("V") : ReportText::tr("% duty");
    figures.push_back({ReportText::tr("Breakaway forwards"), {}, scale * motor.ramp->forward.breakaway,
        scale * motor.ramp->forward.breakawayError, 3, unit});
    figures.push_back({ReportText::tr("Breakaway backwards"), {}, scale * motor.ramp->reverse.breakaway,
        scale * motor.ramp->reverse.breakawayError, 3, unit});
}

/// Nothing of what nobody knows.
void add(std::vector<ModelFigure> &figures, ModelFigure figure, const ModelNumber &number, double scale = 1.0)
{
    if (!number.value)
        return;
    figure.value = scale * *number.value;
    if (number.error)
        figure.error = scale * *number.error;
    figures.push_back(std::move(figure));
}

/// What the two directions tell apart, and what was seen before and at the begin of a push.
void addWays(const ModelNumbers &numbers, const QString &unit, std::vector<ModelFigure> &figures)
{
    if (numbers.load.value) {
        add(figures, {ReportText::tr("Load one way kG"), QStringLiteral("kG"), 0.0, {}, 4, ReportText::tr("% duty")},
            numbers.load, percent);
        add(figures, {ReportText::tr("Gain forwards"), {}, 0.0, {}, 4, unit}, numbers.forward);
        add(figures, {ReportText::tr("Gain backwards"), {}, 0.0, {}, 4, unit}, numbers.reverse);
    }
    add(figures, {ReportText::tr("Noise at rest σ"), QStringLiteral("σ"), 0.0, {}, 2, ReportText::tr("counts")},
        numbers.noise);
    add(figures, {ReportText::tr("Order to motion"), {}, 0.0, {}, 3, QStringLiteral("ms")}, numbers.latency, milli);
}

} // namespace

std::vector<ModelFigure> modelFigures(const TuneReport &report, const std::function<QString(const Message &)> &phrase)
{
    const std::optional<MotorFound> &motor = report.motor;
    const ModelNumbers numbers = modelNumbers(report);
    const QString unit = worded(phrase, Message::label(motor.value_or(MotorFound()).unit));
    std::vector<ModelFigure> figures;
    add(figures, {ReportText::tr("Gain K"), QStringLiteral("K"), 0.0, {}, 4, unit}, numbers.gain);
    add(figures, {ReportText::tr("Lag τ"), QStringLiteral("τ"), 0.0, {}, 4, QStringLiteral("ms")}, numbers.tau, milli);
    add(figures, {ReportText::tr("Dead time θ"), QStringLiteral("θ"), 0.0, {}, 4, QStringLiteral("ms")}, numbers.delay,
        milli);
    add(figures, {ReportText::tr("Friction kS"), QStringLiteral("kS"), 0.0, {}, 4, ReportText::tr("% duty")},
        numbers.friction, percent);
    if (motor && motor->ramp)
        addBreakaway(*motor, figures);
    addWays(numbers, unit, figures);
    return figures;
}

QString filterWords(VelocityFilter::Kind kind, const QString &window)
{
    switch (kind) {
    case VelocityFilter::Kind::None: return ReportText::tr("none, as fresh as the position");
    case VelocityFilter::Kind::Rolling: return ReportText::tr("rolling, %1").arg(window);
    case VelocityFilter::Kind::Block: return ReportText::tr("in blocks, %1").arg(window);
    }
    return {};
}

QString profileWords(const QString &speed, const QString &acceleration)
{
    return ReportText::tr("Set-points that it can follow: at most %1 and %2").arg(speed, acceleration);
}

} // namespace mb
