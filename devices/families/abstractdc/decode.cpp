// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/decode.h"

#include "families/abstractdc/protocol.h"
#include "wire/bytes.h"

#include <algorithm>
#include <array>

namespace mb::abstractdc {
namespace {

constexpr std::array<std::string_view, logCount> logNames{
    "position log", "speed log", "current log", "temperature log", "voltage log"};
constexpr std::array<std::string_view, logCount> logUnits{"counts", "counts/s", "ADC counts", "ADC counts", "PWM"};
constexpr std::array<std::string_view, loopCount> loopUnits{"", "counts/s", "ADC counts", "counts", "PWM"};

/// The offset of `frame` when its identifier belongs to this role.
std::optional<int> offsetIn(const CanFrame &frame, std::uint32_t base)
{
    if (frame.id < base || frame.id > base + maxOffset)
        return std::nullopt;
    return static_cast<int>(frame.id - base);
}

template <std::size_t N> std::optional<std::size_t> placeOf(const std::array<int, N> &codes, int code)
{
    const auto found = std::find(codes.begin(), codes.end(), code);
    if (found == codes.end())
        return std::nullopt;
    return static_cast<std::size_t>(found - codes.begin());
}

double valueAt(const CanFrame &frame, std::size_t place)
{
    return static_cast<std::int32_t>(readU32le(frame.data, place));
}

DecodedFrame made(std::string_view message, int offset)
{
    DecodedFrame decoded;
    decoded.family = "abstractdc";
    decoded.message = message;
    decoded.address = offset;
    return decoded;
}

std::optional<DecodedFrame> setPoint(const Dialect &dialect, const CanFrame &frame, int offset)
{
    const auto loop = placeOf(dialect.type, frame.data[0]);
    if (frame.size != (dialect.wide ? 8 : 5) || !loop)
        return std::nullopt;
    DecodedFrame decoded = made("setpoint", offset);
    decoded.control = *loop != 0;
    decoded.fields = {{"TYPE", static_cast<double>(frame.data[0]), {}},
        {"value", valueAt(frame, dialect.wide ? 4 : 1), loopUnits.at(*loop)}};
    return decoded;
}

std::optional<DecodedFrame> settings(const Dialect &dialect, const CanFrame &frame, int offset)
{
    const bool save = frame.size == 1;
    const int type = dialect.wide && !save ? frame.data[0] & 0xF : frame.data[0];
    const int field = dialect.wide ? frame.data[0] >> 4 : frame.data[1];
    const auto loop = placeOf(dialect.type, type);
    const bool hasGains = loop && *loop != 0 && *loop != static_cast<std::size_t>(Loop::Direct);
    if (!hasGains || (!save && (frame.size != (dialect.wide ? 8 : 6) || !placeOf(dialect.field, field))))
        return std::nullopt;
    DecodedFrame decoded = made(save ? "save" : "settings", offset);
    decoded.fields.push_back({"TYPE", static_cast<double>(type), {}});
    if (!save) {
        decoded.fields.push_back({"FIELD", static_cast<double>(field), {}});
        decoded.fields.push_back({"value", valueAt(frame, dialect.wide ? 4 : 2), {}});
    }
    return decoded;
}

std::optional<DecodedFrame> logRequest(const Dialect &dialect, const CanFrame &frame, int offset)
{
    if (frame.size != 1 || !placeOf(dialect.log, frame.data[0]))
        return std::nullopt;
    DecodedFrame decoded = made("log request", offset);
    decoded.fields.push_back({"LOG", static_cast<double>(frame.data[0]), {}});
    return decoded;
}

std::optional<DecodedFrame> logReply(const Dialect &dialect, const CanFrame &frame)
{
    for (std::size_t i = 0; frame.size == 4 && i < logCount; ++i) {
        if (dialect.log.at(i) == absent)
            continue;
        const auto offset = offsetIn(frame, static_cast<std::uint32_t>(dialect.reply.at(i)));
        const bool plain = i == static_cast<std::size_t>(Log::Voltage) && !dialect.voltageOffset;
        if (!offset || (plain && *offset != 0))
            continue;
        DecodedFrame decoded = made(logNames.at(i), *offset);
        decoded.fields.push_back({"value", valueAt(frame, 0), logUnits.at(i)});
        return decoded;
    }
    return std::nullopt;
}

} // namespace

std::optional<DecodedFrame> decodeCan(const CanFrame &frame, std::string_view dialect)
{
    const Dialect *const spoken = dialect.empty() ? &dialectF : dialectByKey(dialect);
    if (!spoken || frame.extended || frame.remote || frame.error || frame.size == 0)
        return std::nullopt;
    if (const auto offset = offsetIn(frame, id::setPoint))
        return setPoint(*spoken, frame, *offset);
    if (const auto offset = offsetIn(frame, id::settings))
        return settings(*spoken, frame, *offset);
    if (const auto offset = offsetIn(frame, spoken->request); offset && frame.size == 1)
        return logRequest(*spoken, frame, *offset);
    return logReply(*spoken, frame);
}

} // namespace mb::abstractdc
