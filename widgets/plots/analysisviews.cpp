// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/analysisviews.h"

#include "recording/samplecursor.h"
#include "recording/spectrum.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/numberformat.h"
#include "widgets/plots/plotexport.h"
#include "widgets/plots/telemetrysource.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QCoreApplication>
#include <QMenu>

#include <algorithm>
#include <cmath>
#include <utility>

namespace mb {
namespace {

constexpr std::size_t liveSamples = 1U << 15U;   ///< of a spectrum that is made twice a second
constexpr std::size_t pausedSamples = 1U << 20U; ///< of one that is looked at

constexpr std::size_t mostPairs = 20'000;
constexpr int mostBins = 4000; ///< of a drawn spectrum; more than a screen has columns

/// A trace as the views beside the time plot take it.
struct AnalysedTrace {
    std::shared_ptr<const TelemetrySource> source;
    QString name;
    QString unit;
    TraceLook look;
};

struct Analysis {
    std::vector<Curve> curves;
    QString note; ///< what was taken, and what was found
};

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
    for (auto i = static_cast<int>(Spectrum::firstWave); i < size; i += step) {
        const auto begin = spectrum.amplitude.begin() + i;
        const auto highest = std::max_element(begin, spectrum.amplitude.begin() + std::min(i + step, size));
        curve.x << spectrum.frequency(static_cast<std::size_t>(highest - spectrum.amplitude.begin()));
        curve.y << *highest * std::abs(trace.source->scale());
    }
    return curve;
}

QString peakText(const Spectrum &spectrum, const AnalysedTrace &trace)
{
    const auto peak = spectrum.peak();
    if (!peak)
        return AnalysisText::tr("%1: peak –").arg(trace.name);
    return AnalysisText::tr("%1: peak %2 at %3 Hz")
        .arg(trace.name,
            formatSignificant(spectrum.amplitude[*peak] * std::abs(trace.source->scale()), 3) + QChar(QChar::Nbsp)
                + trace.unit,
            formatSignificant(spectrum.frequency(*peak), 4));
}

/// Amplitude against frequency of each trace between two keys, at most `most` of its newest samples.
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

/// One trace against another: a point for each sample of `y`, `x` on the line between its samples.
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

AnalysedTrace analysed(const PlotBoard::Trace &trace)
{
    return {trace.source, trace.style.name, trace.style.unit, trace.style.look()};
}

std::pair<double, double> stretchOf(const PlotStack &stack)
{
    const auto [a, b] = stack.cursorsShown() ? stack.cursorKeys() : stack.view().range();
    return std::minmax({a, b});
}

} // namespace

void fillExportMenu(QMenu &menu, CurvePlot &plot, Workbench &workbench)
{
    menu.addAction(
        AgainstView::tr("Copy picture"), &plot, [&plot] { QApplication::clipboard()->setPixmap(plot.picture()); });
    addPictures(
        menu, plot, [&plot](const QString &kind) { return plot.contentAs(kind); },
        [&workbench](const QString &path, const Result<void> &written) {
            workbench.report(written ? Severity::Good : Severity::Danger, {},
                written ? AgainstView::tr("plot written to %1").arg(path) : errorText(written.error()));
        });
}

