// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/event.h"
#include "async/noncopyable.h"
#include "async/task.h"
#include "transport/seriallink.h"

#include <deque>
#include <optional>
#include <string>

namespace mb::quadquad2drv {

/// The bootloader's text (README.md#firmware): lines of whatever ending, blank ones left out, cut at 256 characters.
class BootConsole : NonCopyable {
public:
    BootConsole(SerialLink &link, Clock &clock, std::string ending = "\r");

    /// Sends text and the ending of a line.
    Result<void> send(const std::string &text);
    /// The next line; Timeout, LinkLost. What stands without an end for 200 ms counts as a line: a prompt has none.
    [[nodiscard]] Task<std::string> line(Duration timeout);
    /// A line that is there already.
    [[nodiscard]] std::optional<std::string> take();
    void clear();

private:
    void hear(std::span<const std::uint8_t> bytes);
    void finishLine();
    void wake();

    SerialLink &m_link;
    Clock &m_clock;
    std::string m_ending;
    std::string m_partial;
    std::deque<std::string> m_lines;
    Event *m_waiting = nullptr;
    Timer m_unfinished;
    Subscription m_received;
    Subscription m_state;
};

} // namespace mb::quadquad2drv
