// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transport/lineload.h"
#include "transport/link.h"
#include "transport/priority.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <typeindex>

namespace mb {

/// A serial line seen through one port: bytes without frames, 8 data bits, no parity, one stop bit. The counters count
/// bytes; `errors` also framing errors and collisions.
///
/// Framing, and one request in flight on a half-duplex line, are the business of the family.
class SerialLink : public Link {
public:
    static constexpr int slowest = 50;
    static constexpr int fastest = 4'000'000;

    /// Hands over one piece: its bytes follow each other without a gap on the wire. Pieces wait for earlier ones; this
    /// never does. An urgent piece goes before what waits, and the normal pieces that have not begun are dropped and
    /// counted as lost, so that no older set-point follows a stop. Fails with LinkLost when the link is not open,
    /// OutOfRange for an empty piece.
    Result<void> send(std::span<const std::uint8_t> bytes, Priority priority = Priority::Normal);
    /// Bytes accepted by send() and not on the wire yet, as far as can be known; times byteTime() it is how long that
    /// takes.
    [[nodiscard]] std::size_t backlog() const { return doBacklog(); }

    /// Bytes of others, as they were read; the present time is theirs. Where frames begin and end says nothing here.
    [[nodiscard]] Listeners<std::span<const std::uint8_t>> &received() { return m_received; }
    /// A byte with a bad stop bit, or one that collided: most ports hand out 0 or garbage for it, or nothing. Not every
    /// port reports it.
    [[nodiscard]] Listeners<> &lineErrors() { return m_lineErrors; }

    /// Bit/s; also of a closed link, which opens with it.
    [[nodiscard]] int baudrate() const { return m_baudrate; }
    /// At once, bytes under way are garbled: wait until backlog() is 0 and the answer is there. OutOfRange when the port
    /// cannot do it; the old rate stays then.
    Result<void> setBaudrate(int baudrate);
    /// setBaudrate() for a thread that must not wait for a driver: in the background that was given, for openLimit at most, then the
    /// link is lost. Nothing is to be sent before it has ended. Ends before the link does.
    [[nodiscard]] Task<void> setBaudrateSoon(int baudrate);
    /// The only rate to use on this link, if the address names one: `baud` (`bitrate` on simulated links).
    [[nodiscard]] std::optional<int> fixedBaudrate() const { return m_fixed; }
    /// Of one byte on the wire: ten bits.
    [[nodiscard]] Duration byteTime() const { return bitTimes(10); }
    /// Fraction of the line in use over the last second of traffic, ours included; nothing in the first.
    [[nodiscard]] std::optional<double> load(Instant now) const { return m_load.fraction(now, m_baudrate); }

    /// What the user should know of this port although it could be opened, in one clause; empty most of the time.
    [[nodiscard]] const Message &remark() const { return m_remark; }

    /// From the last bit of a request to the first of its answer as read: whoever exchanges requests measures it.
    void noteRoundTrip(Duration time);
    /// Smoothed over some dozen answers; nothing before the first.
    [[nodiscard]] std::optional<Duration> roundTrip() const { return m_roundTrip; }

    /// What all who talk on this line share, such as whose turn it is: made when first asked for, gone with its last holder.
    template <class T, class Make> [[nodiscard]] std::shared_ptr<T> shared(const Make &make)
    {
        std::weak_ptr<void> &known = m_shared[std::type_index(typeid(T))];
        auto held = std::static_pointer_cast<T>(known.lock());
        if (!held)
            known = held = make();
        return held;
    }
    /// What is known of who is on this line: made when first asked for, kept for as long as the link.
    template <class T> [[nodiscard]] T &kept()
    {
        std::shared_ptr<void> &known = m_kept[std::type_index(typeid(T))];
        if (!known)
            known = std::make_shared<T>();
        return *std::static_pointer_cast<T>(known);
    }

protected:
    /// A rate that the address fixes is taken; otherwise 115200.
    SerialLink(LinkAddress address, Clock &clock);
    [[nodiscard]] Clock &clock() const { return m_clock; }
    [[nodiscard]] Duration bitTimes(int bits) const { return Duration(std::chrono::seconds(bits)) / m_baudrate; }
    void setRemark(Message remark) { m_remark = std::move(remark); }
    /// For backends: bytes from the line, `time` at the end of the last one; then endBatch() once no more are at hand.
    void deliver(Instant time, std::span<const std::uint8_t> bytes);
    void endBatch() { batchEnded().notify(); }
    void reportLineError();

private:
    virtual Result<void> doSend(std::span<const std::uint8_t> bytes, Priority priority) = 0;
    [[nodiscard]] virtual std::size_t doBacklog() const = 0;
    /// Only while the link is open.
    virtual Result<void> doSetBaudrate(int baudrate) = 0;
    /// For backends whose doSetBaudrate() may block.
    [[nodiscard]] virtual Task<void> doSetBaudrateSoon(Background &, int baudrate)
    {
        co_return doSetBaudrate(baudrate);
    }
    [[nodiscard]] Result<bool> isNewRate(int baudrate) const;

    Clock &m_clock;
    std::optional<int> m_fixed;
    int m_baudrate;
    bool m_isRateInDoubt = false; ///< a change of it was given up, the port may have it
    Message m_remark;
    std::optional<Duration> m_roundTrip;
    LineLoad m_load;
    std::map<std::type_index, std::weak_ptr<void>> m_shared;
    std::map<std::type_index, std::shared_ptr<void>> m_kept;
    Listeners<std::span<const std::uint8_t>> m_received;
    Listeners<> m_lineErrors;
};

} // namespace mb
