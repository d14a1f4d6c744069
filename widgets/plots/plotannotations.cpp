// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotstack.h"

namespace mb {

void PlotStack::setClock(std::optional<double> unixAtZero)
{
    m_unixAtZero = unixAtZero;
    m_timeTicker->setClock(unixAtZero);
    restyle();
}

void PlotStack::setFootNote(const QString &text)
{
    m_footNote = text;
    touch();
}

void PlotStack::setWatermark(const QString &text)
{
    m_watermark = text;
    updateHeads();
    touch();
}

void PlotStack::setLimits(int strip, std::vector<PlotLimit> limits)
{
    ensureStrip(strip);
    m_strips.at(static_cast<std::size_t>(strip))->decor.limits = std::move(limits);
    touch();
}

void PlotStack::setBands(int strip, std::vector<PlotBand> bands)
{
    ensureStrip(strip);
    m_strips.at(static_cast<std::size_t>(strip))->decor.bands = std::move(bands);
    touch();
}

void PlotStack::setSpans(int strip, std::vector<PlotSpan> spans)
{
    ensureStrip(strip);
    m_strips.at(static_cast<std::size_t>(strip))->decor.spans = std::move(spans);
    touch();
}

void PlotStack::setNotes(int strip, std::vector<PlotNote> notes)
{
    ensureStrip(strip);
    m_strips.at(static_cast<std::size_t>(strip))->decor.notes = std::move(notes);
    updateHeads();
    touch();
}

void PlotStack::setMarks(std::vector<PlotMark> marks)
{
    m_marks = std::move(marks);
    updateHeads();
    touch();
}

void PlotStack::setTrigger(const std::optional<PlotTrigger> &trigger)
{
    m_trigger = trigger;
    for (const auto &strip : m_strips)
        strip->decor.trigger.reset();
    const TraceStyle *of = trigger ? style(trigger->trace) : nullptr;
    if (of)
        m_strips.at(static_cast<std::size_t>(of->strip))->decor.trigger
            = TriggerLine{trigger->level, trigger->text, of->secondAxis};
    touch();
}

std::optional<double> PlotStack::middleOf(int trace) const
{
    const auto found = m_traces.find(trace);
    if (found == m_traces.end())
        return {};
    const auto values = valueRange(found->second.plottable->points(), m_from, m_to);
    return values ? std::optional((values->first + values->second) / 2) : std::nullopt;
}

void PlotStack::setStateText(const QString &text)
{
    if (text == m_stateText)
        return;
    m_stateText = text;
    touch();
}

void PlotStack::hold(std::optional<double> key, double before)
{
    if (key == m_held && before == m_heldBefore)
        return;
    m_held = key;
    m_heldBefore = before;
    touch();
}

void PlotStack::acceptDrops(const QString &mimeType)
{
    m_dropType = mimeType;
    setAcceptDrops(true);
}

} // namespace mb
