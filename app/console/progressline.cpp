// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/progressline.h"

#include <algorithm>

#include <unistd.h>

namespace mb::console {
namespace {

constexpr int barWidth = 30;
constexpr Duration redraw = std::chrono::milliseconds(50);
constexpr Duration lineEvery = std::chrono::seconds(1);

void write(const std::string &text)
{
    (void)Outlet(STDERR_FILENO).write(text);
}

} // namespace

ProgressLine::ProgressLine(Console &console)
    : m_console(console)
    , m_terminal(::isatty(STDERR_FILENO) == 1)
    , m_next(console.clock().now() + (m_terminal ? redraw : lineEvery)) // what is quick stays silent
{
}

void ProgressLine::step(const Message &what, int done, int total)
{
    const Instant now = m_console.clock().now();
    if (m_console.options().quiet || now < m_next)
        return;
    m_next = now + (m_terminal ? redraw : lineEvery);
    if (m_terminal) {
        draw(what.english(), done, total);
        return;
    }
    std::string line = what.english();
    if (total > 0)
        line += " (" + std::to_string(done) + " of " + std::to_string(total) + ')';
    if (line != std::exchange(m_last, line))
        complain(line);
}

void ProgressLine::draw(const std::string &what, int done, int total)
{
    std::string line = "\r\x1B[K";
    if (total > 0) {
        const int filled = std::clamp(barWidth * done / total, 0, barWidth);
        line += '[' + std::string(static_cast<std::size_t>(filled), '#')
            + std::string(static_cast<std::size_t>(barWidth - filled), ' ') + "] " + std::to_string(100 * done / total)
            + " % ";
    }
    write(line + what);
    m_drawn = true;
}

void ProgressLine::log(Severity severity, const Message &text)
{
    if (severity != Severity::Caution && severity != Severity::Danger)
        return;
    erase();
    m_console.note(text.english());
}

void ProgressLine::erase()
{
    if (std::exchange(m_drawn, false))
        write("\r\x1B[K");
}

WriteProgress::WriteProgress(Console &console)
    : ProgressLine(console)
    , m_console(console)
{
}

WriteProgress::~WriteProgress()
{
    if (m_console.isInterrupted() && m_done < m_total)
        m_console.note(std::to_string(m_done) + " of " + std::to_string(m_total)
            + " values are written, and the next one may be; 'motorbenchctl get' reads what is in force");
}

void WriteProgress::step(const Message &what, int done, int total)
{
    m_done = done;
    m_total = total;
    ProgressLine::step(what, done, total);
}

} // namespace mb::console
