// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/autorange.h"

#include <algorithm>
#include <cmath>

namespace mb {
namespace {

constexpr double ShrinkBelow = 0.6; ///< of the present span
constexpr double ShrinkAfter = 2.0; ///< seconds

} // namespace

double roundStep(double rough)
{
    const double decade = std::pow(10.0, std::floor(std::log10(rough)));
    const double mantissa = rough / decade * (1 + 1e-12);
    return decade * (mantissa >= 5 ? 5 : mantissa >= 2 ? 2 : 1);
}

double leastSpan(TraceRole role, double magnitude)
{
    constexpr double noise = 0.01; // of a value, where a hundredth of it is what the sensor makes by itself
    switch (role) {
    case TraceRole::Position: return 4.0; // a step is a step, wherever it is
    case TraceRole::Velocity: return std::max(1.0, noise * std::abs(magnitude));
    case TraceRole::Current: return std::max(0.1, noise * std::abs(magnitude));
    case TraceRole::Duty: return 1.0; // %
    case TraceRole::Temperature: return 1.0;
    default: return 0.0;
    }
}

AutoRange::Range AutoRange::fitted(double lowest, double highest, double least)
{
    double low = std::min(lowest, highest);
    double high = std::max(lowest, highest);
    // A constant still needs a span: 10 % of its size, and never less than what a double resolves well.
    const double constant = std::max({std::abs(low), std::abs(high), 1e-3}) * 0.1;
    if (least <= 0 && high - low < constant * 1e-3) {
        low -= constant;
        high += constant;
    }
    if (const double missing = least - (high - low); missing > 0) {
        low -= missing / 2;
        high += missing / 2;
    }
    // Zero belongs into the picture when it is near.
    const double span = high - low;
    if (low > 0 && low < span * 0.6)
        low = 0;
    if (high < 0 && -high < span * 0.6)
        high = 0;
    const double room = (high - low) * 0.06;
    const double step = roundStep((high - low) / 8);
    return {std::floor((low - room) / step) * step, std::ceil((high + room) / step) * step};
}

AutoRange::Range AutoRange::update(double lowest, double highest, double now, double least)
{
    const Range fit = fitted(lowest, highest, least);
    if (!m_set) {
        m_set = true;
        return m_range = fit;
    }
    const double span = m_range.upper - m_range.lower;
    if (lowest < m_range.lower || highest > m_range.upper) {
        m_looseSince.reset();
        return m_range = {std::min(fit.lower, m_range.lower), std::max(fit.upper, m_range.upper)};
    }
    if (fit.upper - fit.lower >= span * ShrinkBelow) {
        m_looseSince.reset();
        return m_range;
    }
    m_looseSince = std::min(m_looseSince.value_or(now), now);
    if (now - *m_looseSince >= ShrinkAfter) {
        m_looseSince.reset();
        m_range = fit;
    }
    return m_range;
}

void AutoRange::reset()
{
    m_set = false;
    m_looseSince.reset();
}

} // namespace mb
