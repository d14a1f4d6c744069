// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/derivedsignal.h"

#include <limits>

namespace mb {

DerivedSignal::DerivedSignal(
    std::string label, std::string unit, Expression expression, const std::vector<Input> &inputs)
    : m_label(std::move(label))
    , m_unit(std::move(unit))
    , m_expression(std::move(expression))
    , m_table{Channel{"derived", m_unit, m_label, Quantity::Other}}
    , m_telemetry(std::make_shared<Telemetry>(m_table))
    , m_values(inputs.size())
{
    for (const Input &input : inputs)
        m_sources.push_back({SampleCursor(input.telemetry, input.channel), 0.0, false});
}

DerivedSignal::~DerivedSignal() = default;

/// Takes everything up to `time`; a gap that is open there leaves no value.
void DerivedSignal::follow(Source &source, Instant time)
{
    for (const Point *next = source.cursor.peek(); next; next = source.cursor.peek()) {
        if (next->isGap() ? next->time >= time : next->time > time)
            return;
        source.known = !next->isGap();
        source.value = next->value;
        source.cursor.pop();
    }
}

std::size_t DerivedSignal::advance(std::size_t most)
{
    SampleCursor &base = m_sources.front().cursor;
    // One look at the others for the whole batch: what they have is what can be computed.
    std::size_t done = 0;
    Instant reached = Instant::max();
    for (std::size_t i = 1; i < m_sources.size(); ++i) {
        const SampleCursor &cursor = m_sources[i].cursor;
        const auto last = cursor.telemetry().last(cursor.channel());
        reached = std::min(reached, last ? last->time : Instant::min());
    }
    for (const Point *next = base.peek(reached); next && done < most; next = base.peek(reached), ++done) {
        if (next->isGap()) {
            m_expression.restart();
            m_telemetry->breakLine({0});
            base.pop();
            continue;
        }
        const Point sample = *next;
        base.pop();
        m_values[0] = sample.value;
        for (std::size_t i = 1; i < m_sources.size(); ++i) {
            follow(m_sources[i], sample.time);
            m_values[i] = m_sources[i].known ? m_sources[i].value : std::numeric_limits<double>::quiet_NaN();
        }
        const double seconds = std::chrono::duration<double>(sample.time.time_since_epoch()).count();
        const double value = m_expression.evaluate(seconds, m_values);
        if (std::isnan(value))
            m_telemetry->breakLine({0});
        else
            m_telemetry->append({{0}, sample.time, value});
    }
    m_telemetry->commit();
    return done;
}

} // namespace mb
