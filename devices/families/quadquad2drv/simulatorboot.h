// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "families/quadquad2drv/simulatorboard.h"
#include "transport/backends/ptyline.h"
#include "transport/seriallink.h"

#include <memory>
#include <string>

namespace mb::quadquad2drv::simulation {

/// The board's bootloader on its UART (README.md#firmware; what the maker does not tell is invented here). A start with the jumper
/// closed, by reset or supply, enters it, one with the jumper open leaves it. It says so every two seconds, as if somebody pressed
/// reset, until the first line comes. Every good line of
/// Intel HEX is confirmed with "ok", others with "error". `reset` starts the application, whose version has risen by 0.1
/// when the file was whole, all of its lines good; after a part of one there is no application to start.
class Boot : NonCopyable {
public:
    /// `address`: pty:PATH or a serial link, 115200 baud. LinkLost or OutOfRange when it cannot be opened.
    [[nodiscard]] static Result<std::unique_ptr<Boot>> open(
        const LinkAddress &address, Clock &clock, Board &board, const BoardOptions &options);
    /// On a link that is open and outlives this.
    Boot(SerialLink &link, Clock &clock, Board &board, const BoardOptions &options);

    ~Boot() { m_board.setStartListener({}); }

    void setJumper(bool closed) { m_jumper = closed; }
    [[nodiscard]] bool isRunning() const { return m_running; }

private:
    void begin();
    void start();
    void end();
    void leave();
    void announce();
    void hear(std::span<const std::uint8_t> bytes);
    void take(const std::string &line);
    [[nodiscard]] bool program(const std::string &line);
    void report(const std::string &text);

    /// What the program memory holds.
    enum class Memory { Application, NewApplication, PartOfOne };

    std::unique_ptr<PtyLine> m_terminal;
    std::unique_ptr<SerialLink> m_own;
    SerialLink &m_link;
    Board &m_board;
    std::string m_text;
    int m_lines = 0;
    bool m_running = false;
    bool m_jumper = false;
    bool m_written = false; ///< a line of the file under way
    bool m_refused = false;
    Memory m_memory = Memory::Application;
    Subscription m_received;
    Timer m_banner;
    Timer m_answer;
};

} // namespace mb::quadquad2drv::simulation
