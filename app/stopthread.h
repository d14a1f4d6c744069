// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/stoplane.h"
#include "async/mailbox.h"

#include <QThread>

#include <atomic>

namespace mb {

/// The thread of the stop lane, which waits for nothing else.
class StopThread final : public QThread {
public:
    StopThread();
    ~StopThread() override;

    /// Any thread: STOP. Waits for nothing.
    void press(StopCause cause);
    /// Engine thread: it has stopped all.
    void served();
    /// True from press() to served().
    [[nodiscard]] const std::atomic<bool> &isPressed() const { return m_pressed; }
    /// Engine thread: takes the links as they are now. Cheap when nothing has changed; must be called at once when a link goes, so
    /// that its descriptor is not held any longer.
    void follow(const Session &session);

private:
    void run() override;

    Mailbox m_orders;
    StopLane *m_lane = nullptr; ///< of run(); used by what is posted to it
    std::atomic<bool> m_pressed = false;
    std::vector<StopOrders> m_known; ///< of the engine thread
};

} // namespace mb
