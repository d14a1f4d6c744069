// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transport/backends/netlink.h"

#include <cstddef>
#include <cstring>
#include <string_view>
#include <vector>

#include <linux/if_link.h>
#include <net/if_arp.h>

namespace mb::test {

// What the kernel says of its interfaces, made byte by byte.

using NetlinkBytes = std::vector<std::byte>;

template <class T> NetlinkBytes rawBytes(const T &value)
{
    NetlinkBytes bytes(sizeof value);
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes;
}

inline NetlinkBytes nameBytes(std::string_view name)
{
    NetlinkBytes bytes(name.size() + 1);
    std::memcpy(bytes.data(), name.data(), name.size());
    return bytes;
}

inline NetlinkBytes joined(const std::vector<NetlinkBytes> &parts)
{
    NetlinkBytes all;
    for (const NetlinkBytes &part : parts)
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

inline NetlinkBytes attribute(int type, const NetlinkBytes &content)
{
    rtattr head{};
    head.rta_len = static_cast<unsigned short>(sizeof head + content.size());
    head.rta_type = static_cast<unsigned short>(type);
    NetlinkBytes bytes = joined({rawBytes(head), content});
    bytes.resize(netlink::aligned(bytes.size()));
    return bytes;
}

/// What RTM_NEWLINK says of an interface.
inline NetlinkBytes interfaceMessage(
    unsigned flags, const std::vector<NetlinkBytes> &attributes, int hardware = ARPHRD_CAN, int index = 7)
{
    ifinfomsg link{};
    link.ifi_type = static_cast<unsigned short>(hardware);
    link.ifi_index = index;
    link.ifi_flags = flags;
    return joined({rawBytes(link), joined(attributes)});
}

inline NetlinkBytes named(std::string_view name)
{
    return attribute(IFLA_IFNAME, nameBytes(name));
}

inline NetlinkBytes kindOf(std::string_view kind, const std::vector<NetlinkBytes> &data = {})
{
    return attribute(
        IFLA_LINKINFO, joined({attribute(IFLA_INFO_KIND, nameBytes(kind)), attribute(IFLA_INFO_DATA, joined(data))}));
}

/// One message of a datagram.
inline NetlinkBytes netlinkMessage(int type, const NetlinkBytes &content)
{
    nlmsghdr head{};
    head.nlmsg_len = static_cast<unsigned>(sizeof head + content.size());
    head.nlmsg_type = static_cast<unsigned short>(type);
    NetlinkBytes bytes = joined({rawBytes(head), content});
    bytes.resize(netlink::aligned(bytes.size()));
    return bytes;
}

} // namespace mb::test
