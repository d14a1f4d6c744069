// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/guardian/port.h"
#include "model/session.h"

#include <chrono>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace mb {

/// One open link, as a thread that does not own it can send stops on it: by a duplicate of its descriptor, or by what the link
/// gives away for that (Outlet::aside). Answers are the engine's: nothing is read.
class StopOutlet final : public guardian::Port {
public:
    StopOutlet(const Link &link, const Outlet &way);
    ~StopOutlet() override;

    [[nodiscard]] bool serves(const Link &link, const Outlet &way) const;
    Sent send(std::span<const std::uint8_t> message) override;
    guardian::Bytes read() override { return {}; }
    void forget() override;

private:
    const Link *m_link;
    int m_descriptor; ///< the link's
    int m_own = -1;   ///< its duplicate
    std::unique_ptr<guardian::Port> m_port;
    std::function<bool(std::span<const std::uint8_t>)> m_aside;
};

/// How the stop of one device is sent without its answers: whole on a terminal, where a message may fall into an answer; elsewhere
/// no step waits for another. What is not a user's leaves out what others obey too (StopStep::forAll).
[[nodiscard]] std::vector<guardian::Script> laneScripts(
    StopScript script, Outlet::Form form, StopCause cause = StopCause::User);

/// What is to be sent on one link: laneScripts() of its devices.
struct StopOrders {
    std::shared_ptr<StopOutlet> outlet;
    std::vector<guardian::Script> scripts;
    std::vector<guardian::Script> own{}; ///< those of devices that this program has moved
};

/// STOP past an engine thread that is blocked: when the engine has not come to a STOP within `patience`, all orders are sent from
/// here, as a guardian sends them, but for answers: each step as often as it may need, with the time between that an answer takes of
/// a half-duplex line (StopStep::taken). The engine sends them again, properly, once it can, and drives nothing before that
/// (MotionGate::setStopGate). Lives in one thread (StopThread) and knows it not, so that tests drive it in virtual time.
///
/// Left out are simulated links: their bus, their motors and their time live in the engine thread, and stand while it does.
class StopLane {
public:
    static constexpr std::chrono::milliseconds patience{5};

    explicit StopLane(Clock &clock)
        : m_clock(clock)
        , m_due(clock)
    {
    }
    /// By the user all are stopped, by the program what it has moved.
    void press(StopCause cause = StopCause::User);
    /// The engine has stopped all.
    void served();
    void setOrders(std::vector<StopOrders> orders) { m_orders = std::move(orders); }

private:
    /// One link on its way through its scripts.
    struct Course {
        std::shared_ptr<StopOutlet> outlet;
        guardian::Runner runner{*outlet};
    };

    void proceed();

    Clock &m_clock;
    std::vector<StopOrders> m_orders;
    std::vector<Course> m_courses;
    Timer m_due;
};

/// Engine thread: what stops the devices of all open links now. Outlets of `known` that still serve are taken over.
[[nodiscard]] std::vector<StopOrders> stopOrdersOf(const Session &session, const std::vector<StopOrders> &known);

} // namespace mb
