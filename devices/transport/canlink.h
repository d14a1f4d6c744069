// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transport/lineload.h"
#include "transport/link.h"
#include "transport/priority.h"

#include <functional>

namespace mb {

/// Both would be arbitrated and received as the same message.
[[nodiscard]] inline bool sameIdentifier(const CanFrame &a, const CanFrame &b)
{
    return a.id == b.id && a.extended == b.extended;
}

/// A CAN bus seen through one controller. Frames of others arrive through `received`; our own do not come back.
class CanLink : public Link {
public:
    /// Hands a frame, stamped with the present time, to the backend, which may queue it behind earlier ones; never
    /// waits. An urgent frame takes the place of waiting ones with the same identifier. Fails with LinkLost when the link is not open, OutOfRange when it is no frame (identifier or size).
    Result<void> send(const CanFrame &frame, Priority priority = Priority::Normal);
    /// Frames accepted by send() and not yet handed to the bus or the kernel.
    [[nodiscard]] std::size_t backlog() const { return doBacklog(); }
    /// Bit/s, 0 when the link does not know.
    [[nodiscard]] int bitrate() const { return doBitrate(); }
    /// Fraction of the bus in use over the last second of traffic, ours included, from estimated frame lengths;
    /// `now` is the present time. 1 Mbit/s is assumed when the rate is unknown.
    [[nodiscard]] double load(Instant now) const;

    [[nodiscard]] Listeners<const CanFrame &> &received() { return m_received; }
    /// Error frames, decoded by nobody yet: id holds the class bits of linux/can/error.h.
    [[nodiscard]] Listeners<const CanFrame &> &errorFrames() { return m_errorFrames; }

protected:
    CanLink(LinkAddress address, Clock &clock)
        : Link(std::move(address), LinkKind::Can)
        , m_clock(clock)
    {
    }
    [[nodiscard]] Clock &clock() const { return m_clock; }
    /// For backends: one frame from the bus, then endBatch() once no more are at hand.
    void deliver(const CanFrame &frame);
    void endBatch() { batchEnded().notify(); }

private:
    virtual Result<void> doSend(const CanFrame &frame, Priority priority) = 0;
    [[nodiscard]] virtual std::size_t doBacklog() const = 0;
    [[nodiscard]] virtual int doBitrate() const = 0;

    Clock &m_clock;
    Listeners<const CanFrame &> m_received;
    Listeners<const CanFrame &> m_errorFrames;
    LineLoad m_load;
};

} // namespace mb
