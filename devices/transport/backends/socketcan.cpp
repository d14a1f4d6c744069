// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/backends/socketcan.h"

#include "transport/backends/caninterface.h"

#include <QSocketNotifier>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include <linux/can.h>
#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <linux/errqueue.h>
#include <linux/net_tstamp.h>
#include <linux/sock_diag.h>
#include <net/if.h>
#include <sys/socket.h>
#include <unistd.h>

namespace mb {
namespace {

constexpr unsigned batchSize = 64;
constexpr int batchesAtOnce = 16; // then other descriptors get their turn
constexpr int wantedReceiveBuffer = 16 << 20;
constexpr int urgentBand = 6; // TC_PRIO_INTERACTIVE: the first band of pfifo_fast
// A full transmit queue does not become readable: ask again. Ten frames wait in the kernel (txqueuelen), one takes 131
// µs.
constexpr Duration retryDelay = std::chrono::microseconds(500);

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

template <class T> T contentOf(const cmsghdr &control)
{
    T value;
    std::memcpy(&value, CMSG_DATA(&control), sizeof value);
    return value;
}

Duration durationOf(const timespec &time)
{
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

can_frame rawOf(const CanFrame &frame)
{
    can_frame raw{};
    raw.can_id = frame.id | (frame.extended ? CAN_EFF_FLAG : 0U) | (frame.remote ? CAN_RTR_FLAG : 0U);
    raw.can_dlc = frame.size;
    std::memcpy(raw.data, frame.data.data(), frame.size);
    return raw;
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

} // namespace

/// Where recvmmsg writes to; set up once, the kernel changes lengths and flags only.
struct SocketCanLink::Batch {
    struct alignas(cmsghdr) Control {
        std::array<std::byte, CMSG_SPACE(sizeof(scm_timestamping)) + CMSG_SPACE(sizeof(std::uint32_t))> bytes;
    };

    Batch()
    {
        for (std::size_t i = 0; i < batchSize; ++i) {
            parts[i] = {&frames[i], sizeof(can_frame)};
            messages[i].msg_hdr.msg_iov = &parts[i];
            messages[i].msg_hdr.msg_iovlen = 1;
            messages[i].msg_hdr.msg_control = &controls[i];
        }
        prepare(batchSize);
    }
    void prepare(unsigned used)
    {
        for (std::size_t i = 0; i < used; ++i)
            messages[i].msg_hdr.msg_controllen = sizeof(Control);
    }

    std::array<can_frame, batchSize> frames{};
    std::array<iovec, batchSize> parts{};
    std::array<Control, batchSize> controls{};
    std::array<mmsghdr, batchSize> messages{};
};

SocketCanLink::SocketCanLink(LinkAddress address, Clock &clock)
    : SocketCanLink(std::move(address), clock, -1)
{
}

SocketCanLink::SocketCanLink(LinkAddress address, Clock &clock, int descriptor)
    : CanLink(std::move(address), clock)
    , m_given(descriptor)
    , m_batch(std::make_unique<Batch>())
    , m_retry(clock)
    , m_failed(clock)
{
}

SocketCanLink::~SocketCanLink()
{
    SocketCanLink::doClose();
    if (m_given >= 0)
        ::close(m_given);
}

Result<void> SocketCanLink::doOpen()
{
    if (m_given >= 0) {
        m_descriptor = std::exchange(m_given, -1);
        configure();
    } else if (auto opened = openInterface(); !opened) {
        return opened;
    }
    watch();
    return {};
}

Result<void> SocketCanLink::openInterface()
{
    if (const auto cause = whyNoCan())
        return fail(Fault::LinkLost, *cause);
    const std::string &name = address().path;
    const unsigned index = name.size() < IFNAMSIZ ? ::if_nametoindex(name.c_str()) : 0;
    if (index == 0)
        return fail(Fault::LinkLost, "there is no CAN interface " + name);
    if (const auto interfaces = canInterfaces()) {
        const auto found = std::find_if(
            interfaces->begin(), interfaces->end(), [&name](const CanInterface &i) { return i.name == name; });
        if (found == interfaces->end())
            return fail(Fault::LinkLost, name + " is a network interface, but not one for CAN");
        if (const auto cause = whyUnusable(*found))
            return fail(Fault::LinkLost, *cause);
        m_bitrate = found->bitrate;
    }
    return bindTo(index);
}

Result<void> SocketCanLink::bindTo(unsigned index)
{
    m_descriptor = ::socket(PF_CAN, SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, CAN_RAW);
    if (m_descriptor < 0)
        return fail(Fault::LinkLost, why(errno));
    configure(); // before bind: no frame comes unstamped
    sockaddr_can where{};
    where.can_family = AF_CAN;
    where.can_ifindex = static_cast<int>(index);
    if (::bind(m_descriptor, reinterpret_cast<const sockaddr *>(&where), sizeof where) == 0)
        return {};
    const int cause = errno;
    ::close(std::exchange(m_descriptor, -1));
    return fail(Fault::LinkLost, why(cause));
}

void SocketCanLink::configure()
{
    m_drops = 0;
    m_latest = {};
    m_hardware.reset();
    // Hardware stamps come with the software ones they are aligned by. Other sockets know only the older option.
    constexpr int stamps = SOF_TIMESTAMPING_RX_SOFTWARE | SOF_TIMESTAMPING_SOFTWARE | SOF_TIMESTAMPING_RX_HARDWARE
        | SOF_TIMESTAMPING_RAW_HARDWARE;
    const bool isCan = optionOf<int>(m_descriptor, SOL_SOCKET, SO_DOMAIN) == PF_CAN;
    if (!isCan || !setOption(m_descriptor, SOL_SOCKET, SO_TIMESTAMPING, stamps))
        setOption(m_descriptor, SOL_SOCKET, SO_TIMESTAMPNS, 1);
    setOption(m_descriptor, SOL_SOCKET, SO_RXQ_OVFL, 1);
    if (!setOption(m_descriptor, SOL_SOCKET, SO_RCVBUFFORCE, wantedReceiveBuffer))
        setOption(m_descriptor, SOL_SOCKET, SO_RCVBUF, wantedReceiveBuffer);
    m_receiveBuffer = optionOf<int>(m_descriptor, SOL_SOCKET, SO_RCVBUF);
    const can_err_mask_t everyError = CAN_ERR_MASK;
    if (isCan)
        setOption(m_descriptor, SOL_CAN_RAW, CAN_RAW_ERR_FILTER, everyError);
}

void SocketCanLink::watch()
{
    m_readable = std::make_unique<QSocketNotifier>(m_descriptor, QSocketNotifier::Read);
    QObject::connect(m_readable.get(), &QSocketNotifier::activated, m_readable.get(), [this] { receive(); });
    m_writable = std::make_unique<QSocketNotifier>(m_descriptor, QSocketNotifier::Write);
    m_writable->setEnabled(false);
    QObject::connect(m_writable.get(), &QSocketNotifier::activated, m_writable.get(), [this] { flush(); });
}

void SocketCanLink::unwatch()
{
    m_readable.reset();
    m_writable.reset();
    m_retry.stop();
    m_failed.stop();
    m_urgent.clear();
    m_normal.clear();
}

void SocketCanLink::doClose()
{
    if (m_descriptor < 0)
        return;
    if (state() == LinkState::Open)
        flush(); // a stop frame that waits gets its last chance
    unwatch();
    ::close(std::exchange(m_descriptor, -1));
    m_bitrate = 0;
}

void SocketCanLink::receive()
{
    bool behind = false;
    for (int i = 0; i < batchesAtOnce; ++i) {
        const int got = ::recvmmsg(m_descriptor, m_batch->messages.data(), batchSize, MSG_DONTWAIT, nullptr);
        if (got < 0) {
            if (errno != EAGAIN && errno != EINTR)
                end(why(errno));
            break;
        }
        takeBatch(static_cast<unsigned>(got));
        endBatch();
        if (state() != LinkState::Open)
            return;
        if (got < static_cast<int>(batchSize))
            break;
        behind = true;
    }
    if (behind && state() == LinkState::Open)
        askForDrops();
}

void SocketCanLink::takeBatch(unsigned count)
{
    const Duration unixOffset = clock().unixOffset();
    const Instant now = clock().now();
    for (std::size_t i = 0; i < count && state() == LinkState::Open; ++i) {
        const mmsghdr &message = m_batch->messages[i];
        const can_frame &raw = m_batch->frames[i];
        if (message.msg_len == 0)
            end(why(EPIPE));
        else if (message.msg_len != CAN_MTU || (message.msg_hdr.msg_flags & MSG_TRUNC) != 0
            || raw.can_dlc > CAN_MAX_DLEN)
            countError();
        else
            take(raw, stampOf(message.msg_hdr, unixOffset, now));
    }
    m_batch->prepare(count);
}

void SocketCanLink::take(const can_frame &raw, Instant time)
{
    const CanFrame frame = frameOf(raw, time);
    if (frame.error && (frame.id & CAN_ERR_CRTL) != 0U && (frame.data[1] & CAN_ERR_CRTL_RX_OVERFLOW) != 0U)
        countLost(1); // at least
    deliver(frame);
    if (frame.error && (frame.id & CAN_ERR_BUSOFF) != 0U)
        end("bus-off: " + address().path
            + " left the bus after too many errors; check wiring, termination and bit rate");
}

Instant SocketCanLink::stampOf(const msghdr &message, Duration unixOffset, Instant now)
{
    Instant time = now;
    auto &head = const_cast<msghdr &>(message); // CMSG_NXTHDR reads only
    for (cmsghdr *control = CMSG_FIRSTHDR(&head); control != nullptr; control = CMSG_NXTHDR(&head, control)) {
        if (control->cmsg_level != SOL_SOCKET)
            continue;
        if (control->cmsg_type == SO_RXQ_OVFL) {
            noteDrops(contentOf<std::uint32_t>(*control));
        } else if (control->cmsg_type == SO_TIMESTAMPNS) {
            time = Instant(durationOf(contentOf<timespec>(*control)) - unixOffset);
        } else if (control->cmsg_type == SO_TIMESTAMPING) {
            const auto stamps = contentOf<scm_timestamping>(*control);
            const Duration software = durationOf(stamps.ts[0]);
            const Duration hardware = durationOf(stamps.ts[2]);
            if (software != Duration::zero())
                time = Instant(software - unixOffset);
            if (hardware != Duration::zero())
                time = m_hardware.align(hardware, std::min(time, now));
        }
    }
    m_latest = std::max(m_latest, std::min(time, now));
    return m_latest;
}

void SocketCanLink::noteDrops(std::uint32_t total)
{
    const auto more = static_cast<std::int32_t>(total - m_drops); // the counter wraps
    if (more <= 0)
        return;
    m_drops = total;
    countLost(static_cast<std::uint64_t>(more));
}

void SocketCanLink::askForDrops()
{
    // A frame carries the drops before it; those after the last one are known only this way.
    std::array<std::uint32_t, SK_MEMINFO_VARS> memory{};
    socklen_t size = sizeof memory;
    if (::getsockopt(m_descriptor, SOL_SOCKET, SO_MEMINFO, memory.data(), &size) == 0 && size == sizeof memory)
        noteDrops(memory[SK_MEMINFO_DROPS]);
}

Result<void> SocketCanLink::doSend(const CanFrame &frame, Priority priority)
{
    auto &queue = priority == Priority::Urgent ? m_urgent : m_normal;
    const bool first = m_urgent.empty() && (priority == Priority::Urgent || m_normal.empty());
    if (first) {
        const int cause = write(frame, priority);
        if (cause == 0)
            return {};
        if (!waitForRoom(cause)) {
            // Told from the clock: whoever sends does not expect to be called back.
            m_failed.startIn(Duration::zero(), [this, reason = why(cause)] { end(reason); });
            return fail(Fault::LinkLost, why(cause));
        }
    }
    queue.push_back(frame);
    return {};
}

void SocketCanLink::flush()
{
    m_writable->setEnabled(false);
    m_retry.stop();
    while (doBacklog() > 0) {
        const bool urgent = !m_urgent.empty();
        auto &queue = urgent ? m_urgent : m_normal;
        const int cause = write(queue.front(), urgent ? Priority::Urgent : Priority::Normal);
        if (cause != 0) {
            if (!waitForRoom(cause))
                m_failed.startIn(Duration::zero(), [this, reason = why(cause)] { end(reason); });
            return;
        }
        queue.pop_front();
    }
}

int SocketCanLink::write(const CanFrame &frame, Priority priority)
{
    const can_frame raw = rawOf(frame);
    const bool urgent = priority == Priority::Urgent;
    if (urgent)
        setOption(m_descriptor, SOL_SOCKET, SO_PRIORITY, urgentBand);
    ssize_t sent = 0;
    do
        sent = ::send(m_descriptor, &raw, sizeof raw, MSG_DONTWAIT | MSG_NOSIGNAL);
    while (sent < 0 && errno == EINTR);
    const int cause = sent < 0 ? errno : 0;
    if (urgent)
        setOption(m_descriptor, SOL_SOCKET, SO_PRIORITY, 0);
    return cause;
}

bool SocketCanLink::waitForRoom(int cause)
{
    if (cause == EAGAIN)
        m_writable->setEnabled(true);
    else if (cause == ENOBUFS && !m_retry.isActive())
        m_retry.startIn(retryDelay, [this] { flush(); });
    return cause == EAGAIN || cause == ENOBUFS;
}

std::string SocketCanLink::why(int cause) const
{
    const std::string &name = address().path;
    switch (cause) {
    case ENETDOWN:
        return ::if_nametoindex(name.c_str()) != 0 ? name + " was switched off" : name + " is gone";
    case ENODEV:
    case ENXIO:
        return name + " is gone";
    case EPIPE:
    case ECONNRESET:
    case ENOTCONN:
        return "the other end of " + name + " closed it";
    case EPERM:
    case EACCES:
        return "no permission to use " + name + "; allow CAN sockets in the container or sandbox";
    default:
        return name + " failed: " + std::strerror(cause);
    }
}

void SocketCanLink::end(std::string reason)
{
    unwatch();
    lose(std::move(reason));
}

} // namespace mb
