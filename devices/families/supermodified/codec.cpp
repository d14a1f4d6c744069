// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/codec.h"

#include "wire/bytes.h"

#include <QtGlobal>

#include <algorithm>
#include <cstdio>
#include <limits>

namespace mb::supermodified {
namespace {

using F = Format;

constexpr std::array<F, 3> none{F::None, F::None, F::None};
constexpr std::array<F, 3> u8{F::U8, F::U8, F::U8};
constexpr std::array<F, 3> u16{F::U16, F::U16, F::U16};
constexpr std::array<F, 3> u32{F::U32, F::U32, F::U32};
constexpr std::array<F, 3> i16{F::I16, F::I16, F::I16};
constexpr std::array<F, 3> profile{F::U16, F::U32, F::U32};
constexpr std::array<F, 3> speedForms{F::I16, F::I32, F::I32};
constexpr std::array<F, 3> placeFormats{F::I32, F::I32, F::I64};
constexpr std::array<F, 3> analogFormats{F::Analog, F::Analog, F::Analog};
constexpr std::array<F, 3> onlyThird{F::Absent, F::Absent, F::U32};

constexpr bool control = true;
constexpr bool stored = true;

// One row per line, whatever its length.
// clang-format off
constexpr std::array messageTable{
    CommandForm{Command::P, "PID P", "P", "", u16, false, stored},
    CommandForm{Command::I, "PID I", "I", "", u16, false, stored},
    CommandForm{Command::D, "PID D", "D", "", u16, false, stored},
    CommandForm{Command::ProfileAcceleration, "profile acceleration", "acceleration", "ticks/s²", profile, false, stored},
    CommandForm{Command::ProfileVelocity, "profile velocity", "velocity", "ticks/s", profile, false, stored},
    CommandForm{Command::CurrentLimit, "current limit", "current", "mA", u16, false, stored},
    CommandForm{Command::CurrentLimitDuration, "current-limit duration", "duration", "ms", u16, false, stored},
    CommandForm{Command::MoveVelocity, "velocity move", "velocity", "ticks/s", speedForms, control},
    CommandForm{Command::MoveAbsolute, "absolute move", "position", "ticks", placeFormats, control},
    CommandForm{Command::MoveRelative, "relative move", "distance", "ticks", placeFormats, control},
    CommandForm{Command::MoveProfiledVelocity, "profiled velocity", "velocity", "ticks/s", speedForms, control},
    CommandForm{Command::MoveProfiledAbsolute, "profiled absolute", "position", "ticks", placeFormats, control},
    CommandForm{Command::MoveProfiledRelative, "profiled relative", "distance", "ticks", placeFormats, control},
    CommandForm{Command::BufferVelocity, "buffer velocity", "velocity", "ticks/s", speedForms},
    CommandForm{Command::BufferAbsolute, "buffer absolute", "position", "ticks", placeFormats},
    CommandForm{Command::BufferRelative, "buffer relative", "distance", "ticks", placeFormats},
    CommandForm{Command::BufferProfiledVelocity, "buffer profiled velocity", "velocity", "ticks/s", speedForms},
    CommandForm{Command::BufferProfiledAbsolute, "buffer profiled absolute", "position", "ticks", placeFormats},
    CommandForm{Command::BufferProfiledRelative, "buffer profiled relative", "distance", "ticks", placeFormats},
    CommandForm{Command::IoDirection, "DIO direction", "direction", "", u8, false, stored},
    CommandForm{Command::Outputs, "digital outputs", "outputs", "", u8},
    CommandForm{Command::NodeId, "node id", "id", "", u8, false, stored},
    CommandForm{Command::NodeMask, "local acceptance mask", "mask", "", u8, false, stored},
    CommandForm{Command::Baudrate, "UART baud", "baud", "bit/s", u32, false, stored},
    CommandForm{Command::ResetPosition, "reset position", "", "", none, control},
    CommandForm{Command::Start, "start", "", "", none, control},
    CommandForm{Command::Halt, "halt", "", "", none, control},
    CommandForm{Command::Stop, "stop", "", "", none},
    CommandForm{Command::ErrorLevel, "error-reporting level", "level", "", {F::U8, F::U8, F::Reactions}, false, stored},
    CommandForm{Command::AntiWindup, "anti-windup", "limit", "", onlyThird, false, stored},
    CommandForm{Command::ResetErrors, "reset errors", "", "", {F::Absent, F::Absent, F::None}},
    CommandForm{Command::GetP, "get PID P", "P", "", u16},
    CommandForm{Command::GetI, "get PID I", "I", "", u16},
    CommandForm{Command::GetD, "get PID D", "D", "", u16},
    CommandForm{Command::GetProfileAcceleration, "get profile acceleration", "acceleration", "ticks/s²", profile},
    CommandForm{Command::GetProfileVelocity, "get profile velocity", "velocity", "ticks/s", profile},
    CommandForm{Command::GetCurrentLimit, "get current limit", "current", "mA", u16},
    CommandForm{Command::GetCurrentLimitDuration, "get current-limit duration", "duration", "ms", u16},
    CommandForm{Command::GetIoDirection, "get DIO direction", "direction", "", u8},
    CommandForm{Command::GetNodeMask, "get local acceptance mask", "mask", "", u8},
    CommandForm{Command::GetInputs, "get digital inputs", "inputs", "", u8},
    CommandForm{Command::GetAnalog, "get analog inputs", "", "1/1024 of 5 V", analogFormats},
    CommandForm{Command::GetPosition, "get position", "position", "ticks", placeFormats},
    CommandForm{Command::GetAbsolutePosition, "get absolute position", "position", "ticks", u16},
    CommandForm{Command::GetVelocity, "get velocity", "velocity", "ticks/s", speedForms},
    CommandForm{Command::GetCurrent, "get current", "current", "", i16},
    CommandForm{Command::GetWarnings, "get warnings", "", "", {F::Codes, F::Codes, F::Reactions}},
    CommandForm{Command::GetAntiWindup, "get anti-windup", "limit", "", onlyThird},
    CommandForm{Command::DoMove, "do move", "", "", none, control},
    CommandForm{Command::GlobalStart, "global start", "", "", none, control},
    CommandForm{Command::GlobalHalt, "global halt", "", "", none, control},
    CommandForm{Command::GlobalStop, "global stop", "", "", none},
    CommandForm{Command::Error, "error", "", "", {F::Codes, F::Codes, F::Codes}},
};

constexpr std::array codeTable{
    CodeName{0x01, "motor_stalled", QT_TRANSLATE_NOOP("table", "the motor stalled")},
    CodeName{0x02, "encoder_overflow", QT_TRANSLATE_NOOP("table", "the position left its range upwards")},
    CodeName{0x03, "encoder_underflow", QT_TRANSLATE_NOOP("table", "the position left its range downwards")},
    CodeName{0x11, "invalid_command", QT_TRANSLATE_NOOP("table", "it has no such command")},
    CodeName{0x12, "invalid_byte_count", QT_TRANSLATE_NOOP("table", "wrong number of data bytes")},
    CodeName{0x13, "invalid_argument", QT_TRANSLATE_NOOP("table", "a value that it does not take")},
    CodeName{0x14, "invalid_for_state", QT_TRANSLATE_NOOP("table", "not possible while the motor is not started")},
    CodeName{0x15, "unexpected_data", QT_TRANSLATE_NOOP("table", "data bytes where none belong")},
    CodeName{0x21, "i2c_no_device", QT_TRANSLATE_NOOP("table", "I2C: nobody answers")},
    CodeName{0x22, "i2c_bus_error", QT_TRANSLATE_NOOP("table", "I2C: bus error")},
    CodeName{0x23, "i2c_arbitration", QT_TRANSLATE_NOOP("table", "I2C: arbitration lost")},
    CodeName{0x24, "i2c_indeterminate", QT_TRANSLATE_NOOP("table", "I2C: indeterminate state")},
    CodeName{0x25, "i2c_ready_timeout", QT_TRANSLATE_NOOP("table", "I2C: the bus did not become ready")},
    CodeName{0x26, "i2c_transmit_timeout", QT_TRANSLATE_NOOP("table", "I2C: sending took too long")},
    CodeName{0x27, "i2c_receive_timeout", QT_TRANSLATE_NOOP("table", "I2C: receiving took too long")},
    CodeName{0x31, "packet_overwritten", QT_TRANSLATE_NOOP("table", "I2C: a packet was overwritten")},
    CodeName{0x32, "packet_length", QT_TRANSLATE_NOOP("table", "I2C: a packet of wrong length")},
    CodeName{0x41, "uart_memory", QT_TRANSLATE_NOOP("table", "UART: out of memory")},
    CodeName{0x43, "uart_frame", QT_TRANSLATE_NOOP("table", "UART: framing error")},
    CodeName{0x44, "uart_parity", QT_TRANSLATE_NOOP("table", "UART: parity error")},
    CodeName{0x45, "uart_overflow", QT_TRANSLATE_NOOP("table", "UART: receive buffer overflow")},
    CodeName{0x46, "uart_overrun", QT_TRANSLATE_NOOP("table", "UART: data overrun (the datasheet means a framing error)")},
    CodeName{0x47, "uart_timeout", QT_TRANSLATE_NOOP("table", "UART: sending took too long (the datasheet means a parity error)")},
    CodeName{0x48, "uart_overflow_datasheet", QT_TRANSLATE_NOOP("table", "UART: receive buffer overflow, by the datasheet's number")},
    CodeName{0x49, "uart_overrun_datasheet", QT_TRANSLATE_NOOP("table", "UART: data overrun, by the datasheet's number")},
    CodeName{0x51, "half_packet", QT_TRANSLATE_NOOP("table", "a frame paused for more than 50 ms")},
    CodeName{0x52, "wrong_checksum", QT_TRANSLATE_NOOP("table", "wrong checksum")},
};
// clang-format on

constexpr std::array<std::size_t, 11> formatSizes{0, 0, 1, 2, 4, 2, 4, 8, 2 * analogInputs, 0, reactionCount};

struct Range {
    std::int64_t low = 0;
    std::int64_t high = 0;
};
Range rangeOf(Format format)
{
    switch (format) {
    case Format::U8: return {0, 0xFF};
    case Format::U16: return {0, 0xFFFF};
    case Format::U32: return {0, 0xFFFFFFFFLL};
    case Format::I16: return {-0x8000, 0x7FFF};
    case Format::I32: return {-0x80000000LL, 0x7FFFFFFFLL};
    case Format::I64: return {std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max()};
    case Format::Reactions: return {0, (std::int64_t{1} << (2 * reactionCount)) - 1};
    default: return {};
    }
}

void writeInteger(Frame &frame, std::int64_t value, std::size_t size)
{
    auto bits = static_cast<std::uint64_t>(value);
    for (std::size_t i = 0; i < size; ++i, bits >>= 8U)
        frame.data.at(i) = static_cast<std::uint8_t>(bits & 0xFFU);
}

std::uint64_t readInteger(std::span<const std::uint8_t> bytes)
{
    std::uint64_t bits = 0;
    for (std::size_t i = bytes.size(); i > 0; --i)
        bits = (bits << 8U) | bytes[i - 1];
    return bits;
}

bool writeReactions(Frame &frame, std::int64_t packed)
{
    for (std::size_t i = 0; i < reactionCount; ++i) {
        frame.data.at(i) = static_cast<std::uint8_t>((packed >> (2 * i)) & 3);
        if (frame.data.at(i) > mostReaction)
            return false;
    }
    return true;
}

std::optional<std::int64_t> readReactions(std::span<const std::uint8_t> bytes)
{
    std::int64_t packed = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        if (bytes[i] > mostReaction)
            return std::nullopt;
        packed |= std::int64_t{bytes[i]} << (2 * i);
    }
    return packed;
}

} // namespace

