// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/sweepsection.h"

#include "report/htmltext.h"
#include "report/svgplot.h"
#include "tuning/frequencyresponse.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mb {
namespace {

using namespace tuning;

constexpr int magnitudeHeight = 120; // px
constexpr int phaseHeight = 90;
constexpr int modelPoints = 100;

const QString modelColour = QStringLiteral("#171C22");
const QString measuredColour = QStringLiteral("#1F8FD6");

/// Of the newest tuning that drives the motor of these sines itself, not its current.
const PlantModel *modelOf(const ReportUnit &unit)
{
    const auto found = std::ranges::find_if(unit.tunings, [&unit](const KeptTuning &kept) {
        return kept.report.loop != Mode::Current && kept.report.axis == unit.sines.front().trial.axis
            && kept.report.plant.gain > 0.0 && kept.report.plant.tau > 0.0;
    });
    return found == unit.tunings.end() ? nullptr : &found->report.plant;
}

std::vector<FrequencyPoint> pointsOf(const ReportUnit &unit, const PlantModel &plant)
{
    std::vector<FrequencyPoint> points;
    for (const KeptTrial &kept : unit.sines) {
        if (const auto point = frequencyPoint(kept.trial, plant.tau))
            points.push_back(*point);
    }
    std::ranges::sort(
        points, [](const FrequencyPoint &one, const FrequencyPoint &other) { return one.hertz < other.hertz; });
    return points;
}

QString tableOf(const std::vector<FrequencyPoint> &points)
{
    HtmlTable table(QStringLiteral("rrrrl"),
        {QStringLiteral("Hz"), ReportText::tr("Counts/s per duty"), ReportText::tr("Phase"),
            ReportText::tr("Coherence"), ReportText::tr("Believed")});
    for (const FrequencyPoint &point : points)
        table.add({figure(point.hertz, 3), figure(point.magnitude, 4), fixedFigure(point.phase, 1, QStringLiteral("°")),
            QString::number(point.coherence, 'f', 3),
            point.trusted ? strong(ReportText::tr("yes"), "ok") : strong(ReportText::tr("no"), "caution")});
    return table.html();
}

QString plotOf(const std::vector<FrequencyPoint> &points, const PlantModel &plant, bool simulated)
{
    SvgPane magnitude{ReportText::tr("magnitude of the motor, dB"), {}, magnitudeHeight};
    SvgPane phase{ReportText::tr("phase of the motor, °"), {}, phaseHeight};
    Trace modelled;
    Trace lagging;
    const double range = std::log(points.back().hertz / points.front().hertz);
    for (int i = 0; i <= modelPoints; ++i) {
        const double hertz = points.front().hertz * std::exp(range * i / modelPoints);
        const double lag = 2.0 * std::numbers::pi * hertz * plant.tau;
        modelled.add(hertz, 20.0 * std::log10(plant.gain / std::hypot(1.0, lag)));
        lagging.add(hertz, -std::atan(lag) * 180.0 / std::numbers::pi);
    }
    Trace measured;
    Trace turned;
    for (const FrequencyPoint &point : points) {
        if (!point.trusted)
            continue;
        measured.add(point.hertz, 20.0 * std::log10(point.magnitude));
        turned.add(point.hertz, point.phase);
    }
    magnitude.curves = {{ReportText::tr("model"), modelColour, QStringLiteral("2,3"), modelled},
        {ReportText::tr("measured"), measuredColour, {}, measured}};
    phase.curves = {{{}, modelColour, QStringLiteral("2,3"), lagging}, {{}, measuredColour, {}, turned}};
    SvgPlot plot;
    plot.logarithmic = true;
    plot.label = QStringLiteral("Hz");
    plot.mark = simulated ? QStringLiteral("DEMO") : QString();
    plot.description = ReportText::tr("Magnitude and phase of the motor, measured and of its model");
    plot.panes = {std::move(magnitude), std::move(phase)};
    return svgOf(plot);
}

} // namespace

QString sweepHtml(const ReportUnit &unit)
{
    const PlantModel *const plant = unit.sines.empty() ? nullptr : modelOf(unit);
    const auto points = plant ? pointsOf(unit, *plant) : std::vector<FrequencyPoint>();
    if (points.size() < 2)
        return {};
    const auto believed = std::ranges::count_if(points, [](const FrequencyPoint &point) { return point.trusted; });
    return heading(2, ReportText::tr("Frequency response of the motor"))
        + paragraph(ReportText::tr("Sines of duty around a speed at which it never reverses, the last on %1. Believed "
                                   "and drawn are %2 of %3: ten samples make a swing, and the sine explains 0.9 of "
                                   "the movement at least (coherence).")
                        .arg(timeText(unit.sines.back().time))
                        .arg(believed)
                        .arg(points.size()),
            "dim")
        + QStringLiteral("<div>") + plotOf(points, *plant, unit.simulated) + QStringLiteral("</div>\n")
        + tableOf(points);
}

} // namespace mb
