// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/backends/unixspi.h"

#include "transport/backends/unixsocket.h"
#include "wire/bytes.h"

#include <QSocketNotifier>

#include <array>
#include <cerrno>

#include <sys/socket.h>
#include <unistd.h>

namespace mb {
namespace {

constexpr std::uint16_t resetPulse = 65535;
constexpr std::size_t headSize = 2;
constexpr Duration lookPeriod = std::chrono::milliseconds(250);
constexpr int mostSilentLooks = 4; ///< in several, so that the time in which this program was held counts as one
constexpr std::size_t bytesOfALook = 1U << 12U; ///< of a long transfer, at a slow clock

} // namespace

/// Never in the middle of a message of the link.
bool UnixSpiLink::Wire::sendAside(std::span<const std::uint8_t> message)
{
    const std::lock_guard lock(mutex);
    if (descriptor < 0 || !out.empty() || message.size() < headSize)
        return false;
    const auto sent = ::send(descriptor, message.data(), message.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent <= 0)
        return false;
    out.assign(message.begin() + sent, message.end()); // the link sends the rest before anything else
    pending.push_back({Ask::Aside, message.size() - headSize});
    return true;
}

UnixSpiLink::UnixSpiLink(LinkAddress address, Clock &clock)
    : SpiLink(std::move(address), clock)
    , m_failed(clock)
    , m_look(clock)
{
}

UnixSpiLink::~UnixSpiLink()
{
    close();
}

Result<void> UnixSpiLink::doOpen()
{
    MB_TRY(auto connected, connectUnixSocket(address().path));
    m_descriptor = connected;
    m_isServed = false;
    {
        const std::lock_guard lock(m_wire->mutex);
        m_wire->descriptor = m_descriptor;
    }
    setReady(false); // the server always knows its line
    m_readable = std::make_unique<QSocketNotifier>(m_descriptor, QSocketNotifier::Read);
    m_writable = std::make_unique<QSocketNotifier>(m_descriptor, QSocketNotifier::Write);
    m_writable->setEnabled(false);
    QObject::connect(m_readable.get(), &QSocketNotifier::activated, m_readable.get(), [this] { receive(); });
    QObject::connect(m_writable.get(), &QSocketNotifier::activated, m_writable.get(), [this] { flush(); });
    return {};
}

void UnixSpiLink::doClose()
{
    m_readable.reset();
    m_writable.reset();
    if (m_descriptor >= 0) {
        flush(); // a stop that was asked for just now still leaves
        const std::lock_guard lock(m_wire->mutex);
        m_wire->descriptor = -1;
        m_wire->out.clear();
        m_wire->pending.clear();
        ::close(std::exchange(m_descriptor, -1));
    }
    m_failed.stop();
    m_look.stop();
    m_in.clear();
    dropTransfers();
}

Outlet UnixSpiLink::doOutlet() const
{
    Outlet way{Outlet::Form::SpiSocket, m_descriptor};
    way.aside = [wire = m_wire](std::span<const std::uint8_t> message) { return wire->sendAside(message); };
    return way;
}

void UnixSpiLink::ask(Pending pending, std::uint16_t length, const Bytes &bytes)
{
    std::array<std::uint8_t, 2> head{};
    writeU16le(head, 0, length);
    {
        const std::lock_guard lock(m_wire->mutex);
        Bytes &out = m_wire->out;
        out.insert(out.end(), head.begin(), head.end());
        out.insert(out.end(), bytes.begin(), bytes.end());
        if (m_wire->pending.empty())
            m_look.stop(); // a second from now
        m_wire->pending.push_back(pending);
    }
    flush();
    watchAnswer();
}

/// A guardian shares the socket: the answers that it reads while this program is held are missing here for good.
void UnixSpiLink::watchAnswer()
{
    if (m_look.isActive())
        return;
    m_silentLooks = 0;
    m_look.startIn(lookPeriod, [this] { lookForAnswer(); });
}

void UnixSpiLink::lookForAnswer()
{
    const auto awaited = [this]() -> std::optional<std::size_t> {
        const std::lock_guard lock(m_wire->mutex);
        return m_wire->pending.empty() ? std::nullopt : std::optional(m_wire->pending.front().size);
    }();
    if (!awaited)
        return;
    if (++m_silentLooks >= mostSilentLooks + static_cast<int>(*awaited / bytesOfALook))
        end({Fault::LinkLost, say("the simulator at %1 does not answer", address().path), say("start it again"), {},
            Ailment::Gone});
    else
        m_look.startIn(lookPeriod, [this] { lookForAnswer(); });
}

void UnixSpiLink::doTransfer(const Bytes &mosi)
{
    ask({Ask::Transfer, mosi.size()}, static_cast<std::uint16_t>(mosi.size()), mosi);
}

void UnixSpiLink::doSampleReady()
{
    const auto isIdle = [this] {
        const std::lock_guard lock(m_wire->mutex);
        return m_wire->pending.empty();
    };
    if (isIdle()) // any answer tells the level
        ask({Ask::Level, 0}, 0, {});
    else
        watchAnswer();
}

Result<void> UnixSpiLink::doPulseReset()
{
    ask({Ask::Level, 0}, resetPulse, {});
    return {};
}

void UnixSpiLink::endOfSimulator()
{
    if (!m_isServed) {
        end(busySocket(address().path));
        return;
    }
    end({Fault::LinkLost, say("the simulator at %1 closed the connection", address().path), say("start it again"), {},
        Ailment::Gone});
}

void UnixSpiLink::flush()
{
    const std::lock_guard lock(m_wire->mutex);
    Bytes &out = m_wire->out;
    while (!out.empty()) {
        const auto sent = ::send(m_descriptor, out.data(), out.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
        if (sent <= 0) {
            if (sent < 0 && errno != EAGAIN && errno != EINTR)
                endOfSimulator(); // broken pipe: it is gone, whichever of its two ends tells first
            break;
        }
        out.erase(out.begin(), out.begin() + sent);
    }
    if (m_writable)
        m_writable->setEnabled(!out.empty());
}

void UnixSpiLink::receive()
{
    if (!receiveFrom(m_descriptor, m_in)) {
        endOfSimulator();
        return;
    }
    m_isServed = m_isServed || !m_in.empty();
    takeAnswers();
}

/// What the bytes that came belong to, once they are whole.
std::optional<UnixSpiLink::Pending> UnixSpiLink::takePending()
{
    const std::lock_guard lock(m_wire->mutex);
    if (m_wire->pending.empty() || m_in.size() <= m_wire->pending.front().size)
        return std::nullopt;
    const Pending done = m_wire->pending.front();
    m_wire->pending.pop_front();
    m_silentLooks = 0;
    return done;
}

void UnixSpiLink::takeAnswers()
{
    while (const auto done = takePending()) {
        const auto level = m_in.begin() + static_cast<std::ptrdiff_t>(done->size);
        Bytes miso(m_in.begin(), level);
        const bool ready = *level != 0;
        m_in.erase(m_in.begin(), level + 1);
        setReady(ready);
        if (done->kind == Ask::Transfer)
            finishTransfer(std::move(miso)); // may close this link
    }
    const std::lock_guard lock(m_wire->mutex);
    if (m_wire->pending.empty() && !m_in.empty())
        end({Fault::LinkLost, say("the simulator at %1 sent bytes that nobody asked for", address().path)});
}

/// From the clock: whoever asked is in the middle of it.
void UnixSpiLink::end(Error loss)
{
    if (m_readable)
        m_readable->setEnabled(false);
    m_failed.startIn(Duration::zero(), [this, loss = std::move(loss)] {
        lose(loss);
        dropTransfers();
    });
}

} // namespace mb
