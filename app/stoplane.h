// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/guardian/port.h"
#include "model/session.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace mb {

/// STOP past a blocked engine thread. A thread of its own holds duplicates of the descriptors of all open links and the stop
/// messages of their devices; when the engine has not come to a STOP within `patience`, it writes them itself. The engine sends
/// them again, properly, once it can, and drives nothing before that (Device::setStopGate). Left out are links without a descriptor
/// (simulated ones live in the engine thread) and `unix:`, whose answers would be taken for others.
class StopLane {
public:
    static constexpr std::chrono::milliseconds patience{5};

    StopLane();
    StopLane(const StopLane &) = delete;
    StopLane &operator=(const StopLane &) = delete;
    ~StopLane();

    /// Any thread: STOP. Waits for nothing.
    void press();
    /// Engine thread: it has stopped all.
    void served();
    /// True from press() to served().
    [[nodiscard]] const std::atomic<bool> &isPressed() const { return m_pressed; }
    /// Engine thread: takes the links as they are now. Cheap when nothing has changed; must be called at once when a link goes, so
    /// that its descriptor is not held any longer.
    void follow(const Session &session);

private:
    struct Outlet {
        const Link *link = nullptr;
        int descriptor = -1; ///< the link's
        int own = -1;        ///< its duplicate
        const char *form = nullptr;
        std::vector<guardian::Bytes> messages;
        std::unique_ptr<guardian::Port> port;
    };

    void run();
    void send();
    [[nodiscard]] static std::vector<Outlet> outletsOf(const Session &session);

    std::atomic<bool> m_pressed = false;
    bool m_ending = false;
    bool m_sent = false; ///< since it was pressed
    std::chrono::steady_clock::time_point m_pressedAt;
    std::vector<Outlet> m_outlets;
    std::mutex m_mutex;
    std::condition_variable m_wake;
    std::thread m_thread; ///< last: it uses all the others
};

} // namespace mb
