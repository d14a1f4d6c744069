// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/backends/cansocket.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include <linux/can.h>
#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <linux/net_tstamp.h>
#include <linux/sock_diag.h>
#include <net/if.h>
#include <sys/socket.h>
#include <unistd.h>

namespace mb {
namespace {

constexpr int wantedReceiveBuffer = 16 << 20;
constexpr int urgentBand = 6; // TC_PRIO_INTERACTIVE: the first band of pfifo_fast

template <class T> bool setOption(int descriptor, int level, int name, const T &value)
{
    return ::setsockopt(descriptor, level, name, &value, sizeof value) == 0;
}

template <class T> T optionOf(int descriptor, int level, int name)
{
    T value{};
    socklen_t size = sizeof value;
    ::getsockopt(descriptor, level, name, &value, &size);
    return value;
}

can_frame rawOf(const CanFrame &frame)
{
    can_frame raw{};
    raw.can_id = frame.id | (frame.extended ? CAN_EFF_FLAG : 0U) | (frame.remote ? CAN_RTR_FLAG : 0U);
    raw.can_dlc = frame.size;
    std::memcpy(raw.data, frame.data.data(), frame.size);
    return raw;
}

Result<OpenedCan> bindTo(const std::string &name, unsigned index)
{
    OpenedCan opened;
    opened.descriptor = ::socket(PF_CAN, SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, CAN_RAW);
    if (opened.descriptor < 0)
        return fail(socketFailure(name, errno));
    opened.receiveBuffer = prepareCanSocket(opened.descriptor); // before bind: no frame comes unstamped
    sockaddr_can where{};
    where.can_family = AF_CAN;
    where.can_ifindex = static_cast<int>(index);
    if (::bind(opened.descriptor, reinterpret_cast<const sockaddr *>(&where), sizeof where) == 0)
        return opened;
    const int cause = errno;
    ::close(opened.descriptor);
    return fail(socketFailure(name, cause));
}

} // namespace

std::optional<Diagnosis> whyNoCan()
{
    const int descriptor = ::socket(PF_CAN, SOCK_RAW | SOCK_CLOEXEC, CAN_RAW);
    if (descriptor >= 0) {
        ::close(descriptor);
        return std::nullopt;
    }
    if (errno == EPERM || errno == EACCES)
        return Diagnosis{Ailment::NoPermission, say("no permission to open CAN sockets here"),
            say("allow them in the container or sandbox"), {}};
    if (errno == EAFNOSUPPORT || errno == EPROTONOSUPPORT)
        return Diagnosis{
            Ailment::NoCan, say("this kernel has no CAN support"), say("load it"), "sudo modprobe can_raw"};
    return Diagnosis{Ailment::Failed, say("CAN sockets cannot be opened: %1", std::strerror(errno)), {}, {}};
}

Result<OpenedCan> openCanSocket(const std::string &name)
{
    if (const auto cause = whyNoCan())
        return fail(errorOf(*cause));
    const unsigned index = name.size() < IFNAMSIZ ? ::if_nametoindex(name.c_str()) : 0;
    if (index == 0)
        return fail(Error{Fault::LinkLost, say("there is no CAN interface %1", name), {}, {}, Ailment::NotThere});
    CanInterface interface;
    if (const auto known = canInterfaces()) {
        const auto found
            = std::find_if(known->begin(), known->end(), [&name](const auto &i) { return i.name == name; });
        if (found == known->end())
            return fail(Fault::LinkLost, say("%1 is a network interface, but not one for CAN", name));
        interface = *found;
        if (const Diagnosis cause = diagnose(interface); !cause.isHealthy())
            return fail(errorOf(cause));
    }
    auto opened = bindTo(name, index);
    if (opened)
        opened->interface = interface;
    return opened;
}

int prepareCanSocket(int descriptor)
{
    // Hardware stamps come with the software ones they are aligned by. Other sockets know only the older option.
    constexpr int stamps = SOF_TIMESTAMPING_RX_SOFTWARE | SOF_TIMESTAMPING_SOFTWARE | SOF_TIMESTAMPING_RX_HARDWARE
        | SOF_TIMESTAMPING_RAW_HARDWARE;
    const bool isCan = optionOf<int>(descriptor, SOL_SOCKET, SO_DOMAIN) == PF_CAN;
    if (!isCan || !setOption(descriptor, SOL_SOCKET, SO_TIMESTAMPING, stamps))
        setOption(descriptor, SOL_SOCKET, SO_TIMESTAMPNS, 1);
    setOption(descriptor, SOL_SOCKET, SO_RXQ_OVFL, 1);
    if (!setOption(descriptor, SOL_SOCKET, SO_RCVBUFFORCE, wantedReceiveBuffer))
        setOption(descriptor, SOL_SOCKET, SO_RCVBUF, wantedReceiveBuffer);
    const can_err_mask_t everyError = CAN_ERR_MASK;
    if (isCan)
        setOption(descriptor, SOL_CAN_RAW, CAN_RAW_ERR_FILTER, everyError);
    return optionOf<int>(descriptor, SOL_SOCKET, SO_RCVBUF);
}

int writeFrame(int descriptor, const CanFrame &frame, Priority priority)
{
    const can_frame raw = rawOf(frame);
    const bool urgent = priority == Priority::Urgent;
    if (urgent)
        setOption(descriptor, SOL_SOCKET, SO_PRIORITY, urgentBand);
    ssize_t sent = 0;
    do
        sent = ::send(descriptor, &raw, sizeof raw, MSG_DONTWAIT | MSG_NOSIGNAL);
    while (sent < 0 && errno == EINTR);
    const int cause = sent < 0 ? errno : 0;
    if (urgent)
        setOption(descriptor, SOL_SOCKET, SO_PRIORITY, 0);
    return cause;
}

std::optional<std::uint32_t> droppedFrames(int descriptor)
{
    std::array<std::uint32_t, SK_MEMINFO_VARS> memory{};
    socklen_t size = sizeof memory;
    if (::getsockopt(descriptor, SOL_SOCKET, SO_MEMINFO, memory.data(), &size) != 0 || size != sizeof memory)
        return std::nullopt;
    return memory[SK_MEMINFO_DROPS];
}

Error socketFailure(const std::string &name, int cause)
{
    switch (cause) {
    case ENETDOWN:
        if (::if_nametoindex(name.c_str()) != 0)
            return {Fault::LinkLost, say("%1 was switched off", name), {}, {}, Ailment::Down};
        return {Fault::LinkLost, say("%1 is gone", name), {}, {}, Ailment::Gone};
    case ENODEV:
    case ENXIO: return {Fault::LinkLost, say("%1 is gone", name), {}, {}, Ailment::Gone};
    case EPIPE:
    case ECONNRESET:
    case ENOTCONN: return {Fault::LinkLost, say("the other end of %1 closed it", name), {}, {}, Ailment::Gone};
    case EPERM:
    case EACCES:
        return {Fault::LinkLost, say("no permission to use %1", name),
            say("allow CAN sockets in the container or sandbox"), {}, Ailment::NoPermission};
    default: return {Fault::LinkLost, say("%1 failed: %2", name, std::strerror(cause))};
    }
}

CanFrame frameOf(const can_frame &raw, Instant time)
{
    CanFrame frame;
    frame.error = (raw.can_id & CAN_ERR_FLAG) != 0U;
    frame.extended = !frame.error && (raw.can_id & CAN_EFF_FLAG) != 0U;
    frame.remote = !frame.error && (raw.can_id & CAN_RTR_FLAG) != 0U;
    frame.id = raw.can_id & (frame.error || frame.extended ? CAN_EFF_MASK : CAN_SFF_MASK);
    frame.size = raw.can_dlc;
    if (!frame.remote)
        std::memcpy(frame.data.data(), raw.data, frame.size);
    frame.time = time;
    return frame;
}

} // namespace mb
