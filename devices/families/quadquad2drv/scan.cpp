// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/scan.h"

#include "families/quadquad2drv/packetport.h"

namespace mb::quadquad2drv {
namespace {

constexpr int knownProtocol = 1;

} // namespace

void setVersion(Identity &identity, int major, int minor, int protocol)
{
    identity.state = DeviceState::Online;
    identity.detail = {};
    identity.firmware = std::to_string(major) + '.' + std::to_string(minor);
    identity.dialect = "protocol " + std::to_string(protocol);
    if (protocol != knownProtocol)
        identity.detail
            = say("the board speaks protocol %1, this program was written for protocol 1; watch it before it is driven",
                protocol);
}

Task<void> scan(Link &link, Clock &clock, ScanSink &sink)
{
    if (link.kind() != LinkKind::Spi)
        co_return fail(Fault::Unsupported, say("a QuadQuad2Drv lives on an SPI link"));
    PacketPort port(static_cast<SpiLink &>(link), clock);
    sink.progress(say("asking for the version"), 0, 1);
    const Result<Packet> reply = co_await port.request(getRequest(PacketId::GetVersion)).attempt();
    if (!reply && reply.error().fault == Fault::LinkLost)
        co_return fail(reply.error());
    if (const auto version = reply ? parseVersion(*reply) : std::nullopt) {
        Identity identity;
        identity.family = "quadquad2drv";
        identity.address = 0;
        setVersion(identity, version->major, version->minor, version->protocol);
        sink.found(identity);
    }
    sink.progress(say("asking for the version"), 1, 1);
    co_return {};
}

} // namespace mb::quadquad2drv
