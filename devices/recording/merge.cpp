// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/merge.h"

#include <utility>

namespace mb {

MergedSamples::MergedSamples(const ExportPlan &plan)
    : m_to(plan.to)
    , m_sleeps(plan.clock.sleeps)
{
    for (const ExportChannel &channel : plan.channels) {
        m_sources.push_back({SampleCursor(channel.telemetry, channel.channel, plan.from),
            channel.telemetry->gaps(channel.channel, plan.from, plan.to), 0, std::nullopt, false});
        load(m_sources.back());
    }
}

void MergedSamples::load(Source &source)
{
    source.waiting.reset();
    source.broken = false;
    const Point *next = source.cursor.peek(m_to);
    if (next && next->isGap()) {
        source.broken = true;
        source.cursor.pop();
        next = source.cursor.peek(m_to);
    }
    if (!next)
        return;
    source.waiting = *next;
    const Duration slept = m_sleeps.sleptAt(next->time);
    source.broken = source.broken || std::exchange(source.slept, slept).value_or(slept) != slept;
    source.cursor.pop();
}

std::optional<MergedSamples::Next> MergedSamples::next()
{
    Source *earliest = nullptr;
    for (Source &source : m_sources) {
        if (source.waiting && (!earliest || source.waiting->time < earliest->waiting->time))
            earliest = &source;
    }
    if (!earliest)
        return std::nullopt;
    Next found{static_cast<std::size_t>(earliest - m_sources.data()), *earliest->waiting, earliest->broken, 0};
    if (found.gap) {
        while (earliest->gap < earliest->gaps.size() && earliest->gaps[earliest->gap].to < found.point.time)
            ++earliest->gap;
        if (earliest->gap < earliest->gaps.size() && earliest->gaps[earliest->gap].to == found.point.time)
            found.lost = earliest->gaps[earliest->gap++].lost;
    }
    load(*earliest);
    return found;
}

} // namespace mb