std::size_t sizeOf(Format format)
{
    return formatSizes.at(static_cast<std::size_t>(format));
}

std::string_view CommandForm::nameOf(Format format) const
{
    if (format != Format::Reactions)
        return name;
    return isGet(static_cast<std::uint8_t>(command)) ? "get error reaction" : "error reaction";
}

std::span<const CommandForm> messages()
{
    return messageTable;
}

const CommandForm *messageOf(std::uint8_t command)
{
    const auto *const row = std::ranges::find_if(
        messageTable, [command](const CommandForm &m) { return static_cast<std::uint8_t>(m.command) == command; });
    return row == messageTable.end() ? nullptr : row;
}

Format formatOf(Command command, Dialect dialect)
{
    const CommandForm *const message = messageOf(static_cast<std::uint8_t>(command));
    return message ? message->formatIn(dialect) : Format::Absent;
}

Frame request(int node, int host, Command command)
{
    return Frame{
        static_cast<std::uint8_t>(node), static_cast<std::uint8_t>(host), static_cast<std::uint8_t>(command), 0, {}};
}

Result<Frame> request(int node, int host, Command command, Dialect dialect, std::int64_t value)
{
    const Format format = formatOf(command, dialect);
    const CommandForm *const message = messageOf(static_cast<std::uint8_t>(command));
    if (format == Format::Absent || message == nullptr)
        return fail(Fault::Unsupported,
            message ? say("%1 is not known to firmware of dialect %2", message->name, toString(dialect))
                    : say("this command is not known to firmware of dialect %1", toString(dialect)));
    const auto [low, high] = rangeOf(format);
    Frame frame = request(node, host, command);
    frame.size = static_cast<std::uint8_t>(sizeOf(format));
    if (value < low || value > high || (format == Format::Reactions && !writeReactions(frame, value)))
        return fail(Fault::OutOfRange,
            say("%1 %2 is outside %3 … %4, what firmware of dialect %5 takes", message->nameOf(format), value, low,
                high, toString(dialect)));
    if (format != Format::Reactions)
        writeInteger(frame, value, frame.size);
    return frame;
}

