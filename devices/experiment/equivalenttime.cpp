// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/equivalenttime.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace mb::tuning {

double ditherOf(int index, int count, double period)
{
    return count > 0 ? period * (index % count) / count : 0.0;
}

Trace merged(const std::vector<Trace> &runs)
{
    if (runs.size() == 1)
        return runs.front();
    Trace all;
    for (const Trace &run : runs) {
        all.t.insert(all.t.end(), run.t.begin(), run.t.end());
        all.y.insert(all.y.end(), run.y.begin(), run.y.end());
    }
    std::vector<std::size_t> order(all.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [&all](std::size_t a, std::size_t b) { return all.t[a] < all.t[b]; });
    Trace sorted;
    for (const std::size_t at : order)
        sorted.add(all.t[at], all.y[at]);
    return sorted;
}

Trace averaged(const std::vector<Trace> &runs)
{
    std::vector<Trace> heard;
    std::copy_if(runs.begin(), runs.end(), std::back_inserter(heard), [](const Trace &run) { return !run.isEmpty(); });
    Trace mean = merged(heard);
    if (heard.size() < 2)
        return mean;
    for (std::size_t i = 0; i < mean.size(); ++i) {
        double sum = 0.0;
        for (const Trace &run : heard)
            sum += valueAt(run, mean.t[i]);
        mean.y[i] = sum / static_cast<double>(heard.size());
    }
    return mean;
}

Trace meanOf(const std::vector<Trace> &runs, double period, double share)
{
    const Trace all = merged(runs);
    Trace mean;
    for (std::size_t i = 0; i < all.size();) {
        const double end = all.t[i] + std::max(period, share * all.t[i]);
        double t = 0.0;
        double y = 0.0;
        const std::size_t from = i;
        for (; i < all.size() && (all.t[i] < end || i == from); ++i) {
            t += all.t[i];
            y += all.y[i];
        }
        const auto count = static_cast<double>(i - from);
        mean.add(t / count, y / count);
    }
    return mean;
}

} // namespace mb::tuning
