// SPDX-License-Identifier: GPL-3.0-or-later
#include "playedkernel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include <dlfcn.h>
#include <linux/can.h>
#include <linux/can/netlink.h>
#include <linux/sock_diag.h>
#include <net/if.h>
#include <sys/stat.h>

namespace {

mb::test::PlayedKernel *playing = nullptr;

/// The function that ours hides.
template <class Function> Function *hidden(Function *, const char *name)
{
    return reinterpret_cast<Function *>(::dlsym(RTLD_NEXT, name));
}

bool isPlayed(int descriptor)
{
    return playing && playing->plays(descriptor);
}

} // namespace

extern "C" {

int socket(int domain, int type, int protocol) noexcept
{
    static const auto real = hidden(&::socket, "socket");
    const bool isPlayed = playing && (domain == PF_CAN || domain == AF_NETLINK);
    return isPlayed ? playing->open(domain, type, protocol) : real(domain, type, protocol);
}
int bind(int descriptor, const sockaddr *address, socklen_t size) noexcept
{
    static const auto real = hidden(&::bind, "bind");
    return isPlayed(descriptor) ? playing->bindTo(descriptor, address) : real(descriptor, address, size);
}
ssize_t send(int descriptor, const void *data, size_t size, int flags)
{
    static const auto real = hidden(&::send, "send");
    return isPlayed(descriptor) ? playing->take(descriptor, data, size, flags) : real(descriptor, data, size, flags);
}
ssize_t recv(int descriptor, void *data, size_t size, int flags)
{
    static const auto real = hidden(&::recv, "recv");
    return isPlayed(descriptor) ? playing->give(descriptor, data, size, flags) : real(descriptor, data, size, flags);
}
int recvmmsg(int descriptor, mmsghdr *messages, unsigned count, int flags, timespec *limit)
{
    static const auto real = hidden(&::recvmmsg, "recvmmsg");
    return isPlayed(descriptor) ? playing->giveFrames(descriptor, messages, count, flags)
                                : real(descriptor, messages, count, flags, limit);
}
int setsockopt(int descriptor, int level, int name, const void *value, socklen_t size) noexcept
{
    static const auto real = hidden(&::setsockopt, "setsockopt");
    return isPlayed(descriptor) ? playing->set(descriptor, level, name, value, size)
                                : real(descriptor, level, name, value, size);
}
int getsockopt(int descriptor, int level, int name, void *value, socklen_t *size) noexcept
{
    static const auto real = hidden(&::getsockopt, "getsockopt");
    return isPlayed(descriptor) ? playing->get(descriptor, level, name, value, size)
                                : real(descriptor, level, name, value, size);
}
unsigned if_nametoindex(const char *name) noexcept
{
    static const auto real = hidden(&::if_nametoindex, "if_nametoindex");
    return playing ? playing->indexOf(name) : real(name);
}

} // extern "C"

namespace mb::test {
namespace {

int refused(int cause)
{
    errno = cause;
    return -1;
}

int nextOf(std::deque<int> &causes)
{
    if (causes.empty())
        return 0;
    const int cause = causes.front();
    causes.pop_front();
    return cause;
}

std::uint64_t inodeOf(int descriptor)
{
    struct stat file { };
    return ::fstat(descriptor, &file) == 0 ? file.st_ino : 0;
}

/// As the kernel does: what does not fit is left out.
void attach(msghdr &head, std::size_t room, const std::vector<PlayedKernel::Control> &controls)
{
    std::size_t used = 0;
    auto *const to = static_cast<std::byte *>(head.msg_control);
    for (const PlayedKernel::Control &control : controls) {
        const std::size_t size = control.bytes.size();
        if (used + CMSG_SPACE(size) > room)
            break;
        cmsghdr start{};
        start.cmsg_len = CMSG_LEN(size);
        start.cmsg_level = control.level;
        start.cmsg_type = control.type;
        std::memcpy(to + used, &start, sizeof start);
        std::memcpy(to + used + CMSG_LEN(0), control.bytes.data(), size);
        used += CMSG_SPACE(size);
    }
    head.msg_controllen = used;
}

} // namespace

PlayedKernel::Network PlayedKernel::controller(int index, const std::string &name, bool up,
    const std::vector<NetlinkBytes> &more, const std::vector<NetlinkBytes> &beside)
{
    can_bittiming timing{};
    timing.bitrate = 500'000;
    timing.sample_point = 875;
    const auto kind = kindOf("can", {attribute(IFLA_CAN_BITTIMING, rawBytes(timing)), joined(more)});
    return {index, name,
        interfaceMessage(up ? unsigned{IFF_UP} : 0U, {named(name), kind, joined(beside)}, ARPHRD_CAN, index)};
}

PlayedKernel::PlayedKernel()
{
    playing = this;
}

PlayedKernel::~PlayedKernel()
{
    playing = nullptr;
}

/// A number may be that of another file by now.
bool PlayedKernel::plays(int descriptor) const
{
    const auto end = m_ends.find(descriptor);
    return end != m_ends.end() && end->second.inode == inodeOf(descriptor);
}

int PlayedKernel::open(int domain, int type, int protocol)
{
    opened.emplace_back(domain, type, protocol);
    if (const int cause = nextOf(domain == PF_CAN ? canCauses : routeCauses); cause != 0)
        return refused(cause);
    std::array<int, 2> ends{-1, -1};
    EXPECT_EQ(::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()), 0);
    m_ends[ends[0]] = {domain, inodeOf(ends[0]), std::make_shared<Descriptor>(ends[1])};
    if (domain == PF_CAN)
        cable = ends[1];
    return ends[0];
}

