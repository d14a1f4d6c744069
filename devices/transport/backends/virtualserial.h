// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "transport/seriallink.h"
#include "transport/serialqueue.h"

#include <optional>
#include <random>
#include <vector>

namespace mb {

class VirtualSerialLink;

/// A serial line in memory, on the given clock, with the timing of a real one: ten bits a byte at the sender's rate,
/// pieces one after the other. Bytes are delivered from the clock queue, never inside send(): as soon as `fifo` of them
/// have passed, and at the end of each piece, when the last stop bit has passed.
///
/// A receiver at another rate gets what its UART would sample (wire/uart.h), at the end of the piece. On a half-duplex
/// line everybody hears everybody else, and bytes that overlap in time reach nobody intact. On a full-duplex line every
/// end has a wire of its own, and nothing collides.
class VirtualSerialLine : NonCopyable {
public:
    enum class Wiring { HalfDuplex, FullDuplex };

    VirtualSerialLine(Clock &clock, Wiring wiring, std::uint64_t seed);

    [[nodiscard]] Clock &clock() const { return m_clock; }
    /// This fraction of pieces is heard by nobody, 0…1.
    void setLoss(double fraction) { m_loss = fraction; }
    /// In this fraction of pieces one bit arrives wrong, 0…1.
    void setCorruption(double fraction) { m_corruption = fraction; }
    /// Every receiver understands every sender, whatever their rates; bytes take the time of `baudrate`. 0 ends that.
    void setAnySpeed(int baudrate) { m_anySpeed = baudrate; }
    /// The cable of `link` comes out: the rest of what it was sending is heard by nobody, and the link is lost.
    void pull(VirtualSerialLink &link);

private:
    friend class VirtualSerialLink;
    static constexpr std::size_t fifo = 16; ///< bytes that an end collects before it delivers, as in a common UART
    /// What is on the wire.
    struct Passing {
        VirtualSerialLink *sender = nullptr;
        std::vector<std::uint8_t> bytes; ///< as they arrive
        std::vector<bool> collided;
        std::size_t delivered = 0;
        Instant start{};
        Duration byteTime{};
        int rate = 0;
        bool lost = false;

        [[nodiscard]] Instant end() const { return endOf(bytes.size()); }
        [[nodiscard]] Instant endOf(std::size_t count) const { return start + byteTime * static_cast<int>(count); }
    };
    void detach(VirtualSerialLink &link);
    void begin(VirtualSerialLink &link);
    void proceed(VirtualSerialLink &link, std::size_t until);
    void spoil(Passing &passing);
    void collide(Passing &passing);
    void hear(VirtualSerialLink &receiver, const Passing &passing, std::size_t from, std::size_t until);
    void hearAtOtherRate(VirtualSerialLink &receiver, const Passing &passing);
    [[nodiscard]] bool chance(double fraction);

    Clock &m_clock;
    Wiring m_wiring;
    std::mt19937_64 m_random;
    double m_loss = 0.0;
    double m_corruption = 0.0;
    int m_anySpeed = 0;
    std::vector<VirtualSerialLink *> m_links;
};

/// One port on a virtual line; the line outlives it. Whoever simulates a device has one of these, the host has another.
class VirtualSerialLink final : public SerialLink {
public:
    VirtualSerialLink(LinkAddress address, VirtualSerialLine &line);
    ~VirtualSerialLink() override;

private:
    friend class VirtualSerialLine;
    Result<void> doOpen() override;
    void doClose() override { m_line.detach(*this); }
    Result<void> doSend(std::span<const std::uint8_t> bytes, Priority priority) override;
    [[nodiscard]] std::size_t doBacklog() const override;
    Result<void> doSetBaudrate(int) override { return {}; }

    VirtualSerialLine &m_line;
    SerialQueue m_queue;
    std::optional<VirtualSerialLine::Passing> m_passing;
    Instant m_freeAt{};
    Timer m_timer;
};

} // namespace mb
