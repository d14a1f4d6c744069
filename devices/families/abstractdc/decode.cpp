// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/decode.h"

#include "families/abstractdc/codec.h"
#include "families/abstractdc/questionbook.h"
#include "wire/bytes.h"

#include <algorithm>
#include <array>
#include <string>

namespace mb::abstractdc {
namespace {

constexpr std::array<std::string_view, logCount> logNames{
    "position log", "speed log", "current log", "temperature log", "voltage log"};
constexpr std::array<std::string_view, logCount> logWords{"position", "velocity", "current", "temperature", "duty"};
constexpr std::array<std::string_view, fieldCount> fieldWords{"P", "I", "D", "divisor", "averaging"};
constexpr std::array<std::string_view, loopCount> loopWords{"off", "velocity", "current", "position", "duty"};
constexpr std::array<std::string_view, logCount> logUnits{"counts", "counts/s", "ADC", "ADC", "PWM"};
constexpr std::array<std::string_view, loopCount> loopUnits{"", "counts/s", "ADC", "counts", "PWM"};

/// The offset of `frame` when its identifier belongs to this role.
std::optional<int> offsetIn(const CanFrame &frame, std::uint32_t base)
{
    if (frame.id < base || frame.id > base + maxOffset)
        return std::nullopt;
    return static_cast<int>(frame.id - base);
}

constexpr int untold = -1; ///< address: the same identifier comes from all drives

DecodedFrame made(std::string_view message, int offset)
{
    DecodedFrame decoded;
    decoded.family = "abstractdc";
    decoded.message = message;
    decoded.address = offset;
    return decoded;
}

/// Drives are stopped with both lengths, whatever they speak.
bool isStop(const CanFrame &frame)
{
    return (frame.size == 5 || frame.size == 8)
        && std::all_of(
            frame.data.begin(), frame.data.begin() + frame.size, [](std::uint8_t byte) { return byte == 0; });
}

std::optional<DecodedFrame> setPoint(const Dialect &dialect, const CanFrame &frame, int offset)
{
    DecodedFrame decoded = made("setpoint", offset);
    if (isStop(frame) && dialect.canStop()) {
        decoded.fields = {{"TYPE", 0.0, {}, loopWords[0]}, {"value", 0.0, {}}};
        return decoded;
    }
    const auto loop = decodeSetPoint(dialect, offset, frame);
    if (!loop)
        return std::nullopt;
    const auto value = static_cast<std::int32_t>(readU32le(frame.data, dialect.wide ? 4 : 1));
    decoded.control = *loop != Loop::None;
    const auto which = static_cast<std::size_t>(*loop);
    decoded.fields = {{"TYPE", static_cast<double>(frame.data[0]), {}, loopWords.at(which)},
        {"value", static_cast<double>(value), loopUnits.at(which)}};
    return decoded;
}

std::optional<DecodedFrame> settings(const Dialect &dialect, const CanFrame &frame, int offset)
{
    const auto saved = decodeSave(dialect, offset, frame);
    const auto written = decodeSettings(dialect, offset, frame);
    if (!saved && !written)
        return std::nullopt;
    DecodedFrame decoded = made(saved ? "save" : "settings", offset);
    const Loop loop = saved ? *saved : written->loop;
    decoded.fields
        = {{"TYPE", static_cast<double>(dialect.codeOf(loop)), {}, loopWords.at(static_cast<std::size_t>(loop))}};
    if (written) {
        decoded.fields.push_back({"FIELD", static_cast<double>(dialect.codeOf(written->field)), {},
            fieldWords.at(static_cast<std::size_t>(written->field))});
        decoded.fields.push_back({"value", static_cast<double>(written->value), {}});
    }
    return decoded;
}

/// Of any dialect: a scan asks in all of them, and a question means the same to whoever understands it.
std::optional<DecodedFrame> logRequest(const CanFrame &frame)
{
    for (const Dialect *dialect : dialects) {
        const auto offset = offsetIn(frame, dialect->request);
        const auto log = std::ranges::find(dialect->log, frame.data[0]);
        if (frame.size != 1 || !offset || log == dialect->log.end())
            continue;
        DecodedFrame decoded = made("log request", *offset);
        decoded.fields.push_back({"LOG", static_cast<double>(frame.data[0]), {},
            logWords.at(static_cast<std::size_t>(log - dialect->log.begin()))});
        return decoded;
    }
    return std::nullopt;
}

std::optional<DecodedFrame> logReply(const Dialect &dialect, const CanFrame &frame)
{
    for (std::size_t i = 0; i < logCount; ++i) {
        const auto offset = offsetIn(frame, static_cast<std::uint32_t>(dialect.reply.at(i)));
        const auto reply = offset ? decodeLog(dialect, *offset, frame) : std::nullopt;
        if (!reply || reply->log != static_cast<Log>(i))
            continue;
        const bool plain = reply->log == Log::Voltage && !dialect.voltageOffset;
        DecodedFrame decoded = made(logNames.at(i), plain ? untold : *offset);
        decoded.fields.push_back({"value", static_cast<double>(reply->value), logUnits.at(i)});
        return decoded;
    }
    return std::nullopt;
}

constexpr Duration voltagePatience = std::chrono::seconds(1); ///< an answer at 1250 bit/s takes 128 ms

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
    if (auto request = logRequest(frame))
        return request;
    return logReply(*spoken, frame);
}

CanDecoder followCan(std::string_view dialect)
{
    return [dialect = std::string(dialect), asked = QuestionBook()](const CanFrame &frame) mutable {
        auto decoded = decodeCan(frame, dialect);
        if (!decoded)
            return decoded;
        asked.expire(frame.time);
        const auto question = questionIn(frame);
        if (question && question->code == dialectF.codeOf(Log::Voltage)) {
            asked.ask(*question, frame.time, voltagePatience);
        } else if (frame.id == id::voltageLog && decoded->message == logNames.at(static_cast<std::size_t>(Log::Voltage))
            && asked.open().size() == 1) { // its identifier does not tell from whom it comes (README.md#dialects)
            const Question answered = asked.open().front().question;
            decoded->address = answered.offset;
            asked.close(answered);
        }
        return decoded;
    };
}

} // namespace mb::abstractdc
