// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/design/bodeplot.h"

#include "widgets/common/layoutin.h"
#include "widgets/common/numberformat.h"
#include "widgets/plots/curveplot.h"

#include <cmath>
#include <numbers>

namespace mb {
namespace {

constexpr int steps = 240;
constexpr double decadesAround = 1.3; ///< of the crossover, either way
constexpr double lowestPhase = -360.0;

double decibel(double ratio)
{
    return 20.0 * std::log10(ratio);
}

struct Response {
    Curve magnitude;
    Curve phase;
};

/// Unwrapped, so that a dead time goes on falling.
Response responseOf(
    const QString &name, const TraceLook &look, double middle, const std::function<std::complex<double>(double)> &at)
{
    Response response{{name, look, {}, {}}, {name, look, {}, {}}};
    double before = 0.0;
    double turns = 0.0;
    for (int i = 0; i <= steps; ++i) {
        const double omega = middle * std::pow(10.0, decadesAround * (2.0 * i / steps - 1.0));
        const std::complex<double> value = at(omega);
        const double angle = std::arg(value) * 180.0 / std::numbers::pi;
        if (i > 0 && angle - before > 180.0)
            turns -= 360.0;
        else if (i > 0 && angle - before < -180.0)
            turns += 360.0;
        before = angle;
        const double hertz = omega / (2.0 * std::numbers::pi);
        response.magnitude.x.append(hertz);
        response.magnitude.y.append(decibel(std::abs(value)));
        if (angle + turns < lowestPhase)
            continue;
        response.phase.x.append(hertz);
        response.phase.y.append(angle + turns);
    }
    return response;
}

} // namespace

QString marginText(const tuning::Margins &margins)
{
    if (!margins.isStable())
        return BodePlot::tr("unstable");
    QStringList parts{
        BodePlot::tr("crossover %1 Hz").arg(formatSignificant(margins.crossover / (2.0 * std::numbers::pi), 3)),
        BodePlot::tr("phase margin %1°").arg(formatNumber(margins.phase))};
    if (std::isfinite(margins.gain))
        parts << BodePlot::tr("gain margin %1 dB").arg(formatNumber(decibel(margins.gain), 1));
    parts << BodePlot::tr("Ms %1").arg(formatNumber(margins.ms, 2));
    return parts.join(QStringLiteral(" · "));
}

BodePlot::BodePlot(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
{
    m_magnitude = new CurvePlot(theme, tr("Magnitude of loop and motor"), this);
    m_phase = new CurvePlot(theme, tr("Phase of loop and motor"), this);
    m_magnitude->setAxes(tr("Hz"), tr("magnitude, dB"), false, true);
    m_phase->setAxes(tr("Hz"), tr("phase, °"), false, true);
    m_phase->setWatermark({});
    m_phase->setLegendPlace(Qt::AlignBottom | Qt::AlignLeft);
    auto *column = layoutIn<QVBoxLayout>(this, 0);
    column->addWidget(m_magnitude, 4);
    column->addWidget(m_phase, 3);
}

void BodePlot::setLoop(
    Mode loop, const tuning::PlantModel &plant, const tuning::ContinuousGains &gains, const tuning::Margins &margins)
{
    const double middle = margins.crossover > 0.0 ? margins.crossover : 1.0 / std::max(plant.tau, 1e-3);
    TraceLook solid;
    solid.role = TraceRole::Velocity;
    solid.dash = TraceDash::Solid;
    solid.emphasis = true;
    TraceLook dotted;
    dotted.role = TraceRole::Setpoint;
    dotted.dash = TraceDash::Long;
    tuning::PlantModel unit = plant; // of the motor its shape only: counts and duty have no common scale
    unit.gain = 1.0;
    const tuning::ContinuousGains one{1.0, 0.0, 0.0, 0.0};
    const Response ours = responseOf(
        tr("loop"), solid, middle, [&](double omega) { return tuning::openLoop(loop, plant, gains, omega); });
    const Response motor = responseOf(
        tr("motor ÷ gain"), dotted, middle, [&](double omega) { return tuning::openLoop(loop, unit, one, omega); });
    std::vector<Curve> magnitude{ours.magnitude, motor.magnitude};
    std::vector<Curve> phase{ours.phase, motor.phase};
    addMeasured(loop, plant, magnitude, phase);
    m_magnitude->setCurves(magnitude);
    m_phase->setCurves(phase);
    m_magnitude->setNote(marginText(margins));
    m_magnitude->fit();
    m_phase->fit();
}

void BodePlot::setMeasured(std::vector<tuning::FrequencyPoint> points)
{
    m_measured = std::move(points);
}

/// Of a position loop the motor integrates its speed.
void BodePlot::addMeasured(
    Mode loop, const tuning::PlantModel &plant, std::vector<Curve> &magnitude, std::vector<Curve> &phase) const
{
    TraceLook look;
    look.role = TraceRole::Position;
    Curve size{tr("motor ÷ gain, measured"), look, {}, {}};
    size.points = true;
    Curve angle = size;
    for (const tuning::FrequencyPoint &point : m_measured) {
        if (!point.trusted)
            break;
        const double omega = 2.0 * std::numbers::pi * point.hertz;
        const bool integrates = loop == Mode::Position;
        size.x.append(point.hertz);
        size.y.append(decibel(point.magnitude / plant.gain / (integrates ? omega : 1.0)));
        angle.x.append(point.hertz);
        angle.y.append(point.phase - (integrates ? 90.0 : 0.0) - omega * plant.delay * 180.0 / std::numbers::pi);
    }
    if (size.x.isEmpty())
        return;
    magnitude.push_back(size);
    phase.push_back(angle);
}

void BodePlot::clear()
{
    m_magnitude->setCurves({});
    m_phase->setCurves({});
    m_magnitude->setNote({});
}

void BodePlot::setWatermark(const QString &text)
{
    m_magnitude->setWatermark(text);
}

} // namespace mb
