// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/trigger.h"

namespace mb {
namespace {

Instant crossing(const Point &before, const Point &after, double level)
{
    const double rise = after.value - before.value;
    const double part = rise != 0.0 ? (level - before.value) / rise : 1.0;
    const auto span = static_cast<double>((after.time - before.time).count());
    return before.time + Duration(static_cast<std::int64_t>(span * part));
}

} // namespace

std::optional<Instant> TriggerScanner::edge(const Point &point, bool rising)
{
    // Downwards is upwards with all signs turned.
    const double sign = rising ? 1.0 : -1.0;
    bool &ready = rising ? m_readyUp : m_readyDown;
    const double level = sign * m_rule.level;
    const double value = sign * point.value;
    const bool fires = ready && m_last && value >= level;
    const auto fired = fires
        ? std::optional(sign * m_last->value < level ? crossing(*m_last, point, m_rule.level) : point.time)
        : std::nullopt;
    if (value >= level)
        ready = false;
    else if (m_rule.hysteresis > 0.0 ? value <= level - m_rule.hysteresis : value < level)
        ready = true;
    return fired;
}

std::optional<Instant> TriggerScanner::feed(const Point &point)
{
    if (point.isGap()) {
        m_last.reset();
        m_readyUp = m_readyDown = false;
        return std::nullopt;
    }
    std::optional<Instant> fired;
    using Kind = TriggerRule::Kind;
    const Kind kind = m_rule.kind;
    if (kind == Kind::Above || kind == Kind::Below) {
        if (kind == Kind::Above ? point.value > m_rule.level : point.value < m_rule.level)
            fired = point.time;
    } else {
        if (kind == Kind::Rising || kind == Kind::Either)
            fired = edge(point, true);
        if (kind == Kind::Falling || kind == Kind::Either) {
            const auto down = edge(point, false);
            fired = fired ? fired : down;
        }
    }
    m_last = point;
    return fired;
}

TriggerSearch::TriggerSearch(
    const TriggerRule &rule, std::shared_ptr<const Telemetry> telemetry, ChannelIndex channel, Instant from)
    : m_scanner(rule)
    , m_cursor(std::move(telemetry), channel, from)
{
}

std::optional<Instant> TriggerSearch::poll(Instant notBefore, std::size_t most)
{
    for (std::size_t i = 0; i < most; ++i) {
        const Point *next = m_cursor.peek();
        if (!next)
            return std::nullopt;
        const auto fired = m_scanner.feed(*next);
        m_cursor.pop();
        if (fired && *fired >= notBefore)
            return fired;
    }
    return std::nullopt;
}

} // namespace mb
