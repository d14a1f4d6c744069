// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/trace.h"

#include <algorithm>

namespace mb::tuning {

Trace Trace::part(double from, double to, double zero) const
{
    Trace found;
    const auto begin = std::lower_bound(t.begin(), t.end(), from);
    for (auto at = static_cast<std::size_t>(begin - t.begin()); at < t.size() && t[at] <= to; ++at)
        found.add(t[at] - zero, y[at]);
    return found;
}

double median(std::vector<double> values)
{
    if (values.empty())
        return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1)
        return *middle;
    return (*middle + *std::max_element(values.begin(), middle)) / 2.0;
}

double samplePeriod(const Trace &trace)
{
    std::vector<double> steps;
    for (std::size_t i = 1; i < trace.size(); ++i)
        steps.push_back(trace.t[i] - trace.t[i - 1]);
    return median(std::move(steps));
}

Trace thinned(const Trace &trace, std::size_t most)
{
    if (trace.size() <= most)
        return trace;
    Trace few;
    const double step = static_cast<double>(trace.size()) / static_cast<double>(most);
    for (double at = 0.0; at < static_cast<double>(trace.size()); at += step)
        few.add(trace.t[static_cast<std::size_t>(at)], trace.y[static_cast<std::size_t>(at)]);
    return few;
}

double valueAt(const Trace &trace, double time)
{
    const auto above = std::upper_bound(trace.t.begin(), trace.t.end(), time);
    if (above == trace.t.begin())
        return trace.y.front();
    if (above == trace.t.end())
        return trace.y.back();
    const auto i = static_cast<std::size_t>(above - trace.t.begin());
    const double share = (time - trace.t[i - 1]) / (trace.t[i] - trace.t[i - 1]);
    return trace.y[i - 1] + share * (trace.y[i] - trace.y[i - 1]);
}

} // namespace mb::tuning
