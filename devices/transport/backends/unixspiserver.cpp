// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/backends/unixspiserver.h"

#include "transport/backends/unixsocket.h"
#include "wire/bytes.h"

#include <QSocketNotifier>

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace mb {
namespace {

constexpr std::size_t headSize = 2;
constexpr std::uint16_t resetPulse = 65535;
constexpr Duration byteTime = std::chrono::microseconds(16); ///< 500 kHz

bool hasGone(int socket)
{
    pollfd seen{socket, POLLRDHUP, 0};
    return ::poll(&seen, 1, 0) > 0;
}

} // namespace

UnixSpiServer::UnixSpiServer(LinkAddress address, Clock &clock)
    : SpiSlaveLink(std::move(address))
    , m_clock(clock)
    , m_paced(this->address().option("pace") == "1")
    , m_wire(clock)
    , m_gone(clock)
{
}

Result<std::unique_ptr<UnixSpiServer>> UnixSpiServer::create(const LinkAddress &address, Clock &clock)
{
    for (const auto &[key, value] : address.options) {
        if (key != "pace")
            return fail(
                Fault::OutOfRange, say("a simulated board's socket has no option '%1'", key), say("it has pace"));
        if (value != "0" && value != "1")
            return fail(Fault::OutOfRange, say("pace=%1 is no choice", value), say("legal are 0 and 1"));
    }
    return std::make_unique<UnixSpiServer>(address, clock);
}

UnixSpiServer::~UnixSpiServer()
{
    close();
}

Result<void> UnixSpiServer::doOpen()
{
    MB_TRY(auto listening, listenOnUnixSocket(address().path));
    m_listening = listening;
    m_calls = std::make_unique<QSocketNotifier>(m_listening, QSocketNotifier::Read);
    QObject::connect(m_calls.get(), &QSocketNotifier::activated, m_calls.get(), [this] { accept(); });
    return {};
}

void UnixSpiServer::doClose()
{
    m_gone.stop();
    hangUp();
    m_calls.reset();
    if (m_listening >= 0) {
        ::close(std::exchange(m_listening, -1));
        ::unlink(address().path.c_str());
    }
}

void UnixSpiServer::accept()
{
    if (m_client >= 0 && hasGone(m_client))
        return; // it is read to its end first
    const int caller = ::accept4(m_listening, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
    if (caller < 0)
        return;
    if (m_client >= 0) { // hung up on before any answer, which tells it that the board is busy
        ::close(caller);
        return;
    }
    m_client = caller;
    m_readable = std::make_unique<QSocketNotifier>(m_client, QSocketNotifier::Read);
    QObject::connect(m_readable.get(), &QSocketNotifier::activated, m_readable.get(), [this] { receive(); });
}

void UnixSpiServer::hangUp()
{
    m_wire.stop();
    m_readable.reset();
    m_in.clear();
    if (m_client >= 0)
        ::close(std::exchange(m_client, -1));
}

void UnixSpiServer::receive()
{
    if (receiveFrom(m_client, m_in)) {
        serve();
        return;
    }
    m_readable->setEnabled(false);
    m_gone.startIn(Duration::zero(), [this] { hangUp(); });
}

void UnixSpiServer::serve()
{
    while (!m_wire.isActive() && m_in.size() >= headSize) {
        const std::uint16_t length = readU16le(m_in, 0);
        const std::size_t size = length == resetPulse ? 0 : length;
        if (m_in.size() < headSize + size)
            return;
        if (length == resetPulse && slave())
            slave()->reset();
        const Duration wire = m_paced ? byteTime * static_cast<std::int64_t>(size) : Duration::zero();
        if (wire == Duration::zero()) {
            send(answer(size));
            continue;
        }
        m_wire.startIn(wire, [this, size] {
            send(answer(size));
            serve();
        });
    }
}

UnixSpiServer::Bytes UnixSpiServer::answer(std::size_t length)
{
    const Bytes mosi(m_in.begin() + headSize, m_in.begin() + static_cast<std::ptrdiff_t>(headSize + length));
    m_in.erase(m_in.begin(), m_in.begin() + static_cast<std::ptrdiff_t>(headSize + length));
    Bytes miso(length);
    if (slave() && length > 0) {
        slave()->transfer(mosi, miso);
        passed(Traffic{m_clock.now(), Direction::Received, nullptr, mosi});
        passed(Traffic{m_clock.now(), Direction::Sent, nullptr, miso});
    }
    miso.push_back(slave() && slave()->isReady() ? 1 : 0);
    return miso;
}

void UnixSpiServer::send(const Bytes &bytes)
{
    // A client that asks without reading its answers is cut off rather than waited for.
    if (::send(m_client, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT) != static_cast<ssize_t>(bytes.size()))
        m_gone.startIn(Duration::zero(), [this] { hangUp(); });
}

} // namespace mb
