// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <optional>
#include <span>
#include <string>

#include <linux/netlink.h>
#include <linux/rtnetlink.h>

namespace mb::netlink {

// Reading of netlink messages: lengths come from the kernel, and are checked all the same.

using Bytes = std::span<const std::byte>;

template <class T> std::optional<T> readAs(Bytes bytes)
{
    if (bytes.size() < sizeof(T))
        return std::nullopt;
    T value;
    std::memcpy(&value, bytes.data(), sizeof value);
    return value;
}

/// Nothing more than the kernel sent: a structure that grew since is filled with zeros.
template <class T> T readPart(Bytes bytes)
{
    T value{};
    std::memcpy(&value, bytes.data(), std::min(bytes.size(), sizeof value));
    return value;
}

inline std::size_t aligned(std::size_t length)
{
    return (length + 3U) & ~std::size_t(3U);
}

/// Calls visit(type, content) for each attribute of a message.
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

/// Calls visit(type, content) for each message of a datagram; false when one of them ends or breaks the list.
template <class Visit> bool eachMessage(Bytes datagram, Visit visit)
{
    while (const auto head = readAs<nlmsghdr>(datagram)) {
        if (head->nlmsg_len < sizeof(nlmsghdr) || head->nlmsg_len > datagram.size())
            return false;
        if (head->nlmsg_type == NLMSG_DONE || head->nlmsg_type == NLMSG_ERROR)
            return false;
        visit(
            static_cast<int>(head->nlmsg_type), datagram.subspan(sizeof(nlmsghdr), head->nlmsg_len - sizeof(nlmsghdr)));
        datagram = datagram.subspan(std::min(datagram.size(), aligned(head->nlmsg_len)));
    }
    return true;
}

inline std::string textOf(Bytes bytes)
{
    std::string text;
    for (const std::byte byte : bytes) {
        if (byte == std::byte{})
            break;
        text += static_cast<char>(byte);
    }
    return text;
}

} // namespace mb::netlink
