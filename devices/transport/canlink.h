// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transport/lineload.h"
#include "transport/link.h"
#include "transport/priority.h"
#include "wire/canerror.h"

#include <memory>
#include <optional>

namespace mb {

/// Both would be arbitrated and received as the same message.
[[nodiscard]] inline bool sameIdentifier(const CanFrame &a, const CanFrame &b)
{
    return a.id == b.id && a.extended == b.extended;
}

/// What the error frames of a bus said since the link was opened, and what its last second looks like.
struct BusHealth {
    BusState state = BusState::Active;
    std::optional<int> transmitErrors; ///< error counters of our controller, as last told
    std::optional<int> receiveErrors;
    std::uint64_t acknowledgeErrors = 0; ///< error frames of this kind; controllers may gather several errors in one
    std::uint64_t arbitrationLosses = 0;
    std::uint64_t protocolErrors = 0;
    std::uint64_t overruns = 0; ///< of the controller's receive buffer
    std::uint64_t restarts = 0; ///< after bus-off
    CanErrorReport last;        ///< of the newest error frame
    std::optional<Instant> lastError;
    std::optional<Instant> lastAcknowledgeError;
    std::optional<Instant> lastProtocolError;
    std::optional<Instant> lastReceived; ///< newest frame of somebody else
    std::optional<Instant> stuckSince;   ///< frames wait in this program and none has gone out since
};

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
    /// How long a frame takes on the wire; zero when the link does not know its rate.
    [[nodiscard]] Duration wireTime(const CanFrame &frame) const;
    /// Fraction of the bus in use over the last second of traffic, ours included, from estimated frame lengths;
    /// `now` is the present time. Nothing in the first second; 1 Mbit/s is assumed when the rate is unknown.
    [[nodiscard]] std::optional<double> load(Instant now) const;

    [[nodiscard]] const BusHealth &health() const { return m_health; }
    /// How many frames the kernel keeps for us while nobody reads; 0 when the link does not know.
    [[nodiscard]] int receiveCapacity() const { return doReceiveCapacity(); }
    /// Frames sent do not reach the bus: the controller only listens.
    [[nodiscard]] bool isListenOnly() const { return doIsListenOnly(); }

    /// A closed end of its own on the same bus, as another controller has it. Only a bus in memory makes one; nullptr on hardware.
    [[nodiscard]] virtual std::unique_ptr<CanLink> makeAnotherEnd() { return nullptr; }

    [[nodiscard]] Listeners<const CanFrame &> &received() { return m_received; }
    /// Error frames; decodeError() reads them, health() sums them up.
    [[nodiscard]] Listeners<const CanFrame &> &errorFrames() { return m_errorFrames; }

protected:
    CanLink(LinkAddress address, Clock &clock)
        : Link(std::move(address), LinkKind::Can)
        , m_clock(clock)
        , m_load(*this, clock)
    {
    }
    [[nodiscard]] Clock &clock() const { return m_clock; }
    /// For backends: one frame from the bus, then endBatch() once no more are at hand.
    void deliver(const CanFrame &frame);
    void endBatch() { batchEnded().notify(); }
    /// For backends: an error that comes without a frame.
    void noteError(const CanErrorReport &report, Instant time);
    /// For backends, when the link opens: what the controller says of itself.
    void startHealth(BusState state, std::optional<int> transmitErrors, std::optional<int> receiveErrors);
    /// For backends: what the controller says of itself meanwhile.
    void updateHealth(BusState state, std::optional<int> transmitErrors, std::optional<int> receiveErrors);
    /// For backends: what was heard belongs to another time.
    void forgetHealth()
    {
        m_health = {};
        m_load.forget();
    }
    /// For backends: frames wait since then, or none does.
    void setStuckSince(std::optional<Instant> since) { m_health.stuckSince = since; }

private:
    virtual Result<void> doSend(const CanFrame &frame, Priority priority) = 0;
    [[nodiscard]] virtual std::size_t doBacklog() const = 0;
    [[nodiscard]] virtual int doBitrate() const = 0;
    [[nodiscard]] virtual int doReceiveCapacity() const { return 0; }
    [[nodiscard]] virtual bool doIsListenOnly() const { return false; }

    Clock &m_clock;
    Listeners<const CanFrame &> m_received;
    Listeners<const CanFrame &> m_errorFrames;
    BusHealth m_health;
    LineLoad m_load;
};

} // namespace mb
