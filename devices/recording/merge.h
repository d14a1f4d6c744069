// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/export.h"
#include "recording/samplecursor.h"

namespace mb {

/// The samples of all channels of a plan in order of time.
class MergedSamples {
public:
    struct Next {
        std::size_t channel = 0;
        Point point;
        bool gap = false;       ///< does not connect to the one before
        std::uint64_t lost = 0; ///< known missing before it
    };
    explicit MergedSamples(const ExportPlan &plan);
    /// Nothing at the end.
    [[nodiscard]] std::optional<Next> next();

private:
    struct Source {
        SampleCursor cursor;
        std::vector<History::Gap> gaps;
        std::size_t gap = 0;
        std::optional<Point> waiting;
        bool broken = false;
        std::optional<Duration> slept{}; ///< by the time of the sample that waits
    };
    void load(Source &source);

    Instant m_to;
    SleepLog m_sleeps;
    std::vector<Source> m_sources;
};

} // namespace mb
