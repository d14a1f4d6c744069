// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/backends/ptyline.h"

#include "transport/backends/serialdriver.h"
#include "wire/number.h"

#include <QSocketNotifier>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <utility>

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <termios.h>
#include <unistd.h>

namespace mb {
namespace {

namespace fs = std::filesystem;

constexpr Duration restTime = std::chrono::milliseconds(20);

/// The number of a terminal is given to others again: a link to one that is younger leads nowhere that its maker meant.
bool isStale(const std::string &link)
{
    struct stat made { };
    struct stat terminal { };
    if (::stat(link.c_str(), &terminal) != 0 || ::lstat(link.c_str(), &made) != 0)
        return true;
    return std::pair(terminal.st_ctim.tv_sec, terminal.st_ctim.tv_nsec)
        > std::pair(made.st_mtim.tv_sec, made.st_mtim.tv_nsec);
}

std::string lastError()
{
    return std::strerror(errno);
}

} // namespace

Result<std::unique_ptr<PtyLine>> PtyLine::create(const LinkAddress &address, Clock &clock)
{
    for (const auto &[key, value] : address.options) {
        int rate = 0;
        const bool whole = takeNumber(value, rate);
        if (key != "baud" || !whole || rate < SerialLink::slowest || rate > SerialLink::fastest)
            return fail(
                Fault::OutOfRange, say("pty links have the option baud=BITS_PER_SECOND, not '%1=%2'", key, value));
    }
    return std::unique_ptr<PtyLine>(new PtyLine(address, clock));
}

PtyLine::PtyLine(LinkAddress address, Clock &clock)
    : m_address(std::move(address))
    , m_line(clock, VirtualSerialLine::Wiring::FullDuplex, 1)
    , m_bridge(m_address, m_line)
    , m_received(m_bridge.received().add([this](std::span<const std::uint8_t> bytes) { writeTerminal(bytes); }))
    , m_rest(clock)
{
    if (!m_bridge.fixedBaudrate())
        m_line.setAnySpeed(m_bridge.baudrate());
}

PtyLine::~PtyLine()
{
    std::error_code ignored;
    if (m_linked && fs::read_symlink(m_address.path, ignored) == m_terminal)
        fs::remove(m_address.path, ignored);
    m_notifier.reset();
    if (m_master >= 0)
        ::close(m_master);
    if (m_claim >= 0)
        ::close(m_claim);
}

/// An abstract socket ends with its process, however that ends. The number of a terminal is given to others again, so the
/// link alone does not tell whether it is still served.
Result<void> PtyLine::claimPath()
{
    std::error_code failed;
    const fs::path folder = fs::canonical(fs::absolute(m_address.path).parent_path(), failed);
    const std::string place = (folder / fs::path(m_address.path).filename()).string();
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const std::string name = "motorbench-pty-" + std::to_string(std::hash<std::string>()(place));
    std::copy(name.begin(), name.end(), address.sun_path + 1);
    const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
    m_claim = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    void *const generic = &address;
    if (m_claim >= 0 && ::bind(m_claim, static_cast<sockaddr *>(generic), size) != 0 && errno == EADDRINUSE)
        return fail(Fault::LinkLost, say("%1 is served by another simulator", m_address.path),
            say("end that one first, or choose another path"));
    return {};
}

Result<void> PtyLine::open()
{
    MB_TRY_VOID(claimPath());
    MB_TRY_VOID(openTerminal());
    MB_TRY_VOID(putLink());
    m_notifier = std::make_unique<QSocketNotifier>(m_master, QSocketNotifier::Read);
    QObject::connect(m_notifier.get(), &QSocketNotifier::activated, m_notifier.get(), [this] { readTerminal(); });
    return m_bridge.open();
}

Result<void> PtyLine::openTerminal()
{
    m_master = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    std::array<char, 64> name{};
    if (m_master < 0 || ::grantpt(m_master) != 0 || ::unlockpt(m_master) != 0
        || ::ptsname_r(m_master, name.data(), name.size()) != 0)
        return fail(Fault::LinkLost, say("no pseudo terminal can be had: %1", lastError()));
    m_terminal = name.data();
    termios settings{};
    if (::tcgetattr(m_master, &settings) == 0) { // nothing is echoed before the other program has set it up
        ::cfmakeraw(&settings);
        ::tcsetattr(m_master, TCSANOW, &settings);
    }
    return {};
}

Result<void> PtyLine::putLink()
{
    const fs::path path = m_address.path;
    std::error_code failed;
    const auto there = fs::symlink_status(path, failed);
    if (fs::is_symlink(there)) {
        const fs::path target = fs::read_symlink(path, failed);
        const bool isOfTerminal = target.parent_path() == "/dev/pts";
        if (isStale(m_address.path) && (isOfTerminal || !fs::exists(path, failed)))
            fs::remove(path, failed);
        else if (isOfTerminal)
            return fail(Fault::LinkLost, say("%1 leads to a terminal that another program serves", m_address.path),
                say("end that one first, or choose another path"));
    }
    failed.clear();
    fs::create_symlink(m_terminal, path, failed);
    if (failed == std::errc::file_exists)
        return fail(Fault::LinkLost, say("%1 is there already and no link to a terminal", m_address.path),
            say("choose another path"));
    if (failed)
        return fail(Fault::LinkLost, say("%1 cannot be made: %2", m_address.path, failed.message()));
    m_linked = true;
    return {};
}

std::unique_ptr<VirtualSerialLink> PtyLine::makeEnd()
{
    return std::make_unique<VirtualSerialLink>(m_address, m_line);
}

void PtyLine::readTerminal()
{
    std::array<std::uint8_t, 4096> buffer{};
    const auto got = ::read(m_master, buffer.data(), buffer.size());
    if (got < 0 && (errno == EAGAIN || errno == EINTR))
        return;
    if (got <= 0) {
        rest();
        return;
    }
    const int rate = driverBaudrate(m_master).value_or(m_bridge.baudrate());
    if (m_bridge.fixedBaudrate())
        (void)m_bridge.setBaudrate(rate); // the devices hear garbage when it is not theirs
    else
        m_line.setAnySpeed(std::clamp(rate, SerialLink::slowest, SerialLink::fastest));
    (void)m_bridge.send(std::span(buffer).first(static_cast<std::size_t>(got)));
}

/// Nobody has the terminal open: it would be readable all the time.
void PtyLine::rest()
{
    m_notifier->setEnabled(false);
    m_rest.startIn(restTime, [this] { m_notifier->setEnabled(true); });
}

void PtyLine::writeTerminal(std::span<const std::uint8_t> bytes)
{
    if (m_rest.isActive())
        return; // nobody listens
    const auto written = ::write(m_master, bytes.data(), bytes.size());
    (void)written; // a program that does not read loses bytes, as on a real line
}

} // namespace mb