bool answers(const Frame &reply, int node, int host, Command command)
{
    return reply.from == node && reply.to == host && (reply.is(command) || codesOf(reply));
}

std::optional<std::int64_t> valueOf(std::span<const std::uint8_t> payload, Format format)
{
    if (format == Format::Absent || format == Format::Codes || format == Format::Analog || format == Format::None
        || payload.size() != sizeOf(format))
        return std::nullopt;
    if (format == Format::Reactions)
        return readReactions(payload);
    const std::uint64_t bits = readInteger(payload);
    switch (format) {
    case Format::I16: return static_cast<std::int16_t>(bits);
    case Format::I32: return static_cast<std::int32_t>(bits);
    default: return static_cast<std::int64_t>(bits);
    }
}

std::optional<std::array<std::uint16_t, analogInputs>> analogOf(std::span<const std::uint8_t> payload)
{
    if (payload.size() != sizeOf(Format::Analog))
        return std::nullopt;
    std::array<std::uint16_t, analogInputs> raw{};
    for (std::size_t i = 0; i < raw.size(); ++i)
        raw.at(i) = readU16le(payload, 2 * i);
    return raw;
}

std::optional<std::span<const std::uint8_t>> codesOf(const Frame &reply)
{
    if (!reply.is(Command::Error) || reply.size == 0 || reply.size > mostCodes)
        return std::nullopt;
    return reply.payload();
}

