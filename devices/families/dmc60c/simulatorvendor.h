// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "async/noncopyable.h"
#include "families/dmc60c/simulatormemory.h"

#include <span>
#include <string_view>
#include <vector>

namespace mb::dmc60c::simulation {

/// What vendor commands act on.
class Board : NonCopyable {
public:
    virtual ~Board() = default;

    [[nodiscard]] virtual bool isInBootloader() const = 0;
    virtual void sendStatus(CommandStatus status, std::uint8_t terminal, std::size_t bytes) = 0;
    virtual void sendData(std::span<const std::uint8_t> bytes) = 0;
    /// A reset on command; `stay` in the bootloader.
    virtual void restart(bool stay) = 0;
    /// Half of `page` is written; true when the supply was lost at this very moment.
    [[nodiscard]] virtual bool failsDuring(int page) = 0;
    virtual void note(std::string_view what, double value) = 0;
};

/// The vendor commands and their transfers (README.md#vendor-commands).
class VendorPort {
public:
    /// `crc`: how the bootloader checks a page. All outlive it.
    VendorPort(Board &board, Processor &processor, ConfigMemory &memory, ApplicationFlash &application, CrcVariant crc)
        : m_board(board)
        , m_processor(processor)
        , m_memory(memory)
        , m_application(application)
        , m_crc(crc)
    {
    }
    /// A VENDORCMD of 8 bytes with the right session and number.
    void command(std::span<const std::uint8_t> bytes);
    void data(std::span<const std::uint8_t> bytes);
    /// Forgets the transfer in progress.
    void reset() { m_open = false; }

private:
    void reply(CommandStatus status) { m_board.sendStatus(status, 0, 0); }
    void sendBlock(std::span<const std::uint8_t> bytes);
    void openTransfer(Command command, std::size_t bytes, int page);
    void setNumber(int number);
    void beginText(Command command, std::size_t count);
    void beginPage(int imageType, int page);
    void endText();
    void endPage();
    void erasePage();
    void writePage();
    void finishPage();
    void applicationCommand(Command code);

    Board &m_board;
    Processor &m_processor;
    ConfigMemory &m_memory;
    ApplicationFlash &m_application;
    CrcVariant m_crc;
    bool m_open = false;
    Command m_command{};
    std::size_t m_expected = 0;
    int m_page = 0;
    std::vector<std::uint8_t> m_bytes;
};

constexpr std::uint16_t bootloaderVersion = 0x0109;

} // namespace mb::dmc60c::simulation
