// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/canlink.h"

namespace mb {
namespace {

std::uint64_t estimatedBits(const CanFrame &frame)
{
    const std::uint64_t plain = (frame.extended ? 67U : 47U) + 8U * frame.size;
    return plain + plain / 12; // stuff bits of ordinary data
}

} // namespace

Result<void> CanLink::send(const CanFrame &frame, Priority priority)
{
    if (state() != LinkState::Open)
        return fail(notOpen());
    if (frame.size > frame.data.size() || frame.error || frame.id > (frame.extended ? 0x1FFFFFFFU : 0x7FFU))
        return fail(Fault::OutOfRange, say("no CAN frame: its identifier or size is out of range"));
    CanFrame stamped = frame;
    stamped.time = m_clock.now();
    MB_TRY_VOID(doSend(stamped, priority));
    m_load.count(stamped.time, estimatedBits(stamped));
    passed(Traffic{stamped.time, Direction::Sent, &stamped, {}});
    return {};
}

Duration CanLink::wireTime(const CanFrame &frame) const
{
    const int rate = bitrate();
    return rate > 0 ? Duration(std::chrono::seconds(1)) * bitsOnWire(frame) / rate : Duration::zero();
}

std::optional<double> CanLink::load(Instant now) const
{
    return m_load.fraction(now, bitrate() > 0 ? bitrate() : 1'000'000);
}

void CanLink::deliver(const CanFrame &frame)
{
    if (frame.error) {
        noteError(decodeError(frame), frame.time);
        m_errorFrames.notify(frame);
        passed(Traffic{frame.time, Direction::Received, &frame, {}});
        return;
    }
    m_load.count(frame.time, estimatedBits(frame));
    m_health.lastReceived = frame.time;
    passed(Traffic{frame.time, Direction::Received, &frame, {}});
    m_received.notify(frame);
}

void CanLink::noteError(const CanErrorReport &report, Instant time)
{
    countError();
    m_health.state = report.state.value_or(m_health.state);
    if (report.transmitErrors)
        m_health.transmitErrors = report.transmitErrors;
    if (report.receiveErrors)
        m_health.receiveErrors = report.receiveErrors;
    m_health.acknowledgeErrors += report.noAcknowledge ? 1 : 0;
    m_health.arbitrationLosses += report.arbitrationLost ? 1 : 0;
    m_health.protocolErrors += report.protocol ? 1 : 0;
    m_health.overruns += report.overrun ? 1 : 0;
    m_health.restarts += report.restarted ? 1 : 0;
    m_health.last = report;
    m_health.lastError = time;
    if (report.noAcknowledge)
        m_health.lastAcknowledgeError = time;
    if (report.protocol)
        m_health.lastProtocolError = time;
}

void CanLink::startHealth(BusState state, std::optional<int> transmitErrors, std::optional<int> receiveErrors)
{
    updateHealth(state, transmitErrors, receiveErrors);
    m_health.stuckSince.reset();
    m_health.lastAcknowledgeError.reset();
    m_health.lastProtocolError.reset();
}

void CanLink::updateHealth(BusState state, std::optional<int> transmitErrors, std::optional<int> receiveErrors)
{
    m_health.state = state;
    m_health.transmitErrors = transmitErrors;
    m_health.receiveErrors = receiveErrors;
}

} // namespace mb
