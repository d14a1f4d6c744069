// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace mb::tuning {

/// Samples of one signal: seconds, ascending, and values in its unit. Never resampled.
struct Trace {
    std::vector<double> t;
    std::vector<double> y;

    [[nodiscard]] std::size_t size() const { return t.size(); }
    [[nodiscard]] bool isEmpty() const { return t.empty(); }
    void add(double time, double value)
    {
        t.push_back(time);
        y.push_back(value);
    }
    /// The samples in [from, to], with `from` as their new zero if it is told.
    [[nodiscard]] Trace part(double from, double to, double zero = 0.0) const;
    friend bool operator==(const Trace &, const Trace &) = default;
};

/// 0 for none.
[[nodiscard]] double median(std::vector<double> values);
/// Median step of time; 0 for fewer than two samples.
[[nodiscard]] double samplePeriod(const Trace &trace);
/// At most about so many of its samples, from all of it.
[[nodiscard]] Trace thinned(const Trace &trace, std::size_t most);
/// The value at a time between samples; the first or last beyond them. Not for an empty trace.
[[nodiscard]] double valueAt(const Trace &trace, double time);

} // namespace mb::tuning
