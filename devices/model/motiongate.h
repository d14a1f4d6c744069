// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "async/message.h"
#include "async/noncopyable.h"
#include "model/setpoint.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>

namespace mb {

/// A buffered move that a device has until it begins it. No stop takes it away, but another one, and a restart.
struct KeptMove {
    enum class State : std::uint8_t {
        None,
        Sent, ///< whether the device has it, or still the one before it, is not known
        Acknowledged,
        Released, ///< told to begin it; whether the device has heard that is not known
        Stale,    ///< stopped before it began: nobody wants it any more, and the device would begin it
    };
    State state = State::None;
    SetPoint order; ///< while it is acknowledged or released; sent: what was acknowledged before
};

/// What of this program stands before a motion of a device: STOP that is pressed, an update that runs, a move that the device
/// keeps for later, targets that are of another origin. Engine thread, but for the flag behind setStopGate().
class MotionGate : NonCopyable {
public:
    /// While it is true nothing drives the device: STOP was pressed, and this thread has not come to it yet. Outlives the device.
    void setStopGate(const std::atomic<bool> *gate) { m_stopGate = gate; }
    [[nodiscard]] bool isStopPressed() const { return m_stopGate && *m_stopGate; }

    /// When this program last told the device to stop.
    [[nodiscard]] Instant stoppedAt() const { return m_stoppedAt; }
    void stopped(Instant time)
    {
        m_stoppedAt = time;
        if (m_kept.state != KeptMove::State::None)
            m_kept.state = KeptMove::State::Stale;
    }

    /// While an update runs nothing else may talk to the device; empty: nothing runs.
    void setBusy(Message why) { m_busy = std::move(why); }
    [[nodiscard]] const Message &busy() const { return m_busy; }

    [[nodiscard]] const KeptMove &kept() const { return m_kept; }
    [[nodiscard]] bool keepsMove() const { return m_kept.state != KeptMove::State::None; }
    /// For families: what became of a buffered move, from when it is on the wire.
    void moveSent() { m_before = std::exchange(m_kept.state, KeptMove::State::Sent); }
    /// The device has what it had before.
    void moveRefused()
    {
        if (m_kept.state == KeptMove::State::Sent)
            m_kept.state = m_before;
    }
    void moveAcknowledged(const SetPoint &order) { m_kept = {KeptMove::State::Acknowledged, order}; }
    /// Its release is on the wire; whether there was one that is known and wanted.
    bool moveReleased()
    {
        if (m_kept.state != KeptMove::State::Acknowledged)
            return false;
        m_kept.state = KeptMove::State::Released;
        return true;
    }
    /// The device has none any more: it has begun it, or has restarted.
    void forgetMove() { m_kept = {}; }

    /// Another number once its positions may count from another place: somebody has zeroed them, or it has restarted.
    [[nodiscard]] std::uint32_t origin() const { return *m_origin; }
    void originMoved() { ++*m_origin; }
    /// originMoved() for an order that may outlive the device.
    [[nodiscard]] auto originMover() const
    {
        return [origin = m_origin] { ++*origin; };
    }

private:
    Message m_busy;
    const std::atomic<bool> *m_stopGate = nullptr;
    Instant m_stoppedAt{};
    KeptMove m_kept;
    std::shared_ptr<std::uint32_t> m_origin = std::make_shared<std::uint32_t>(0);
    KeptMove::State m_before = KeptMove::State::None; ///< the newest was sent
};

} // namespace mb
