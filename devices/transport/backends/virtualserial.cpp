// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/backends/virtualserial.h"

#include "wire/uart.h"

#include <algorithm>

namespace mb {

VirtualSerialLine::VirtualSerialLine(Clock &clock, Wiring wiring, std::uint64_t seed)
    : m_clock(clock)
    , m_wiring(wiring)
    , m_random(seed)
{
}

bool VirtualSerialLine::chance(double fraction)
{
    return fraction > 0.0 && std::uniform_real_distribution<double>(0.0, 1.0)(m_random) < fraction;
}

void VirtualSerialLine::pull(VirtualSerialLink &link)
{
    detach(link);
    link.lose({Fault::LinkLost, say("the cable was pulled out"), say("plug it in again"), {}, Ailment::Gone});
}

void VirtualSerialLine::detach(VirtualSerialLink &link)
{
    if (std::erase(m_links, &link) == 0)
        return;
    if (link.m_passing) { // what is complete by now has been heard
        const auto passed = (m_clock.now() - link.m_passing->start) / link.m_passing->byteTime;
        const auto whole = std::clamp<std::int64_t>(passed, 0, static_cast<std::int64_t>(link.m_passing->bytes.size()));
        proceed(link, static_cast<std::size_t>(whole));
    }
    link.m_timer.stop();
    link.m_passing.reset();
    link.m_queue.clear();
}

void VirtualSerialLine::begin(VirtualSerialLink &link)
{
    if (link.m_passing || link.m_queue.isEmpty())
        return;
    const int rate = m_anySpeed > 0 ? m_anySpeed : link.baudrate();
    Passing passing;
    passing.sender = &link;
    passing.bytes = link.m_queue.pop();
    passing.collided.resize(passing.bytes.size());
    passing.start = link.m_freeAt;
    passing.rate = rate;
    passing.byteTime = Duration(std::chrono::seconds(10)) / rate;
    spoil(passing);
    if (m_wiring == Wiring::HalfDuplex)
        collide(passing);
    link.m_freeAt = passing.end();
    link.m_passing = std::move(passing);
    proceed(link, 0);
}

void VirtualSerialLine::spoil(Passing &passing)
{
    passing.lost = chance(m_loss);
    if (!chance(m_corruption))
        return;
    const std::size_t bit = m_random() % (passing.bytes.size() * 8);
    passing.bytes[bit / 8] = static_cast<std::uint8_t>(passing.bytes[bit / 8] ^ (1U << (bit % 8)));
}

/// Two drivers at once: what overlaps is noise at every end.
void VirtualSerialLine::collide(Passing &passing)
{
    const auto mark = [this](Passing &mine, const Passing &other) {
        for (std::size_t i = mine.delivered; i < mine.bytes.size(); ++i) {
            if (mine.endOf(i) >= other.end() || mine.endOf(i + 1) <= other.start || mine.collided[i])
                continue;
            mine.collided[i] = true;
            mine.bytes[i] = static_cast<std::uint8_t>(mine.bytes[i] ^ (1U + m_random() % 255U));
        }
    };
    for (VirtualSerialLink *other : m_links) {
        if (other == passing.sender || !other->m_passing)
            continue;
        mark(*other->m_passing, passing);
        mark(passing, *other->m_passing);
    }
}

/// Delivers up to `until`, then waits for what comes next.
void VirtualSerialLine::proceed(VirtualSerialLink &link, std::size_t until)
{
    Passing &passing = *link.m_passing;
    const std::size_t from = std::exchange(passing.delivered, until);
    const bool whole = until == passing.bytes.size();
    if (!whole) {
        const std::size_t next = std::min(passing.bytes.size(), until + fifo);
        link.m_timer.start(passing.endOf(next), [this, &link, next] { proceed(link, next); });
    }
    if (until == from)
        return;
    const Passing heard = passing; // receivers may send, close and open while they are called
    const auto receivers = m_links;
    if (whole) {
        link.m_passing.reset();
        begin(link);
    }
    for (VirtualSerialLink *receiver : receivers) {
        if (receiver != &link && std::ranges::find(m_links, receiver) != m_links.end())
            hear(*receiver, heard, from, until);
    }
}

void VirtualSerialLine::hear(VirtualSerialLink &receiver, const Passing &passing, std::size_t from, std::size_t until)
{
    if (passing.lost || receiver.state() != LinkState::Open)
        return;
    if (m_anySpeed == 0 && receiver.baudrate() != passing.rate) {
        if (until == passing.bytes.size())
            hearAtOtherRate(receiver, passing);
        return;
    }
    for (std::size_t i = from; i < until; ++i) {
        if (passing.collided[i])
            receiver.reportLineError();
    }
    receiver.deliver(passing.endOf(until), std::span(passing.bytes).subspan(from, until - from));
    receiver.endBatch();
}

void VirtualSerialLine::hearAtOtherRate(VirtualSerialLink &receiver, const Passing &passing)
{
    std::vector<std::uint8_t> values;
    for (const UartByte &byte : sampledAt(passing.bytes, static_cast<double>(passing.rate) / receiver.baudrate())) {
        values.push_back(byte.value);
        if (byte.framingError)
            receiver.reportLineError();
    }
    if (values.empty())
        return;
    receiver.deliver(passing.end(), values);
    receiver.endBatch();
}

VirtualSerialLink::VirtualSerialLink(LinkAddress address, VirtualSerialLine &line)
    : SerialLink(std::move(address), line.clock())
    , m_line(line)
    , m_timer(line.clock())
{
}

VirtualSerialLink::~VirtualSerialLink()
{
    m_line.detach(*this);
}

Result<void> VirtualSerialLink::doOpen()
{
    m_line.m_links.push_back(this);
    return {};
}

Result<void> VirtualSerialLink::doSend(std::span<const std::uint8_t> bytes, Priority priority)
{
    countLost(m_queue.push(bytes, priority));
    m_freeAt = std::max(m_freeAt, clock().now());
    m_line.begin(*this);
    return {};
}

std::size_t VirtualSerialLink::doBacklog() const
{
    std::size_t waiting = m_queue.size();
    if (m_passing) {
        const auto left = (m_passing->end() - clock().now() + m_passing->byteTime - Duration(1)) / m_passing->byteTime;
        waiting += static_cast<std::size_t>(std::max<std::int64_t>(left, 0));
    }
    return waiting;
}

} // namespace mb
