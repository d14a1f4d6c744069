// SPDX-License-Identifier: GPL-3.0-or-later
// What a unit hears, and what it answers.
#include "families/dmc60c/simulatorunit.h"

#include "wire/bytes.h"

#include <algorithm>

namespace mb::dmc60c::simulation {
namespace {

constexpr std::size_t fifoFrames = 24;
constexpr std::uint32_t edition = 0x00103U; ///< pdid bits 19…0
constexpr auto halfMillisecond = std::chrono::microseconds(500);

std::uint32_t messageOf(const CanFrame &frame)
{
    return frame.id & id::messageMask;
}

/// The filter of the controller: the standard part of the identifier.
bool passesFilter(const CanFrame &frame)
{
    const std::uint32_t standardPart = frame.id >> 18U;
    return frame.extended && (standardPart == (id::control >> 18U) || messageOf(frame) == id::enumerate);
}

} // namespace

void Unit::receive(const CanFrame &frame)
{
    const bool deaf = m_stage == Stage::Off || m_stage == Stage::Starting || m_stage == Stage::Dead || m_busOff;
    if (deaf || frame.error || frame.remote)
        return;
    if (m_session == 0)
        hear();
    if (!passesFilter(frame))
        return;
    if (isAddressed(frame)) {
        ++m_addressed;
        const bool fatal = std::any_of(m_options.faults.begin(), m_options.faults.end(),
            [this](const SimulatedFault &f) { return f.kind == "power" && f.at == static_cast<double>(m_addressed); });
        if (fatal)
            return losePower(true);
    }
    if (m_stalls.empty())
        handle(frame);
    else if (m_fifo.size() < fifoFrames)
        m_fifo.push_back(frame);
}

bool Unit::isAddressed(const CanFrame &frame) const
{
    return messageOf(frame) == id::enumerate || static_cast<int>(frame.id & id::deviceMask) == m_ram.number;
}

void Unit::hear()
{
    m_session
        = std::exchange(m_nextSession, std::nullopt).value_or(static_cast<std::uint16_t>(m_random() % 0xFFFFU + 1U));
    if (m_stage != Stage::Application)
        return;
    m_drive.setOutsideFault(faultbit::communication, false, m_clock.now());
    startStatus();
}

void Unit::drain()
{
    while (m_stalls.empty() && !m_fifo.empty()) {
        const CanFrame frame = m_fifo.front();
        m_fifo.pop_front();
        handle(frame);
    }
}

void Unit::overhear(const CanFrame &frame)
{
    const int device = static_cast<int>(frame.id & id::deviceMask);
    if (m_stage != Stage::Application || messageOf(frame) != id::statusGeneral || frame.size != 8
        || device == m_ram.number)
        return;
    const Instant now = m_clock.now();
    m_drive.advance(now);
    if (device == m_drive.master())
        m_drive.masterHeard(signExtend(readU16le(frame.bytes(), 0), 16), now);
}

void Unit::handle(const CanFrame &frame)
{
    const std::uint32_t message = messageOf(frame);
    if (message == id::enumerate) {
        if (frame.size == 0)
            enumerate();
    } else if (message == id::statusGeneral) {
        overhear(frame);
    } else if (isAddressed(frame)) {
        handleForNumber(message, frame);
    }
}

void Unit::handleForNumber(std::uint32_t message, const CanFrame &frame)
{
    const bool application = m_stage == Stage::Application;
    const auto bytes = frame.bytes();
    if (message == id::vendorDout && frame.size > 0)
        return m_vendor.data(bytes);
    if (message == id::control && frame.size == 8 && application)
        return control(frame);
    if (frame.size < 2 || readU16le(bytes, 0) != m_session)
        return;
    if (message == id::vendorCommand && frame.size == 8)
        m_vendor.command(bytes);
    else if (message == id::paramRequest && frame.size == 3 && application)
        readParameter(bytes[2]);
    else if (message == id::paramSet && frame.size == 7 && application)
        writeParameter(bytes[2], readU32le(bytes, 3));
}

void Unit::enumerate()
{
    if (m_enumTimer.isActive())
        return;
    Duration delay = std::chrono::milliseconds(m_ram.number);
    if (m_ram.number == 0) {
        const auto ticks = isInBootloader() ? m_random() : m_session;
        delay = std::max<Duration>(halfMillisecond, halfMillisecond * static_cast<int>(ticks & 0x7FU));
    }
    m_enumTimer.startIn(delay, [this] { sendEnumeration(); });
}

void Unit::sendEnumeration()
{
    if (!m_stalls.empty()) {
        m_enumTimer.startIn(halfMillisecond, [this] { sendEnumeration(); });
        return;
    }
    std::array<std::uint8_t, 6> first{};
    writeU16le(first, 0, m_session);
    writeU32le(first, 2, (m_options.product << 20U) | edition);
    std::array<std::uint8_t, 8> second{};
    writeU16le(second, 0, m_session);
    writeU16le(
        second, 2, static_cast<std::uint16_t>(isInBootloader() ? ImageType::Bootloader : ImageType::Application));
    writeU16le(second, 4, m_application.version());
    writeU16le(second, 6, bootloaderVersion);
    const auto identifier = id::enumResponse | static_cast<std::uint32_t>(m_ram.number);
    m_outbox.send(extendedFrame(identifier, first));
    m_outbox.send(extendedFrame(identifier, second));
}

void Unit::control(const CanFrame &frame)
{
    m_drive.command(ControlWord::decode(frame.bytes()), m_clock.now());
    m_heartbeatMissed = false;
    const Instant end = frame.time + heartbeat; // of the device's own timer, however late this process runs
    m_heartbeat.start(end, [this, end] {
        if (m_stalls.empty())
            m_drive.halt(end, false);
        else
            m_heartbeatMissed = true;
    });
}

void Unit::readParameter(std::uint8_t id)
{
    m_drive.advance(m_clock.now());
    if (findRow(id) == nullptr)
        return answer(id, 0, ParameterStatus::BadParameter);
    const bool live = id == param::encoderPosition;
    answer(
        id, live ? static_cast<std::uint32_t>(m_drive.position()) : m_ram.parameters.raw(id), ParameterStatus::NoError);
}

bool Unit::isAcceptable(const Row &row, std::uint32_t raw) const
{
    if (row.id == param::encoderPosition && !m_drive.isDisabled())
        return false;
    if (row.rule == Rule::Counter)
        return true;
    const std::int64_t value
        = row.rule == Rule::Unsigned ? std::int64_t{raw} : std::int64_t{static_cast<std::int32_t>(raw)};
    return value >= row.low && value <= row.high;
}

void Unit::writeParameter(std::uint8_t id, std::uint32_t raw)
{
    m_drive.advance(m_clock.now());
    const Row *row = findRow(id);
    if (row == nullptr || row->rule == Rule::ReadOnly)
        return answer(id, 0, ParameterStatus::BadParameter);
    if (!isAcceptable(*row, raw))
        return answer(id, 0, ParameterStatus::BadValue);
    const std::uint32_t before = m_ram.parameters.raw(id);
    std::uint32_t answered = raw;
    if (row->rule == Rule::Counter) {
        answered = before;
        raw = raw == 0 ? before : 0;
    }
    m_ram.parameters.set(id, raw);
    if (id == param::encoderPosition)
        m_drive.setPosition(static_cast<std::int32_t>(raw));
    m_drive.wake();
    const bool isPeriod = id == param::analogPeriod || id == param::encoderPeriod || id == param::generalPeriod;
    if (isPeriod && raw != before)
        armStatus(id, m_clock.now() + period(id));
    const bool kept = row->persistent && (row->rule != Rule::Counter || raw != before);
    if (kept)
        configChanged([this, id, answered] { answer(id, answered, ParameterStatus::NoError); });
    else
        answer(id, answered, ParameterStatus::NoError);
}

void Unit::answer(std::uint8_t id, std::uint32_t raw, ParameterStatus status)
{
    std::array<std::uint8_t, 6> bytes{};
    bytes[0] = id;
    writeU32le(bytes, 1, raw);
    bytes[5] = static_cast<std::uint8_t>(status);
    sendReply(id::paramResponse, bytes);
}

} // namespace mb::dmc60c::simulation
