// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/bootconsole.h"

namespace mb::quadquad2drv {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t longestLine = 256;
constexpr Duration unfinishedTime = 200ms;
constexpr char firstPrintable = ' ';

} // namespace

BootConsole::BootConsole(SerialLink &link, Clock &clock, std::string ending)
    : m_link(link)
    , m_clock(clock)
    , m_ending(std::move(ending))
    , m_unfinished(clock)
    , m_received(link.received().add([this](std::span<const std::uint8_t> bytes) { hear(bytes); }))
    , m_state(link.stateChanged().add([this](LinkState) { wake(); }))
{
}

Result<void> BootConsole::send(const std::string &text)
{
    std::vector<std::uint8_t> bytes(text.begin(), text.end());
    bytes.insert(bytes.end(), m_ending.begin(), m_ending.end());
    return m_link.send(bytes);
}

void BootConsole::hear(std::span<const std::uint8_t> bytes)
{
    for (const std::uint8_t byte : bytes) {
        const char c = static_cast<char>(byte);
        if (c == '\r' || c == '\n')
            finishLine();
        else if (byte >= static_cast<std::uint8_t>(firstPrintable) && m_partial.size() < longestLine)
            m_partial += c;
    }
    if (m_partial.empty())
        m_unfinished.stop();
    else
        m_unfinished.startIn(unfinishedTime, [this] { finishLine(); });
}

void BootConsole::finishLine()
{
    if (m_partial.empty())
        return;
    m_lines.push_back(std::exchange(m_partial, {}));
    wake();
}

void BootConsole::wake()
{
    if (m_waiting)
        m_waiting->set();
}

std::optional<std::string> BootConsole::take()
{
    if (m_lines.empty())
        return std::nullopt;
    std::string first = std::move(m_lines.front());
    m_lines.pop_front();
    return first;
}

void BootConsole::clear()
{
    m_lines.clear();
    m_partial.clear();
}

Task<std::string> BootConsole::line(Duration timeout)
{
    if (m_lines.empty() && m_link.state() == LinkState::Open) {
        struct Waiting {
            explicit Waiting(Event *&place)
                : slot(place)
            {
                slot = &event;
            }
            ~Waiting() { slot = nullptr; }
            Event event;
            Event *&slot;
        };
        Waiting waiting(m_waiting);
        Timer limit(m_clock);
        limit.startIn(timeout, [&waiting] { waiting.event.set(); });
        co_await waiting.event.wait();
    }
    if (auto first = take())
        co_return std::move(*first);
    if (m_link.state() != LinkState::Open)
        co_return fail(m_link.notOpen());
    co_return fail(Fault::Timeout, say("the bootloader said nothing"));
}

} // namespace mb::quadquad2drv
