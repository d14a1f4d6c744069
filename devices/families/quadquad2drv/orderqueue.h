// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/scope.h"
#include "families/quadquad2drv/boardlayout.h"

#include <array>
#include <deque>

namespace mb::quadquad2drv {

/// The requests of set-points on their way to the board, one after the other, each accepted before the next. What an axis (0…3) is
/// told anew takes the place of what waits for it, and the axes take turns, so that none is further behind than one order of each.
/// What is ordered behind a stop waits until that is proven: what asks for the proof switches all axes off (StopProof). Engine thread.
class OrderQueue {
public:
    struct Order {
        Bytes request;
        std::function<void()> accepted{}; ///< called when the board has taken it
        std::function<Bytes()> late{}; ///< makes the request when it is sent, where it depends on how things are then
    };

    /// Port and layout outlive it; `failed` stops the motors, because the board did not take an order.
    OrderQueue(Clock &clock, PacketPort &port, BoardLayout &layout, std::function<void()> failed);

    /// Takes another mode: before what waits for other axes, and instead of what waits for this one.
    void enter(int axis, std::vector<Order> orders);
    /// Behind the mode; a newer target takes the place of one that has not left yet.
    void setTarget(int axis, Bytes target);
    /// The board will tell everything, where it does not.
    void learn();
    /// Nothing that was ordered before is sent any more, not even again; and nothing at all until stopEnded().
    void stop();
    /// Nobody asks for its proof any more.
    void stopEnded();
    /// The board was reset.
    void clear() { m_slots = {}; }
    /// What ended the motion; told once.
    [[nodiscard]] std::optional<Error> takeFailure() { return std::exchange(m_failure, std::nullopt); }

private:
    struct Slot {
        std::deque<Order> entry;
        std::optional<Bytes> target;
    };
    void begin();
    [[nodiscard]] bool isWaiting() const;
    [[nodiscard]] std::optional<Order> take();
    [[nodiscard]] Task<void> work();
    [[nodiscard]] Task<void> obey(Order order);

    PacketPort &m_port;
    BoardLayout &m_layout;
    std::function<void()> m_failed;
    std::array<Slot, axes> m_slots;
    std::size_t m_turn = 0; ///< axis that comes next
    bool m_working = false;
    bool m_stopping = false; ///< since stop()
    bool m_learning = false;
    std::uint64_t m_stops = 0;
    std::optional<Error> m_failure;
    Scope m_scope; ///< last: its tasks use everything above
};

} // namespace mb::quadquad2drv
