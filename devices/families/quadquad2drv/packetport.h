// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "families/quadquad2drv/codec.h"
#include "transport/spilink.h"

#include <functional>
#include <utility>

namespace mb::quadquad2drv {

/// The conversation with one board (README.md#waiting-packets). Several ports may share a link: each hears every packet that comes, whoever
/// clocked it out, so a stream packet between request and reply is never lost; requests take turns.
class PacketPort : NonCopyable {
public:
    PacketPort(SpiLink &link, Clock &clock);

    /// Whether a request may still be sent, asked each time just before it is.
    using Gate = std::function<bool()>;
    /// Sends a request and yields its reply when the board accepted it; Refused with what it said, Timeout (asked `tries`
    /// times), LinkLost, Cancelled when a stop went first or the gate is shut.
    [[nodiscard]] Task<Packet> request(Bytes request, int tries = 3, Gate gate = {});
    /// Clocks out what is pending without a request, a stream packet most likely; ends at once when nothing is.
    [[nodiscard]] Task<void> fetch();
    /// Without reply and before everything else; the reply comes through received().
    Result<void> urgent(const Bytes &request) { return m_link.sendUrgent(request); }

    /// How long packets are, from what the board was last told or said.
    void setLayout(const DataMasks &masks, std::uint8_t streamConfig);
    [[nodiscard]] const DataMasks &masks() const { return m_masks; }
    [[nodiscard]] std::uint8_t streamConfig() const { return m_streamConfig; }
    /// What came garbled since it was asked for last.
    enum class Damage : std::uint8_t {
        None,
        Unclear, ///< a stream packet, or a reply, or bytes between packets
        OfStream,
    };
    [[nodiscard]] Damage takeDamage() { return std::exchange(m_damage, Damage::None); }
    /// Every packet, in order, with the time its last byte came.
    [[nodiscard]] Listeners<const Packet &, Instant> &received() { return m_received; }

private:
    struct Round {
        std::uint8_t id = 0;
        std::optional<Packet> reply;
        Instant deadline{};
        std::uint64_t from
            = UINT64_MAX; ///< PacketReader::fed() once the request was clocked: no reply to it begins before
    };
    void hear(const Traffic &traffic);
    void noteDamage();
    [[nodiscard]] Task<Packet> ask(const Bytes &request, const Gate &gate, Duration patience);
    [[nodiscard]] Task<void> listenFor(Round &round, std::size_t expected);
    [[nodiscard]] Task<void> takeWaiting();
    [[nodiscard]] Task<void> clockOut(std::size_t bytes);
    [[nodiscard]] Task<void> searchStart();

    SpiLink &m_link;
    Clock &m_clock;
    PacketReader m_reader;
    DataMasks m_masks{datamask::startUp, datamask::startUp, datamask::startUp, datamask::startUp};
    std::uint8_t m_streamConfig = 0;
    Round *m_round = nullptr;
    std::uint64_t m_bad = 0;    ///< of the reader, as noted
    std::uint64_t m_strays = 0; ///< the same
    Damage m_damage = Damage::None;
    Listeners<const Packet &, Instant> m_received;
    Subscription m_traffic;
};

} // namespace mb::quadquad2drv
