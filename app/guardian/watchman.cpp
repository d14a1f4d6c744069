// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/guardian/watchman.h"

#include <algorithm>
#include <utility>

namespace mb::guardian {

Watchman::Watchman(Port &port, Voice voice)
    : m_runner(port)
    , m_voice(std::move(voice))
{
}

void Watchman::hear(std::span<const std::uint8_t> packet, Time now)
{
    m_heardAt = now;
    if (const auto order = decodeOrder(packet))
        obey(*order, now);
    else
        m_voice.report({Report::Kind::Refused, 0, false});
}

void Watchman::obey(const Order &order, Time now)
{
    switch (order.kind) {
    case Order::Kind::Watch:
        if (m_stopping.count(order.id) > 0) { // an id is used once
            m_voice.report({Report::Kind::Refused, order.id, false});
            break;
        }
        m_watched[order.id] = {order.name, order.script};
        m_voice.report({Report::Kind::Standing, order.id, false});
        break;
    case Order::Kind::Renew:
        if (m_watched.count(order.id) > 0)
            m_voice.report({Report::Kind::Standing, order.id, false});
        break;
    case Order::Kind::Forget: m_watched.erase(order.id); break;
    case Order::Kind::Stop: stop(order.id, "a stop without confirmation", now); break;
    }
}

void Watchman::hangUp(Time now)
{
    m_hungUp = true;
    stopAll("the program that drove it ended", now);
}

void Watchman::proceed(Time now)
{
    if (!m_watched.empty() && now - m_heardAt >= silenceLimit)
        stopAll("the program that drove it fell silent", now);
    for (const Runner::Outcome &outcome : m_runner.proceed(now)) {
        const std::string what = std::exchange(m_stopping[outcome.id], {});
        m_voice.log((outcome.confirmed ? "stopped " : "TRIED IN VAIN to stop, cut its power: ") + what);
        m_stopping.erase(outcome.id);
        m_voice.report({Report::Kind::Acted, outcome.id, outcome.confirmed});
    }
}

std::optional<Time> Watchman::due() const
{
    const auto next = m_runner.due();
    if (m_watched.empty())
        return next;
    const Time silent = m_heardAt + silenceLimit;
    return next ? std::min(*next, silent) : silent;
}

void Watchman::stop(std::uint32_t id, const char *why, Time now)
{
    const auto watched = m_watched.find(id);
    if (watched == m_watched.end())
        return;
    m_stopping[id] = watched->second.name + " (" + why + ")";
    m_runner.add(id, watched->second.script, now);
    m_watched.erase(watched);
}

void Watchman::stopAll(const char *why, Time now)
{
    while (!m_watched.empty())
        stop(m_watched.begin()->first, why, now);
}

} // namespace mb::guardian
