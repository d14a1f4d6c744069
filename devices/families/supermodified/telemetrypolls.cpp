// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/telemetrypolls.h"

#include "async/seconds.h"
#include "families/supermodified/channels.h"

#include <algorithm>

namespace mb::supermodified {
namespace {

constexpr double silentRate = 2.0;
constexpr double mostRate = 10'000.0; ///< beyond every line
constexpr double ampereOfMilli = 0.001;

} // namespace

TelemetryPolls::TelemetryPolls(Line &line, const Node &node, Telemetry &telemetry, Events events)
    : m_line(line)
    , m_node(node)
    , m_telemetry(telemetry)
    , m_events(std::move(events))
    , m_polls{
          {Command::GetPosition, channel::position, 2, 20.0, 50.0},
          {Command::GetCurrent, channel::current, 1, 5.0, 20.0},
          {Command::GetVelocity, channel::reportedVelocity, 1, 2.0, 5.0},
          {Command::GetAbsolutePosition, channel::absolutePosition, 1, 1.0, 1.0},
          {Command::GetAnalog, channel::analog1, analogInputs, 2.0, 2.0},
          {Command::GetInputs, channel::digital, 1, 2.0, 2.0},
      }
{
    for (std::size_t i = 0; i < m_polls.size(); ++i)
        m_polls[i].key = m_line.polls().add(asking(m_node, m_polls[i].command), periodOf(m_polls[i]),
            [this, i](const Result<Frame> &reply) { answered(i, reply); });
}

TelemetryPolls::~TelemetryPolls()
{
    for (const Poll &poll : m_polls)
        m_line.polls().remove(poll.key);
}

// Rates

Duration TelemetryPolls::periodOf(const Poll &poll) const
{
    const bool essential = poll.command == Command::GetPosition;
    double rate = m_driven ? poll.driven : poll.idle;
    if (const double wished = poll.wishes.highest(); wished > 0.0)
        rate = essential ? std::max(wished, silentRate) : wished; // liveness comes from positions
    if (!m_heard || !m_node.dialect)
        rate = essential ? silentRate : 0.0;
    const bool forbidden = poll.command == Command::GetAbsolutePosition
        && (!m_knownOff || !m_line.roster().followersOf(m_node.id).empty());
    if (m_paused || forbidden || rate <= 0.0)
        return Duration::zero();
    return fromSeconds(1.0 / std::min(rate, mostRate));
}

void TelemetryPolls::apply()
{
    for (const Poll &poll : m_polls)
        m_line.polls().setPeriod(poll.key, periodOf(poll));
}

bool TelemetryPolls::setRate(ChannelIndex channel, double hertz)
{
    for (Poll &poll : m_polls) {
        const int offset = channel.value - poll.first.value;
        if (offset < 0 || offset >= poll.channels)
            continue;
        poll.wishes.set(channel, hertz);
        apply();
        return true;
    }
    return false;
}

void TelemetryPolls::zeroed()
{
    m_origin = 0;
    m_velocity.interrupt();
    m_telemetry.breakLine(channel::position);
    m_telemetry.breakLine(channel::velocity);
}

void TelemetryPolls::setDriven(bool driven)
{
    if (std::exchange(m_driven, driven) != driven)
        apply();
}

void TelemetryPolls::setKnownOff(bool off)
{
    if (std::exchange(m_knownOff, off) != off)
        apply();
}

void TelemetryPolls::setHeard(bool heard)
{
    if (std::exchange(m_heard, heard) == heard)
        return;
    if (!heard)
        interrupt();
    apply();
}

void TelemetryPolls::setPaused(bool paused)
{
    if (std::exchange(m_paused, paused) != paused)
        apply();
}

void TelemetryPolls::nodeChanged()
{
    for (const Poll &poll : m_polls)
        m_line.polls().setRequest(poll.key, asking(m_node, poll.command));
    apply();
}

void TelemetryPolls::interrupt()
{
    m_velocity.interrupt();
    for (const Poll &poll : m_polls) {
        for (int i = 0; i < poll.channels; ++i)
            m_telemetry.breakLine(ChannelIndex{static_cast<std::uint16_t>(poll.first.value + i)});
    }
}

// Answers

void TelemetryPolls::answered(std::size_t index, const Result<Frame> &reply)
{
    Poll &poll = m_polls[index];
    const bool good = reply && !codesOf(*reply); // an error instead of an answer is asked again, and nothing is lost
    if (!reply && m_heard) {
        for (int i = 0; i < poll.channels; ++i)
            m_telemetry.lost(ChannelIndex{static_cast<std::uint16_t>(poll.first.value + i)}, 1);
    }
    m_events.answered(reply); // first: after a silence, the sample belongs to a new line
    if (good)
        take(poll, *reply);
    else if (reply && !poll.refused) // once: a node of error level 1 refuses every time
        m_line.polls().repeat(poll.key);
    poll.refused = reply && !good;
}

void TelemetryPolls::append(ChannelIndex channel, double value)
{
    m_telemetry.append({channel, m_line.clock().now(), value});
}

void TelemetryPolls::takePosition(const Frame &reply)
{
    const auto raw = valueOf(reply.payload(), reply.size == sizeOf(Format::I64) ? Format::I64 : Format::I32);
    if (!raw)
        return;
    m_events.positioned(*raw);
    append(channel::position, static_cast<double>(*raw + m_origin));
    if (const auto speed = m_velocity.add(m_line.clock().now(), *raw + m_origin))
        append(channel::velocity, *speed);
}

void TelemetryPolls::take(const Poll &poll, const Frame &reply)
{
    if (poll.command == Command::GetPosition) {
        takePosition(reply);
        return;
    }
    if (!m_node.dialect)
        return;
    if (poll.command == Command::GetAnalog) {
        const auto raw = analogOf(reply.payload());
        for (int i = 0; raw && i < analogInputs; ++i)
            append(ChannelIndex{static_cast<std::uint16_t>(poll.first.value + i)},
                raw->at(static_cast<std::size_t>(i)) * adcVolts);
        return;
    }
    const auto raw = valueOf(reply.payload(), formatOf(poll.command, *m_node.dialect));
    if (!raw)
        return;
    double value = static_cast<double>(*raw);
    if (poll.command == Command::GetCurrent)
        value *= m_node.dialect == Dialect::D3 ? ampereOfMilli : m_currentScale > 0.0 ? m_currentScale : 1.0;
    append(poll.first, value);
    if (poll.command == Command::GetInputs)
        m_events.inputs(static_cast<std::uint8_t>(*raw));
}

} // namespace mb::supermodified
