// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/orderqueue.h"

#include <algorithm>
#include <utility>

namespace mb::quadquad2drv {
namespace {

constexpr int orderTries = 3;

} // namespace

OrderQueue::OrderQueue(Clock &clock, PacketPort &port, BoardLayout &layout, std::function<void()> failed)
    : m_port(port)
    , m_layout(layout)
    , m_failed(std::move(failed))
    , m_scope(clock)
{
}

void OrderQueue::post(Bytes request, std::function<void()> accepted)
{
    const auto replaces = [&request](const Bytes &other) {
        return other.size() == request.size() && std::equal(other.begin(), other.begin() + 4, request.begin());
    };
    if (m_orders.size() > 1 && replaces(m_orders.back().request))
        m_orders.pop_back();
    m_orders.push_back({std::move(request), std::move(accepted)});
    m_layout.noteChange();
    if (!m_working)
        begin();
}

void OrderQueue::learn()
{
    if (m_layout.tellsEverything() || std::exchange(m_learning, true))
        return;
    m_scope.spawn<void>(m_layout.tellEverything(), [this](const Result<void> &) { m_learning = false; });
}

void OrderQueue::stop()
{
    m_orders.clear();
    ++m_stops;
    m_failure.reset();
}

void OrderQueue::begin()
{
    m_working = true;
    m_scope.spawn<void>(work(), [this](const Result<void> &) {
        m_working = false;
        if (!m_orders.empty()) // of a motion that began since a stop
            begin();
    });
}

/// An order that the board does not take ends the motion. A stop ends what is under way.
Task<void> OrderQueue::work()
{
    while (!m_orders.empty()) {
        const std::uint64_t stops = m_stops;
        Order next = std::move(m_orders.front());
        m_orders.pop_front();
        auto obeying = obey(std::move(next.request));
        const Result<void> obeyed = co_await std::move(obeying).attempt();
        if (obeyed && next.accepted)
            next.accepted();
        if (obeyed || stops != m_stops)
            continue;
        m_failed();
        m_failure = obeyed.error();
        co_return fail(obeyed.error());
    }
    co_return {};
}

Task<void> OrderQueue::obey(Bytes order)
{
    PacketPort::Gate gate = [this, stops = m_stops] { return stops == m_stops; };
    if (!m_layout.tellsEverything()) {
        auto telling = m_layout.tellEverything();
        co_await std::move(telling);
    }
    auto asking = m_port.request(std::move(order), orderTries, std::move(gate));
    co_await std::move(asking);
    co_return {};
}

} // namespace mb::quadquad2drv
