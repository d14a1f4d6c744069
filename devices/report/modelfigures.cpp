// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/modelfigures.h"

#include "files/qttext.h"
#include "report/htmltext.h"

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

/// What the two directions tell apart, and what was seen before and at the begin of a push.
void addWays(const MotorFound &motor, const QString &unit, std::vector<ModelFigure> &figures)
{
    if (motor.line.forward > 0.0 && motor.line.reverse > 0.0) {
        figures.push_back({ReportText::tr("Load one way kG"), QStringLiteral("kG"), percent * motor.line.offset,
            percent * motor.line.offsetError, 4, ReportText::tr("% duty")});
        figures.push_back({ReportText::tr("Gain forwards"), {}, motor.line.forward, {}, 4, unit});
        figures.push_back({ReportText::tr("Gain backwards"), {}, motor.line.reverse, {}, 4, unit});
    }
    if (motor.restNoise)
        figures.push_back({ReportText::tr("Noise at rest σ"), QStringLiteral("σ"), *motor.restNoise, {}, 2,
            ReportText::tr("counts")});
    if (motor.latency)
        figures.push_back({ReportText::tr("Order to motion"), {}, milli * *motor.latency, {}, 3, QStringLiteral("ms")});
}

} // namespace

std::vector<ModelFigure> modelFigures(const TuneReport &report, const std::function<QString(const Message &)> &phrase)
{
    const std::optional<MotorFound> &motor = report.motor;
    const MotorFound found = motor.value_or(MotorFound());
    const auto error = [&motor](double of) { return motor ? std::optional(of) : std::nullopt; };
    const QString unit = worded(phrase, Message::label(found.unit));
    std::vector<ModelFigure> figures{
        {ReportText::tr("Gain K"), QStringLiteral("K"), report.plant.gain, error(found.line.gainError), 4, unit},
        {ReportText::tr("Lag τ"), QStringLiteral("τ"), milli * report.plant.tau, error(milli * found.pushes.tauError),
            4, QStringLiteral("ms")},
        {ReportText::tr("Dead time θ"), QStringLiteral("θ"), milli * report.plant.delay,
            error(milli * found.pushes.delayError), 4, QStringLiteral("ms")},
        {ReportText::tr("Friction kS"), QStringLiteral("kS"), percent * report.plant.friction,
            error(percent * found.line.frictionError), 4, ReportText::tr("% duty")}};
    if (motor && motor->ramp)
        addBreakaway(*motor, figures);
    if (motor)
        addWays(*motor, unit, figures);
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
