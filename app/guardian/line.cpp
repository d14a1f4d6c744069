// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/guardian/line.h"

#include "place/place.h"

#include <cstring>
#include <utility>

#include <asm/termbits.h>
#include <fcntl.h>
#include <linux/can.h>
#include <linux/can/raw.h>
#include <linux/spi/spidev.h>
#include <net/if.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace mb::guardian {
namespace {

int openCan(const std::string &name)
{
    const unsigned index = ::if_nametoindex(name.c_str());
    const int made = index == 0 ? -1 : ::socket(PF_CAN, SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, CAN_RAW);
    if (made < 0)
        return -1;
    ::setsockopt(made, SOL_CAN_RAW, CAN_RAW_FILTER, nullptr, 0); // nothing is to be received
    sockaddr_can address{};
    address.can_family = AF_CAN;
    address.can_ifindex = static_cast<int>(index);
    if (::bind(made, reinterpret_cast<const sockaddr *>(&address), sizeof address) == 0)
        return made;
    ::close(made);
    return -1;
}

/// Hears the bus of this socket from now on; −1 where it is none of CAN.
int openEar(int descriptor)
{
    sockaddr_can address{};
    socklen_t size = sizeof address;
    if (::getsockname(descriptor, reinterpret_cast<sockaddr *>(&address), &size) != 0 || address.can_family != AF_CAN)
        return -1;
    const int made = ::socket(PF_CAN, SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, CAN_RAW);
    if (made < 0 || ::bind(made, reinterpret_cast<const sockaddr *>(&address), sizeof address) == 0)
        return made;
    ::close(made);
    return -1;
}

int openSocket(const std::string &path)
{
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const int made
        = path.size() < sizeof address.sun_path ? ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0) : -1;
    if (made < 0)
        return -1;
    std::memcpy(address.sun_path, path.data(), path.size());
    if (::connect(made, reinterpret_cast<const sockaddr *>(&address), sizeof address) == 0)
        return made;
    ::close(made);
    return -1;
}

PlaceKind kindOf(const Whereabouts &where)
{
    return where.form == PortForm::Packet ? PlaceKind::CanInterface
        : where.form == PortForm::Spi     ? PlaceKind::SpiDevice
                                          : PlaceKind::SerialPort;
}

} // namespace

struct Line::Setup {
    [[nodiscard]] static Setup of(int descriptor);
    /// False when the device does not take it.
    [[nodiscard]] bool applyTo(int descriptor) const;
    [[nodiscard]] bool isLike(const Setup &other) const;

    bool isTerminal = false;
    termios2 terminal{};
    bool isSpi = false;
    std::uint32_t spiMode = 0;
    std::uint32_t spiSpeed = 0;
    std::uint8_t spiBits = 8;
};

Line::Setup Line::Setup::of(int descriptor)
{
    Setup now;
    now.isTerminal = ::ioctl(descriptor, TCGETS2, &now.terminal) == 0;
    now.isSpi = ::ioctl(descriptor, SPI_IOC_RD_MODE32, &now.spiMode) == 0
        && ::ioctl(descriptor, SPI_IOC_RD_MAX_SPEED_HZ, &now.spiSpeed) == 0
        && ::ioctl(descriptor, SPI_IOC_RD_BITS_PER_WORD, &now.spiBits) == 0;
    return now;
}

bool Line::Setup::applyTo(int descriptor) const
{
    return (!isTerminal || ::ioctl(descriptor, TCSETS2, &terminal) == 0)
        && (!isSpi
            || (::ioctl(descriptor, SPI_IOC_WR_MODE32, &spiMode) == 0
                && ::ioctl(descriptor, SPI_IOC_WR_MAX_SPEED_HZ, &spiSpeed) == 0
                && ::ioctl(descriptor, SPI_IOC_WR_BITS_PER_WORD, &spiBits) == 0));
}

bool Line::Setup::isLike(const Setup &other) const
{
    const termios2 &a = terminal;
    const termios2 &b = other.terminal;
    return isTerminal == other.isTerminal && isSpi == other.isSpi
        && (!isTerminal
            || (a.c_iflag == b.c_iflag && a.c_oflag == b.c_oflag && a.c_cflag == b.c_cflag && a.c_lflag == b.c_lflag
                && a.c_ispeed == b.c_ispeed && a.c_ospeed == b.c_ospeed))
        && (!isSpi || (spiMode == other.spiMode && spiSpeed == other.spiSpeed && spiBits == other.spiBits));
}

Line::Line(Whereabouts where, int descriptor)
    : m_where(std::move(where))
    , m_descriptor(descriptor)
    , m_port(makePort(m_where.form, descriptor))
    , m_setup(std::make_unique<Setup>())
{
}

Line::~Line()
{
    closeEar();
}

void Line::keepSetup()
{
    const Setup now = Setup::of(m_descriptor);
    if (now.isTerminal || now.isSpi)
        *m_setup = now;
}

void Line::restoreSetup()
{
    if (m_port && !m_setup->isLike(Setup::of(m_descriptor)))
        (void)m_setup->applyTo(m_descriptor);
}

int Line::openNow() const
{
    const bool isPlace = m_where.identity.starts_with('/');
    const std::string name = isPlace ? nameAt(kindOf(m_where), m_where.identity) : m_where.name;
    if (name.empty())
        return -1;
    if (m_where.form == PortForm::Packet)
        return openCan(name);
    if (m_where.identity.starts_with("unix:"))
        return openSocket(name);
    return ::open(name.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
}

bool Line::reopen()
{
    if (m_port)
        return true;
    const int opened = openNow();
    if (opened < 0)
        return false;
    if (!m_setup->applyTo(opened)) {
        ::close(opened);
        return false;
    }
    m_descriptor = opened;
    m_port = makePort(m_where.form, opened);
    return true;
}

void Line::share() const
{
    (void)::ioctl(m_descriptor, TIOCNXCL);
}

void Line::closeEar()
{
    if (m_ear >= 0)
        ::close(std::exchange(m_ear, -1));
}

void Line::close()
{
    closeEar();
    ::close(m_descriptor);
    m_descriptor = -1;
    m_port.reset();
}

Port::Sent Line::send(std::span<const std::uint8_t> bytes)
{
    const Sent sent = m_port ? m_port->send(bytes) : Sent::Lost;
    if (sent == Sent::Lost && m_port)
        close();
    return sent;
}

void Line::prepare()
{
    closeEar();
    if (m_where.form == PortForm::Packet)
        m_ear = openEar(m_descriptor);
    if (m_ear < 0)
        (void)read();
}

void Line::forget()
{
    if (m_port)
        m_port->forget();
}

std::size_t Line::messageSize() const
{
    return m_where.form == PortForm::Packet ? sizeof(can_frame) : 1;
}

Bytes Line::read()
{
    if (m_ear >= 0)
        return makePort(m_where.form, m_ear)->read();
    return m_port ? m_port->read() : Bytes();
}

} // namespace mb::guardian
