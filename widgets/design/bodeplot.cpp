// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/design/bodeplot.h"

#include "widgets/common/layoutin.h"
#include "widgets/design/bodemarks.h"
#include "widgets/plots/curvelegend.h"
#include "widgets/plots/curveplot.h"
#include "widgets/plots/plottickers.h"

#include <cmath>
#include <numbers>

namespace mb {
namespace {

constexpr int steps = 240;
constexpr double decadesAround = 1.3; ///< of the crossover, either way
constexpr double lowestPhase = -285.0;
constexpr double quarterTurn = 90.0;  ///< degrees between two labels
constexpr double fullyTrusted = 0.97; ///< coherence
constexpr int labelRoom = 78;         ///< units, beside both plots

double decibel(double ratio)
{
    return 20.0 * std::log10(ratio);
}

class PhaseTicker : public NumberTicker {
protected:
    double getTickStep(const QCPRange &range) override
    {
        if (range.size() <= quarterTurn)
            return NumberTicker::getTickStep(range);
        double step = quarterTurn;
        while (step < leastStep(range) && step < range.size() / 2.0)
            step *= 2.0;
        return step;
    }
};

double hertzOf(double omega)
{
    return omega / (2.0 * std::numbers::pi);
}

TraceLook lookOf(TraceRole role, TraceDash dash)
{
    TraceLook look;
    look.role = role;
    look.dash = dash;
    look.emphasis = dash == TraceDash::Solid;
    return look;
}

const TraceLook ofLoop = lookOf(TraceRole::Setpoint, TraceDash::Solid);
const TraceLook ofMotor = lookOf(TraceRole::Setpoint, TraceDash::Dots);
const TraceLook ofCompared = lookOf(TraceRole::Neutral, TraceDash::Long);
const TraceLook ofMeasured = lookOf(TraceRole::Velocity, TraceDash::Automatic);
const TraceLook ofUnused = lookOf(TraceRole::Neutral, TraceDash::Automatic);

/// The two curves of one thing.
struct Response {
    Curve magnitude;
    Curve phase;

    Response(const QString &name, const TraceLook &look)
        : magnitude{name, look, {}, {}}
        , phase{name, look, {}, {}}
    {
    }
    void add(double hertz, double size, double angle)
    {
        magnitude.x.append(hertz);
        magnitude.y.append(size);
        if (angle < lowestPhase)
            return;
        phase.x.append(hertz);
        phase.y.append(angle);
    }
    void showAsPoints(bool hollow)
    {
        magnitude.points = phase.points = true;
        magnitude.hollow = phase.hollow = hollow;
    }
};

/// Unwrapped, so that a dead time goes on falling.
Response responseOf(
    const QString &name, const TraceLook &look, double middle, const std::function<std::complex<double>(double)> &at)
{
    Response response(name, look);
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
        response.add(hertzOf(omega), decibel(std::abs(value)), angle + turns);
    }
    return response;
}

/// Of a position loop the motor integrates its speed.
void addPoint(Response &into, const tuning::FrequencyPoint &point, Mode loop, const tuning::PlantModel &plant)
{
    const double omega = 2.0 * std::numbers::pi * point.hertz;
    const bool integrates = loop == Mode::Position;
    into.add(point.hertz, decibel(point.magnitude / plant.gain / (integrates ? omega : 1.0)),
        point.phase - (integrates ? 90.0 : 0.0) - omega * plant.delay * 180.0 / std::numbers::pi);
}

} // namespace

