// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "async/message.h"

#include <atomic>
#include <utility>

namespace mb {

/// What of this program stands before a motion of a device: STOP that is pressed, an update that runs, a move that the device
/// keeps for later. Engine thread, but for the flag behind setStopGate().
class MotionGate {
public:
    MotionGate() = default;
    MotionGate(const MotionGate &) = delete;
    MotionGate &operator=(const MotionGate &) = delete;

    /// While it is true nothing drives the device: STOP was pressed, and this thread has not come to it yet. Outlives the device.
    void setStopGate(const std::atomic<bool> *gate) { m_stopGate = gate; }
    [[nodiscard]] bool isStopPressed() const { return m_stopGate && *m_stopGate; }

    /// When this program last told the device to stop.
    [[nodiscard]] Instant stoppedAt() const { return m_stoppedAt; }
    void stopped(Instant time) { m_stoppedAt = time; }

    /// While an update runs nothing else may talk to the device; empty: nothing runs.
    void setBusy(Message why) { m_busy = std::move(why); }
    [[nodiscard]] const Message &busy() const { return m_busy; }

    /// The device keeps a move that has not begun; a stop does not take it away.
    [[nodiscard]] bool keepsMove() const { return m_keepsMove; }
    void keepMove() { m_keepsMove = true; }
    /// The move has begun, or the device forgot it: whether there was one.
    bool takeMove() { return std::exchange(m_keepsMove, false); }

private:
    Message m_busy;
    const std::atomic<bool> *m_stopGate = nullptr;
    Instant m_stoppedAt{};
    bool m_keepsMove = false;
};

} // namespace mb
