// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/backends/socketcan.h"

#include "async/background.h"
#include "async/descriptor.h"
#include "transport/backends/cansocket.h"
#include "wire/canerror.h"

#include <QSocketNotifier>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include <linux/can.h>
#include <linux/errqueue.h>
#include <sys/socket.h>
#include <unistd.h>

namespace mb {
namespace {

constexpr unsigned batchSize = 64;
constexpr int batchesAtOnce = 16; // then other descriptors get their turn
// A full transmit queue does not tell when it has room again. Ten frames wait in it (txqueuelen), one takes 131 µs.
constexpr Duration retryDelay = std::chrono::microseconds(500);
constexpr Duration lookPeriod = std::chrono::milliseconds(500);

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

/// Of the background: of one adapter after the other.
std::string laneOf(const std::string &interface)
{
    return "can:" + interface;
}

Error busOff(const std::string &interface)
{
    return {Fault::LinkLost, say("bus-off: %1 left the bus after too many errors", interface),
        say("check wiring, termination and bit rate"), {}, Ailment::BusOff};
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
    , m_queue(clock)
    , m_retry(clock)
    , m_failed(clock)
    , m_look(clock)
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
        const int given = std::exchange(m_given, -1);
        take(given, prepareCanSocket(given));
        return {};
    }
    MB_TRY(const auto opened, openCanSocket(address().path));
    adopt(opened.interface);
    take(opened.descriptor, opened.receiveBuffer);
    return {};
}

/// The kernel lists no interface while a driver holds its lock.
Task<void> SocketCanLink::doOpenSoon(Background &background)
{
    if (m_given >= 0)
        co_return doOpen();
    struct Opened {
        CanInterface interface;
        int receiveBuffer;
        Descriptor descriptor;
    };
    const std::string path = address().path;
    auto opening = inBackground<std::shared_ptr<Opened>>(
        background, clock(), laneOf(path), openLimit,
        [path]() -> Result<std::shared_ptr<Opened>> {
            MB_TRY(const auto opened, openCanSocket(path));
            return std::shared_ptr<Opened>(
                new Opened{opened.interface, opened.receiveBuffer, Descriptor(opened.descriptor)});
        },
        WhenLate::Drop);
    const Result<std::shared_ptr<Opened>> opened = co_await std::move(opening).attempt();
    if (!opened && opened.error().fault == Fault::Timeout)
        co_return fail(Fault::LinkLost, say("the kernel does not say what %1 is: a driver holds it up", path),
            say("unplug the adapter and plug it in again"));
    if (!opened)
        co_return fail(opened.error());
    adopt((*opened)->interface);
    take((*opened)->descriptor.give(), (*opened)->receiveBuffer);
    co_return {};
}

void SocketCanLink::take(int descriptor, int receiveBuffer)
{
    m_descriptor = descriptor;
    m_receiveBuffer = receiveBuffer;
    m_drops = 0;
    m_latest = {};
    m_hardware.reset();
    m_asked = std::make_shared<bool>(false);
    watch();
}

void SocketCanLink::watch()
{
    m_readable = std::make_unique<QSocketNotifier>(m_descriptor, QSocketNotifier::Read);
    QObject::connect(m_readable.get(), &QSocketNotifier::activated, m_readable.get(), [this] { receive(); });
    m_writable = std::make_unique<QSocketNotifier>(m_descriptor, QSocketNotifier::Write);
    m_writable->setEnabled(false);
    QObject::connect(m_writable.get(), &QSocketNotifier::activated, m_writable.get(), [this] { flush(); });
    m_look.startIn(lookPeriod, [this] { look(); });
}

void SocketCanLink::unwatch()
{
    m_readable.reset();
    m_writable.reset();
    m_retry.stop();
    m_failed.stop();
    m_look.stop();
    m_queue.clear();
}

void SocketCanLink::doClose()
{
    if (m_descriptor < 0)
        return;
    if (state() == LinkState::Open)
        flush(); // a stop frame that waits gets its last chance
    unwatch();
    ::close(std::exchange(m_descriptor, -1));
    m_asked.reset();
    m_interface = {};
}

void SocketCanLink::adopt(const CanInterface &interface)
{
    m_interface = m_atOpening = interface;
    m_overruns = m_counted = 0;
    startHealth(interface.state, interface.transmitErrors, interface.receiveErrors);
}

void SocketCanLink::look()
{
    m_look.startIn(lookPeriod, [this] { look(); });
    if (!m_queue.isEmpty())
        flush();
    recount();
}

void SocketCanLink::recount()
{
    if (m_descriptor < 0 || state() != LinkState::Open)
        return;
    if (const auto drops = droppedFrames(m_descriptor))
        noteDrops(*drops);
    if (m_interface.index <= 0)
        return;
    if (settings().background)
        askKernel(*settings().background);
    else if (const auto now = canInterface(m_interface.index))
        takeInterface(*now);
}

/// A driver may hold it up. The answer counts after the link is lost, too: of what was dropped nobody else tells.
void SocketCanLink::askKernel(Background &background)
{
    if (std::exchange(*m_asked, true))
        return;
    const auto found = std::make_shared<std::optional<CanInterface>>();
    background.run(
        laneOf(m_interface.name), [found, index = m_interface.index] { *found = canInterface(index); },
        [this, found, asked = std::weak_ptr<bool>(m_asked)] {
            const auto own = asked.lock();
            if (!own)
                return; // it was closed meanwhile
            *own = false;
            if (*found)
                takeInterface(**found);
        });
}

void SocketCanLink::takeInterface(const CanInterface &now)
{
    m_interface = now;
    countInterface();
    if (now.kind != CanInterface::Kind::Controller || state() != LinkState::Open)
        return;
    updateHealth(now.state, now.transmitErrors, now.receiveErrors);
    if (now.state == BusState::BusOff) // its error frame may have found no room in the socket
        endLater(busOff(address().path));
}

void SocketCanLink::countInterface()
{
    // An overrun may be told by an error frame, in the statistics, or in both.
    const std::uint64_t overruns = std::max(m_overruns, m_interface.overruns - m_atOpening.overruns);
    const std::uint64_t lost = overruns + m_interface.dropped - m_atOpening.dropped;
    if (lost > m_counted)
        countLost(lost - std::exchange(m_counted, lost));
}

void SocketCanLink::catchUp()
{
    const Instant begin = clock().now();
    while (m_descriptor >= 0 && state() == LinkState::Open && m_latest < begin && receive()) { }
}

/// Whether more may wait.
bool SocketCanLink::receive()
{
    bool behind = false;
    bool isMore = false;
    int cause = 0;
    for (int i = 0; i < batchesAtOnce || cause != 0; ++i) {
        const int got = ::recvmmsg(m_descriptor, m_batch->messages.data(), batchSize, MSG_DONTWAIT, nullptr);
        if (got < 0) {
            isMore = errno == EINTR;
            if (errno == EAGAIN || errno == EINTR || cause != 0)
                break;
            cause = errno; // told once, before the frames that came earlier: those are still ours
            continue;
        }
        takeBatch(static_cast<unsigned>(got));
        endBatch();
        if (state() != LinkState::Open)
            return false;
        const bool full = got == static_cast<int>(batchSize);
        behind = behind || full;
        isMore = full;
        if (!full && cause == 0)
            break;
    }
    // A frame carries the drops before it; those after the last one are known only this way.
    if (const auto drops = behind ? droppedFrames(m_descriptor) : std::nullopt)
        noteDrops(*drops);
    if (cause != 0)
        end(socketFailure(address().path, cause));
    return isMore;
}

void SocketCanLink::endLater(Error loss)
{
    // Told from the clock: whoever sends or counts does not expect to be called back. What was received before counts first.
    m_failed.startIn(Duration::zero(), [this, loss = std::move(loss)] {
        catchUp();
        if (state() == LinkState::Open)
            end(loss);
    });
}

void SocketCanLink::takeBatch(unsigned count)
{
    const Duration unixOffset = clock().unixOffset();
    const Instant now = clock().now();
    for (std::size_t i = 0; i < count && state() == LinkState::Open; ++i) {
        const mmsghdr &message = m_batch->messages[i];
        const can_frame &raw = m_batch->frames[i];
        if (message.msg_len == 0)
            end(socketFailure(address().path, EPIPE));
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
    const CanErrorReport report = frame.error ? decodeError(frame) : CanErrorReport{};
    if (report.overrun) {
        ++m_overruns; // at least one frame
        countInterface();
    }
    deliver(frame);
    if (report.state == BusState::BusOff)
        end(busOff(address().path));
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

Result<void> SocketCanLink::doSend(const CanFrame &frame, Priority priority)
{
    MB_TRY_VOID(m_queue.admit(frame, priority, address().path));
    if (m_queue.isNext(priority)) {
        const int cause = writeFrame(m_descriptor, frame, priority);
        if (cause == 0) {
            if (m_queue.isEmpty())
                setStuckSince(std::nullopt);
            return {};
        }
        if (!health().stuckSince)
            setStuckSince(clock().now());
        if (!tryLater(cause)) {
            endLater(socketFailure(address().path, cause));
            return fail(socketFailure(address().path, cause));
        }
    }
    m_queue.push(frame, priority);
    return {};
}

void SocketCanLink::flush()
{
    m_writable->setEnabled(false);
    m_retry.stop();
    countLost(m_queue.dropStale()); // first: it may be long ago that this thread had its turn
    while (!m_queue.isEmpty()) {
        const CanQueue::Next next = m_queue.take();
        const int cause = writeFrame(m_descriptor, next.frame, next.priority);
        if (cause != 0) {
            m_queue.putBack(next);
            if (!tryLater(cause))
                endLater(socketFailure(address().path, cause));
            return;
        }
        m_queue.wentOut(next);
        setStuckSince(m_queue.isEmpty() ? std::nullopt : std::optional(clock().now()));
    }
}

bool SocketCanLink::tryLater(int cause)
{
    if (cause == EAGAIN)
        m_writable->setEnabled(true);
    else if (cause == ENOBUFS && !m_retry.isActive())
        m_retry.startIn(retryDelay, [this] { flush(); });
    return cause == EAGAIN || cause == ENOBUFS;
}

void SocketCanLink::end(Error loss)
{
    recount(); // the last moment to learn what was dropped
    unwatch();
    lose(std::move(loss));
}

} // namespace mb
