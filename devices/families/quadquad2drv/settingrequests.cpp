// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/settingrequests.h"

#include "families/quadquad2drv/calibrations.h"

#include <cmath>
#include <utility>

namespace mb::quadquad2drv {

Readings SettingRequests::readings() const
{
    Readings now;
    now.velocityTargetShifted = m_profile.calibrated(calibration::targetShift) == calibration::shiftedTarget;
    now.libraryPolarity = m_profile.calibrated(calibration::inputReading) == calibration::asLibrary;
    return now;
}

std::int64_t SettingRequests::known(ParameterIndex index) const
{
    const Parameter &row = m_known.parameter(index);
    return m_known.entry(index).raw.value_or(std::llround(row.fallback * row.one));
}

std::int64_t SettingRequests::known(int axis, AxisParameter which) const
{
    const ParameterIndex index = indexOf(axis, which);
    return which == AxisParameter::LimitPower ? m_known.entry(index).raw.value_or(firstPowerLimit) : known(index);
}

void SettingRequests::assume(int axis, AxisParameter from, AxisParameter to)
{
    for (int i = static_cast<int>(from); i <= static_cast<int>(to); ++i) {
        const auto which = static_cast<AxisParameter>(i);
        const ParameterIndex index = indexOf(axis, which);
        if (!m_known.entry(index).raw)
            m_known.setWritten(index, known(axis, which));
    }
}

void SettingRequests::accepted(ParameterIndex index, std::optional<std::int64_t> raw)
{
    if (m_known.parameter(index).access != Access::WriteOnly)
        return;
    using enum AxisParameter;
    const int axis = index.value / parametersPerAxis;
    const auto which = static_cast<AxisParameter>(index.value % parametersPerAxis);
    if (raw)
        m_known.setWritten(index, *raw);
    if (which <= PositionWindup)
        assume(axis, PositionP, PositionWindup);
    else if (which <= VelocityD)
        assume(axis, VelocityP, VelocityD);
    else if (which <= LimitAcceleration)
        assume(axis, which, which);
    else if (which >= InputMode && which <= InputPosition)
        assume(axis, InputMode, InputPosition);
}

Bytes SettingRequests::group(int axis, AxisParameter which, std::int64_t raw) const
{
    const auto value = [&](AxisParameter other) { return other == which ? raw : known(axis, other); };
    const auto gain = [&](AxisParameter other) { return static_cast<std::uint16_t>(value(other)); };
    using enum AxisParameter;
    if (which <= PositionWindup)
        return setPositionGains(
            maskOf(axis), {gain(PositionP), gain(PositionI), gain(PositionD), gain(PositionWindup)});
    if (which <= VelocityD)
        return setVelocityGains(maskOf(axis), {gain(VelocityP), gain(VelocityI), gain(VelocityD)});
    InputSettings input;
    input.configuration = inputConfiguration(static_cast<int>(value(InputMode)), static_cast<int>(value(InputPolarity)),
        static_cast<int>(value(InputEdge)), readings());
    input.spacing = gain(InputSpacing);
    input.position = static_cast<std::int32_t>(value(InputPosition));
    return setInputMode(maskOf(axis), input);
}

Bytes SettingRequests::writeBoard(BoardParameter which, std::uint32_t bits) const
{
    const auto value = [&](BoardParameter other) {
        return static_cast<std::uint8_t>(other == which ? bits : known(indexOf(other)));
    };
    switch (which) {
    case BoardParameter::StreamPeriod: return setStreamPeriod(static_cast<std::uint16_t>(bits));
    case BoardParameter::StreamConfig: return setStreamConfig(static_cast<std::uint8_t>(bits));
    case BoardParameter::HistoryLength:
    case BoardParameter::HistoryTimeBits: break;
    }
    return setHistory(value(BoardParameter::HistoryLength), value(BoardParameter::HistoryTimeBits));
}

Bytes SettingRequests::write(ParameterIndex index, std::int64_t raw) const
{
    const auto bits = static_cast<std::uint32_t>(raw);
    if (isBoard(index))
        return writeBoard(static_cast<BoardParameter>(index.value - axes * parametersPerAxis), bits);
    const int axis = index.value / parametersPerAxis;
    const auto which = static_cast<AxisParameter>(index.value % parametersPerAxis);
    switch (which) {
    case AxisParameter::LimitPower: return setPowerLimit(maskOf(axis), static_cast<std::uint16_t>(bits));
    case AxisParameter::LimitVelocity: return setVelocityLimit(maskOf(axis), bits);
    case AxisParameter::LimitAcceleration: return setAccelerationLimit(maskOf(axis), bits);
    case AxisParameter::DataMask: return setDataMask(maskOf(axis), static_cast<std::uint8_t>(bits));
    case AxisParameter::Counter: return setPosition(maskOf(axis), 3, static_cast<std::int32_t>(raw));
    default: return group(axis, which, raw);
    }
}

std::vector<Bytes> SettingRequests::ofAxis(int axis) const
{
    using enum AxisParameter;
    const auto bits = [&](AxisParameter which) { return static_cast<std::uint32_t>(known(axis, which)); };
    return {
        setPowerLimit(maskOf(axis), static_cast<std::uint16_t>(bits(LimitPower))),
        setVelocityLimit(maskOf(axis), bits(LimitVelocity)),
        setAccelerationLimit(maskOf(axis), bits(LimitAcceleration)),
        group(axis, PositionP, known(axis, PositionP)),
        group(axis, VelocityP, known(axis, VelocityP)),
    };
}

Bytes SettingRequests::input(int axis) const
{
    return group(axis, AxisParameter::InputMode, known(axis, AxisParameter::InputMode));
}

bool SettingRequests::takeReadingChange()
{
    const bool library = readings().libraryPolarity;
    return library != std::exchange(m_libraryPolarity, library);
}

std::vector<Bytes> SettingRequests::writtenInputs() const
{
    std::vector<Bytes> inputs;
    for (int axis = 0; axis < axes; ++axis) {
        if (m_known.entry(indexOf(axis, AxisParameter::InputMode)).raw)
            inputs.push_back(input(axis));
    }
    return inputs;
}

std::optional<Bytes> SettingRequests::firstLimit(int axis) const
{
    if (m_known.entry(indexOf(axis, AxisParameter::LimitPower)).raw)
        return std::nullopt;
    return setPowerLimit(maskOf(axis), static_cast<std::uint16_t>(firstPowerLimit));
}

namespace {

Task<std::int64_t> readBoard(PacketPort &port, BoardParameter which)
{
    constexpr std::array<PacketId, 4> requests{
        PacketId::GetStreamPeriod, PacketId::GetStreamConfig, PacketId::GetHistory, PacketId::GetHistory};
    auto asking = port.request(getRequest(requests[static_cast<std::size_t>(which)]));
    const Packet reply = co_await std::move(asking);
    std::optional<std::int64_t> value;
    if (which == BoardParameter::StreamPeriod)
        value = parseStreamPeriod(reply);
    else if (which == BoardParameter::StreamConfig)
        value = parseStreamConfig(reply);
    else if (const auto history = parseHistory(reply))
        value = which == BoardParameter::HistoryLength ? history->length : history->timeBits;
    if (!value)
        co_return fail(Fault::BadReply, say("the reply has an unexpected length"));
    co_return *value;
}

} // namespace

Task<std::int64_t> readParameter(PacketPort &port, ParameterIndex index)
{
    if (isBoard(index)) {
        auto reading = readBoard(port, static_cast<BoardParameter>(index.value - axes * parametersPerAxis));
        const std::int64_t value = co_await std::move(reading);
        co_return value;
    }
    const auto axis = static_cast<std::size_t>(index.value / parametersPerAxis);
    if (static_cast<AxisParameter>(index.value % parametersPerAxis) == AxisParameter::DataMask) {
        const Packet reply = co_await port.request(getRequest(PacketId::GetDataMask));
        const auto masks = parseDataMasks(reply);
        if (!masks)
            co_return fail(Fault::BadReply, say("the data masks have an unexpected length"));
        co_return (*masks)[axis];
    }
    std::array<std::uint8_t, axes> sizes{};
    sizes[axis] = datamask::positionSize;
    const Packet reply = co_await port.request(getPositions(sizes));
    const auto positions = parsePositions(reply, sizes);
    if (!positions)
        co_return fail(Fault::BadReply, say("the positions have an unexpected length"));
    co_return *(*positions)[axis];
}

} // namespace mb::quadquad2drv
