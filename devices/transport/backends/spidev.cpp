// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/backends/spidev.h"

#include "wire/number.h"

#include <QSocketNotifier>

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <linux/spi/spidev.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace mb {
namespace {

constexpr int usualSpeed = 500'000;
constexpr int slowest = 10'000;
constexpr int quickest = 10'000'000;
constexpr Duration resetPulse = std::chrono::milliseconds(1);

Error causeOf(int error, const std::string &path)
{
    switch (error) {
    case ENOENT:
        return {Fault::LinkLost, say("there is no %1", path),
            say("enable SPI in the device tree (on a Raspberry Pi: dtparam=spi=on) and restart"), {},
            Ailment::NotThere};
    case EACCES:
        return {Fault::LinkLost, say("no permission to use %1", path), say("become a member of its group"),
            "sudo usermod -aG spi $USER", Ailment::NoPermission};
    case EBUSY: return {Fault::LinkLost, say("%1 is used by another program", path), {}, {}, Ailment::Busy};
    case EINVAL:
        return {Fault::LinkLost, say("%1 cannot do SPI mode 1 at this speed", path), say("try a lower speed=")};
    default: return {Fault::LinkLost, say("%1: %2", path, std::strerror(error))};
    }
}

tl::unexpected<Error> lost(int error, const std::string &path)
{
    return fail(causeOf(error, path));
}

} // namespace

Result<std::unique_ptr<SpidevLink>> SpidevLink::make(const LinkAddress &address, Clock &clock)
{
    int hertz = usualSpeed;
    for (const auto &[key, value] : address.options) {
        if (key == "ready" || key == "reset")
            continue;
        if (key != "speed")
            return fail(Fault::OutOfRange, say("spidev links have no option '%1'", key),
                say("speed, ready and reset are known"));
        const bool whole = takeNumber(value, hertz);
        if (!whole || hertz < slowest || hertz > quickest)
            return fail(Fault::OutOfRange, say("speed is 10000 to 10000000 Hz, not '%1'", value));
    }
    return std::unique_ptr<SpidevLink>(new SpidevLink(address, clock, hertz));
}

SpidevLink::SpidevLink(LinkAddress address, Clock &clock, int hertz)
    : SpiLink(std::move(address), clock, hertz)
    , m_released(clock)
{
}

SpidevLink::~SpidevLink()
{
    close();
}

Result<void> SpidevLink::doOpen()
{
    MB_TRY_VOID(openDevice());
    if (auto opened = openLines(); !opened) {
        doClose();
        return opened;
    }
    startWorker();
    return {};
}

Result<void> SpidevLink::openDevice()
{
    const std::string &path = address().path;
    m_descriptor = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
    if (m_descriptor < 0)
        return lost(errno, path);
    std::uint8_t mode = SPI_MODE_1;
    std::uint8_t bits = 8;
    auto speed = static_cast<std::uint32_t>(clockRate());
    const bool good = ::ioctl(m_descriptor, SPI_IOC_WR_MODE, &mode) == 0
        && ::ioctl(m_descriptor, SPI_IOC_WR_BITS_PER_WORD, &bits) == 0
        && ::ioctl(m_descriptor, SPI_IOC_WR_MAX_SPEED_HZ, &speed) == 0;
    if (good)
        return {};
    const int error = errno == ENOTTY ? EINVAL : errno;
    ::close(std::exchange(m_descriptor, -1));
    return lost(error, path);
}

Result<void> SpidevLink::openLines()
{
    setReady(std::nullopt);
    if (const auto line = address().option("ready")) {
        if (auto opened = m_readyLine.openInput(*line, [this](bool level) { setReady(level); }); !opened)
            return opened;
        setReady(m_readyLine.level());
    }
    if (const auto line = address().option("reset"))
        return m_resetLine.openOpenDrain(*line);
    return {};
}

void SpidevLink::startWorker()
{
    m_done = std::make_unique<Mailbox>();
    m_arrivals = std::make_unique<QSocketNotifier>(m_done->descriptor(), QSocketNotifier::Read);
    QObject::connect(m_arrivals.get(), &QSocketNotifier::activated, m_arrivals.get(), [this] { m_done->drain(); });
    m_ending = false;
    m_worker = std::thread([this] { work(); });
}

void SpidevLink::doClose()
{
    m_released.stop();
    if (m_worker.joinable()) {
        {
            const std::lock_guard lock(m_mutex);
            m_ending = true;
        }
        m_wake.notify_one();
        m_worker.join(); // after the transfer that was handed over, a stop perhaps
        m_done->close();
    }
    m_arrivals.reset();
    m_readyLine.close();
    m_resetLine.close();
    if (m_descriptor >= 0)
        ::close(std::exchange(m_descriptor, -1));
    dropTransfers();
}

void SpidevLink::doTransfer(const Bytes &mosi)
{
    {
        const std::lock_guard lock(m_mutex);
        m_next = mosi;
    }
    m_wake.notify_one();
}

void SpidevLink::work()
{
    std::unique_lock lock(m_mutex);
    while (true) {
        m_wake.wait(lock, [this] { return m_next || m_ending; });
        if (!m_next)
            return;
        const Bytes mosi = std::move(*m_next);
        m_next.reset();
        lock.unlock();
        Bytes miso(mosi.size());
        spi_ioc_transfer transfer{};
        transfer.tx_buf = reinterpret_cast<std::uintptr_t>(mosi.data());
        transfer.rx_buf = reinterpret_cast<std::uintptr_t>(miso.data());
        transfer.len = static_cast<std::uint32_t>(mosi.size());
        const int error = ::ioctl(m_descriptor, SPI_IOC_MESSAGE(1), &transfer) < 0 ? errno : 0;
        m_done->post([this, miso = std::move(miso), error] { transferred(miso, error); });
        lock.lock();
    }
}

void SpidevLink::transferred(Bytes miso, int error)
{
    if (m_readyLine.isOpen())
        setReady(m_readyLine.level());
    if (error == 0) {
        finishTransfer(std::move(miso));
        return;
    }
    lose(causeOf(error, address().path));
    dropTransfers();
}

Result<void> SpidevLink::doPulseReset()
{
    if (!m_resetLine.isOpen())
        return fail(Fault::Unsupported, say("no reset line is wired"), say("add reset=CHIP:LINE to the address"));
    m_resetLine.set(false);
    m_released.startIn(resetPulse, [this] { m_resetLine.set(true); });
    return {};
}

} // namespace mb
