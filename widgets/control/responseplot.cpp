// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/responseplot.h"

#include "experiment/envelope.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/numberformat.h"
#include "widgets/plots/fixedtrace.h"
#include "widgets/plots/plotstack.h"

#include <algorithm>
#include <cmath>

namespace mb {
namespace {

using tuning::Trace;
using tuning::Trial;

constexpr double alikeHolds = 0.02;
constexpr double band = 0.02;
constexpr double nearLimit = 0.98;
constexpr double beforeEdge = 0.1; ///< s
constexpr double shortestSpan = 0.01;
constexpr double notablePeak = 0.01;
constexpr int roomForTwo = 210; ///< units of height
constexpr int roomForThree = 250;
constexpr int lowestStrip = 30;
constexpr double stripShare = 0.11; ///< of the height, at least, for what explains the first one

/// The stretches of a trace that stay at or above a limit, either way.
std::vector<std::pair<double, double>> stretchesAt(const Trace &trace, double limit)
{
    std::vector<std::pair<double, double>> all;
    bool inside = false;
    for (std::size_t i = 0; i < trace.size(); ++i) {
        const bool at = std::abs(trace.y[i]) >= limit;
        if (at && !inside)
            all.emplace_back(trace.t[i], trace.t[i]);
        else if (at)
            all.back().second = trace.t[i];
        inside = at;
    }
    std::erase_if(all, [](const auto &span) { return span.second - span.first < shortestSpan; });
    return all;
}

std::vector<PlotPoint> pointsOf(const Trace &trace, double scale)
{
    std::vector<PlotPoint> points;
    points.reserve(trace.size());
    for (std::size_t i = 0; i < trace.size(); ++i)
        points.push_back({trace.t[i], trace.y[i] * scale});
    return points;
}

double holdOf(const Trial &trial)
{
    double least = trial.stimulus.length();
    for (const tuning::Span &span : trial.holds)
        least = std::min(least, span.to - span.from);
    return least;
}

/// They come back at clearly other times: what one does then is no answer to the set-point of the other.
bool comeBackApart(const KeptTrial *a, const KeptTrial *b)
{
    if (!a || !b || a->trial.holds.empty() || b->trial.holds.empty())
        return false;
    const auto [shorter, longer] = std::minmax({holdOf(a->trial), holdOf(b->trial)});
    return longer - shorter > alikeHolds * longer;
}

/// Where the response is highest above (or lowest below) where it ends, during the hold.
std::optional<PlotPoint> peakOf(const Trial &trial)
{
    const Trace whole = trial.folded(tuning::measuredOf(trial.mode));
    const Trace trace = whole.part(0.0, holdOf(trial));
    if (trace.isEmpty() || trial.metrics.overshoot.value_or(0.0) <= notablePeak)
        return std::nullopt;
    const bool up = trial.stimulus.to > trial.stimulus.from;
    const auto at = up ? std::ranges::max_element(trace.y) : std::ranges::min_element(trace.y);
    return PlotPoint{trace.t[static_cast<std::size_t>(at - trace.y.begin())], *at};
}

const Channel *channelOf(const Family &family, const Trial &trial, std::string_view key)
{
    const tuning::Signal *const signal = trial.signal(key);
    const auto index = signal ? findChannel(family.channels, signal->channel) : std::nullopt;
    return index ? &family.channels[index->value] : nullptr;
}

} // namespace

ResponsePlot::ResponsePlot(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    auto *column = layoutIn<QVBoxLayout>(this);
    m_stack = new PlotStack(theme, this);
    m_stack->setObjectName(QStringLiteral("responseStack"));
    m_stack->view().setLive(false);
    m_stack->readings().setCursorValues(true);
    column->addWidget(m_stack);
    m_stack->exporter().setDressing([this](bool dressed) { showHead(dressed || m_hasHead); });
}

void ResponsePlot::setHead(bool shown)
{
    m_hasHead = shown;
    showHead(shown);
}

void ResponsePlot::showHead(bool shown)
{
    if (m_stack->strips().all().empty())
        return;
    StripStyle style = m_stack->strips().at(0).style;
    style.legend = shown;
    m_stack->strips().setStrip(0, style);
}

void ResponsePlot::setTrials(const Family *family, const KeptTrial *a, const KeptTrial *b, const DisplayUnits &units)
{
    m_stack->strips().clear();
    m_legend.clear();
    m_length = 0.0;
    m_isWithoutReturn = comeBackApart(a, b);
    m_drawnStrips = strips();
    const Side sideA{a, QStringLiteral("A"), false};
    const Side sideB{b, QStringLiteral("B"), true};
    const KeptTrial *const leading = b ? b : a;
    m_stack->setStateText(QStringLiteral(" "));
    if (!family || !leading) {
        m_stack->setFootNote({});
        m_stack->refresh(0.0);
        return;
    }
    const Trial &trial = leading->trial;
    const std::string_view measured = tuning::measuredOf(trial.mode);
    int strip = 0;
    for (const std::string_view channel : {measured, std::string_view("duty"), std::string_view("current")}) {
        if (strip > 0 && channel == measured)
            continue;
        if (strip >= m_drawnStrips)
            continue; // better one less than all of them flat
        const bool there = (a && channelOf(*family, a->trial, channel)) || (b && channelOf(*family, b->trial, channel));
        if (!there)
            continue;
        add(*family, sideA, channel, strip, units);
        add(*family, sideB, channel, strip, units);
        addLimits(trial, strip, channel);
        ++strip;
    }
    for (int i = 0; i < strip; ++i)
        m_stack->strips().setStrip(i, {{}, i == 0 ? 4.0 : 1.0, i == 0 && m_hasHead});
    fitStrips();
    const ShownUnit unit = shownUnit(trial.mode == Mode::Duty ? Mode::Velocity : trial.mode, units);
    if (trial.mode != Mode::Duty)
        addSetPoint(trial, unit, m_length);
    addMarks(sideA, sideB, unit);
    addSpans(sideA, sideB);
    m_stack->strips().setWatermark(trial.simulated ? tr("DEMO") : QString());
    m_stack->setFootNote(footNoteOf(trial));
    m_stack->view().setRange(-std::min(beforeEdge, 0.1 * m_length), std::max(m_length, 0.05));
    m_stack->refresh(0.0);
    setAccessibleName(tr("Responses"));
    setAccessibleDescription(summary());
}

QString ResponsePlot::footNoteOf(const Trial &trial)
{
    if (trial.repeat > 1)
        return tr("t = 0 at the edge, mean of %1 · %2 samples, %3 lost")
            .arg(trial.repeat)
            .arg(trial.samples)
            .arg(trial.lost);
    return tr("t = 0 at the edge · %1 samples, %2 lost").arg(trial.samples).arg(trial.lost);
}

void ResponsePlot::add(
    const Family &family, const Side &side, std::string_view channel, int strip, const DisplayUnits &units)
{
    const Channel *const row = side.kept ? channelOf(family, side.kept->trial, channel) : nullptr;
    if (!row)
        return;
    const Trial &trial = side.kept->trial;
    const ShownUnit unit = shownUnit(row->quantity, trial.signal(channel)->unit, units);
    Trace trace = trial.folded(channel);
    if (m_isWithoutReturn && !trace.isEmpty() && holdOf(trial) > 0.0)
        trace = trace.part(trace.t.front(), holdOf(trial));
    if (!trace.isEmpty())
        m_length = std::max(m_length, trace.t.back());
    TraceStyle style;
    style.name = strip == 0 ? tr("%1 #%2").arg(side.letter).arg(side.kept->number) : tableText(row->label);
    style.unit = unit.text;
    style.role = roleOf(row->quantity);
    style.strip = strip;
    style.dash = side.current ? TraceDash::Solid : TraceDash::Long;
    style.marker = side.current ? TraceMarker::Automatic : TraceMarker::HollowSquare;
    style.emphasis = side.current && strip == 0;
    style.valueTag = false; // where a response ends says nothing of it
    addLine(style, pointsOf(trace, unit.scale));
}

void ResponsePlot::addLine(const TraceStyle &style, std::vector<PlotPoint> points)
{
    if (style.strip == 0)
        m_legend.push_back({style.name, style.look()});
    m_stack->strips().addTrace(style, std::make_shared<FixedTrace>(std::move(points)));
}

void ResponsePlot::fitStrips()
{
    const int least = std::max(m_theme.theme().u(lowestStrip), static_cast<int>(stripShare * height()));
    for (std::size_t i = 1; i < m_stack->strips().all().size(); ++i)
        m_stack->strips().all()[i]->rect().setMinimumSize(50, least);
}

void ResponsePlot::addSetPoint(const Trial &trial, const ShownUnit &unit, double length)
{
    const bool steps = !trial.stimulus.edges().empty();
    const double hold = steps ? holdOf(trial) : trial.stimulus.length();
    std::vector<PlotPoint> points{{-beforeEdge, trial.stimulus.from * unit.scale}};
    if (trial.stimulus.profile == tuning::Profile::Step || trial.stimulus.profile == tuning::Profile::Square) {
        for (const auto &[t, value] : {std::pair(0.0, trial.stimulus.from), std::pair(0.0, trial.stimulus.to),
                 std::pair(m_isWithoutReturn ? length : hold, trial.stimulus.to)})
            points.push_back({t, value * unit.scale});
        if (!m_isWithoutReturn)
            points.push_back({hold, trial.stimulus.from * unit.scale});
    } else {
        const double fine = std::max(hold / 2000.0, 0.001);
        for (double t = 0.0; t < hold; t += fine)
            points.push_back({t, trial.stimulus.at(t) * unit.scale});
    }
    if (!m_isWithoutReturn)
        points.push_back({std::max(length, hold), trial.stimulus.from * unit.scale});
    TraceStyle style;
    style.name = tr("set-point");
    style.unit = unit.text;
    style.role = TraceRole::Setpoint;
    addLine(style, std::move(points));
}

void ResponsePlot::addMarks(const Side &a, const Side &b, const ShownUnit &unit)
{
    const Trial &trial = (b.kept ? b.kept : a.kept)->trial;
    const bool steps = !trial.stimulus.edges().empty() && trial.mode != Mode::Duty;
    std::vector<PlotNote> notes;
    std::vector<PlotBand> bands;
    if (steps) {
        const double target = trial.stimulus.to * unit.scale;
        const double half = std::abs(trial.stimulus.to - trial.stimulus.from) * unit.scale * band;
        bands.push_back({target - half, target + half, m_drawnStrips > 1 ? tr("±2 % band") : QString(), Tone::Ok});
    }
    for (const Side &side : {a, b}) {
        if (!side.kept || !steps || m_drawnStrips < 2) // a low plot has room for curves only
            continue;
        const tuning::Metrics &metrics = side.kept->trial.metrics;
        if (const auto peak = peakOf(side.kept->trial))
            notes.push_back({peak->key, peak->value * unit.scale,
                tr("%1 peak %2 %").arg(side.letter, formatDifference(*metrics.overshoot * 100.0, 1)),
                {14, side.current ? -10.0 : -16.0}, side.current});
        if (metrics.settle)
            notes.push_back({*metrics.settle, side.kept->trial.stimulus.to * unit.scale,
                tr("%1 settles %2").arg(side.letter, formatDuration(*metrics.settle)), {10, side.current ? 40.0 : 22.0},
                side.current});
    }
    m_stack->strips().annotate<PlotBand>(0, bands);
    m_stack->strips().annotate<PlotNote>(0, notes);
    const auto settleOf = [](const Side &side) { return side.kept ? side.kept->trial.metrics.settle : std::nullopt; };
    if (settleOf(a) && settleOf(b) && !m_stack->cursorsShown())
        m_stack->setCursorKeys(*settleOf(a), *settleOf(b));
}

/// Where the duty, or the current, was at its limit.
void ResponsePlot::addSpans(const Side &a, const Side &b)
{
    std::vector<PlotSpan> spans;
    for (const Side &side : {a, b}) {
        if (!side.kept)
            continue;
        const Trial &trial = side.kept->trial;
        const double duty = trial.envelope.duty.value_or(1.0);
        for (const auto &[from, to] : stretchesAt(trial.folded("duty"), nearLimit * duty))
            spans.push_back({from, to,
                tr("%1: duty at %2 % limit, %3")
                    .arg(side.letter, formatNumber(duty * 100.0), formatDuration(to - from)),
                TraceRole::Duty});
        if (!trial.envelope.current)
            continue;
        for (const auto &[from, to] : stretchesAt(trial.folded("current"), nearLimit * *trial.envelope.current))
            spans.push_back({from, to, tr("%1: current at its limit, %2").arg(side.letter, formatDuration(to - from)),
                TraceRole::Current});
    }
    m_stack->strips().annotate<PlotSpan>(0, spans);
}

void ResponsePlot::addLimits(const Trial &trial, int strip, std::string_view channel)
{
    const bool duty = channel == "duty";
    const auto limit = duty ? trial.envelope.duty : channel == "current" ? trial.envelope.current : std::nullopt;
    if (!limit || strip == 0)
        return;
    const double shown = *limit * (duty ? 100.0 : 1.0);
    const QString text = duty ? tr("limit %1 %").arg(formatNumber(shown)) : tr("limit %1 A").arg(formatNumber(shown));
    m_stack->strips().annotate<PlotLimit>(strip, {{shown, text, duty ? TraceRole::Duty : TraceRole::Current}});
}

int ResponsePlot::strips() const
{
    const Theme &theme = m_theme.theme();
    return height() < theme.u(roomForTwo) ? 1 : height() < theme.u(roomForThree) ? 2 : 3;
}

void ResponsePlot::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    fitStrips();
    if (strips() != m_drawnStrips)
        Q_EMIT roomChanged();
}

QString ResponsePlot::summary() const
{
    return m_stack->readings().summary();
}

} // namespace mb
