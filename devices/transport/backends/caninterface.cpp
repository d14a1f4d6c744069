// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/backends/caninterface.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>

#include <linux/can.h>
#include <linux/can/netlink.h>
#include <linux/rtnetlink.h>
#include <net/if.h>
#include <net/if_arp.h>
#include <sys/socket.h>
#include <unistd.h>

namespace mb {
namespace {

using Bytes = std::span<const std::byte>;

template <class T> std::optional<T> readAs(Bytes bytes)
{
    if (bytes.size() < sizeof(T))
        return std::nullopt;
    T value;
    std::memcpy(&value, bytes.data(), sizeof value);
    return value;
}

std::size_t aligned(std::size_t length)
{
    return (length + 3U) & ~std::size_t(3U);
}

/// Calls visit(type, content) for each attribute of a netlink message.
template <class Visit> void eachAttribute(Bytes bytes, Visit visit)
{
    while (const auto head = readAs<rtattr>(bytes)) {
        if (head->rta_len < sizeof(rtattr) || head->rta_len > bytes.size())
            return;
        visit(static_cast<int>(head->rta_type & NLA_TYPE_MASK),
            bytes.subspan(sizeof(rtattr), head->rta_len - sizeof(rtattr)));
        bytes = bytes.subspan(std::min(bytes.size(), aligned(head->rta_len)));
    }
}

std::string textOf(Bytes bytes)
{
    std::string text;
    for (const std::byte byte : bytes) {
        if (byte == std::byte{})
            break;
        text += static_cast<char>(byte);
    }
    return text;
}

void readController(Bytes data, CanInterface &interface)
{
    eachAttribute(data, [&interface](int type, Bytes content) {
        if (type == IFLA_CAN_BITTIMING) {
            if (const auto timing = readAs<can_bittiming>(content))
                interface.bitrate = static_cast<int>(timing->bitrate);
        } else if (type == IFLA_CAN_STATE) {
            interface.busOff = readAs<std::uint32_t>(content) == std::uint32_t(CAN_STATE_BUS_OFF);
        } else if (type == IFLA_CAN_CTRLMODE) {
            if (const auto mode = readAs<can_ctrlmode>(content))
                interface.listenOnly = (mode->flags & CAN_CTRLMODE_LISTENONLY) != 0U;
        }
    });
}

void readLink(Bytes message, std::vector<CanInterface> &out)
{
    const auto link = readAs<ifinfomsg>(message);
    if (!link || link->ifi_type != ARPHRD_CAN)
        return;
    CanInterface interface;
    interface.up = (link->ifi_flags & IFF_UP) != 0U;
    eachAttribute(message.subspan(aligned(sizeof(ifinfomsg))), [&interface](int type, Bytes content) {
        if (type == IFLA_IFNAME)
            interface.name = textOf(content);
        if (type != IFLA_LINKINFO)
            return;
        Bytes data;
        eachAttribute(content, [&](int detail, Bytes value) {
            if (detail == IFLA_INFO_KIND)
                interface.driver = textOf(value);
            if (detail == IFLA_INFO_DATA)
                data = value;
        });
        if (interface.driver == "can")
            readController(data, interface);
    });
    out.push_back(std::move(interface));
}

/// Takes the messages of one datagram; false when the list is complete or broken.
bool readMessages(Bytes datagram, std::vector<CanInterface> &out)
{
    while (const auto head = readAs<nlmsghdr>(datagram)) {
        if (head->nlmsg_len < sizeof(nlmsghdr) || head->nlmsg_len > datagram.size())
            return false;
        if (head->nlmsg_type == NLMSG_DONE || head->nlmsg_type == NLMSG_ERROR)
            return false;
        if (head->nlmsg_type == RTM_NEWLINK)
            readLink(datagram.subspan(sizeof(nlmsghdr), head->nlmsg_len - sizeof(nlmsghdr)), out);
        datagram = datagram.subspan(std::min(datagram.size(), aligned(head->nlmsg_len)));
    }
    return true;
}

bool askForLinks(int descriptor)
{
    struct {
        nlmsghdr head{};
        ifinfomsg link{};
    } request;
    request.head.nlmsg_len = sizeof request;
    request.head.nlmsg_type = RTM_GETLINK;
    request.head.nlmsg_flags = NLM_F_REQUEST | NLM_F_DUMP;
    const timeval patience{1, 0};
    ::setsockopt(descriptor, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    return ::send(descriptor, &request, sizeof request, 0) == ssize_t(sizeof request);
}

} // namespace

Result<std::vector<CanInterface>> canInterfaces()
{
    const int descriptor = ::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_ROUTE);
    if (descriptor < 0)
        return fail(Fault::LinkLost, "the kernel does not list its interfaces: " + std::string(std::strerror(errno)));
    std::vector<CanInterface> interfaces;
    bool more = askForLinks(descriptor);
    alignas(nlmsghdr) std::array<std::byte, 32768> buffer;
    while (more) {
        const ssize_t got = ::recv(descriptor, buffer.data(), buffer.size(), 0);
        more = got > 0 && readMessages(Bytes(buffer.data(), static_cast<std::size_t>(got)), interfaces);
    }
    ::close(descriptor);
    return interfaces;
}

std::optional<std::string> whyUnusable(const CanInterface &interface)
{
    const std::string &name = interface.name;
    if (!interface.up) {
        const bool needsBitrate = interface.driver == "can" && interface.bitrate == 0;
        return name + " is switched off; bring it up: ip link set " + name + " up"
            + (needsBitrate ? " type can bitrate 1000000" : "");
    }
    if (interface.busOff)
        return name + " is bus-off: check wiring, termination and bit rate, then: ip link set " + name
            + " type can restart";
    return std::nullopt;
}

std::optional<std::string> whyNoCan()
{
    const int descriptor = ::socket(PF_CAN, SOCK_RAW | SOCK_CLOEXEC, CAN_RAW);
    if (descriptor >= 0) {
        ::close(descriptor);
        return std::nullopt;
    }
    if (errno == EPERM || errno == EACCES)
        return "no permission to open CAN sockets here; allow them in the container or sandbox";
    if (errno == EAFNOSUPPORT || errno == EPROTONOSUPPORT)
        return "this kernel has no CAN support; load it: modprobe can_raw";
    return "CAN sockets cannot be opened: " + std::string(std::strerror(errno));
}

} // namespace mb
