// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/simulatorparameterport.h"

#include "wire/bytes.h"

namespace mb::dmc60c::simulation {

ParameterPort::ParameterPort(Clock &clock, Drive &drive, ConfigMemory &memory, StatusSender &status,
    std::function<void(std::span<const std::uint8_t>)> reply)
    : m_clock(clock)
    , m_drive(drive)
    , m_memory(memory)
    , m_status(status)
    , m_reply(std::move(reply))
{
}

void ParameterPort::read(std::uint8_t id)
{
    m_drive.advance(m_clock.now());
    if (findRow(id) == nullptr)
        return answer(id, 0, ParameterStatus::BadParameter);
    const bool live = id == param::encoderPosition;
    answer(id, live ? static_cast<std::uint32_t>(m_drive.position()) : m_memory.ram().parameters.raw(id),
        ParameterStatus::NoError);
}

bool ParameterPort::isAcceptable(const Row &row, std::uint32_t raw) const
{
    if (row.id == param::encoderPosition && !m_drive.isDisabled())
        return false;
    if (row.rule == Rule::Counter)
        return true;
    const std::int64_t value
        = row.rule == Rule::Unsigned ? std::int64_t{raw} : std::int64_t{static_cast<std::int32_t>(raw)};
    return value >= row.low && value <= row.high;
}

void ParameterPort::write(std::uint8_t id, std::uint32_t raw)
{
    m_drive.advance(m_clock.now());
    const Row *row = findRow(id);
    if (row == nullptr || row->rule == Rule::ReadOnly)
        return answer(id, 0, ParameterStatus::BadParameter);
    if (!isAcceptable(*row, raw))
        return answer(id, 0, ParameterStatus::BadValue);
    const std::uint32_t before = m_memory.ram().parameters.raw(id);
    std::uint32_t answered = raw;
    if (row->rule == Rule::Counter) {
        answered = before;
        raw = raw == 0 ? before : 0;
    }
    m_memory.ram().parameters.set(id, raw);
    if (id == param::encoderPosition)
        m_drive.setPosition(static_cast<std::int32_t>(raw));
    m_drive.wake();
    const bool isPeriod = id == param::analogPeriod || id == param::encoderPeriod || id == param::generalPeriod;
    if (isPeriod && raw != before)
        m_status.restart(id);
    const bool kept = row->persistent && (row->rule != Rule::Counter || raw != before);
    if (kept)
        m_memory.changed([this, id, answered] { answer(id, answered, ParameterStatus::NoError); });
    else
        answer(id, answered, ParameterStatus::NoError);
}

void ParameterPort::answer(std::uint8_t id, std::uint32_t raw, ParameterStatus status)
{
    std::array<std::uint8_t, 6> bytes{};
    bytes[0] = id;
    writeU32le(bytes, 1, raw);
    bytes[5] = static_cast<std::uint8_t>(status);
    m_reply(bytes);
}

} // namespace mb::dmc60c::simulation
