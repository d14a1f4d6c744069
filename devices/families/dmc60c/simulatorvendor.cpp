// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/simulatorvendor.h"

#include "wire/bytes.h"

#include <algorithm>

namespace mb::dmc60c::simulation {
namespace {

constexpr auto crcTime = std::chrono::microseconds(800);
constexpr auto pinTestTime = std::chrono::milliseconds(100);
constexpr std::uint8_t terminalQea = 4; ///< terc: without the loop-back the test ends there

/// Longest text of a descriptor, without its NUL.
std::size_t textLimit(Command command)
{
    switch (command) {
    case Command::SetDevName: return maxNameLength;
    case Command::SetManName:
    case Command::SetProdName: return 28;
    case Command::SetManDate: return 20;
    case Command::SetHardwareVer: return 8;
    case Command::SetSN: return 12;
    default: return 0;
    }
}

Descriptor descriptorOf(Command command)
{
    return static_cast<Descriptor>(static_cast<int>(command) - static_cast<int>(Command::SetDevName) + 1);
}

} // namespace

void VendorPort::command(std::span<const std::uint8_t> bytes)
{
    reset();
    const auto code = static_cast<Command>(readU16le(bytes, 2));
    const int first = readU16le(bytes, 4);
    const int second = readU16le(bytes, 6);
    const bool boot = m_board.isInBootloader();
    switch (code) {
    case Command::SetDevNumber: return setNumber(first);
    case Command::SetDevName:
    case Command::SetManName:
    case Command::SetProdName:
    case Command::SetManDate:
    case Command::SetHardwareVer:
    case Command::SetSN: return beginText(code, static_cast<std::size_t>(first));
    case Command::GetDescriptors: return sendBlock(m_memory.ram().descriptors());
    case Command::GetFwver: {
        std::array<std::uint8_t, 6> version{};
        writeU16le(version, 0, static_cast<std::uint16_t>(boot ? ImageType::Bootloader : ImageType::Application));
        writeU16le(version, 2, m_application.version());
        writeU16le(version, 4, bootloaderVersion);
        return sendBlock(version);
    }
    case Command::EnterBootloader: return boot ? reply(CommandStatus::InBootloader) : m_board.restart(true);
    case Command::SoftReset: return m_board.restart(false);
    case Command::EraseWriteFlashPage: return boot ? beginPage(first, second) : reply(CommandStatus::NotSupported);
    case Command::FlashLEDs:
    case Command::GetFlashSeqnum:
    case Command::J1ShortTest:
    case Command::J1OpenTest: break;
    }
    if (boot)
        return reply(CommandStatus::NotSupported);
    applicationCommand(code);
}

void VendorPort::applicationCommand(Command code)
{
    switch (code) {
    case Command::FlashLEDs: m_board.note("leds", 5.0); return reply(CommandStatus::NoError);
    case Command::GetFlashSeqnum: {
        std::array<std::uint8_t, 4> number{};
        writeU32le(number, 0, m_memory.ram().sequence);
        return sendBlock(number);
    }
    case Command::J1ShortTest: return m_processor.stall(pinTestTime, [this] { reply(CommandStatus::TestPassed); });
    case Command::J1OpenTest:
        return m_processor.stall(
            pinTestTime, [this] { m_board.sendStatus(CommandStatus::TestFailed, terminalQea, 0); });
    default: return reply(CommandStatus::NotSupported);
    }
}

void VendorPort::sendBlock(std::span<const std::uint8_t> bytes)
{
    m_board.sendStatus(CommandStatus::NoError, 0, bytes.size());
    m_board.sendData(bytes);
}

void VendorPort::setNumber(int number)
{
    if (number < 1 || number > maxDeviceNumber)
        return reply(CommandStatus::BadParameter);
    m_processor.stall(writeTime, [this, number] {
        m_memory.ram().number = number;
        m_memory.commit();
        reply(CommandStatus::NoError);
    });
}

void VendorPort::beginText(Command command, std::size_t count)
{
    if (count > textLimit(command) + 1)
        return reply(CommandStatus::BadParameter);
    openTransfer(command, count, 0);
}

void VendorPort::beginPage(int imageType, int page)
{
    const bool known = imageType == static_cast<int>(ImageType::Application)
        || imageType == static_cast<int>(ImageType::AuxiliaryBootloader);
    if (!known || page > lastPage)
        return reply(CommandStatus::BadParameter);
    openTransfer(Command::EraseWriteFlashPage, pageTransferSize, page);
}

void VendorPort::openTransfer(Command command, std::size_t bytes, int page)
{
    m_open = true;
    m_command = command;
    m_expected = bytes;
    m_page = page;
    m_bytes.clear();
}

void VendorPort::data(std::span<const std::uint8_t> bytes)
{
    if (!m_open)
        return;
    m_bytes.insert(m_bytes.end(), bytes.begin(), bytes.end());
    if (m_bytes.size() > m_expected) {
        reset();
        return reply(CommandStatus::DataRcvMore);
    }
    if (m_bytes.size() < m_expected)
        return;
    reset();
    if (m_command == Command::EraseWriteFlashPage)
        endPage();
    else
        endText();
}

void VendorPort::endText()
{
    const auto end = std::ranges::find(m_bytes, std::uint8_t{0});
    std::string text(m_bytes.begin(), end == m_bytes.end() ? end - 1 : end);
    m_processor.stall(writeTime, [this, text = std::move(text), which = descriptorOf(m_command)] {
        m_memory.ram().text(which) = text;
        m_memory.commit();
        reply(CommandStatus::NoError);
    });
}

void VendorPort::endPage()
{
    m_processor.stall(crcTime, [this] {
        const std::span<const std::uint8_t> bytes = m_bytes;
        if (pageCrc(m_crc, bytes.first(pageSize)) != readU32le(bytes, pageSize))
            reply(CommandStatus::CrcMismatch);
        else
            erasePage();
    });
}

void VendorPort::erasePage()
{
    m_application.erase(m_page);
    m_processor.stall(eraseTime + writeTime / 2, [this] { writePage(); });
}

void VendorPort::writePage()
{
    if (m_board.failsDuring(m_page))
        return;
    const Duration rest = writeTime / 2;
    m_processor.stall(m_page == firstPage ? rest + versionWriteTime : rest, [this] { finishPage(); });
}

void VendorPort::finishPage()
{
    if (!m_application.program(m_page, m_bytes)) {
        m_board.note("page-failed", m_page);
        return reply(CommandStatus::FlashWriteFailed);
    }
    if (m_page == firstPage)
        m_application.writeVersion();
    m_board.note("page-written", m_page);
    reply(CommandStatus::NoError);
}

} // namespace mb::dmc60c::simulation