BodePlot::BodePlot(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_legend(new CurveLegend(theme, {}, this))
    , m_magnitude(new CurvePlot(theme, tr("Magnitude of loop and motor"), this))
    , m_phase(new CurvePlot(theme, tr("Phase of loop and motor"), this))
{
    m_magnitude->setAxes({}, tr("magnitude, dB"), false, true);
    m_phase->setAxes(tr("Hz"), tr("phase, °"), false, true);
    m_phase->setWatermark({});
    m_magnitude->setSurroundings({false, false, false, labelRoom, true});
    m_phase->setSurroundings({false, false, true, labelRoom, true});
    m_phase->setLeastRange(-3.0 * quarterTurn, 0.0);
    m_phase->plot().yAxis->setTicker(QSharedPointer<PhaseTicker>::create());
    const auto follow = [](CurvePlot *leader, CurvePlot *follower) {
        connect(leader->plot().xAxis, qOverload<const QCPRange &>(&QCPAxis::rangeChanged), follower,
            [follower](const QCPRange &range) {
                if (follower->plot().xAxis->range() == range)
                    return;
                follower->plot().xAxis->setRange(range);
                follower->plot().replot(QCustomPlot::rpQueuedReplot);
            });
    };
    follow(m_magnitude, m_phase);
    follow(m_phase, m_magnitude);
    auto *column = layoutIn<QVBoxLayout>(this, 0);
    column->addWidget(m_legend);
    column->addWidget(m_magnitude, 4);
    column->addWidget(m_phase, 3);
    name();
}

void BodePlot::setLoop(
    Mode loop, const tuning::PlantModel &plant, const tuning::ContinuousGains &gains, const tuning::Margins &margins)
{
    const double middle = margins.crossover > 0.0 ? margins.crossover : 1.0 / std::max(plant.tau, 1e-3);
    tuning::PlantModel unit = plant; // of the motor its shape only: counts and duty have no common scale
    unit.gain = 1.0;
    const tuning::ContinuousGains one{1.0, 0.0, 0.0, 0.0};
    const Response ours = responseOf(
        tr("loop"), ofLoop, middle, [&](double omega) { return tuning::openLoop(loop, plant, gains, omega); });
    const Response motor = responseOf(
        tr("motor ÷ gain"), ofMotor, middle, [&](double omega) { return tuning::openLoop(loop, unit, one, omega); });
    std::vector<Curve> magnitude{ours.magnitude, motor.magnitude};
    std::vector<Curve> phase{ours.phase, motor.phase};
    addMeasured(loop, plant, magnitude, phase);
    showBehind(loop, plant, middle);
    m_magnitude->setCurves(magnitude);
    m_phase->setCurves(phase);
    m_magnitude->setNote(marginText(margins));
    BodeMarks marks = bodeMarks(margins, usableUpTo());
    m_magnitude->setMarks(std::move(marks.magnitude));
    m_phase->setMarks(std::move(marks.phase));
    name();
    m_magnitude->fit();
    m_phase->fit();
}

void BodePlot::setCompared(const std::optional<tuning::ContinuousGains> &gains, const QString &name)
{
    m_compared = gains;
    m_comparedName = name;
}

double BodePlot::usableUpTo() const
{
    double last = 0.0;
    for (const tuning::FrequencyPoint &point : m_measured) {
        if (!point.trusted)
            break;
        last = point.hertz;
    }
    return last;
}

/// What is trusted: filled where a sine explains nearly everything, hollow where it explains less.
void BodePlot::addMeasured(
    Mode loop, const tuning::PlantModel &plant, std::vector<Curve> &magnitude, std::vector<Curve> &phase) const
{
    Response hollow(tr("0.90 … 0.97"), ofMeasured);
    Response filled(tr("motor ÷ gain, measured"), ofMeasured);
    hollow.showAsPoints(true);
    filled.showAsPoints(false);
    for (const tuning::FrequencyPoint &point : m_measured) {
        if (point.trusted && point.hertz <= usableUpTo())
            addPoint(point.coherence >= fullyTrusted ? filled : hollow, point, loop, plant);
    }
    for (const Response *response : {&hollow, &filled}) {
        if (response->magnitude.x.isEmpty())
            continue;
        magnitude.push_back(response->magnitude);
        phase.push_back(response->phase);
    }
}

/// The gains to compare with, and what was measured beyond what may be trusted.
void BodePlot::showBehind(Mode loop, const tuning::PlantModel &plant, double middle)
{
    std::vector<Curve> magnitude;
    std::vector<Curve> phase;
    const auto add = [&](const Response &response) {
        magnitude.push_back(response.magnitude);
        phase.push_back(response.phase);
    };
    if (m_compared)
        add(responseOf(m_comparedName, ofCompared, middle,
            [&](double omega) { return tuning::openLoop(loop, plant, *m_compared, omega); }));
    Response unused(tr("not used"), ofUnused);
    unused.showAsPoints(true);
    for (const tuning::FrequencyPoint &point : m_measured) {
        if (point.hertz > usableUpTo() && point.magnitude > 0.0)
            addPoint(unused, point, loop, plant);
    }
    if (!unused.magnitude.x.isEmpty())
        add(unused);
    m_magnitude->setBehind(magnitude);
    m_phase->setBehind(phase);
}

void BodePlot::name()
{
    using Shape = CurveLegend::Shape;
    std::vector<CurveLegend::Entry> entries{{tr("loop"), ofLoop}, {tr("motor ÷ gain"), ofMotor}};
    if (m_compared)
        entries.push_back({m_comparedName, ofCompared});
    if (!m_measured.empty()) {
        entries.push_back({tr("measured, γ² ≥ 0.97"), ofMeasured, Shape::Filled});
        entries.push_back({tr("0.90 … 0.97"), ofMeasured, Shape::Hollow});
        entries.push_back({tr("under 0.90, not used"), ofUnused, Shape::Faint});
    }
    m_legend->setEntries(entries);
}

void BodePlot::clear()
{
    for (CurvePlot *plot : {m_magnitude, m_phase}) {
        plot->setBehind({});
        plot->setCurves({});
        plot->setMarks({});
    }
    m_magnitude->setNote({});
}

void BodePlot::setWatermark(const QString &text)
{
    m_magnitude->setWatermark(text);
}

} // namespace mb
