// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/simulatorcommands.h"

#include "wire/bytes.h"

namespace mb::quadquad2drv::simulation {
namespace {

constexpr std::uint32_t fastestRaw = 100'000U * 4096U;
constexpr std::uint32_t steepestRaw = 1'000'000U * 4096U;

constexpr std::size_t sizeOfPosition(std::uint8_t code)
{
    constexpr std::array<std::size_t, 4> sizes{0, 1, 2, 4};
    return sizes[code & 3U];
}

/// Bytes of the tuple that begins here, mask included; 0 for a packet without tuples.
std::size_t tupleSize(std::uint8_t id, Commands::Values from)
{
    switch (static_cast<PacketId>(id)) {
    case PacketId::SetDataMask:
    case PacketId::SetControlMode: return 2;
    case PacketId::SetPosition: return 1 + sizeOfPosition(static_cast<std::uint8_t>(from[0] >> 4U));
    case PacketId::SetInputMode: return from.size() > 1 && (from[1] & 3U) == 0 ? 2 : 8;
    case PacketId::SetPower:
    case PacketId::SetPowerLimit: return 3;
    case PacketId::SetPositionTarget:
    case PacketId::SetVelocityTarget:
    case PacketId::SetVelocityLimit:
    case PacketId::SetAccelerationLimit: return 5;
    case PacketId::SetPositionGains:
    case PacketId::RampVelocity: return 9;
    case PacketId::SetVelocityGains: return 7;
    case PacketId::RampPosition: return 13;
    default: return 0;
    }
}

std::int32_t i32(Commands::Values v, std::size_t at)
{
    return static_cast<std::int32_t>(readU32le(v, at));
}

void put(std::vector<std::uint8_t> &out, std::int32_t value, std::size_t size)
{
    for (std::size_t i = 0; i < size; ++i)
        out.push_back(static_cast<std::uint8_t>(static_cast<std::uint32_t>(value) >> (8U * i)));
}

ReturnCode setRamp(std::uint8_t id, Axis &axis, Commands::Values v)
{
    AxisSettings &s = axis.settings;
    const bool position = static_cast<PacketId>(id) == PacketId::RampPosition;
    if (s.mode != (position ? ControlMode::Position : ControlMode::Velocity))
        return ReturnCode::InvalidCommand;
    const std::uint32_t acceleration = readU32le(v, position ? 8 : 4);
    if (acceleration > steepestRaw)
        return ReturnCode::InvalidParameter;
    if (position) {
        if (readU32le(v, 4) > fastestRaw)
            return ReturnCode::InvalidParameter;
        s.positionTarget = i32(v, 0);
        s.rampVelocity = readU32le(v, 4) / limitOne;
    } else {
        const std::int32_t velocity = i32(v, 0);
        if (velocity < -fastest || velocity > fastest)
            return ReturnCode::InvalidParameter;
        s.velocityTarget = velocity;
        s.rampVelocity = 0.0;
    }
    s.rampAcceleration = acceleration / limitOne;
    return ReturnCode::Ok;
}

ReturnCode setGains(std::uint8_t id, Axis &axis, Commands::Values v)
{
    AxisSettings &s = axis.settings;
    switch (static_cast<PacketId>(id)) {
    case PacketId::SetPowerLimit:
        if (readU16le(v, 0) > fullPower)
            return ReturnCode::InvalidParameter;
        s.powerLimit = readU16le(v, 0);
        return ReturnCode::Ok;
    case PacketId::SetVelocityLimit:
        if (readU32le(v, 0) > fastestRaw)
            return ReturnCode::InvalidParameter;
        s.velocityLimit = readU32le(v, 0);
        return ReturnCode::Ok;
    case PacketId::SetAccelerationLimit:
        if (readU32le(v, 0) > steepestRaw)
            return ReturnCode::InvalidParameter;
        s.accelerationLimit = readU32le(v, 0);
        return ReturnCode::Ok;
    case PacketId::SetPositionGains:
        if (readU16le(v, 6) > fullPower)
            return ReturnCode::InvalidParameter;
        for (std::size_t i = 0; i < s.positionGains.size(); ++i)
            s.positionGains[i] = readU16le(v, 2 * i);
        return ReturnCode::Ok;
    case PacketId::SetVelocityGains:
        for (std::size_t i = 0; i < s.velocityGains.size(); ++i)
            s.velocityGains[i] = readU16le(v, 2 * i);
        return ReturnCode::Ok;
    default: return setRamp(id, axis, v);
    }
}

} // namespace

Commands::Commands(Axes &axes, bool shiftedTarget, std::function<void()> streamChanged)
    : m_axes(axes)
    , m_shiftedTarget(shiftedTarget)
    , m_streamChanged(std::move(streamChanged))
{
}

void Commands::restart()
{
    m_streamPeriod = 0;
    m_streamConfig = 0;
    m_historyLength = 31;
    m_historyBits = 20;
}

std::optional<Commands::Bytes> Commands::answer(std::uint8_t id, Values payload)
{
    const bool bare = payload.empty();
    switch (static_cast<PacketId>(id)) {
    case PacketId::GetVersion:
        if (bare)
            return Bytes(version.begin(), version.end());
        break;
    case PacketId::GetMotion:
        if (bare) {
            Bytes motion;
            appendMotion(motion);
            return motion;
        }
        break;
    case PacketId::GetStreamPeriod:
        if (bare)
            return Bytes{
                static_cast<std::uint8_t>(m_streamPeriod & 0xFFU), static_cast<std::uint8_t>(m_streamPeriod >> 8U)};
        break;
    case PacketId::GetDataMask:
        if (bare) {
            Bytes masks;
            for (const auto &axis : m_axes)
                masks.push_back(axis->settings.dataMask);
            return masks;
        }
        break;
    case PacketId::GetStreamConfig:
        if (bare)
            return Bytes{m_streamConfig};
        break;
    case PacketId::GetPosition:
        if (payload.size() <= 1 || payload.size() == axes)
            return positions(payload);
        break;
    case PacketId::GetHistory:
        if (bare)
            return Bytes{m_historyLength, m_historyBits};
        break;
    default: break;
    }
    return std::nullopt;
}

Commands::Bytes Commands::positions(Values payload)
{
    Bytes out;
    for (std::size_t i = 0; i < axes; ++i) {
        std::uint8_t size = m_axes[i]->settings.dataMask;
        if (payload.size() == axes)
            size = payload[i];
        else if (!payload.empty() && ((payload[0] >> i) & 1U) == 0)
            size = 0;
        put(out, m_axes[i]->counter(), sizeOfPosition(size));
    }
    return out;
}

void Commands::appendMotion(Bytes &out)
{
    for (const auto &axis : m_axes) {
        const std::uint8_t mask = axis->settings.dataMask;
        if (const std::size_t size = sizeOfPosition(mask); size > 0)
            put(out, (mask & datamask::relative) != 0 ? axis->takeChange() : axis->counter(), size);
        if ((mask & datamask::velocity) != 0)
            put(out, axis->velocity(), 4);
        if ((mask & datamask::status) != 0)
            out.push_back(axis->takeStatus());
    }
}

ReturnCode Commands::set(std::uint8_t id, Values payload)
{
    if (id % 2 == 1 || id < 4 || id > 36)
        return id >= 1 && id <= 13 ? ReturnCode::InvalidData : ReturnCode::InvalidCommand;
    if (payload.empty())
        return ReturnCode::InvalidData;
    return tupleSize(id, payload) == 0 ? setWhole(id, payload) : setTuples(id, payload);
}

ReturnCode Commands::setWhole(std::uint8_t id, Values payload)
{
    switch (static_cast<PacketId>(id)) {
    case PacketId::SetStreamPeriod:
        if (payload.size() != 2)
            return ReturnCode::InvalidData;
        m_streamPeriod = readU16le(payload, 0);
        m_streamChanged();
        return ReturnCode::Ok;
    case PacketId::SetStreamConfig:
        if (payload.size() != 1)
            return ReturnCode::InvalidData;
        if (payload[0] > 3)
            return ReturnCode::InvalidParameter;
        m_streamConfig = payload[0];
        return ReturnCode::Ok;
    case PacketId::SetHistory:
        if (payload.size() != 2)
            return ReturnCode::InvalidData;
        if (payload[0] < 2 || payload[0] > 127 || payload[1] < 14 || payload[1] > 32)
            return ReturnCode::InvalidParameter;
        m_historyLength = payload[0];
        m_historyBits = payload[1];
        for (const auto &axis : m_axes)
            axis->setHistory(m_historyLength, m_historyBits);
        return ReturnCode::Ok;
    default: return ReturnCode::InvalidCommand;
    }
}

ReturnCode Commands::setTuples(std::uint8_t id, Values payload)
{
    while (!payload.empty()) {
        const std::size_t size = tupleSize(id, payload);
        if (payload.size() < size)
            return ReturnCode::InvalidData;
        for (std::size_t i = 0; i < axes; ++i) {
            if (((payload[0] >> i) & 1U) == 0)
                continue;
            // the sizes of packet 10 are in the upper bits of its mask
            const Values values = static_cast<PacketId>(id) == PacketId::SetPosition ? payload.first(size)
                                                                                     : payload.subspan(1, size - 1);
            if (const ReturnCode code = setTuple(id, *m_axes[i], values); code != ReturnCode::Ok)
                return code;
        }
        payload = payload.subspan(size);
    }
    return ReturnCode::Ok;
}

ReturnCode Commands::setTuple(std::uint8_t id, Axis &axis, Values v)
{
    AxisSettings &s = axis.settings;
    switch (static_cast<PacketId>(id)) {
    case PacketId::SetDataMask:
        if ((v[0] & 0xD0U) != 0)
            return ReturnCode::InvalidParameter;
        s.dataMask = v[0];
        return ReturnCode::Ok;
    case PacketId::SetPosition:
        switch (v.size()) {
        case 1: axis.setCounter(0); break;
        case 2: axis.setCounter(signExtend(v[1], 8)); break;
        case 3: axis.setCounter(signExtend(readU16le(v, 1), 16)); break;
        default: axis.setCounter(i32(v, 1)); break;
        }
        return ReturnCode::Ok;
    case PacketId::SetInputMode:
        s.input = v[0];
        s.inputSpacing = v.size() > 1 ? readU16le(v, 1) : std::uint16_t{0};
        s.inputPosition = v.size() > 1 ? i32(v, 3) : 0;
        return ReturnCode::Ok;
    case PacketId::SetControlMode:
        if (v[0] > 3)
            return ReturnCode::InvalidParameter;
        axis.setMode(static_cast<ControlMode>(v[0]));
        return ReturnCode::Ok;
    default: return setMotion(id, axis, v);
    }
}

ReturnCode Commands::setMotion(std::uint8_t id, Axis &axis, Values v)
{
    AxisSettings &s = axis.settings;
    switch (static_cast<PacketId>(id)) {
    case PacketId::SetPower: {
        const std::int32_t power = signExtend(readU16le(v, 0), 16);
        if (power < -fullPower || power > fullPower)
            return ReturnCode::InvalidParameter;
        s.power = static_cast<std::int16_t>(power);
        return ReturnCode::Ok;
    }
    case PacketId::SetPositionTarget:
        s.positionTarget = i32(v, 0);
        s.rampVelocity = s.rampAcceleration = 0.0;
        return ReturnCode::Ok;
    case PacketId::SetVelocityTarget: {
        const double target = m_shiftedTarget ? i32(v, 0) / limitOne : i32(v, 0);
        if (target < -fastest || target > fastest)
            return ReturnCode::InvalidParameter;
        s.velocityTarget = target;
        s.rampVelocity = s.rampAcceleration = 0.0;
        return ReturnCode::Ok;
    }
    default: return setGains(id, axis, v);
    }
}

} // namespace mb::quadquad2drv::simulation
