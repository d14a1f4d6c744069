// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/trial.h"

#include "experiment/equivalenttime.h"

#include <algorithm>

namespace mb::tuning {
namespace {

constexpr double beforeEdge = 0.1; ///< s

double shortest(const std::vector<Span> &spans)
{
    double least = spans.front().to - spans.front().from;
    for (const Span &span : spans)
        least = std::min(least, span.to - span.from);
    return least;
}

/// The mean of stretches of a signal, one over the other, from `lead` before their beginning until `length` after it.
Trace over(const Trace &trace, const std::vector<Span> &spans, double lead, double length)
{
    std::vector<Trace> runs;
    for (const Span &span : spans)
        runs.push_back(trace.part(span.from - lead, span.from + length, span.from));
    return averaged(runs);
}

} // namespace

bool Trial::has(std::string_view flag) const
{
    return std::ranges::find(flags, flag) != flags.end();
}

const Signal *Trial::signal(std::string_view key) const
{
    const auto found = std::ranges::find_if(signals, [key](const Signal &signal) {
        return signal.channel == key || (signal.channel.ends_with(key) && signal.channel.starts_with("ch"));
    });
    return found == signals.end() ? nullptr : &*found;
}

Trace Trial::folded(std::string_view key) const
{
    const Signal *const found = signal(key);
    if (!found)
        return {};
    if (holds.empty() || stimulus.edges().empty())
        return found->trace;
    const double hold = shortest(holds);
    Trace trace = over(found->trace, holds, beforeEdge, hold);
    if (returns.empty())
        return trace;
    const Trace back = over(found->trace, returns, 0.0, shortest(returns));
    for (std::size_t i = 0; i < back.size(); ++i)
        trace.add(back.t[i] + hold, back.y[i]);
    return trace;
}

} // namespace mb::tuning
