// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/simulatorsender.h"

#include <algorithm>

namespace mb::dmc60c::simulation {
namespace {

constexpr std::array statusPeriods{param::generalPeriod, param::encoderPeriod, param::analogPeriod};
constexpr Duration longestLate = std::chrono::seconds(1); // whoever slept longer begins anew

} // namespace

StatusSender::StatusSender(Clock &clock, Drive &drive, const ConfigMemory &memory, CanOutbox &outbox,
    std::mt19937_64 &random, std::function<bool()> mayTell)
    : m_clock(clock)
    , m_drive(drive)
    , m_memory(memory)
    , m_outbox(outbox)
    , m_random(random)
    , m_mayTell(std::move(mayTell))
    , m_general(clock)
    , m_encoder(clock)
    , m_analog(clock)
{
}

Duration StatusSender::length(std::uint8_t period) const
{
    return std::chrono::milliseconds(m_memory.ram().parameters.raw(period));
}

Timer &StatusSender::timer(std::uint8_t period)
{
    if (period == param::generalPeriod)
        return m_general;
    return period == param::encoderPeriod ? m_encoder : m_analog;
}

void StatusSender::start()
{
    for (const std::uint8_t period : statusPeriods) {
        const auto steps = static_cast<std::uint64_t>(length(period) / std::chrono::microseconds(1));
        arm(period, m_clock.now() + std::chrono::microseconds(m_random() % steps));
    }
}

void StatusSender::stop()
{
    for (const std::uint8_t period : statusPeriods)
        timer(period).stop();
}

void StatusSender::restart(std::uint8_t period)
{
    arm(period, m_clock.now() + length(period));
}

/// On a busy computer it is late; the pace is that of a crystal all the same, and no frame is left out.
void StatusSender::arm(std::uint8_t period, Instant due)
{
    timer(period).start(due, [this, period, due] {
        const Instant earliest = m_clock.now() - longestLate;
        arm(period, std::max(due, earliest) + length(period));
        send(period, due);
    });
}

void StatusSender::send(std::uint8_t period, Instant due)
{
    m_drive.advance(due);
    if (!m_mayTell())
        return; // an event on the way here ended it
    const int number = m_memory.ram().number;
    if (period == param::generalPeriod)
        m_outbox.send(generalFrame(number, m_drive.general()));
    else if (period == param::encoderPeriod)
        m_outbox.send(encoderFrame(number, m_drive.encoder()));
    else
        m_outbox.send(analogFrame(number, m_drive.analog()));
}

} // namespace mb::dmc60c::simulation
