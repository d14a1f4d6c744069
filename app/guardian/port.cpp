// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/guardian/port.h"

#include <array>
#include <cerrno>

#include <linux/spi/spidev.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace mb::guardian {
namespace {

// Whether the descriptor blocks is the program's choice, and shared with it: it is asked before each call instead.
bool isReady(int descriptor, short events)
{
    pollfd asked{descriptor, events, 0};
    return ::poll(&asked, 1, 0) == 1 && (asked.revents & (events | POLLERR | POLLHUP)) != 0;
}

class FilePort final : public Port {
public:
    explicit FilePort(int descriptor)
        : m_descriptor(descriptor)
    {
    }
    Sent send(std::span<const std::uint8_t> bytes) override
    {
        while (m_written < bytes.size()) {
            if (!isReady(m_descriptor, POLLOUT))
                return Sent::Later;
            const auto rest = bytes.subspan(m_written);
            const ssize_t wrote = ::write(m_descriptor, rest.data(), rest.size());
            if (wrote < 0)
                return verdictOn(errno);
            m_written += static_cast<std::size_t>(wrote);
        }
        m_written = 0;
        return Sent::All;
    }
    Bytes read() override
    {
        Bytes all;
        std::array<std::uint8_t, 1024> part{};
        for (int i = 0; i < mostReads && isReady(m_descriptor, POLLIN); ++i) {
            const ssize_t got = ::read(m_descriptor, part.data(), part.size());
            if (got <= 0)
                break;
            all.insert(all.end(), part.begin(), part.begin() + got);
        }
        return all;
    }
    void forget() override { m_written = 0; }

private:
    static constexpr int mostReads = 64; // a flood does not keep us from sending
    int m_descriptor;
    std::size_t m_written = 0;
};

/// Mode, speed and word length are as the program has set them: the device file keeps them.
class SpiPort final : public Port {
public:
    explicit SpiPort(int descriptor)
        : m_descriptor(descriptor)
    {
    }
    Sent send(std::span<const std::uint8_t> bytes) override
    {
        spi_ioc_transfer transfer{};
        transfer.tx_buf = reinterpret_cast<std::uintptr_t>(bytes.data());
        transfer.len = static_cast<std::uint32_t>(bytes.size());
        return ::ioctl(m_descriptor, SPI_IOC_MESSAGE(1), &transfer) < 0 ? verdictOn(errno) : Sent::All;
    }
    Bytes read() override { return {}; }

private:
    int m_descriptor;
};

} // namespace

Port::Sent verdictOn(int cause)
{
    switch (cause) {
    case EIO:
    case ENODEV:
    case ENXIO:
    case ESHUTDOWN: // spidev, of what was unplugged
    case EPIPE:
    case ECONNRESET:
    case ENOTCONN:
    case EBADF:
    case EINVAL: return Port::Sent::Lost;
    default: return Port::Sent::Later; // full (EAGAIN, ENOBUFS), off (ENETDOWN), interrupted
    }
}

const char *toString(PortForm form)
{
    switch (form) {
    case PortForm::Packet: return "packet";
    case PortForm::Stream: return "stream";
    case PortForm::Spi: return "spi";
    }
    return "";
}

std::optional<PortForm> portFormFrom(std::string_view word)
{
    for (const PortForm form : {PortForm::Packet, PortForm::Stream, PortForm::Spi}) {
        if (word == toString(form))
            return form;
    }
    return std::nullopt;
}

std::unique_ptr<Port> makePort(PortForm form, int descriptor)
{
    if (form == PortForm::Spi)
        return std::make_unique<SpiPort>(descriptor);
    return std::make_unique<FilePort>(descriptor);
}

} // namespace mb::guardian
