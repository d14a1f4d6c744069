// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotanalysis.h"

#include "recording/samplecursor.h"
#include "recording/spectrum.h"
#include "widgets/common/numberformat.h"

#include <QCoreApplication>
#include <cmath>

namespace mb {
namespace {

constexpr std::size_t mostPairs = 20'000;
constexpr int mostBins = 4000; ///< of a drawn spectrum; more than a screen has columns

struct AnalysisText {
    Q_DECLARE_TR_FUNCTIONS(AnalysisText)
};

std::vector<Point> samplesOf(const TelemetrySource &source, double from, double to, std::size_t most)
{
    const Telemetry &telemetry = source.telemetry();
    const std::size_t begin = telemetry.lowerBound(source.channel(), instantOf(from));
    const std::size_t end = telemetry.lowerBound(source.channel(), instantOf(to));
    std::vector<Point> points;
    (void)telemetry.read(source.channel(), end - begin > most ? end - most : begin, instantOf(to), most, points);
    return points;
}

/// The largest of neighbouring lines where there are more of them than columns: a peak never gets lost.
Curve curveOf(const Spectrum &spectrum, const AnalysedTrace &trace)
{
    Curve curve{trace.name, trace.look, {}, {}};
    curve.look.dash = TraceDash::Solid;
    const auto size = static_cast<int>(spectrum.amplitude.size());
    const int step = std::max(1, size / mostBins);
    for (int i = 1; i < size; i += step) {
        const auto begin = spectrum.amplitude.begin() + i;
        const auto highest = std::max_element(begin, spectrum.amplitude.begin() + std::min(i + step, size));
        curve.x << spectrum.frequency(static_cast<std::size_t>(highest - spectrum.amplitude.begin()));
        curve.y << *highest * std::abs(trace.source->scale());
    }
    return curve;
}

QString peakText(const Spectrum &spectrum, const AnalysedTrace &trace)
{
    const std::size_t peak = spectrum.peak();
    return AnalysisText::tr("%1: peak %2 at %3 Hz")
        .arg(trace.name,
            formatSignificant(spectrum.amplitude[peak] * std::abs(trace.source->scale()), 3) + QChar(QChar::Nbsp)
                + trace.unit,
            formatSignificant(spectrum.frequency(peak), 4));
}

} // namespace

Analysis spectra(const std::vector<AnalysedTrace> &traces, double from, double to, std::size_t most)
{
    Analysis analysis;
    QStringList notes;
    for (const AnalysedTrace &trace : traces) {
        const auto spectrum = mb::spectrumOf(samplesOf(*trace.source, from, to, most));
        if (!spectrum) {
            notes << AnalysisText::tr("%1: fewer than 16 samples connect").arg(trace.name);
            continue;
        }
        analysis.curves.push_back(curveOf(*spectrum, trace));
        analysis.curves.back().name = peakText(*spectrum, trace);
        if (spectrum->shortened && analysis.note.isEmpty())
            analysis.note = AnalysisText::tr("the longest stretch without a gap");
    }
    if (!analysis.note.isEmpty())
        notes.prepend(analysis.note);
    analysis.note = notes.join(QStringLiteral(" · "));
    return analysis;
}

Analysis against(const AnalysedTrace &x, const AnalysedTrace &y, double from, double to)
{
    Analysis analysis;
    Curve curve{AnalysisText::tr("%1 against %2").arg(y.name, x.name), y.look, {}, {}};
    curve.look.dash = TraceDash::Solid;
    SampleCursor wide(x.source->sharedTelemetry(), x.source->channel(), instantOf(from) - std::chrono::seconds(1));
    SampleCursor high(y.source->sharedTelemetry(), y.source->channel(), instantOf(from));
    const Telemetry &of = y.source->telemetry();
    const std::size_t count
        = of.lowerBound(y.source->channel(), instantOf(to)) - of.lowerBound(y.source->channel(), instantOf(from));
    const std::size_t step = count / mostPairs + 1;
    Point before;
    std::size_t number = 0;
    for (const Point *next = high.peek(instantOf(to)); next; next = high.peek(instantOf(to))) {
        const Point sample = *next;
        high.pop();
        const Point *after = wide.peek();
        for (; after && (after->isGap() || after->time < sample.time); after = wide.peek()) {
            before = *after;
            wide.pop();
        }
        const bool known
            = after && !before.isGap() && !sample.isGap() && after->time - before.time < std::chrono::seconds(1);
        if (!known || number++ % step != 0)
            continue;
        const double span = static_cast<double>((after->time - before.time).count());
        const double part = span > 0.0 ? static_cast<double>((sample.time - before.time).count()) / span : 1.0;
        curve.x << (before.value + (after->value - before.value) * part) * x.source->scale();
        curve.y << sample.value * y.source->scale();
    }
    analysis.note = step > 1 ? AnalysisText::tr("%1 points, every %2. sample").arg(curve.x.size()).arg(step)
                             : AnalysisText::tr("%1 points").arg(curve.x.size());
    analysis.curves.push_back(std::move(curve));
    return analysis;
}

} // namespace mb
