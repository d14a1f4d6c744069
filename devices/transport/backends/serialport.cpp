// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/backends/serialport.h"

#include "async/descriptor.h"
#include "transport/backends/serialports.h"
#include "wire/number.h"

#include <QSerialPort>
#include <QThread>
#include <QVariant>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include <poll.h>
#include <unistd.h>

namespace mb {
namespace {

constexpr Duration echoDelay = std::chrono::milliseconds(100); ///< an adapter hands out its bytes late
constexpr Duration lookPeriod = std::chrono::seconds(1);
constexpr int mostEmptyReads = 100; ///< in a row, of a port that is there
constexpr Duration heldUpLook = std::chrono::milliseconds(10);
constexpr Duration heldUpLimit = std::chrono::seconds(1); ///< of a driver that takes nothing

/// As QSerialPort reads names: without a slash it is one of /dev. Links are followed, so that a port has one lock.
std::string deviceFile(const std::string &path)
{
    const std::filesystem::path named = path.find('/') == std::string::npos ? "/dev/" + path : path;
    std::error_code failed;
    const auto real = std::filesystem::canonical(named, failed);
    return failed ? named.string() : real.string();
}

bool isPseudoTerminal(const std::string &path)
{
    return path.starts_with("/dev/pts/");
}

/// The rate is set, or the nearest that the port can do is told. Any thread.
Result<void> applyRate(int descriptor, const std::string &name, int baudrate)
{
    if (!setDriverBaudrate(descriptor, baudrate))
        return fail(Fault::OutOfRange,
            say("%1 cannot do %2 bit/s: %3", name, baudrate, std::generic_category().message(errno)));
    const auto real = driverBaudrate(descriptor);
    if (real && std::abs(*real - baudrate) > baudrate / 50)
        return fail(
            Fault::OutOfRange, say("%1 cannot do %2 bit/s", name, baudrate), say("the nearest it can is %1", *real));
    return {};
}

Result<void> applyFormat(QSerialPort &port, const std::string &name, const std::string &format)
{
    const auto parity = format[1] == 'E' ? QSerialPort::EvenParity
        : format[1] == 'O'               ? QSerialPort::OddParity
                                         : QSerialPort::NoParity;
    if (format == "8N1"
        || (port.setParity(parity) && port.setStopBits(format[2] == '2' ? QSerialPort::TwoStop : QSerialPort::OneStop)))
        return {};
    return fail(Fault::OutOfRange, say("%1 cannot do %2: %3", name, format, port.errorString().toStdString()));
}

struct RateOrder {
    int descriptor = -1;
    std::string name;
    int wanted = 0;
    int before = 0;
};

Result<void> applyRateOrKeep(const RateOrder &order)
{
    auto applied = applyRate(order.descriptor, order.name, order.wanted);
    if (!applied)
        (void)setDriverBaudrate(order.descriptor, order.before);
    return applied;
}

Error silentDriver(const std::string &name)
{
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(Link::openLimit).count();
    return {Fault::LinkLost, say("%1 does not open: its driver has not answered for %2 s", name, seconds),
        say("unplug it and plug it in again")};
}

/// A guardian shares the terminal, and may read the answer to its own question between the notice and our read: that is reported
/// as an error, and none.
bool isGone(int descriptor)
{
    pollfd asked{descriptor, POLLIN, 0};
    return ::poll(&asked, 1, 0) < 0 || (asked.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0;
}

} // namespace

/// All that opening needs of the link, which lives in another thread.
struct SerialPortLink::Order {
    std::string name;
    std::string path;
    int baudrate = 0;
    Options options;
    QThread *home = nullptr; ///< the thread of the link
};

struct SerialPortLink::Opened {
    std::string path; ///< links followed
    Message remark;
    std::unique_ptr<QSerialPort> port;
};

SerialPortLink::SerialPortLink(LinkAddress address, Clock &clock, Options options)
    : SerialLink(std::move(address), clock)
    , m_options(options)
    , m_timer(clock)
    , m_failed(clock)
{
}

SerialPortLink::~SerialPortLink()
{
    SerialPortLink::doClose();
}

SerialPortLink::Order SerialPortLink::order() const
{
    return {name(), address().path, baudrate(), m_options, QThread::currentThread()};
}

/// Any thread; may block for as long as a driver does.
Result<SerialPortLink::Opened> SerialPortLink::openPort(const Order &order)
{
    Opened made;
    made.path = deviceFile(order.path);
    if (const auto cause = whyUnusable(order.path, made.path))
        return fail(errorOf(*cause));
    made.port = std::make_unique<QSerialPort>();
    QSerialPort &port = *made.port;
    port.setProperty("settingsRestoredOnClose", false); // a guardian shares them, and what was sent last leaves after
    port.setPortName(QString::fromStdString(made.path));
    port.setBaudRate(order.baudrate);
    if (!port.open(QIODevice::ReadWrite)) {
        if (port.error() == QSerialPort::PermissionError)
            return fail(Error{Fault::LinkLost, say("%1 is in use by another program", order.name),
                say("close that one first ('fuser %1' names it)", made.path), {}, Ailment::Busy});
        return fail(Fault::LinkLost, say("%1 cannot be opened: %2", order.name, port.errorString().toStdString()));
    }
    auto dressed = applyRate(port.handle(), order.name, order.baudrate);
    if (dressed)
        dressed = applyFormat(port, order.name, order.options.format);
    if (!dressed)
        return fail(Fault::LinkLost, dressed.error().detail, dressed.error().remedy);
    if (order.options.rs485 && !setDriverRs485(port.handle(), true))
        made.remark = say("the driver of %1 cannot switch the direction of an RS-485 line, so the adapter has to do it "
                          "by itself; if nothing answers, use one that does",
            order.name);
    askLowLatency(port.handle());
    port.clear(QSerialPort::Input);
    port.moveToThread(order.home);
    return made;
}

void SerialPortLink::take(Opened opened)
{
    m_path = std::move(opened.path);
    m_port = std::move(opened.port);
    setRemark(std::move(opened.remark));
    m_sentAt = m_heardAt = m_lookedAt = clock().now();
    m_heldUpSince.reset();
    m_driverErrors = driverErrors(m_port->handle());
    watch();
}

Result<void> SerialPortLink::doOpen()
{
    MB_TRY(auto opened, openPort(order()));
    take(std::move(opened));
    return {};
}

Task<void> SerialPortLink::doOpenSoon(Background &background)
{
    const Order wanted = order();
    auto opening = inBackground<Opened>(
        background, clock(), wanted.path, openLimit, [wanted] { return openPort(wanted); }, WhenLate::Drop);
    Result<Opened> opened = co_await std::move(opening).attempt();
    if (!opened && opened.error().fault == Fault::Timeout)
        co_return fail(silentDriver(wanted.name));
    if (!opened)
        co_return fail(opened.error());
    take(std::move(*opened));
    co_return {};
}

Result<void> SerialPortLink::doSetBaudrate(int wanted)
{
    return applyRateOrKeep({m_port->handle(), name(), wanted, baudrate()});
}

Task<void> SerialPortLink::doSetBaudrateSoon(Background &background, int wanted)
{
    const auto own = std::make_shared<const Descriptor>(::dup(m_port->handle()));
    const RateOrder order{own->get(), name(), wanted, baudrate()};
    auto setting = inBackground<bool>(
        background, clock(), m_path, openLimit,
        [own, order]() -> Result<bool> {
            const auto applied = applyRateOrKeep(order);
            return applied ? Result<bool>(true) : fail(applied.error());
        },
        WhenLate::Drop);
    const Result<bool> set = co_await std::move(setting).attempt();
    if (!set && set.error().fault == Fault::Timeout) {
        end(silentDriver(name()));
        co_return fail(notOpen());
    }
    if (!set)
        co_return fail(set.error());
    co_return {};
}

void SerialPortLink::watch()
{
    QSerialPort *port = m_port.get();
    QObject::connect(port, &QSerialPort::readyRead, port, [this] { receive(); });
    QObject::connect(port, &QSerialPort::errorOccurred, port, [this](QSerialPort::SerialPortError error) {
        if (error == QSerialPort::NoError || error == QSerialPort::TimeoutError)
            return;
        if (!isGone(m_port->handle()) && ++m_emptyReads < mostEmptyReads) {
            m_port->clearError();
            (void)m_port->peek(1); // listens again
            return;
        }
        if (m_isWriting)
            m_failed.startIn(Duration::zero(), [this, loss = lossOfPort()] { end(loss); });
        else
            end(lossOfPort());
    });
}

Error SerialPortLink::lossOfPort() const
{
    if (isPseudoTerminal(m_path))
        return {Fault::LinkLost, say("the other end of %1 hung up", name()), say("start it again"), {}, Ailment::Gone};
    if (::access(m_path.c_str(), F_OK) != 0)
        return {Fault::LinkLost, say("%1 was unplugged", name()), say("plug it in again"), {}, Ailment::Gone};
    return {Fault::LinkLost, say("%1 failed (%2)", name(), m_port->errorString().toStdString()),
        say("unplug it and plug it in again")};
}

void SerialPortLink::doClose()
{
    if (auto port = std::exchange(m_port, nullptr)) {
        port->disconnect();
        sendUrgent(*port);
        closeBehind(*port);
        port.release()->deleteLater(); // this may be one of its own signals
    }
    m_timer.stop();
    m_failed.stop();
    m_echo.clear();
}

/// A stop does not wait any longer for the piece before it: the driver keeps their order.
void SerialPortLink::sendUrgent(QSerialPort &port)
{
    m_queue.keepUrgent();
    if (!m_queue.isEmpty())
        dropHeldUp(port);
    while (!m_queue.isEmpty()) {
        const auto piece = m_queue.pop();
        port.write(reinterpret_cast<const char *>(piece.data()), static_cast<qint64>(piece.size()));
    }
    port.flush();
}

/// The driver may wait for what it still has to send: the last descriptor of the port is closed in the background, where there is one.
void SerialPortLink::closeBehind(QSerialPort &port)
{
    const auto own = settings().background ? std::make_shared<const Descriptor>(::dup(port.handle())) : nullptr;
    port.close();
    if (own)
        settings().background->run(
            m_path, [last = own] { (void)last; }, [] {});
}

Outlet SerialPortLink::doOutlet() const
{
    return m_port ? Outlet{Outlet::Form::Stream, m_port->handle()} : Outlet{};
}

void SerialPortLink::end(Error loss)
{
    doClose(); // at once, so that the port gets the same name when it comes back
    lose(std::move(loss));
}

Result<void> SerialPortLink::doSend(std::span<const std::uint8_t> bytes, Priority priority)
{
    countLost(m_queue.push(bytes, priority));
    if (priority == Priority::Urgent)
        dropHeldUp(*m_port);
    pump();
    return {};
}

/// No stop waits behind what the driver does not take.
void SerialPortLink::dropHeldUp(QSerialPort &port)
{
    const std::int64_t waiting = port.bytesToWrite();
    if (waiting == 0)
        return;
    port.clear(QSerialPort::Output);
    countLost(static_cast<std::uint64_t>(waiting));
    m_sentAt = clock().now();
}

/// What is handed over meanwhile would only pile up. A port that takes nothing for a second is no port.
bool SerialPortLink::isHeldUp(Instant now)
{
    const std::int64_t waiting = m_port->bytesToWrite();
    if (waiting == 0) {
        m_heldUpSince.reset();
        return false;
    }
    if (!m_heldUpSince || waiting != m_heldUp)
        m_heldUpSince = now;
    m_heldUp = waiting;
    if (now - *m_heldUpSince < heldUpLimit)
        m_timer.startIn(heldUpLook, [this] { pump(); });
    else
        m_failed.startIn(Duration::zero(), [this] {
            end({Fault::LinkLost, say("%1 takes no bytes any more", name()), say("unplug it and plug it in again"), {},
                Ailment::Failed});
        });
    return true;
}

/// One piece is on the wire at a time: the kernel would take seconds of them, and a stop had to wait behind all.
void SerialPortLink::pump()
{
    if (m_queue.isEmpty() || !m_port)
        return;
    const Instant now = clock().now();
    const Instant start = isHalfDuplex() ? std::max(m_sentAt, m_heardAt + byteTime()) : m_sentAt;
    if (now < start) {
        m_timer.start(start, [this] { pump(); });
        return;
    }
    if (isHeldUp(now))
        return;
    const auto piece = m_queue.pop();
    m_sentAt = now + byteTime() * static_cast<int>(piece.size());
    if (m_options.echo)
        m_echo.expect(piece, m_sentAt + echoDelay);
    if (!m_queue.isEmpty())
        m_timer.start(m_sentAt, [this] { pump(); });
    QSerialPort &port = *m_port;
    m_isWriting = true;
    port.write(reinterpret_cast<const char *>(piece.data()), static_cast<qint64>(piece.size()));
    port.flush(); // now, not when the event loop comes round
    m_isWriting = false;
}

std::size_t SerialPortLink::doBacklog() const
{
    const auto left = (m_sentAt - clock().now() + byteTime() - Duration(1)) / byteTime();
    return m_queue.size() + static_cast<std::size_t>(std::max<std::int64_t>(left, 0));
}

void SerialPortLink::receive()
{
    const QByteArray read = m_port->readAll();
    const Instant now = clock().now();
    std::span<const std::uint8_t> bytes(
        reinterpret_cast<const std::uint8_t *>(read.constData()), static_cast<std::size_t>(read.size()));
    std::vector<std::uint8_t> others;
    if (m_options.echo) {
        if (!m_echo.take(now, bytes, others))
            reportLineError();
        bytes = others;
    }
    m_emptyReads = 0;
    if (!bytes.empty()) {
        m_heardAt = now;
        deliver(now, bytes);
        endBatch();
    }
    if (now - m_lookedAt >= lookPeriod)
        lookAtDriver();
}

void SerialPortLink::lookAtDriver()
{
    if (!m_port)
        return;
    m_lookedAt = clock().now();
    const auto counted = driverErrors(m_port->handle());
    if (counted && m_driverErrors) {
        for (auto error = m_driverErrors->framing; error < counted->framing; ++error)
            reportLineError();
        if (counted->overrun > m_driverErrors->overrun)
            countLost(counted->overrun - m_driverErrors->overrun);
    }
    m_driverErrors = counted;
}

Result<std::unique_ptr<Link>> makeSerialPortLink(const LinkAddress &address, Clock &clock)
{
    SerialPortLink::Options options;
    for (const auto &[key, value] : address.options) {
        int number = 0;
        const bool whole = takeNumber(value, number);
        bool good = whole && (number == 0 || number == 1);
        std::string legal = "0, 1";
        if (key == "format") {
            legal = "8N1, 8E1, 8O1, 8N2";
            good = value == "8N1" || value == "8E1" || value == "8O1" || value == "8N2";
            options.format = value;
        } else if (key == "baud") {
            legal = std::to_string(SerialLink::slowest) + " … " + std::to_string(SerialLink::fastest);
            good = whole && number >= SerialLink::slowest && number <= SerialLink::fastest;
        } else if (key == "rs485")
            options.rs485 = number == 1;
        else if (key == "echo")
            options.echo = number == 1;
        else
            return fail(Fault::OutOfRange, say("unknown option '%1' of a serial link", key),
                say("baud, format, rs485 and echo are known"));
        if (!good)
            return fail(
                Fault::OutOfRange, say("link option %1=%2 is out of range", key, value), say("legal is %1", legal));
    }
    return std::make_unique<SerialPortLink>(address, clock, options);
}

} // namespace mb
