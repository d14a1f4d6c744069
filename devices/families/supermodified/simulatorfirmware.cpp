// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/simulatorfirmware.h"

#include <algorithm>

namespace mb::supermodified::simulation {
namespace {

constexpr Duration turnaround = std::chrono::microseconds(100);
constexpr Duration eepromByte = std::chrono::microseconds(3400);
constexpr std::size_t crashingData = 24; ///< 17…24 bytes only spoil the checksum, 40 crashed the shipped image
constexpr std::size_t dataAt = 6;

std::uint64_t unsignedOf(std::span<const std::uint8_t> data)
{
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < data.size(); ++i)
        value += std::uint64_t{data[i]} << (8 * i);
    return value;
}

std::int64_t signedOf(std::span<const std::uint8_t> data)
{
    const std::uint64_t value = unsignedOf(data);
    const auto shift = 64 - 8 * data.size();
    return static_cast<std::int64_t>(value << shift) >> shift;
}

constexpr std::uint8_t firstMove = 0x07;
constexpr std::uint8_t firstBuffered = 0x0D;
constexpr std::uint8_t lastBuffered = 0x12;

bool isMove(std::uint8_t command)
{
    return command >= firstMove && command <= lastBuffered;
}

} // namespace

Firmware::Firmware(Dialect dialect, Drive &drive, const Eeprom &eeprom)
    : m_dialect(dialect)
    , m_drive(drive)
    , m_settings(dialect, eeprom)
{
}

void Firmware::restart(Instant now)
{
    m_settings.restart();
    m_node = m_settings.inForce().node;
    m_baudrate = static_cast<int>(m_settings.inForce().baudrate);
    m_outputs = 0;
    m_received.clear();
    m_errors.clear();
    m_warnings.clear();
    m_buffered.reset();
    m_dead = false;
    m_drive.restart(m_settings.loop(), now);
}

// Receiving

std::optional<Firmware::Answer> Firmware::take(std::uint8_t byte, Instant now)
{
    if (m_dead)
        return std::nullopt;
    m_now = now;
    m_received.push_back(byte);
    const std::size_t count = m_received.size();
    if ((count == 1 && byte != header0) || (count == 2 && byte != header1)) {
        m_received.clear();
        return std::nullopt;
    }
    if (count < dataAt || count < dataAt + m_received[dataAt - 1] + 1U)
        return std::nullopt;
    auto answer = takeFrame();
    m_received.clear();
    return answer;
}

void Firmware::dropHalf()
{
    m_received.clear();
    report(code::halfPacket);
}

bool Firmware::accepts(std::uint8_t to) const
{
    return to == broadcastId || (to & m_settings.inForce().mask) == (m_node & m_settings.inForce().mask);
}

std::optional<Firmware::Answer> Firmware::takeFrame()
{
    const std::uint8_t to = m_received[2];
    const std::uint8_t host = m_received[3];
    const std::uint8_t command = m_received[4];
    const std::size_t size = m_received[5];
    const Data data(m_received.data() + dataAt, size);
    if (size > (isThird() ? mostData : crashingData)) {
        die("crashed", static_cast<double>(size));
        return std::nullopt;
    }
    if (!accepts(to) || (beforeAction && to == m_node && !beforeAction()))
        return std::nullopt;
    std::uint8_t lrc = static_cast<std::uint8_t>(command ^ size);
    for (const std::uint8_t byte : data)
        lrc = static_cast<std::uint8_t>(lrc ^ byte);
    const bool overflow = !isThird() && size > mostDataD1D2;
    Frame reply{host, static_cast<std::uint8_t>(m_node), command, 0, {}};
    std::vector<std::uint8_t> out;
    m_busy = turnaround;
    if (lrc != m_received.back() || overflow)
        report(code::wrongLrc);
    else if (m_errors.empty())
        execute(command, data, out);
    if (to != m_node || m_dead)
        return std::nullopt;
    if (!m_errors.empty()) {
        reply.command = static_cast<std::uint8_t>(Command::Error);
        out.assign(m_errors.begin(), m_errors.end());
        m_errors.clear();
    }
    reply.size = static_cast<std::uint8_t>(out.size());
    std::copy(out.begin(), out.end(), reply.data.begin());
    return Answer{uartBytes(reply), m_busy};
}

void Firmware::report(std::uint8_t code)
{
    const bool warning = code == code::invalidGetCount && m_settings.inForce().level == 0;
    auto &queue = warning ? m_warnings : m_errors;
    if (queue.size() < mostCodes)
        queue.push_back(code);
}

void Firmware::die(std::string_view what, double value)
{
    m_dead = true;
    if (died)
        died(what, value);
}

/// The interrupt of the loop takes the flag that the transfer to the encoder waits for.
bool Firmware::hangsIn(std::uint8_t command) const
{
    const bool asksEncoder = (command == 0x70 && m_dialect == Dialect::D1)
        || ((command == 0x18 || command == 0x19 || command == 0xC9) && !isThird());
    return m_hangs && asksEncoder && m_drive.isAboutToLoop(m_now);
}

// Commands

bool Firmware::isKnown(std::uint8_t command) const
{
    if (command <= 0x1C || (command >= 0x64 && command <= 0x73) || (command >= 0xC8 && command <= 0xCB))
        return true;
    return isThird() && (command == 0x1D || command == 0x1E || command == 0x74);
}

