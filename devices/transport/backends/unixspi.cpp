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

} // namespace

UnixSpiLink::UnixSpiLink(LinkAddress address, Clock &clock)
    : SpiLink(std::move(address), clock)
    , m_failed(clock)
{
}

UnixSpiLink::~UnixSpiLink()
{
    close();
}

Result<void> UnixSpiLink::doOpen()
{
    auto connected = connectUnixSocket(address().path);
    if (!connected)
        return fail(connected.error());
    m_descriptor = *connected;
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
    m_failed.stop();
    m_readable.reset();
    m_writable.reset();
    if (m_descriptor >= 0) {
        flush(); // a stop that was asked for just now still leaves
        ::close(std::exchange(m_descriptor, -1));
    }
    m_out.clear();
    m_in.clear();
    m_pending.clear();
    dropTransfers();
}

void UnixSpiLink::ask(Pending pending, std::uint16_t length, const Bytes &bytes)
{
    std::array<std::uint8_t, 2> head{};
    writeU16le(head, 0, length);
    m_out.insert(m_out.end(), head.begin(), head.end());
    m_out.insert(m_out.end(), bytes.begin(), bytes.end());
    m_pending.push_back(pending);
    flush();
}

void UnixSpiLink::doTransfer(const Bytes &mosi)
{
    ask({Ask::Transfer, mosi.size()}, static_cast<std::uint16_t>(mosi.size()), mosi);
}

void UnixSpiLink::doSampleReady()
{
    if (m_pending.empty()) // any answer tells the level
        ask({Ask::Level, 0}, 0, {});
}

Result<void> UnixSpiLink::doPulseReset()
{
    ask({Ask::Level, 0}, resetPulse, {});
    return {};
}

void UnixSpiLink::endOfSimulator()
{
    end("the simulator at " + address().path + " closed the connection; start it again");
}

void UnixSpiLink::flush()
{
    while (!m_out.empty() && m_descriptor >= 0) {
        const auto sent = ::send(m_descriptor, m_out.data(), m_out.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
        if (sent <= 0) {
            if (sent < 0 && errno != EAGAIN && errno != EINTR)
                endOfSimulator(); // broken pipe: it is gone, whichever of its two ends tells first
            break;
        }
        m_out.erase(m_out.begin(), m_out.begin() + sent);
    }
    if (m_writable)
        m_writable->setEnabled(!m_out.empty());
}

void UnixSpiLink::receive()
{
    std::array<std::uint8_t, 4096> chunk{};
    const auto got = ::recv(m_descriptor, chunk.data(), chunk.size(), MSG_DONTWAIT);
    if (got < 0 && (errno == EAGAIN || errno == EINTR))
        return;
    if (got <= 0) {
        endOfSimulator();
        return;
    }
    m_in.insert(m_in.end(), chunk.begin(), chunk.begin() + got);
    takeAnswers();
}

void UnixSpiLink::takeAnswers()
{
    while (!m_pending.empty() && m_in.size() > m_pending.front().size) {
        const Pending done = m_pending.front();
        m_pending.pop_front();
        const auto level = m_in.begin() + static_cast<std::ptrdiff_t>(done.size);
        Bytes miso(m_in.begin(), level);
        const bool ready = *level != 0;
        m_in.erase(m_in.begin(), level + 1);
        setReady(ready);
        if (done.kind == Ask::Transfer)
            finishTransfer(std::move(miso)); // may close this link
    }
    if (m_pending.empty() && !m_in.empty())
        end("the simulator at " + address().path + " sent bytes that nobody asked for");
}

/// From the clock: whoever asked is in the middle of it.
void UnixSpiLink::end(std::string reason)
{
    if (m_readable)
        m_readable->setEnabled(false);
    m_failed.startIn(Duration::zero(), [this, reason = std::move(reason)] {
        lose(reason);
        dropTransfers();
    });
}

} // namespace mb
