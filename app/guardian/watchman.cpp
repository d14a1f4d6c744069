// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/guardian/watchman.h"

#include <algorithm>
#include <utility>

namespace mb::guardian {

Watchman::Watchman(Port &port, Voice voice)
    : m_port(port)
    , m_runner(port)
    , m_voice(std::move(voice))
{
}

void Watchman::hear(std::span<const std::uint8_t> packet, Time now)
{
    m_heardAt = now;
    m_silent = false;
    if (const auto order = decodeOrder(packet))
        obey(*order, now);
    else
        m_voice.report({Report::Kind::Refused, 0, false, false});
}

void Watchman::obey(const Order &order, Time now)
{
    switch (order.kind) {
    case Order::Kind::Watch:
        if (m_stopping.count(order.id) > 0 || m_owed.count(order.id) > 0) { // an id is used once
            m_voice.report({Report::Kind::Refused, order.id, false, false});
            break;
        }
        m_watched[order.id] = {order.name, order.script};
        m_port.keepSetup();
        m_voice.report({Report::Kind::Standing, order.id, false, false});
        break;
    case Order::Kind::Renew:
        if (m_watched.count(order.id) > 0) {
            m_port.keepSetup();
            m_voice.report({Report::Kind::Standing, order.id, false, false});
        }
        break;
    case Order::Kind::Forget: m_watched.erase(order.id); break;
    case Order::Kind::Stop: stop(order.id, "a stop without confirmation", now); break;
    }
}

void Watchman::hangUp(Time now)
{
    m_hungUp = true;
    m_silent = false;
    stopAll("the program that drove it ended", now);
}

void Watchman::proceed(Time now)
{
    if (!m_watched.empty() && now - m_heardAt >= silenceLimit) {
        m_silent = true;
        stopAll("the program that drove it fell silent", now);
    }
    for (const Runner::Outcome &outcome : m_runner.proceed(now))
        ended(outcome, now);
    dropOldDebts(now);
}

void Watchman::ended(const Runner::Outcome &outcome, Time now)
{
    m_isCut = !outcome.sent;
    if (const auto owed = m_owed.find(outcome.id); owed != m_owed.end()) {
        if (!outcome.confirmed)
            return;
        m_voice.log("stopped at last " + owed->second.name + owed->second.cause);
        if (m_voice.debt)
            m_voice.debt(owed->second, false);
        m_owed.erase(owed);
        return;
    }
    Owed stopped = std::exchange(m_stopping[outcome.id], {});
    m_stopping.erase(outcome.id);
    m_voice.log((outcome.proved             ? "stopped "
                        : outcome.confirmed ? "sent the stop, NOT CONFIRMED, look whether it stands: "
                                            : "TRIED IN VAIN to stop, cut its power: ")
        + stopped.name + stopped.cause);
    m_voice.report({Report::Kind::Acted, outcome.id, outcome.confirmed, outcome.proved});
    stopped.since = now;
    if (m_voice.debt
        && outcome.confirmed == outcome.proved) // what is only sent stays owed where its program wrote it down
        m_voice.debt(stopped, !outcome.confirmed);
    if (!outcome.confirmed)
        m_owed[outcome.id] = std::move(stopped);
}

void Watchman::dropOldDebts(Time now)
{
    if (!m_runner.isIdle())
        return;
    std::erase_if(m_owed, [&](const auto &entry) {
        const Owed &owed = entry.second;
        const bool isOld = now - owed.since >= debtLimit;
        if (isOld) // and it stays written down
            m_voice.log("GAVE UP after ten minutes, cut its power: " + owed.name + owed.cause);
        return isOld;
    });
}

void Watchman::pay(Time now)
{
    for (const auto &[id, owed] : m_owed)
        m_runner.add(id, owed.script, now, Time::zero());
}

void Watchman::tellDebts() const
{
    for (const auto &[id, owed] : m_owed)
        m_voice.debt(owed, true);
}

void Watchman::settle(const std::function<bool(const Owed &)> &isSettled)
{
    if (m_runner.isIdle())
        std::erase_if(m_owed, [&isSettled](const auto &entry) { return isSettled(entry.second); });
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
    m_stopping[id] = {watched->second.name, watched->second.script, std::string(" (") + why + ")", now};
    m_runner.add(id, watched->second.script, now);
    m_watched.erase(watched);
}

void Watchman::stopAll(const char *why, Time now)
{
    while (!m_watched.empty())
        stop(m_watched.begin()->first, why, now);
}

} // namespace mb::guardian
