// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/descriptor.h"
#include "async/noncopyable.h"
#include "netlinkbytes.h"

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include <sys/socket.h>

namespace mb::test {

/// What most kernels have not: CAN interfaces, sockets on them, and what is told of them. While one of these lives it answers the
/// socket(), bind(), send() … of this program that are about CAN and about the list of interfaces; the kernel answers all others. A
/// CAN socket is one end of a pair; `cable` is the other one.
class PlayedKernel : NonCopyable {
public:
    struct Network {
        int index;
        std::string name;
        NetlinkBytes message; ///< of RTM_NEWLINK
    };
    /// A CAN controller at 500 kbit/s; `more` is said of it, `beside` of its interface.
    [[nodiscard]] static Network controller(int index, const std::string &name, bool up = true,
        const std::vector<NetlinkBytes> &more = {}, const std::vector<NetlinkBytes> &beside = {});

    using Three = std::tuple<int, int, int>;
    struct Control { ///< beside a frame
        int level;
        int type;
        NetlinkBytes bytes;
    };

    PlayedKernel();
    ~PlayedKernel();

    // Each has an errno for the next calls, 0 where one succeeds.
    std::deque<int> canCauses;   ///< socket() of CAN
    std::deque<int> routeCauses; ///< socket() of the list of interfaces
    std::deque<int> bindCauses;
    std::deque<int> sendCauses;
    std::deque<int> receiveCauses; ///< recvmmsg()
    std::deque<int> noticeCauses;  ///< recv() of notices

    std::vector<Network> networks;
    std::optional<std::vector<NetlinkBytes>> datagrams; ///< answer every question instead
    std::deque<std::vector<Control>> controls;          ///< of the next frames
    int fullBatches = 0;                                ///< come before what is on the cable
    std::optional<std::uint32_t> drops = 0;
    unsigned memoryBytes = 36; ///< of SO_MEMINFO
    int receiveBuffer = 768 * 100;
    std::set<int> refusedSettings;

    std::vector<Three> opened;    ///< domain, type, protocol
    std::vector<Three> questions; ///< type, flags, index
    std::vector<Three> settings;  ///< of CAN sockets: level, name, value
    std::vector<Three> bound;     ///< family, index or groups, settings made before
    int looks = 0;                ///< recvmmsg()
    int sends = 0;                ///< of frames
    int cable = -1;               ///< of the youngest CAN socket
    int notices = -1;             ///< where the kernel tells of changes

    // For the functions of the system that are played.
    [[nodiscard]] bool plays(int descriptor) const;
    int open(int domain, int type, int protocol);
    int bindTo(int descriptor, const sockaddr *address);
    ssize_t take(int descriptor, const void *data, std::size_t size, int flags);
    ssize_t give(int descriptor, void *data, std::size_t size, int flags);
    int giveFrames(int descriptor, mmsghdr *messages, unsigned count, int flags);
    int set(int descriptor, int level, int name, const void *value, socklen_t size);
    int get(int descriptor, int level, int name, void *value, socklen_t *size) const;
    [[nodiscard]] unsigned indexOf(const std::string &name) const;

private:
    struct End {
        int domain = 0;
        std::uint64_t inode = 0;
        std::shared_ptr<Descriptor> other;
    };
    [[nodiscard]] std::vector<NetlinkBytes> answersTo(int index) const;
    ssize_t answer(End &end, const void *question, std::size_t size);

    std::map<int, End> m_ends; ///< by descriptor
};

} // namespace mb::test
