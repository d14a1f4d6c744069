// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/codec.h"

#include "wire/bytes.h"
#include "wire/fixedpoint.h"

#include <algorithm>
#include <numeric>

namespace mb::quadquad2drv {
namespace {

constexpr std::array<std::size_t, 4> positionBytes{0, 1, 2, 4};

/// Each value with the bytes of its type, the least first.
template <class... Values> Bytes request(PacketId id, Values... values)
{
    Bytes payload;
    const auto put = [&payload](auto value) {
        for (std::size_t i = 0; i < sizeof value; ++i)
            payload.push_back(static_cast<std::uint8_t>(static_cast<std::uint32_t>(value) >> (8U * i)));
    };
    (put(values), ...);
    return encode(static_cast<std::uint8_t>(id), payload);
}

std::uint32_t limitRaw(double value)
{
    return static_cast<std::uint32_t>(toFixed(value, limitOne));
}

bool isReply(const Packet &packet, PacketId id, std::size_t size)
{
    return packet.id == static_cast<std::uint8_t>(id) && packet.payload.size() == size && packet.payload[0] == 0;
}

std::int32_t readSigned(std::span<const std::uint8_t> bytes, std::size_t at, std::size_t size)
{
    switch (size) {
    case 1: return signExtend(bytes[at], 8);
    case 2: return signExtend(readU16le(bytes, at), 16);
    default: return signExtend(readU32le(bytes, at), 32);
    }
}

} // namespace

std::uint8_t checksum(std::span<const std::uint8_t> bytes)
{
    return static_cast<std::uint8_t>(0U - std::accumulate(bytes.begin(), bytes.end(), 0U));
}

Bytes encode(std::uint8_t id, std::span<const std::uint8_t> payload)
{
    Bytes out{stx, static_cast<std::uint8_t>(payload.size() + overhead), id};
    out.insert(out.end(), payload.begin(), payload.end());
    out.push_back(checksum(out));
    return out;
}

void PacketReader::align()
{
    const auto begin = std::ranges::find(m_bytes, stx);
    if (std::any_of(m_bytes.begin(), begin, [](std::uint8_t byte) { return byte != 0; }))
        ++m_strays;
    drop(static_cast<std::size_t>(begin - m_bytes.begin()));
}

void PacketReader::giveUp()
{
    ++m_bad;
    drop(1);
}

void PacketReader::drop(std::size_t count)
{
    m_bytes.erase(m_bytes.begin(), m_bytes.begin() + static_cast<std::ptrdiff_t>(count));
    m_taken += count;
}

std::optional<Packet> PacketReader::next()
{
    for (align(); m_bytes.size() >= 2; align()) {
        const std::size_t size = m_bytes[1];
        if (size < overhead) {
            giveUp();
            continue;
        }
        if (m_bytes.size() < size)
            return std::nullopt;
        const auto end = m_bytes.begin() + static_cast<std::ptrdiff_t>(size);
        if (checksum({m_bytes.data(), size}) != 0) {
            giveUp();
            continue;
        }
        Packet found{m_bytes[2], Bytes(m_bytes.begin() + 3, end - 1)};
        drop(size);
        return found;
    }
    return std::nullopt;
}

std::size_t PacketReader::missing()
{
    align();
    if (m_bytes.empty())
        return 0;
    if (m_bytes.size() < 2)
        return 1;
    return m_bytes[1] > m_bytes.size() ? m_bytes[1] - m_bytes.size() : 0;
}

Bytes getRequest(PacketId id)
{
    return encode(static_cast<std::uint8_t>(id), {});
}

Bytes setStreamPeriod(std::uint16_t units)
{
    return request(PacketId::SetStreamPeriod, units);
}

Bytes setDataMask(std::uint8_t mask, std::uint8_t data)
{
    return request(PacketId::SetDataMask, mask, data);
}

Bytes setStreamConfig(std::uint8_t bits)
{
    return request(PacketId::SetStreamConfig, bits);
}

Bytes setPosition(std::uint8_t mask, int size, std::int32_t position)
{
    Bytes payload{static_cast<std::uint8_t>(mask | (size << 4))};
    const auto value = static_cast<std::uint32_t>(position);
    for (std::size_t i = 0; i < positionBytes[static_cast<std::size_t>(size)]; ++i)
        payload.push_back(static_cast<std::uint8_t>(value >> (8U * i)));
    return encode(static_cast<std::uint8_t>(PacketId::SetPosition), payload);
}

Bytes getPositions(const std::array<std::uint8_t, axes> &sizes)
{
    return encode(static_cast<std::uint8_t>(PacketId::GetPosition), sizes);
}

Bytes getPositions(std::uint8_t mask)
{
    return request(PacketId::GetPosition, mask);
}

Bytes setHistory(std::uint8_t length, std::uint8_t timeBits)
{
    return request(PacketId::SetHistory, length, timeBits);
}

std::uint8_t inputConfiguration(int mode, int polarity, int edge, const Readings &readings)
{
    constexpr std::array<int, 4> edgeOfSheet{0, 2, 1, 3};
    if (mode == static_cast<int>(InputMode::Disabled))
        return 0;
    const int bit = readings.libraryPolarity ? polarity : 1 - polarity;
    const int code = readings.libraryPolarity ? edge : edgeOfSheet[static_cast<std::size_t>(edge & 3)];
    return static_cast<std::uint8_t>(mode | bit << 3 | code << 4);
}

Bytes setInputMode(std::uint8_t mask, const InputSettings &settings)
{
    if ((settings.configuration & 0x03U) == static_cast<unsigned>(InputMode::Disabled))
        return request(PacketId::SetInputMode, mask, settings.configuration);
    return request(PacketId::SetInputMode, mask, settings.configuration, settings.spacing, settings.position);
}

Bytes setControlMode(std::uint8_t mask, ControlMode mode)
{
    return request(PacketId::SetControlMode, mask, static_cast<std::uint8_t>(mode));
}

Bytes setPower(std::uint8_t mask, std::int16_t power)
{
    return request(PacketId::SetPower, mask, power);
}

Bytes setPositionTarget(std::uint8_t mask, std::int32_t counts)
{
    return request(PacketId::SetPositionTarget, mask, counts);
}

Bytes setVelocityTarget(std::uint8_t mask, double countsPerSecond, const Readings &readings)
{
    const auto raw = toFixed(countsPerSecond, readings.velocityTargetShifted ? limitOne : 1.0);
    return request(PacketId::SetVelocityTarget, mask, static_cast<std::int32_t>(raw));
}

Bytes setPowerLimit(std::uint8_t mask, std::uint16_t power)
{
    return request(PacketId::SetPowerLimit, mask, power);
}

Bytes setVelocityLimit(std::uint8_t mask, std::uint32_t raw)
{
    return request(PacketId::SetVelocityLimit, mask, raw);
}

Bytes setAccelerationLimit(std::uint8_t mask, std::uint32_t raw)
{
    return request(PacketId::SetAccelerationLimit, mask, raw);
}

Bytes setPositionGains(std::uint8_t mask, const std::array<std::uint16_t, 4> &pidWindup)
{
    const auto [p, i, d, windup] = pidWindup;
    return request(PacketId::SetPositionGains, mask, p, i, d, windup);
}

Bytes setVelocityGains(std::uint8_t mask, const std::array<std::uint16_t, 3> &pid)
{
    const auto [p, i, d] = pid;
    return request(PacketId::SetVelocityGains, mask, p, i, d);
}

Bytes rampPosition(std::uint8_t mask, std::int32_t counts, double velocity, double acceleration)
{
    return request(PacketId::RampPosition, mask, counts, limitRaw(velocity), limitRaw(acceleration));
}

Bytes rampVelocity(std::uint8_t mask, std::int32_t countsPerSecond, double acceleration)
{
    return request(PacketId::RampVelocity, mask, countsPerSecond, limitRaw(acceleration));
}

std::optional<std::int8_t> returnCode(const Packet &reply)
{
    if (reply.payload.empty())
        return std::nullopt;
    return static_cast<std::int8_t>(reply.payload[0]);
}

Message explain(std::int8_t code)
{
    switch (static_cast<ReturnCode>(code)) {
    case ReturnCode::Ok: return say("accepted");
    case ReturnCode::Overflow: return say("the packet is too long for the board");
    case ReturnCode::InvalidCommand: return say("the board does not know this command");
    case ReturnCode::InvalidParameter: return say("the board refused a value");
    case ReturnCode::InvalidData: return say("the board found the packet malformed");
    case ReturnCode::Unspecified: break;
    }
    return say("the board answered with an error that its documents do not name");
}

std::optional<Version> parseVersion(const Packet &reply)
{
    if (!isReply(reply, PacketId::GetVersion, 4))
        return std::nullopt;
    return Version{reply.payload[1], reply.payload[2], reply.payload[3]};
}

std::optional<std::uint16_t> parseStreamPeriod(const Packet &reply)
{
    if (!isReply(reply, PacketId::GetStreamPeriod, 3))
        return std::nullopt;
    return readU16le(reply.payload, 1);
}

std::optional<std::uint8_t> parseStreamConfig(const Packet &reply)
{
    if (!isReply(reply, PacketId::GetStreamConfig, 2))
        return std::nullopt;
    return reply.payload[1];
}

std::optional<DataMasks> parseDataMasks(const Packet &reply)
{
    if (!isReply(reply, PacketId::GetDataMask, 1 + axes))
        return std::nullopt;
    DataMasks masks{};
    std::copy_n(reply.payload.begin() + 1, axes, masks.begin());
    return masks;
}

std::optional<History> parseHistory(const Packet &reply)
{
    if (!isReply(reply, PacketId::GetHistory, 3))
        return std::nullopt;
    return History{reply.payload[1], reply.payload[2]};
}

std::optional<std::array<std::optional<std::int32_t>, axes>> parsePositions(
    const Packet &reply, const std::array<std::uint8_t, axes> &sizes)
{
    std::size_t expected = 1;
    for (const std::uint8_t size : sizes)
        expected += positionBytes[size & datamask::positionSize];
    if (!isReply(reply, PacketId::GetPosition, expected))
        return std::nullopt;
    std::array<std::optional<std::int32_t>, axes> positions;
    std::size_t at = 1;
    for (std::size_t i = 0; i < axes; ++i) {
        const std::size_t size = positionBytes[sizes[i] & datamask::positionSize];
        if (size > 0)
            positions[i] = readSigned(reply.payload, at, size);
        at += size;
    }
    return positions;
}

std::size_t channelSize(std::uint8_t dataMask)
{
    return positionBytes[dataMask & datamask::positionSize] + ((dataMask & datamask::velocity) != 0 ? 4U : 0U)
        + ((dataMask & datamask::status) != 0 ? 1U : 0U);
}

std::size_t streamPacketSize(const DataMasks &masks, std::uint8_t streamConfig)
{
    std::size_t size = overhead + ((streamConfig & streamconfig::timing) != 0 ? 2U : 0U)
        + ((streamConfig & streamconfig::elapsed) != 0 ? 1U : 0U);
    for (const std::uint8_t mask : masks)
        size += channelSize(mask);
    return size;
}

std::optional<Motion> parseMotion(const Packet &packet, const DataMasks &masks, std::uint8_t streamConfig)
{
    const bool stream = packet.id == static_cast<std::uint8_t>(PacketId::Stream);
    const std::size_t expected = streamPacketSize(masks, stream ? streamConfig : 0U) - overhead + (stream ? 0U : 1U);
    if (packet.payload.size() != expected)
        return std::nullopt;
    if (!stream && !isReply(packet, PacketId::GetMotion, expected))
        return std::nullopt;
    const auto &bytes = packet.payload;
    Motion motion;
    std::size_t at = stream ? 0 : 1;
    if (stream && (streamConfig & streamconfig::timing) != 0) {
        motion.timing = readU16le(bytes, at);
        at += 2;
    }
    if (stream && (streamConfig & streamconfig::elapsed) != 0)
        motion.elapsed = bytes[at++];
    for (std::size_t i = 0; i < axes; ++i) {
        AxisMotion &axis = motion.channels[i];
        if (const std::size_t size = positionBytes[masks[i] & datamask::positionSize]; size > 0) {
            axis.position = readSigned(bytes, at, size);
            at += size;
        }
        if ((masks[i] & datamask::velocity) != 0) {
            axis.velocity = readSigned(bytes, at, 4);
            at += 4;
        }
        if ((masks[i] & datamask::status) != 0)
            axis.status = bytes[at++];
    }
    return motion;
}

std::size_t replySize(const Bytes &request, const DataMasks &masks)
{
    switch (static_cast<PacketId>(request[2])) {
    case PacketId::GetVersion: return overhead + 4;
    case PacketId::GetMotion: return streamPacketSize(masks, 0) + 1;
    case PacketId::GetStreamPeriod:
    case PacketId::GetHistory: return overhead + 3;
    case PacketId::GetStreamConfig: return overhead + 2;
    case PacketId::GetDataMask: return overhead + 1 + axes;
    case PacketId::GetPosition: break;
    default: return overhead + 1;
    }
    std::size_t size = overhead + 1;
    const std::size_t payload = request.size() - overhead;
    for (std::size_t i = 0; i < axes; ++i) {
        if (payload == axes)
            size += positionBytes[request[3 + i] & datamask::positionSize];
        else if (payload == 0 || (request[3] >> i & 1U) != 0)
            size += positionBytes[masks[i] & datamask::positionSize];
    }
    return size;
}

} // namespace mb::quadquad2drv
