// SPDX-License-Identifier: GPL-3.0-or-later
// Status frames, replies, and the time the processor spends on flash.
#include "families/dmc60c/simulatorunit.h"

#include "wire/bytes.h"

#include <algorithm>

namespace mb::dmc60c::simulation {
namespace {

constexpr std::array statusPeriods{param::generalPeriod, param::encoderPeriod, param::analogPeriod};
constexpr Duration longestLate = std::chrono::seconds(1); // whoever slept longer begins anew

} // namespace

Timer &Unit::statusTimer(std::uint8_t period)
{
    if (period == param::generalPeriod)
        return m_general;
    return period == param::encoderPeriod ? m_encoder : m_analog;
}

void Unit::startStatus()
{
    for (const std::uint8_t id : statusPeriods) {
        const auto steps = static_cast<std::uint64_t>(period(id) / std::chrono::microseconds(1));
        armStatus(id, m_clock.now() + std::chrono::microseconds(m_random() % steps));
    }
}

void Unit::stopStatus()
{
    for (const std::uint8_t id : statusPeriods)
        statusTimer(id).stop();
}

/// On a busy computer it is late; the pace is that of a crystal all the same, and no frame is left out.
void Unit::armStatus(std::uint8_t period, Instant due)
{
    statusTimer(period).start(due, [this, period, due] {
        const Instant earliest = m_clock.now() - longestLate;
        armStatus(period, std::max(due, earliest) + this->period(period));
        sendStatusFrame(period, due);
    });
}

void Unit::sendStatusFrame(std::uint8_t period, Instant due)
{
    m_drive.advance(due);
    if (m_stage != Stage::Application || m_session == 0)
        return; // an event on the way here ended it
    if (period == param::generalPeriod)
        m_outbox.send(generalFrame(m_ram.number, m_drive.general()));
    else if (period == param::encoderPeriod)
        m_outbox.send(encoderFrame(m_ram.number, m_drive.encoder()));
    else
        m_outbox.send(analogFrame(m_ram.number, m_drive.analog()));
}

Duration Unit::replyDelay()
{
    return std::chrono::microseconds(120 + m_random() % 180);
}

void Unit::sendReply(std::uint32_t message, std::span<const std::uint8_t> bytes)
{
    m_outbox.post(extendedFrame(message | static_cast<std::uint32_t>(m_ram.number), bytes), replyDelay());
}

void Unit::sendStatus(CommandStatus status, std::uint8_t terminal, std::size_t bytes)
{
    std::array<std::uint8_t, 4> payload{};
    payload[0] = static_cast<std::uint8_t>(status);
    payload[1] = terminal;
    writeU16le(payload, 2, static_cast<std::uint16_t>(bytes));
    sendReply(id::vendorStatus, payload);
}

void Unit::sendData(std::span<const std::uint8_t> bytes)
{
    const auto identifier = id::vendorDin | static_cast<std::uint32_t>(m_ram.number);
    for (std::size_t at = 0; at < bytes.size(); at += 8)
        m_outbox.post(extendedFrame(identifier, bytes.subspan(at, std::min<std::size_t>(8, bytes.size() - at))),
            Duration::zero());
}

void Unit::stall(Duration time, std::function<void()> then)
{
    m_stalls.push_back({time, std::move(then)});
    if (m_stalls.size() == 1)
        runStall();
}

void Unit::runStall()
{
    m_stallTimer.startIn(m_stalls.front().time, [this] { endStall(); });
}

void Unit::endStall()
{
    const auto then = std::move(m_stalls.front().then);
    const std::size_t waiting = m_stalls.size();
    then(); // may add a stall, or lose the supply
    if (m_stalls.size() < waiting)
        return;
    m_stalls.pop_front();
    if (!m_stalls.empty())
        return runStall();
    if (std::exchange(m_heartbeatMissed, false))
        m_drive.halt(m_clock.now(), false);
    drain();
}

void Unit::configChanged(std::function<void()> then)
{
    const Instant now = m_clock.now();
    const bool quiet = !m_configChanged || now - *m_configChanged >= flashDelay;
    m_configChanged = now;
    if (quiet)
        return writeConfig(std::move(then));
    m_configTimer.startIn(flashDelay, [this] { writeConfig({}); });
    if (then)
        then();
}

void Unit::writeConfig(std::function<void()> then)
{
    stall(writeTime, [this, then = std::move(then)] {
        commitConfig();
        if (then)
            then();
    });
}

void Unit::commitConfig()
{
    ++m_ram.sequence;
    m_flash = m_ram;
    note("config-flash", m_ram.sequence);
}

} // namespace mb::dmc60c::simulation