AgainstView::AgainstView(PlotStack &stack, PlotBoard &board, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_stack(stack)
    , m_board(board)
    , m_plot(new CurvePlot(theme, tr("One signal against another"), this))
    , m_across(new QComboBox(this))
    , m_upwards(new QComboBox(this))
{
    m_across->setAccessibleName(tr("Signal across"));
    m_upwards->setAccessibleName(tr("Signal upwards"));
    m_plot->setSurroundings({.legend = false}); // the axes name the one curve
    auto *row = new QHBoxLayout;
    row->setContentsMargins(theme.theme().u(12), theme.theme().u(4), theme.theme().u(12), theme.theme().u(4));
    row->addWidget(m_upwards);
    row->addWidget(textLabel(tr("against"), TextRole::Caption, Tone::Dim, this));
    row->addWidget(m_across);
    row->addStretch(1);
    auto *column = layoutIn<QVBoxLayout>(this);
    column->addLayout(row);
    column->addWidget(m_plot, 1);
    for (QComboBox *box : {m_across, m_upwards})
        connect(box, qOverload<int>(&QComboBox::activated), this, [this] {
            m_plot->setCurves({});
            refresh();
            m_plot->fit();
        });
}

void AgainstView::follow()
{
    const auto listed = std::exchange(m_listed, {});
    for (const PlotBoard::Trace &trace : m_board.traces())
        m_listed.push_back(trace.signal);
    for (QComboBox *box : {m_across, m_upwards}) {
        const int before = box->currentIndex();
        box->clear();
        for (const PlotBoard::Trace &trace : m_board.traces())
            box->addItem(trace.style.name);
        const int other = box == m_upwards || box->count() < 2 ? 0 : 1;
        const auto kept
            = before < 0 ? m_listed.end() : std::ranges::find(m_listed, listed.at(static_cast<std::size_t>(before)));
        box->setCurrentIndex(kept == m_listed.end() ? other : static_cast<int>(kept - m_listed.begin()));
    }
    if (m_listed.empty())
        m_plot->setCurves({});
    if (m_across->count() > 1 && m_across->currentIndex() == m_upwards->currentIndex())
        m_across->setCurrentIndex(m_upwards->currentIndex() == 0 ? 1 : 0); // against itself it is a line
}

void AgainstView::refresh()
{
    const auto &traces = m_board.traces();
    const int x = m_across->currentIndex();
    const int y = m_upwards->currentIndex();
    if (x < 0 || y < 0 || traces.size() <= static_cast<std::size_t>(std::max(x, y)))
        return;
    const PlotBoard::Trace &wide = traces[static_cast<std::size_t>(x)];
    const PlotBoard::Trace &high = traces[static_cast<std::size_t>(y)];
    const auto [from, to] = stretchOf(m_stack);
    const Analysis analysis = against(analysed(wide), analysed(high), from, to);
    m_plot->setAxes(
        tr("%1, %2").arg(wide.style.name, wide.style.unit), tr("%1, %2").arg(high.style.name, high.style.unit), false);
    m_plot->setWatermark(m_stack.strips().watermark());
    m_plot->setCurves(analysis.curves);
    m_plot->setNote((m_stack.cursorsShown() ? tr("A … B: ") : tr("what is seen: ")) + analysis.note);
}

SpectrumView::SpectrumView(PlotStack &stack, PlotBoard &board, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_stack(stack)
    , m_board(board)
    , m_plot(new CurvePlot(theme, tr("Spectrum"), this))
{
    auto *column = layoutIn<QVBoxLayout>(this);
    column->addWidget(m_plot);
    m_plot->setAxes(tr("frequency, Hz"), tr("amplitude"), true, true);
}

void SpectrumView::follow()
{
    if (m_board.traces().empty())
        m_plot->setCurves({});
}

void SpectrumView::refresh()
{
    std::vector<AnalysedTrace> traces;
    QStringList units;
    for (const PlotBoard::Trace &trace : m_board.traces()) {
        traces.push_back(analysed(trace));
        if (!units.contains(trace.style.unit))
            units << trace.style.unit;
    }
    const bool selection = m_stack.cursorsShown();
    const auto [from, to] = stretchOf(m_stack);
    const bool still = selection || !m_stack.view().isLive();
    const Analysis analysis = spectra(traces, from, to, still ? pausedSamples : liveSamples);
    m_plot->setAxes(tr("frequency, Hz"), tr("amplitude, %1").arg(units.join(QStringLiteral(", "))), true, true);
    m_plot->setWatermark(m_stack.strips().watermark());
    m_plot->setCurves(analysis.curves);
    m_plot->setNote(
        (selection ? tr("A … B") : tr("what is seen")) + tr(", Hann window, peak values. ") + analysis.note);
}

} // namespace mb
