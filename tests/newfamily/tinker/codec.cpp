// SPDX-License-Identifier: GPL-3.0-or-later
#include "tinker/codec.h"

#include "wire/bytes.h"

#include <algorithm>
#include <array>

namespace mb::tinker {
namespace {

std::uint32_t idOf(Message message, int address)
{
    return baseId | static_cast<std::uint32_t>(message) << 8U | static_cast<std::uint32_t>(address);
}

std::int32_t i32(const CanFrame &frame, std::size_t at)
{
    return static_cast<std::int32_t>(readU32le(frame.data, at));
}

CanFrame numbered(Message message, int address, std::uint8_t first, std::int32_t value)
{
    std::array<std::uint8_t, 5> data{first};
    writeU32le(data, 1, static_cast<std::uint32_t>(value));
    return extendedFrame(idOf(message, address), data);
}

struct Row {
    Message message;
    std::string_view name;
    int size;
};
constexpr std::array<Row, 12> rows{{{Message::Who, "who", 0}, {Message::Drive, "drive", 5}, {Message::Read, "read", 1},
    {Message::Write, "write", 5}, {Message::Store, "store", 0}, {Message::Load, "load", 0},
    {Message::Piece, "piece", 6}, {Message::Run, "run", 0}, {Message::Here, "here", 3}, {Message::Value, "value", 5},
    {Message::Status, "status", 7}, {Message::Loaded, "loaded", 2}}};

std::vector<DecodedField> fieldsOf(Message message, const CanFrame &frame)
{
    switch (message) {
    case Message::Drive: return {{"mode", 1.0 * frame.data[0], {}}, {"value", 1.0 * i32(frame, 1), {}}};
    case Message::Write:
    case Message::Value: return {{"parameter", 1.0 * frame.data[0], {}}, {"value", 1.0 * i32(frame, 1), {}}};
    case Message::Status: {
        const auto duty = static_cast<std::int16_t>(readU16le(frame.data, 4));
        return {{"position", 1.0 * i32(frame, 0), "counts"}, {"duty", duty / fullDuty, "fraction"}};
    }
    default: return {};
    }
}

} // namespace

CanFrame ask(Message message, int address)
{
    return extendedFrame(idOf(message, address), {});
}

CanFrame drive(int address, Drive mode, std::int32_t value)
{
    return numbered(Message::Drive, address, static_cast<std::uint8_t>(mode), value);
}

CanFrame readParameter(int address, std::uint8_t number)
{
    return extendedFrame(idOf(Message::Read, address), {number});
}

CanFrame writeParameter(int address, ParameterValue value)
{
    return numbered(Message::Write, address, value.number, value.raw);
}

CanFrame piece(int address, std::uint16_t at, std::span<const std::uint8_t> four)
{
    std::array<std::uint8_t, 6> data{};
    writeU16le(data, 0, at);
    std::copy(four.begin(), four.end(), data.begin() + 2);
    return extendedFrame(idOf(Message::Piece, address), data);
}

bool isFrom(const CanFrame &frame, Message message, int address, int size)
{
    return frame.extended && !frame.remote && frame.id == idOf(message, address) && frame.size == size;
}

std::optional<Status> statusOf(const CanFrame &frame, int address)
{
    if (!isFrom(frame, Message::Status, address, 7))
        return std::nullopt;
    const auto duty = static_cast<std::int16_t>(readU16le(frame.data, 4));
    return Status{
        i32(frame, 0), duty / fullDuty, (frame.data[6] & stalledFlag) != 0, (frame.data[6] & endSwitchFlag) != 0};
}

std::optional<Here> hereOf(const CanFrame &frame, int address)
{
    if (!isFrom(frame, Message::Here, address, 3))
        return std::nullopt;
    return Here{frame.data[0] == 1, frame.data[1], frame.data[2]};
}

std::optional<ParameterValue> valueOf(const CanFrame &frame, int address)
{
    if (!isFrom(frame, Message::Value, address, 5))
        return std::nullopt;
    return ParameterValue{frame.data[0], i32(frame, 1)};
}

std::optional<DecodedFrame> decode(const CanFrame &frame, std::string_view)
{
    const auto address = static_cast<int>(frame.id & 0xFFU);
    const auto message = static_cast<Message>(frame.id >> 8U & 0xFFU);
    const auto *const row
        = std::find_if(rows.begin(), rows.end(), [message](const Row &one) { return one.message == message; });
    if (address > highestAddress || row == rows.end() || !isFrom(frame, message, address, row->size))
        return std::nullopt;
    return DecodedFrame{"tinker", row->name, address, message == Message::Drive, fieldsOf(message, frame)};
}

} // namespace mb::tinker
