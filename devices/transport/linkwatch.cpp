// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/linkwatch.h"

#include "transport/backends/netlink.h"

#include <QSocketNotifier>

#include <array>
#include <cerrno>

#include <net/if_arp.h>
#include <sys/socket.h>
#include <unistd.h>

namespace mb {
namespace {

constexpr Duration settling = std::chrono::milliseconds(20);

bool isAboutCan(int type, netlink::Bytes content)
{
    if (type != RTM_NEWLINK && type != RTM_DELLINK)
        return false;
    const auto link = netlink::readAs<ifinfomsg>(content);
    return link && link->ifi_type == ARPHRD_CAN;
}

} // namespace

LinkWatch::LinkWatch(Clock &clock)
    : m_descriptor(::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, NETLINK_ROUTE))
    , m_settled(clock)
{
    sockaddr_nl group{};
    group.nl_family = AF_NETLINK;
    group.nl_groups = RTMGRP_LINK;
    if (m_descriptor < 0 || ::bind(m_descriptor, reinterpret_cast<const sockaddr *>(&group), sizeof group) != 0)
        return;
    m_notifier = std::make_unique<QSocketNotifier>(m_descriptor, QSocketNotifier::Read);
    QObject::connect(m_notifier.get(), &QSocketNotifier::activated, m_notifier.get(), [this] { read(); });
}

LinkWatch::~LinkWatch()
{
    m_notifier.reset();
    if (m_descriptor >= 0)
        ::close(m_descriptor);
}

void LinkWatch::read()
{
    bool told = false;
    alignas(nlmsghdr) std::array<std::byte, 32768> buffer;
    for (;;) {
        const ssize_t got = ::recv(m_descriptor, buffer.data(), buffer.size(), MSG_DONTWAIT);
        const bool overflowed = got < 0 && errno == ENOBUFS; // some notice was lost: which, nobody knows
        if (got <= 0 && !overflowed)
            break;
        told = told || overflowed;
        if (got > 0)
            netlink::eachMessage(netlink::Bytes(buffer.data(), static_cast<std::size_t>(got)),
                [&told](int type, netlink::Bytes content) { told = told || isAboutCan(type, content); });
    }
    if (told && !m_settled.isActive())
        m_settled.startIn(settling, [this] { m_changed.notify(); });
}

} // namespace mb
