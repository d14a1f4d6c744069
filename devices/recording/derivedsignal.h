// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "recording/expression.h"
#include "recording/samplecursor.h"

namespace mb {

/// A signal that is computed from recorded ones and recorded itself, so that it can be plotted, triggered on and
/// exported like them. It has a value for each sample of the first signal of its formula; of the others it takes the last
/// sample at or before that time. Where one of them has a gap it has one, too. One thread computes, any may read.
class DerivedSignal : NonCopyable {
public:
    struct Input {
        std::shared_ptr<const Telemetry> telemetry;
        ChannelIndex channel;
    };
    /// `inputs`: those of expression.used(), in its order; `label` and `unit` as people shall see them.
    DerivedSignal(std::string label, std::string unit, Expression expression, const std::vector<Input> &inputs);
    ~DerivedSignal();

    /// Computes what has been recorded since, at most `most` samples; how many it was.
    std::size_t advance(std::size_t most);
    /// One channel, index 0.
    [[nodiscard]] const std::shared_ptr<Telemetry> &telemetry() const { return m_telemetry; }
    /// What it is computed from, by the place of the input.
    [[nodiscard]] const Telemetry &input(std::size_t place) const { return m_sources.at(place).cursor.telemetry(); }
    [[nodiscard]] const std::string &label() const { return m_label; }
    [[nodiscard]] const std::string &unit() const { return m_unit; }

private:
    struct Source {
        SampleCursor cursor;
        double value = 0.0;
        bool known = false;
    };
    static void follow(Source &source, Instant time);

    std::string m_label;
    std::string m_unit;
    Expression m_expression;
    std::vector<Channel> m_table;
    std::shared_ptr<Telemetry> m_telemetry;
    std::vector<Source> m_sources;
    std::vector<double> m_values;
};

} // namespace mb
