// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "model/devicebook.h"
#include "model/linkbook.h"
#include "model/owedstops.h"

namespace mb {

/// STOP for all devices of a session, and its follow-up across links that close, are lost and come back. Thread of the session.
class SessionStops : NonCopyable {
public:
    /// Links and devices outlive it.
    SessionStops(Clock &clock, LinkBook &links, DeviceBook &devices, MotionGuard *guard);

    /// Stops every stream. By the user also every device for which its family has a harmless stop (Device::mayStop), moving or
    /// not; by the program only what it has moved. Each is followed up (Device::stopping), also over a link that is lost: that is
    /// opened again as soon as it can be, and its first frames are the stops. Waits for nothing.
    void stopAll(StopCause cause);
    /// Stops what this program drives on a link that is about to be closed; what was told and is not seen to stand by then is owed.
    void beforeClose(const Link &link);
    /// Its devices are gone: what is owed on this line is the guardians' again.
    void leave(const Link &link) { m_owed.leave(link); }
    /// To motors of which no device of the session shows what became of them.
    [[nodiscard]] std::vector<OwedStop> owed() const { return m_owed.unseen(); }
    /// This unit was driven, by whomever, and nobody has seen it stand since; for as long as a stop is owed after it was told.
    [[nodiscard]] bool mayTurn(const Link &link, const DeviceSelector &selector) const;
    /// The user has looked at the motors: nothing is owed any more.
    void dismiss();
    /// Starts the buffered moves of every device on the link of `lead` at the same moment. Unsafe when one of them is not
    /// guarded, or keeps a move whose motion was stopped before it began.
    [[nodiscard]] Result<void> releaseMoves(Device &lead);

private:
    void linkOpened(Link &link);
    void linkLost(const Link &link);
    void stopChanged(Device &device);
    void retryOwing();
    [[nodiscard]] bool isOwing(const Link &link) const;

    LinkBook &m_links;
    DeviceBook &m_devices;
    OwedStops m_owed;
    Timer m_retry;
    Subscription m_opened;
    Subscription m_lost;
    Subscription m_added;
    Subscription m_stopChanged;
};

} // namespace mb
