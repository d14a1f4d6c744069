// SPDX-License-Identifier: GPL-3.0-or-later
// Controller: what asks and waits.
#include "families/quadquad2drv/controller.h"

#include "async/sleep.h"
#include "families/quadquad2drv/calibrations.h"
#include "families/quadquad2drv/channels.h"
#include "families/quadquad2drv/scan.h"

#include <algorithm>
#include <cmath>

namespace mb::quadquad2drv {
namespace {

constexpr Duration startTime = std::chrono::milliseconds(100); ///< after a reset (README.md#waiting-packets)

bool isBoard(ParameterIndex index)
{
    return index.value >= axes * parametersPerAxis;
}

} // namespace

Task<void> Controller::doRefresh()
{
    auto asking = m_port.request(getRequest(PacketId::GetVersion));
    const Packet reply = co_await std::move(asking);
    const auto version = parseVersion(reply);
    if (!version)
        co_return fail(Fault::BadReply, "the version has an unexpected length");
    auto judging = checkReset();
    co_await std::move(judging);
    auto layout = takeLayout();
    co_await std::move(layout);
    Identity known = identity();
    setVersion(known, version->major, version->minor, version->protocol);
    m_restarted = false;
    setIdentity(std::move(known));
    updateLiveness();
    co_return {};
}

/// 2.1: replies must fit the masks exactly, so these are read before anything is understood.
Task<void> Controller::takeLayout()
{
    auto masksTask = m_port.request(getRequest(PacketId::GetDataMask));
    const Packet masksReply = co_await std::move(masksTask);
    auto configTask = m_port.request(getRequest(PacketId::GetStreamConfig));
    const Packet configReply = co_await std::move(configTask);
    auto periodTask = m_port.request(getRequest(PacketId::GetStreamPeriod));
    const Packet periodReply = co_await std::move(periodTask);
    const auto masks = parseDataMasks(masksReply);
    const auto config = parseStreamConfig(configReply);
    const auto period = parseStreamPeriod(periodReply);
    if (!masks || !config || !period)
        co_return fail(Fault::BadReply, "the stream settings have an unexpected length");
    judge(*masks);
    m_port.setLayout(*masks, *config);
    m_streamPeriod = *period;
    schedulePoll();
    co_return {};
}

/// Whole positions, velocity and status of every channel. Afterwards a reset before now could not be seen any more.
Task<void> Controller::tellEverything()
{
    if (!m_judged) {
        auto judging = checkReset();
        co_await std::move(judging);
        if (m_restarted)
            co_return fail(Fault::Unsafe, "the board was reset since its settings were written", "look at it again");
    }
    auto masks = m_port.request(setDataMask(allAxes, datamask::everything));
    co_await std::move(masks);
    m_changed = true;
    auto layout = takeLayout();
    co_await std::move(layout);
    co_return {};
}

Task<std::int64_t> Controller::readBoard(BoardParameter which)
{
    constexpr std::array<PacketId, 4> requests{
        PacketId::GetStreamPeriod, PacketId::GetStreamConfig, PacketId::GetHistory, PacketId::GetHistory};
    auto asking = m_port.request(getRequest(requests[static_cast<std::size_t>(which)]));
    const Packet reply = co_await std::move(asking);
    std::optional<std::int64_t> value;
    if (which == BoardParameter::StreamPeriod)
        value = parseStreamPeriod(reply);
    else if (which == BoardParameter::StreamConfig)
        value = parseStreamConfig(reply);
    else if (const auto history = parseHistory(reply))
        value = which == BoardParameter::HistoryLength ? history->length : history->timeBits;
    if (!value)
        co_return fail(Fault::BadReply, "the reply has an unexpected length");
    co_return *value;
}

Task<std::int64_t> Controller::doRead(ParameterIndex index)
{
    if (isBoard(index)) {
        auto reading = readBoard(static_cast<BoardParameter>(index.value - axes * parametersPerAxis));
        const std::int64_t value = co_await std::move(reading);
        co_return value;
    }
    const auto axis = static_cast<std::size_t>(index.value / parametersPerAxis);
    if (static_cast<AxisParameter>(index.value % parametersPerAxis) == AxisParameter::DataMask) {
        auto asking = m_port.request(getRequest(PacketId::GetDataMask));
        const Packet reply = co_await std::move(asking);
        const auto masks = parseDataMasks(reply);
        if (!masks)
            co_return fail(Fault::BadReply, "the data masks have an unexpected length");
        co_return (*masks)[axis];
    }
    std::array<std::uint8_t, axes> sizes{};
    sizes[axis] = datamask::positionSize;
    auto asking = m_port.request(getPositions(sizes));
    const Packet reply = co_await std::move(asking);
    const auto positions = parsePositions(reply, sizes);
    if (!positions)
        co_return fail(Fault::BadReply, "the positions have an unexpected length");
    co_return *(*positions)[axis];
}

/// What was written, or else what the board starts with; assumed from then on, because a group travels whole.
std::int64_t Controller::known(int axis, AxisParameter which)
{
    const ParameterIndex index = indexOf(axis, which);
    if (const auto raw = parameters().entry(index).raw)
        return *raw;
    const Parameter &row = parameters().parameter(index);
    const auto raw = static_cast<std::int64_t>(std::llround(row.fallback * row.one));
    parameters().setWritten(index, raw);
    return raw;
}

Bytes Controller::groupRequest(int axis, AxisParameter which, std::int64_t raw)
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

Result<Bytes> Controller::writeRequest(ParameterIndex index, std::int64_t raw)
{
    const auto bits = static_cast<std::uint32_t>(raw);
    if (isBoard(index)) {
        const auto length = parameters().entry(indexOf(BoardParameter::HistoryLength)).raw;
        const auto timeBits = parameters().entry(indexOf(BoardParameter::HistoryTimeBits)).raw;
        switch (static_cast<BoardParameter>(index.value - axes * parametersPerAxis)) {
        case BoardParameter::StreamPeriod: return setStreamPeriod(static_cast<std::uint16_t>(bits));
        case BoardParameter::StreamConfig: return setStreamConfig(static_cast<std::uint8_t>(bits));
        case BoardParameter::HistoryLength:
            return setHistory(static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(timeBits.value_or(20)));
        case BoardParameter::HistoryTimeBits:
            return setHistory(static_cast<std::uint8_t>(length.value_or(31)), static_cast<std::uint8_t>(bits));
        }
    }
    const int axis = index.value / parametersPerAxis;
    const auto which = static_cast<AxisParameter>(index.value % parametersPerAxis);
    switch (which) {
    case AxisParameter::LimitPower: return setPowerLimit(maskOf(axis), static_cast<std::uint16_t>(bits));
    case AxisParameter::LimitVelocity: return setVelocityLimit(maskOf(axis), bits);
    case AxisParameter::LimitAcceleration: return setAccelerationLimit(maskOf(axis), bits);
    case AxisParameter::DataMask: return setDataMask(maskOf(axis), static_cast<std::uint8_t>(bits));
    case AxisParameter::Counter:
        if (m_drives[static_cast<std::size_t>(axis)].mode == ControlMode::Position)
            return fail(Fault::Unsafe, "in position mode a new counter would make the motor jump", "stop it first");
        return setPosition(maskOf(axis), 3, static_cast<std::int32_t>(raw));
    default: return groupRequest(axis, which, raw);
    }
}

Task<std::int64_t> Controller::doWrite(ParameterIndex index, std::int64_t raw)
{
    const Parameter &row = parameters().parameter(index);
    if (isBoard(index)) { // its two halves travel together
        for (const BoardParameter other : {BoardParameter::HistoryLength, BoardParameter::HistoryTimeBits}) {
            auto reading = readBoard(other);
            parameters().setRead(indexOf(other), co_await std::move(reading));
        }
    }
    if (m_port.masks()[0] == datamask::startUp) {
        auto telling = tellEverything();
        co_await std::move(telling);
    }
    auto request = writeRequest(index, raw);
    if (!request)
        co_return fail(request.error());
    m_changed = true;
    auto writing = m_port.request(std::move(*request));
    const Result<Packet> reply = co_await std::move(writing).attempt();
    if (!reply)
        co_return fail(reply.error().about(row.key));
    if (!isBoard(index) && static_cast<AxisParameter>(index.value % parametersPerAxis) == AxisParameter::DataMask) {
        DataMasks masks = m_port.masks(); // told, and so no sign of a reset
        masks[index.value / parametersPerAxis] = static_cast<std::uint8_t>(raw);
        m_port.setLayout(masks, m_port.streamConfig());
    }
    auto layout = takeLayout();
    co_await std::move(layout);
    if (row.access == Access::WriteOnly)
        co_return raw;
    auto reading = doRead(index);
    const std::int64_t inForce = co_await std::move(reading);
    co_return inForce;
}

Task<bool> Controller::doStore(Progress &)
{
    co_return fail(Fault::Unsupported, "the board keeps nothing without power",
        "the values stay with this program and are written again after a reset");
}

Task<std::vector<FaultRecord>> Controller::doReadFaults()
{
    std::vector<FaultRecord> faults;
    for (std::size_t axis = 0; axis < axes; ++axis) {
        const std::string prefix = "ch" + std::to_string(axis + 1) + '.';
        const std::uint8_t bits = m_tracked[axis].status;
        faults.push_back({prefix + "glitch", (bits & status::glitch) != 0, false, std::nullopt});
        faults.push_back({prefix + "overspeed", (bits & status::overspeed) != 0, false, std::nullopt});
    }
    co_return faults;
}

Task<void> Controller::doIdentify()
{
    co_return fail(Fault::Unsupported, "the board cannot blink");
}

Task<void> Controller::doRestart()
{
    if (auto pulsed = m_spi.pulseReset(); !pulsed)
        co_return pulsed;
    forgetBoard();
    co_await Sleep(clock(), startTime);
    auto refreshing = doRefresh();
    co_await std::move(refreshing);
    co_return {};
}

Task<void> Controller::doRename(std::string)
{
    co_return fail(Fault::Unsupported, "the board has no name");
}

Task<void> Controller::doRenumber(int)
{
    co_return fail(Fault::Unsupported, "the board has no number: chip select tells boards apart");
}

/// One rate for the whole board; the period is a multiple of 40.96 µs, at least one pass of the loop (README.md#ready-line).
Task<void> Controller::doSetRate(ChannelIndex channel, double hertz)
{
    m_wishes.set(channel, hertz);
    const double wished = m_wishes.highest();
    std::uint16_t period = 0;
    if (wished > 0.0) {
        const double units = 1e9 / wished / static_cast<double>(streamUnit.count());
        period = static_cast<std::uint16_t>(std::clamp(std::round(units), 1.0 * fastestStream, 65535.0));
    }
    if (period == m_streamPeriod && (period == 0 || m_told)) // another channel wishes the same, or more
        co_return {};
    if (period > 0) {
        auto telling = tellEverything();
        co_await std::move(telling);
        auto config = m_port.request(setStreamConfig(streamconfig::elapsed));
        co_await std::move(config);
    }
    if (!m_spi.ready().has_value())
        co_return fail(
            Fault::Unsupported, "without a ready line the board is asked 100 times a second, and cannot stream");
    auto setting = m_port.request(setStreamPeriod(period));
    co_await std::move(setting);
    auto layout = takeLayout();
    co_await std::move(layout);
    m_told = period > 0;
    m_spi.watchReady(streamUnit * period / 4);
    for (int axis = 0; axis < axes; ++axis) {
        for (std::uint16_t i = 0; i < measuredPerAxis; ++i)
            telemetry()->breakLine(channelOf(axis, static_cast<AxisChannel>(i)));
    }
    co_return {};
}

} // namespace mb::quadquad2drv
