// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/orderqueue.h"

#include <algorithm>
#include <iterator>
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

void OrderQueue::enter(int axis, std::vector<Order> orders)
{
    Slot &slot = m_slots[static_cast<std::size_t>(axis)];
    slot.entry.assign(std::make_move_iterator(orders.begin()), std::make_move_iterator(orders.end()));
    slot.target.reset();
    m_turn = static_cast<std::size_t>(axis);
    begin();
}

void OrderQueue::setTarget(int axis, Bytes target)
{
    m_slots[static_cast<std::size_t>(axis)].target = std::move(target);
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
    clear();
    ++m_stops;
    m_stopping = true;
    m_failure.reset();
}

void OrderQueue::stopEnded()
{
    m_stopping = false;
    if (isWaiting())
        begin();
}

bool OrderQueue::isWaiting() const
{
    return std::ranges::any_of(m_slots, [](const Slot &slot) { return !slot.entry.empty() || slot.target; });
}

void OrderQueue::begin()
{
    m_layout.noteChange();
    if (m_stopping || std::exchange(m_working, true))
        return;
    m_scope.spawn<void>(work(), [this](const Result<void> &) {
        m_working = false;
        if (isWaiting()) // of a motion that began since a stop
            begin();
    });
}

std::optional<OrderQueue::Order> OrderQueue::take()
{
    for (std::size_t i = 0; i < m_slots.size(); ++i) {
        const std::size_t axis = (m_turn + i) % m_slots.size();
        Slot &slot = m_slots[axis];
        std::optional<Order> next;
        if (!slot.entry.empty()) {
            next = std::move(slot.entry.front());
            slot.entry.pop_front();
        } else if (slot.target) {
            next = Order{std::move(*slot.target)};
            slot.target.reset();
        }
        if (!next)
            continue;
        m_turn = slot.entry.empty() ? axis + 1 : axis;
        return next;
    }
    return std::nullopt;
}

/// An order that the board does not take ends the motion. A stop ends what is under way.
Task<void> OrderQueue::work()
{
    while (std::optional<Order> next = m_stopping ? std::nullopt : take()) {
        const std::uint64_t stops = m_stops;
        const Result<void> obeyed = co_await obey(*next).attempt();
        if (obeyed && next->accepted)
            next->accepted();
        if (obeyed || stops != m_stops)
            continue;
        m_failed();
        m_failure = obeyed.error();
    }
    co_return {};
}

Task<void> OrderQueue::obey(Order order)
{
    PacketPort::Gate gate = [this, stops = m_stops] { return stops == m_stops; };
    if (!m_layout.tellsEverything())
        co_await m_layout.tellEverything();
    Bytes request = order.late ? order.late() : std::move(order.request);
    co_await m_port.request(std::move(request), orderTries, std::move(gate));
    co_return {};
}

} // namespace mb::quadquad2drv