/// Data bytes of a set.
std::size_t Firmware::expected(std::uint8_t command) const
{
    const std::size_t profile = m_dialect == Dialect::D1 ? 2 : 4;
    switch (command) {
    case 0x00:
    case 0x01:
    case 0x02:
    case 0x05:
    case 0x06: return 2;
    case 0x03:
    case 0x04: return profile;
    case 0x07:
    case 0x0A:
    case 0x0D:
    case 0x10: return speedSize();
    case 0x13:
    case 0x14:
    case 0x15:
    case 0x16: return 1;
    case 0x17:
    case 0x1D: return 4;
    case 0x1C: return isThird() ? reactionCount : 1;
    default: return isMove(command) ? placeSize() : 0;
    }
}

void Firmware::execute(std::uint8_t command, Data data, std::vector<std::uint8_t> &reply)
{
    if (hangsIn(command)) {
        die("hung", command);
    } else if (!isKnown(command)) {
        report(code::invalidCommand);
    } else if (command >= 0xC8) {
        act(command);
    } else if (command >= 0x64) {
        get(command, reply);
        if (!isThird())
            report(code::invalidGetCount); // a bug of the firmware (README.md#errors)
    } else if (data.size() != expected(command)) {
        report(code::invalidSetCount);
    } else {
        set(command, data);
    }
}

void Firmware::set(std::uint8_t command, Data data)
{
    if (isMove(command))
        move(command, data, command >= firstBuffered);
    else if (command >= 0x18 && command <= 0x1B)
        act(command);
    else if (command == 0x1E)
        m_errors.clear();
    else if (command == 0x1C && isThird())
        checkStored(m_settings.storeReactions(data));
    else if (command == 0x14)
        m_outputs = static_cast<std::uint8_t>(data[0] & m_settings.inForce().direction);
    else
        checkStored(m_settings.store(command, unsignedOf(data)));
    if (data.size() > 1 && !isMove(command))
        m_busy += eepromByte * static_cast<int>(data.size() - 1);
}

void Firmware::checkStored(bool good)
{
    if (good)
        m_drive.setSettings(m_settings.loop());
    else
        report(code::invalidArgument);
}

bool Firmware::isStarted()
{
    if (!m_drive.isOn())
        report(code::invalidForState);
    return m_drive.isOn();
}

void Firmware::move(std::uint8_t command, Data data, bool buffered)
{
    if (buffered) {
        const auto immediate = static_cast<std::uint8_t>(command - firstBuffered + firstMove);
        m_buffered = Buffered{immediate, {data.begin(), data.end()}};
        return;
    }
    if (!isStarted())
        return;
    const std::int64_t value = signedOf(data);
    switch (command) {
    case 0x07: m_drive.moveAt(value, false); break;
    case 0x08: m_drive.moveTo(value, false); break;
    case 0x09: m_drive.moveTo((isThird() ? m_drive.position() : m_drive.setPoint()) + value, false); break;
    case 0x0A: m_drive.moveAt(value, true); break;
    case 0x0B: m_drive.moveTo(value, true); break;
    case 0x0C: m_drive.moveTo(m_drive.position() + value, true); break;
    default: break;
    }
}

/// Do move and global halt report that the motor is not started, and are done all the same (README.md#errors).
void Firmware::act(std::uint8_t command)
{
    switch (command) {
    case 0x18: m_drive.resetPosition(); break;
    case 0x19:
    case 0xC9: m_drive.start(); break;
    case 0x1A:
        if (isStarted())
            m_drive.halt();
        break;
    case 0xCA:
        (void)isStarted();
        m_drive.halt();
        break;
    case 0x1B:
    case 0xCB: m_drive.stop(); break;
    case 0xC8: doMove(); break;
    default: break;
    }
}

void Firmware::doMove()
{
    if (!m_buffered)
        return;
    const Buffered order = *m_buffered;
    m_buffered.reset();
    move(order.command, order.data, false);
}

// Answers

void Firmware::get(std::uint8_t command, std::vector<std::uint8_t> &reply)
{
    switch (command) {
    case 0x6D: put(reply, (inputs & ~m_settings.inForce().direction) | m_outputs, 1); break;
    case 0x6E:
        for (const std::uint16_t raw : analog)
            put(reply, raw, 2);
        break;
    case 0x6F: put(reply, m_drive.position(), placeSize()); break;
    case 0x70: put(reply, m_drive.encoder().absolutePosition(), 2); break;
    case 0x71: put(reply, m_drive.reportedVelocity(), speedSize()); break;
    case 0x72: {
        constexpr double countsPerAmpere = 100.0;
        const double current = m_drive.motor().current();
        const double raw = isThird() ? current * 1000.0 : std::min(std::abs(current) * countsPerAmpere, 1023.0);
        put(reply, static_cast<std::int64_t>(raw), 2);
        break;
    }
    case 0x73:
        if (isThird())
            reply.assign(m_settings.inForce().reactions.begin(), m_settings.inForce().reactions.end());
        else
            reply.assign(m_warnings.begin(), m_warnings.end());
        m_warnings.clear();
        break;
    default: m_settings.get(command, reply); break;
    }
}

} // namespace mb::supermodified::simulation
