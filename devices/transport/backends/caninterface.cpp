// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/backends/caninterface.h"

#include "async/noncopyable.h"
#include "transport/backends/netlink.h"

#include <array>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include <linux/can.h>
#include <linux/can/netlink.h>
#include <linux/if_link.h>
#include <net/if.h>
#include <net/if_arp.h>
#include <sys/socket.h>
#include <unistd.h>

namespace mb {
namespace {

using netlink::Bytes;
using netlink::eachAttribute;
using netlink::readAs;
using netlink::readPart;

BusState stateOf(std::uint32_t kernel)
{
    switch (kernel) {
    case CAN_STATE_ERROR_WARNING: return BusState::Warning;
    case CAN_STATE_ERROR_PASSIVE: return BusState::Passive;
    case CAN_STATE_BUS_OFF: return BusState::BusOff;
    default: return BusState::Active;
    }
}

/// What a controller says beside the description of the interface.
struct ControllerFacts {
    bool fixedRates = false; ///< a list of bit rates
    bool freeRates = false;  ///< bit timing of its own
};

void readTiming(Bytes content, CanInterface &interface)
{
    const auto timing = readPart<can_bittiming>(content);
    interface.bitrate = static_cast<int>(timing.bitrate);
    interface.samplePoint = timing.sample_point / 1000.0;
}

void readController(Bytes data, CanInterface &interface, ControllerFacts &facts)
{
    eachAttribute(data, [&](int type, Bytes content) {
        switch (type) {
        case IFLA_CAN_BITTIMING: readTiming(content, interface); break;
        case IFLA_CAN_BITTIMING_CONST: facts.freeRates = true; break;
        case IFLA_CAN_BITRATE_CONST: facts.fixedRates = true; break;
        case IFLA_CAN_STATE: interface.state = stateOf(readPart<std::uint32_t>(content)); break;
        case IFLA_CAN_RESTART_MS: interface.restarts = readPart<std::uint32_t>(content) > 0; break;
        case IFLA_CAN_CTRLMODE:
            interface.listenOnly = (readPart<can_ctrlmode>(content).flags & CAN_CTRLMODE_LISTENONLY) != 0U;
            break;
        case IFLA_CAN_BERR_COUNTER: {
            const auto counters = readPart<can_berr_counter>(content);
            interface.transmitErrors = counters.txerr;
            interface.receiveErrors = counters.rxerr;
            break;
        }
        case IFLA_CAN_CTRLMODE_EXT:
            eachAttribute(content, [&interface](int detail, Bytes value) {
                if (detail == IFLA_CAN_CTRLMODE_SUPPORTED)
                    interface.canListenOnly = (readPart<std::uint32_t>(value) & CAN_CTRLMODE_LISTENONLY) != 0U;
            });
            break;
        default: break;
        }
    });
}

void readStatistics(Bytes content, CanInterface &interface)
{
    const auto counted = readPart<rtnl_link_stats64>(content);
    interface.overruns = counted.rx_over_errors + counted.rx_fifo_errors;
    interface.dropped = counted.rx_dropped + counted.rx_missed_errors + counted.tx_dropped;
}

/// The driver of the adapter behind an interface; virtual ones have none.
std::string driverOf(const std::string &name)
{
    std::error_code failed;
    const auto driver = std::filesystem::read_symlink("/sys/class/net/" + name + "/device/driver", failed);
    return failed ? std::string() : driver.filename().string();
}

void setKind(const std::string &kind, const ControllerFacts &facts, CanInterface &interface)
{
    interface.driver = driverOf(interface.name);
    const bool anonymous = interface.driver.empty();
    if (kind == "vcan" || kind == "vxcan")
        interface.kind = CanInterface::Kind::Virtual;
    else if (interface.name.starts_with("slcan") || (anonymous && facts.fixedRates && !facts.freeRates))
        interface.kind = CanInterface::Kind::SerialLine;
    else if (kind == "can" || !anonymous)
        interface.kind = CanInterface::Kind::Controller;
    if (anonymous)
        interface.driver = interface.kind == CanInterface::Kind::SerialLine ? "slcan" : kind;
}

} // namespace

std::optional<CanInterface> canInterfaceFrom(Bytes message)
{
    const auto link = readAs<ifinfomsg>(message);
    if (!link || link->ifi_type != ARPHRD_CAN)
        return std::nullopt;
    CanInterface interface;
    ControllerFacts facts;
    std::string kind;
    Bytes data;
    interface.index = link->ifi_index;
    interface.up = (link->ifi_flags & IFF_UP) != 0U;
    eachAttribute(message.subspan(netlink::aligned(sizeof(ifinfomsg))), [&](int type, Bytes content) {
        if (type == IFLA_IFNAME)
            interface.name = netlink::textOf(content);
        if (type == IFLA_STATS64)
            readStatistics(content, interface);
        if (type != IFLA_LINKINFO)
            return;
        eachAttribute(content, [&](int detail, Bytes value) {
            if (detail == IFLA_INFO_KIND)
                kind = netlink::textOf(value);
            if (detail == IFLA_INFO_DATA)
                data = value;
        });
    });
    if (kind == "can")
        readController(data, interface, facts);
    setKind(kind, facts, interface);
    return interface;
}

namespace {

/// A conversation with the kernel about its interfaces.
class Question : NonCopyable {
public:
    Question()
        : m_descriptor(::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_ROUTE))
    {
        const timeval patience{1, 0};
        if (isOpen()) // else errno says why it is not
            ::setsockopt(m_descriptor, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    }
    ~Question()
    {
        if (m_descriptor >= 0)
            ::close(m_descriptor);
    }
    [[nodiscard]] bool isOpen() const { return m_descriptor >= 0; }

    /// All interfaces, or the one with this index; calls visit for each of CAN.
    template <class Visit> void ask(int index, Visit visit)
    {
        struct {
            nlmsghdr head{};
            ifinfomsg link{};
        } request;
        request.head.nlmsg_len = sizeof request;
        request.head.nlmsg_type = RTM_GETLINK;
        request.head.nlmsg_flags = static_cast<std::uint16_t>(NLM_F_REQUEST | (index == 0 ? NLM_F_DUMP : 0));
        request.link.ifi_index = index;
        bool more = ::send(m_descriptor, &request, sizeof request, 0) == ssize_t(sizeof request);
        alignas(nlmsghdr) std::array<std::byte, 32768> buffer;
        while (more) {
            const ssize_t got = ::recv(m_descriptor, buffer.data(), buffer.size(), 0);
            const auto take = [&visit](int type, Bytes content) {
                if (type != RTM_NEWLINK)
                    return;
                if (auto interface = canInterfaceFrom(content))
                    visit(std::move(*interface));
            };
            more = got > 0 && netlink::eachMessage(Bytes(buffer.data(), static_cast<std::size_t>(got)), take)
                && index == 0;
        }
    }

private:
    int m_descriptor;
};

} // namespace

Result<std::vector<CanInterface>> canInterfaces()
{
    Question question;
    if (!question.isOpen())
        return fail(Fault::LinkLost, say("the kernel does not list its interfaces: %1", std::strerror(errno)));
    std::vector<CanInterface> interfaces;
    question.ask(0, [&interfaces](CanInterface &&interface) { interfaces.push_back(std::move(interface)); });
    return interfaces;
}

std::optional<CanInterface> canInterface(int index)
{
    Question question;
    std::optional<CanInterface> found;
    if (question.isOpen() && index > 0)
        question.ask(index, [&found](CanInterface &&interface) { found = std::move(interface); });
    return found;
}

} // namespace mb
