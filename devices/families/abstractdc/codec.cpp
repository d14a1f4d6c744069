// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/codec.h"

#include "wire/bytes.h"

#include <algorithm>
#include <vector>

namespace mb::abstractdc {
namespace {

std::uint32_t at(std::uint32_t base, int offset)
{
    return base + static_cast<std::uint32_t>(offset);
}

std::uint8_t byteOf(int code)
{
    return static_cast<std::uint8_t>(code);
}

CanFrame withValue(std::uint32_t identifier, std::vector<std::uint8_t> bytes, std::int32_t value)
{
    const std::size_t place = bytes.size();
    bytes.resize(place + 4);
    writeU32le(bytes, place, static_cast<std::uint32_t>(value));
    return standardFrame(identifier, bytes);
}

bool isFor(const CanFrame &frame, std::uint32_t base, int offset)
{
    return !frame.extended && !frame.remote && !frame.error && (frame.id == base || frame.id == at(base, offset));
}

template <class Name, std::size_t N> std::optional<Name> nameOf(const std::array<int, N> &codes, int code)
{
    const auto found = std::ranges::find(codes, code);
    if (code == absent || found == codes.end())
        return std::nullopt;
    return static_cast<Name>(found - codes.begin());
}

} // namespace

CanFrame encodeSetPoint(const Dialect &dialect, int offset, Loop loop, std::int32_t value)
{
    const std::uint8_t type = byteOf(dialect.codeOf(loop));
    if (dialect.wide)
        return withValue(at(id::setPoint, offset), {type, 0, 0, 0}, value);
    return withValue(at(id::setPoint, offset), {type}, value);
}

CanFrame encodeSettings(const Dialect &dialect, int offset, Loop loop, Field field, std::int32_t value)
{
    const int type = dialect.codeOf(loop);
    const int name = dialect.codeOf(field);
    if (dialect.wide)
        return withValue(at(id::settings, offset), {byteOf(type | name * 16), 0, 0, 0}, value);
    return withValue(at(id::settings, offset), {byteOf(type), byteOf(name)}, value);
}

CanFrame encodeSave(const Dialect &dialect, int offset, Loop loop)
{
    const std::array data{byteOf(dialect.codeOf(loop))};
    return standardFrame(at(id::settings, offset), data);
}

CanFrame encodeLogRequest(const Dialect &dialect, int offset, Log log)
{
    const std::array data{byteOf(dialect.codeOf(log))};
    return standardFrame(at(dialect.request, offset), data);
}

std::array<CanFrame, 2> stopFrames(int offset)
{
    const std::array<std::uint8_t, 8> nothing{};
    const std::span<const std::uint8_t> bytes(nothing);
    return {standardFrame(at(id::setPoint, offset), bytes.first(5)), standardFrame(at(id::setPoint, offset), bytes)};
}

std::uint32_t replyId(const Dialect &dialect, int offset, Log log)
{
    const bool plain = log == Log::Voltage && !dialect.voltageOffset;
    return static_cast<std::uint32_t>(dialect.reply.at(static_cast<std::size_t>(log)) + (plain ? 0 : offset));
}

std::optional<LogReply> decodeLog(const Dialect &dialect, int offset, const CanFrame &frame)
{
    if (frame.extended || frame.remote || frame.error || frame.size != 4)
        return std::nullopt;
    for (std::size_t i = 0; i < logCount; ++i) {
        const auto log = static_cast<Log>(i);
        if (dialect.has(log) && frame.id == replyId(dialect, offset, log))
            return LogReply{log, static_cast<std::int32_t>(readU32le(frame.data, 0))};
    }
    return std::nullopt;
}

std::optional<Loop> decodeSetPoint(const Dialect &dialect, int offset, const CanFrame &frame)
{
    if (!isFor(frame, id::setPoint, offset) || frame.size != (dialect.wide ? 8 : 5))
        return std::nullopt;
    return nameOf<Loop>(dialect.type, frame.data[0]);
}

std::optional<SettingsFrame> decodeSettings(const Dialect &dialect, int offset, const CanFrame &frame)
{
    if (!isFor(frame, id::settings, offset) || frame.size != (dialect.wide ? 8 : 6))
        return std::nullopt;
    const auto loop = nameOf<Loop>(dialect.type, dialect.wide ? frame.data[0] & 0xF : frame.data[0]);
    const auto field = nameOf<Field>(dialect.field, dialect.wide ? frame.data[0] >> 4 : frame.data[1]);
    if (!loop || !field || *loop == Loop::None || *loop == Loop::Direct)
        return std::nullopt;
    return SettingsFrame{*loop, *field, static_cast<std::int32_t>(readU32le(frame.data, dialect.wide ? 4 : 2))};
}

std::optional<Loop> decodeSave(const Dialect &dialect, int offset, const CanFrame &frame)
{
    if (!isFor(frame, id::settings, offset) || frame.size != 1)
        return std::nullopt;
    const auto loop = nameOf<Loop>(dialect.type, frame.data[0]);
    return loop == Loop::None || loop == Loop::Direct ? std::nullopt : loop;
}

} // namespace mb::abstractdc
