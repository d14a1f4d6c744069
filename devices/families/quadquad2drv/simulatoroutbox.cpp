// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/simulatoroutbox.h"

#include "families/quadquad2drv/protocol.h"

#include <utility>

namespace mb::quadquad2drv::simulation {
namespace {

constexpr std::size_t mostWaiting = 8;

} // namespace

void Outbox::push(std::vector<std::uint8_t> packet)
{
    if (m_packets.size() >= mostWaiting)
        return;
    m_streamWaits = m_streamWaits || packet[2] == static_cast<std::uint8_t>(PacketId::Stream);
    m_packets.push_back(std::move(packet));
}

std::uint8_t Outbox::next()
{
    if (m_packets.empty())
        return 0;
    const std::vector<std::uint8_t> &packet = m_packets.front();
    const std::uint8_t byte = packet[m_at++];
    if (m_at == packet.size()) {
        m_streamWaits = m_streamWaits && packet[2] != static_cast<std::uint8_t>(PacketId::Stream);
        m_packets.pop_front();
        m_at = 0;
    }
    return byte;
}

void Outbox::clear()
{
    m_packets.clear();
    m_at = 0;
    m_streamWaits = false;
}

} // namespace mb::quadquad2drv::simulation
