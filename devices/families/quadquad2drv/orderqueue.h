// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/scope.h"
#include "families/quadquad2drv/boardlayout.h"

#include <deque>

namespace mb::quadquad2drv {

/// The requests of set-points on their way to the board, one after the other, each accepted before the next. Engine thread.
class OrderQueue {
public:
    /// Port and layout outlive it; `failed` stops the motors, because the board did not take an order.
    OrderQueue(Clock &clock, PacketPort &port, BoardLayout &layout, std::function<void()> failed);

    /// A newer target of the same kind for the same axis takes the place of one that has not left yet. `accepted` is called when the
    /// board has taken it.
    void post(Bytes request, std::function<void()> accepted = {});
    /// The board will tell everything, where it does not.
    void learn();
    /// Nothing that was ordered before is sent any more, not even again.
    void stop();
    /// The board was reset.
    void clear() { m_orders.clear(); }
    /// What ended the motion; told once.
    [[nodiscard]] std::optional<Error> takeFailure() { return std::exchange(m_failure, std::nullopt); }

private:
    struct Order {
        Bytes request;
        std::function<void()> accepted;
    };
    void begin();
    [[nodiscard]] Task<void> work();
    [[nodiscard]] Task<void> obey(Bytes order);

    PacketPort &m_port;
    BoardLayout &m_layout;
    std::function<void()> m_failed;
    std::deque<Order> m_orders;
    bool m_working = false;
    bool m_learning = false;
    std::uint64_t m_stops = 0;
    std::optional<Error> m_failure;
    Scope m_scope; ///< last: its tasks use everything above
};

} // namespace mb::quadquad2drv