std::optional<bool> isThirdGeneration(const Frame &positionReply)
{
    if (!positionReply.is(Command::GetPosition) || (positionReply.size != 4 && positionReply.size != 8))
        return std::nullopt;
    return positionReply.size == 8;
}

std::optional<Dialect> dialectByVelocity(const Frame &velocityReply)
{
    if (!velocityReply.is(Command::GetVelocity) || (velocityReply.size != 2 && velocityReply.size != 4))
        return std::nullopt;
    return velocityReply.size == 2 ? Dialect::D1 : Dialect::D2;
}

std::string_view toString(Dialect dialect)
{
    constexpr std::array<std::string_view, 3> names{"D1", "D2", "D3"};
    return names.at(static_cast<std::size_t>(dialect));
}

std::optional<Dialect> dialectFrom(std::string_view text)
{
    for (const Dialect dialect : {Dialect::D1, Dialect::D2, Dialect::D3}) {
        if (toString(dialect) == text)
            return dialect;
    }
    return std::nullopt;
}

std::span<const CodeName> codeNames()
{
    return codeTable;
}

Message codeText(std::uint8_t code)
{
    const auto *const row = std::ranges::find(codeTable, code, &CodeName::code);
    std::array<char, 8> number{};
    std::snprintf(number.data(), number.size(), "%02X", static_cast<unsigned>(code));
    return say("%1 (%2)", row == codeTable.end() ? say("error") : Message::label(row->text), number.data());
}

Message codesText(std::span<const std::uint8_t> codes)
{
    Message all;
    for (const std::uint8_t code : codes)
        all = all.empty() ? codeText(code) : say("%1, %2", all, codeText(code));
    return all;
}

} // namespace mb::supermodified
