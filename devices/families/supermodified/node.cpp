// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/node.h"

namespace mb::supermodified {
namespace {

/// Codes that a command earns by itself, so that repeating it earns them again.
bool isVerdict(std::uint8_t code)
{
    return code >= code::invalidCommand && code <= code::invalidGetCount;
}

Error refusal(std::span<const std::uint8_t> codes, bool reading)
{
    Error error{Fault::Refused, codesText(codes)};
    if (reading && codes.back() == code::invalidGetCount)
        error.remedy = say("its error level is 1, which makes every reading fail: set error.level to 0");
    return error;
}

} // namespace

Line::Request asking(const Node &node, Command command)
{
    Line::Request ask;
    ask.frame = request(node.id, 0, command);
    ask.baudrate = node.baudrate;
    const Format format = isGet(ask.frame.command) ? formatOf(command, node.dialect.value_or(Dialect::D3))
                                                   : Format::None; // before the dialect is known, wait for the longest
    ask.replySize = format == Format::Codes ? mostCodes : sizeOf(format);
    return ask;
}

Result<Line::Request> setting(const Node &node, Command command, std::int64_t value)
{
    if (!node.dialect)
        return fail(Fault::Unsupported, say("its dialect is not known yet"), say("read it first"));
    MB_TRY(const auto frame, request(node.id, 0, command, *node.dialect, value));
    Line::Request ask;
    ask.frame = frame;
    ask.baudrate = node.baudrate;
    const CommandForm *const message = messageOf(frame.command);
    if (message != nullptr && message->stored)
        ask.patience = storedAnswerTime + eepromByteTime * static_cast<int>(frame.size);
    return ask;
}

Line::Request telling(const Node &node, Command command)
{
    Line::Request tell;
    tell.frame = request(broadcastId, 0, command);
    tell.baudrate = node.baudrate;
    tell.answered = false;
    return tell;
}

Task<Frame> converse(Line &line, Line::Request request, CodeSink codes, int tries)
{
    Error last{Fault::Timeout, say("no answer")};
    int verdicts = 0;
    for (int attempt = 0; attempt < line.link().settings().patience.tries(tries); ++attempt) {
        const Result<Frame> reply = co_await ask(line, request).attempt();
        if (!reply && reply.error().fault != Fault::Timeout)
            co_return fail(reply.error());
        if (!reply) {
            last = reply.error();
            continue;
        }
        const auto reported = codesOf(*reply);
        if (!reported)
            co_return *reply;
        if (codes)
            codes(*reported);
        last = refusal(*reported, isGet(request.frame.command));
        if (isVerdict(reported->back()) && ++verdicts == 2)
            break;
    }
    co_return fail(last);
}

} // namespace mb::supermodified
