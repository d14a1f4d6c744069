// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/canlink.h"

#include <algorithm>

namespace mb {
namespace {

constexpr Duration window = std::chrono::seconds(1);

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
        return fail(Fault::OutOfRange, "no CAN frame: its identifier or size is out of range");
    CanFrame stamped = frame;
    stamped.time = m_clock.now();
    if (auto sent = doSend(stamped, priority); !sent)
        return sent;
    countBits(stamped);
    passed(Traffic{stamped.time, Direction::Sent, &stamped, {}});
    return {};
}

double CanLink::load(Instant now) const
{
    const auto age = now - m_second;
    if (age >= 2 * window)
        return 0.0;
    const double rate = bitrate() > 0 ? bitrate() : 1e6;
    const double bits = static_cast<double>(age >= window ? m_bits : m_bitsBefore);
    return std::min(1.0, bits / rate);
}

void CanLink::deliver(const CanFrame &frame)
{
    if (frame.error) {
        countError();
        m_errorFrames.notify(frame);
        passed(Traffic{frame.time, Direction::Received, &frame, {}});
        return;
    }
    countBits(frame);
    passed(Traffic{frame.time, Direction::Received, &frame, {}});
    m_received.notify(frame);
}

void CanLink::countBits(const CanFrame &frame)
{
    if (frame.time - m_second >= window) {
        m_bitsBefore = frame.time - m_second < 2 * window ? m_bits : 0;
        m_bits = 0;
        m_second = frame.time;
    }
    m_bits += estimatedBits(frame);
}

} // namespace mb