int PlayedKernel::bindTo(int descriptor, const sockaddr *address)
{
    const End &end = m_ends.at(descriptor);
    int where = 0;
    if (end.domain == PF_CAN) {
        where = reinterpret_cast<const sockaddr_can *>(address)->can_ifindex;
    } else {
        where = static_cast<int>(reinterpret_cast<const sockaddr_nl *>(address)->nl_groups);
        notices = end.other->get();
    }
    bound.emplace_back(address->sa_family, where, settings.size());
    const int cause = nextOf(bindCauses);
    return cause != 0 ? refused(cause) : 0;
}

ssize_t PlayedKernel::take(int descriptor, const void *data, std::size_t size, int flags)
{
    static const auto real = hidden(&::send, "send");
    End &end = m_ends.at(descriptor);
    if (end.domain == AF_NETLINK)
        return answer(end, data, size);
    ++sends;
    const int cause = nextOf(sendCauses);
    return cause != 0 ? refused(cause) : real(descriptor, data, size, flags);
}

/// All that is to be said, at once; nothing follows it.
ssize_t PlayedKernel::answer(End &end, const void *question, std::size_t size)
{
    struct {
        nlmsghdr head;
        ifinfomsg link;
    } asked{};
    EXPECT_EQ(size, sizeof asked);
    std::memcpy(&asked, question, std::min(size, sizeof asked));
    EXPECT_EQ(asked.head.nlmsg_len, sizeof asked);
    questions.emplace_back(asked.head.nlmsg_type, asked.head.nlmsg_flags, asked.link.ifi_index);
    for (const NetlinkBytes &datagram : datagrams.value_or(answersTo(asked.link.ifi_index)))
        EXPECT_EQ(::send(end.other->get(), datagram.data(), datagram.size(), 0), ssize_t(datagram.size()));
    end.other.reset();
    return static_cast<ssize_t>(size);
}

std::vector<NetlinkBytes> PlayedKernel::answersTo(int index) const
{
    std::vector<NetlinkBytes> found;
    for (const Network &network : networks) {
        if (index == 0 || index == network.index)
            found.push_back(netlinkMessage(RTM_NEWLINK, network.message));
    }
    if (index == 0)
        found.push_back(netlinkMessage(NLMSG_DONE, rawBytes(0)));
    else if (found.empty())
        found.push_back(netlinkMessage(NLMSG_ERROR, rawBytes(nlmsgerr{})));
    return {joined(found)};
}

ssize_t PlayedKernel::give(int descriptor, void *data, std::size_t size, int flags)
{
    static const auto real = hidden(&::recv, "recv");
    const End &end = m_ends.at(descriptor);
    const int cause = end.other && end.other->get() == notices ? nextOf(noticeCauses) : 0;
    return cause != 0 ? refused(cause) : real(descriptor, data, size, flags);
}

int PlayedKernel::giveFrames(int descriptor, mmsghdr *messages, unsigned count, int flags)
{
    static const auto real = hidden(&::recvmmsg, "recvmmsg");
    ++looks;
    if (const int cause = nextOf(receiveCauses); cause != 0)
        return refused(cause);
    std::vector<std::size_t> rooms;
    for (unsigned i = 0; i < count; ++i)
        rooms.push_back(messages[i].msg_hdr.msg_controllen);
    if (fullBatches > 0) {
        --fullBatches;
        for (unsigned i = 0; i < count; ++i) {
            std::memset(messages[i].msg_hdr.msg_iov->iov_base, 0, sizeof(can_frame));
            messages[i].msg_len = sizeof(can_frame);
            messages[i].msg_hdr.msg_controllen = 0;
        }
        return static_cast<int>(count);
    }
    const int got = real(descriptor, messages, count, flags, nullptr);
    for (int i = 0; i < got && !controls.empty(); ++i) {
        attach(messages[i].msg_hdr, rooms[static_cast<std::size_t>(i)], controls.front());
        controls.pop_front();
    }
    return got;
}

int PlayedKernel::set(int descriptor, int level, int name, const void *value, socklen_t size)
{
    static const auto real = hidden(&::setsockopt, "setsockopt");
    if (m_ends.at(descriptor).domain != PF_CAN)
        return real(descriptor, level, name, value, size);
    int number = 0;
    EXPECT_EQ(size, sizeof number);
    std::memcpy(&number, value, sizeof number);
    settings.emplace_back(level, name, number);
    return refusedSettings.contains(name) ? refused(EPERM) : 0;
}

int PlayedKernel::get(int descriptor, int level, int name, void *value, socklen_t *size) const
{
    static const auto real = hidden(&::getsockopt, "getsockopt");
    const auto tell = [&](const auto &what, std::size_t bytes) {
        EXPECT_GE(*size, bytes);
        std::memcpy(value, &what, bytes);
        *size = static_cast<socklen_t>(bytes);
        return 0;
    };
    if (level != SOL_SOCKET || m_ends.at(descriptor).domain != PF_CAN)
        return real(descriptor, level, name, value, size);
    if (name == SO_DOMAIN)
        return tell(int{PF_CAN}, sizeof(int));
    if (name == SO_RCVBUF)
        return tell(receiveBuffer, sizeof receiveBuffer);
    if (name != SO_MEMINFO)
        return real(descriptor, level, name, value, size);
    if (!drops)
        return refused(ENOPROTOOPT);
    std::array<std::uint32_t, SK_MEMINFO_VARS> memory{};
    memory.fill(77'777);
    memory[SK_MEMINFO_DROPS] = *drops;
    return tell(memory, memoryBytes);
}

unsigned PlayedKernel::indexOf(const std::string &name) const
{
    const auto found = std::find_if(
        networks.begin(), networks.end(), [&name](const Network &network) { return network.name == name; });
    return found == networks.end() ? 0 : static_cast<unsigned>(found->index);
}

} // namespace mb::test
