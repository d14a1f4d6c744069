// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/quadquad2drv/protocol.h"

#include "async/result.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace mb::quadquad2drv {

constexpr std::uint8_t allAxes = 0x0F;

/// The channel mask of one axis, 0 to 3.
[[nodiscard]] constexpr std::uint8_t maskOf(int axis)
{
    return static_cast<std::uint8_t>(1U << static_cast<unsigned>(axis));
}

using Bytes = std::vector<std::uint8_t>;

struct Packet {
    std::uint8_t id = 0;
    Bytes payload;
};

/// Two's complement of the sum: all bytes of a packet add up to 0 (README.md#checksum).
[[nodiscard]] std::uint8_t checksum(std::span<const std::uint8_t> bytes);
[[nodiscard]] Bytes encode(std::uint8_t id, std::span<const std::uint8_t> payload);

/// Finds packets in what the board clocks out; tolerates filler, and what is no packet costs one byte at a time (README.md#checksum).
class PacketReader {
public:
    void feed(std::span<const std::uint8_t> bytes) { m_bytes.insert(m_bytes.end(), bytes.begin(), bytes.end()); }
    /// The next whole packet with a good checksum.
    [[nodiscard]] std::optional<Packet> next();
    /// How many bytes the packet that has begun still lacks, 0 when none has, at least 1 while its size is unknown.
    [[nodiscard]] std::size_t missing();
    [[nodiscard]] std::uint64_t bad() const { return m_bad; } ///< packets given up
    [[nodiscard]] std::uint64_t strays() const
    {
        return m_strays;
    } ///< pieces without a beginning, filler not among them
    /// Bytes that were fed, and those up to the end of the packet that next() has yielded.
    [[nodiscard]] std::uint64_t fed() const { return m_taken + m_bytes.size(); }
    [[nodiscard]] std::uint64_t taken() const { return m_taken; }
    void clear() { drop(m_bytes.size()); }

private:
    void align();
    void giveUp();
    void drop(std::size_t count);

    Bytes m_bytes;
    std::uint64_t m_taken = 0; ///< bytes that are not in m_bytes any more
    std::uint64_t m_bad = 0;
    std::uint64_t m_strays = 0;
};

/// @name Requests (2). `mask` bit 0 is the first channel.
/// @{
[[nodiscard]] Bytes getRequest(PacketId id);
[[nodiscard]] Bytes setStreamPeriod(std::uint16_t units);
[[nodiscard]] Bytes setDataMask(std::uint8_t mask, std::uint8_t data);
[[nodiscard]] Bytes setStreamConfig(std::uint8_t bits);
/// `size` 0…3 as in the data mask; 0 means position 0.
[[nodiscard]] Bytes setPosition(std::uint8_t mask, int size, std::int32_t position);
[[nodiscard]] Bytes getPositions(const std::array<std::uint8_t, axes> &sizes);
[[nodiscard]] Bytes getPositions(std::uint8_t mask);
[[nodiscard]] Bytes setHistory(std::uint8_t length, std::uint8_t timeBits);
struct InputSettings {
    std::uint8_t configuration = 0;
    std::uint16_t spacing = 0;
    std::int32_t position = 0;
};
/// The configuration byte of an input whose polarity (0 active high, 1 active low) and edge (0 record and 1 set at the positive
/// end, 2 and 3 the same at the negative one) mean what the vendor's library says; the readings tell how to say it (README.md#inputs).
[[nodiscard]] std::uint8_t inputConfiguration(int mode, int polarity, int edge, const Readings &readings);
/// Two bytes a tuple when the mode is disabled (README.md#inputs).
[[nodiscard]] Bytes setInputMode(std::uint8_t mask, const InputSettings &settings);
[[nodiscard]] Bytes setControlMode(std::uint8_t mask, ControlMode mode);
[[nodiscard]] Bytes setPower(std::uint8_t mask, std::int16_t power);
[[nodiscard]] Bytes setPositionTarget(std::uint8_t mask, std::int32_t counts);
[[nodiscard]] Bytes setVelocityTarget(std::uint8_t mask, double countsPerSecond, const Readings &readings);
[[nodiscard]] Bytes setPowerLimit(std::uint8_t mask, std::uint16_t power);
/// Raw, times 4096.
[[nodiscard]] Bytes setVelocityLimit(std::uint8_t mask, std::uint32_t raw);
[[nodiscard]] Bytes setAccelerationLimit(std::uint8_t mask, std::uint32_t raw);
[[nodiscard]] Bytes setPositionGains(std::uint8_t mask, const std::array<std::uint16_t, 4> &pidWindup);
[[nodiscard]] Bytes setVelocityGains(std::uint8_t mask, const std::array<std::uint16_t, 3> &pid);
/// Velocity and acceleration in counts/s and counts/s².
[[nodiscard]] Bytes rampPosition(std::uint8_t mask, std::int32_t counts, double velocity, double acceleration);
[[nodiscard]] Bytes rampVelocity(std::uint8_t mask, std::int32_t countsPerSecond, double acceleration);
/// @}

/// @name Replies. Nothing when the length or the meaning is wrong.
/// @{
struct Version {
    int major = 0;
    int minor = 0;
    int protocol = 0;
};
struct AxisMotion {
    std::optional<std::int32_t> position; ///< absolute, or the change since the last read in relative mode
    std::optional<std::int32_t> velocity;
    std::optional<std::uint8_t> status;
};
using DataMasks = std::array<std::uint8_t, axes>;
struct Motion {
    std::optional<std::uint16_t> timing;
    std::optional<std::uint8_t> elapsed;
    std::array<AxisMotion, axes> channels;
};

/// The return code that a reply begins with; nothing for an empty one.
[[nodiscard]] std::optional<std::int8_t> returnCode(const Packet &reply);
[[nodiscard]] Message explain(std::int8_t code);
[[nodiscard]] std::optional<Version> parseVersion(const Packet &reply);
[[nodiscard]] std::optional<std::uint16_t> parseStreamPeriod(const Packet &reply);
[[nodiscard]] std::optional<std::uint8_t> parseStreamConfig(const Packet &reply);
[[nodiscard]] std::optional<DataMasks> parseDataMasks(const Packet &reply);
struct History {
    int length = 0;
    int timeBits = 0;
};
[[nodiscard]] std::optional<History> parseHistory(const Packet &reply);
/// Positions of the channels whose size is not 0.
[[nodiscard]] std::optional<std::array<std::optional<std::int32_t>, axes>> parsePositions(
    const Packet &reply, const std::array<std::uint8_t, axes> &sizes);
/// A reply to packet 2, or a stream packet, whose length must fit the masks exactly (README.md#stream).
[[nodiscard]] std::optional<Motion> parseMotion(
    const Packet &packet, const DataMasks &masks, std::uint8_t streamConfig);

/// Bytes of one channel with this data mask, and of whole packets.
[[nodiscard]] std::size_t channelSize(std::uint8_t dataMask);
[[nodiscard]] std::size_t streamPacketSize(const DataMasks &masks, std::uint8_t streamConfig);
/// Whole reply of a request that is accepted.
[[nodiscard]] std::size_t replySize(const Bytes &request, const DataMasks &masks);
/// @}

} // namespace mb::quadquad2drv
