// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/simulatorboot.h"

#include "transport/linkcatalog.h"
#include "wire/number.h"

namespace mb::quadquad2drv::simulation {
namespace {

using namespace std::chrono_literals;

constexpr int baudrate = 115200;
constexpr Duration bannerPeriod = 2s;
constexpr Duration programming = 5ms; ///< a line
constexpr std::size_t longestLine = 600;
constexpr std::string_view endOfFile = ":00000001FF";

std::optional<unsigned> hexByte(std::string_view text, std::size_t at)
{
    return text.size() < at + 2 ? std::nullopt : wholeFrom<unsigned>(text.substr(at, 2), 16);
}

/// A record whose length and checksum are right.
bool isRecord(std::string_view line)
{
    const auto count = line.starts_with(':') ? hexByte(line, 1) : std::nullopt;
    if (!count || line.size() != 11 + 2 * *count)
        return false;
    unsigned sum = 0;
    for (std::size_t at = 1; at < line.size(); at += 2) {
        const auto byte = hexByte(line, at);
        if (!byte)
            return false;
        sum += *byte;
    }
    return (sum & 0xFFU) == 0;
}

} // namespace

Result<std::unique_ptr<Boot>> Boot::open(
    const LinkAddress &address, Clock &clock, Board &board, const BoardOptions &options)
{
    std::unique_ptr<PtyLine> terminal;
    std::unique_ptr<SerialLink> own;
    if (address.scheme == "pty") {
        MB_TRY(auto made, PtyLine::create(address, clock));
        terminal = std::move(made);
        MB_TRY_VOID(terminal->open());
        own = terminal->makeEnd();
    } else {
        MB_TRY(auto made, createLink(address, clock));
        if (made->kind() != LinkKind::Serial)
            return fail(Fault::OutOfRange, say("boot= names a serial link, such as pty:./boot"));
        own.reset(static_cast<SerialLink *>(made.release()));
    }
    if (!own->fixedBaudrate())
        (void)own->setBaudrate(baudrate);
    MB_TRY_VOID(own->open());
    auto boot = std::make_unique<Boot>(*own, clock, board, options);
    boot->m_terminal = std::move(terminal);
    boot->m_own = std::move(own);
    return boot;
}

Boot::Boot(SerialLink &link, Clock &clock, Board &board, const BoardOptions &options)
    : m_link(link)
    , m_board(board)
    , m_received(link.received().add([this](std::span<const std::uint8_t> bytes) { hear(bytes); }))
    , m_banner(clock)
    , m_answer(clock)
{
    m_jumper = options.jumper || options.inBootloader;
    m_board.setStartListener([this](bool started) {
        if (started)
            begin();
        else
            end();
    });
    if (options.inBootloader)
        start();
}

/// The processor looks at the jumper.
void Boot::begin()
{
    if (m_jumper)
        start();
    else
        leave();
}

/// The supply is gone.
void Boot::end()
{
    m_running = false;
    m_banner.stop();
    m_answer.stop();
    m_text.clear();
}

void Boot::start()
{
    m_answer.stop();
    m_running = true;
    m_lines = 0;
    m_written = m_refused = false;
    m_text.clear();
    m_board.setRunning(false);
    announce();
}

void Boot::leave()
{
    m_banner.stop();
    m_running = false;
    if (m_memory == Memory::PartOfOne)
        return; // and what runs then, if anything, tells nothing
    auto version = m_board.version();
    if (std::exchange(m_memory, Memory::Application) == Memory::NewApplication)
        ++version[1];
    m_board.setVersion(version);
    m_board.setRunning(true);
}

void Boot::announce()
{
    report("QuadQuad2Drv bootloader 1.0");
    m_banner.startIn(bannerPeriod, [this] { announce(); });
}

void Boot::hear(std::span<const std::uint8_t> bytes)
{
    for (const std::uint8_t byte : bytes) {
        if (!m_running)
            return;
        const char c = static_cast<char>(byte);
        if (c == '\r' || c == '\n') {
            if (!m_text.empty())
                take(std::exchange(m_text, {}));
        } else if (m_text.size() < longestLine) {
            m_text += c;
        }
    }
}

void Boot::take(const std::string &line)
{
    m_banner.stop();
    if (line == "reset") {
        leave();
        return;
    }
    if (m_board.failsWithLine(++m_lines))
        return;
    const bool good = program(line);
    m_answer.startIn(programming, [this, good] { report(good ? "ok" : "error: bad line"); });
}

bool Boot::program(const std::string &line)
{
    if (!isRecord(line)) {
        m_refused = true;
        return false;
    }
    if (line != endOfFile) {
        m_written = true;
        m_memory = Memory::PartOfOne;
        return true;
    }
    if (m_written && !m_refused)
        m_memory = Memory::NewApplication;
    m_written = m_refused = false;
    return true;
}

void Boot::report(const std::string &text)
{
    const std::string line = text + "\r\n";
    (void)m_link.send({reinterpret_cast<const std::uint8_t *>(line.data()), line.size()});
}

} // namespace mb::quadquad2drv::simulation
