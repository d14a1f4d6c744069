// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/questionwatch.h"

#include "families/abstractdc/answertime.h"
#include "families/abstractdc/codec.h"

#include <algorithm>

namespace mb::abstractdc {
namespace {

constexpr Duration longestHeldBack = std::chrono::seconds(1);

/// Only for the speed, the one code that all dialects share; the same as a question to the drive with offset 0.
bool isToAll(const Question &question)
{
    return question == Question{0, id::logRequest, static_cast<std::uint8_t>(dialectF.codeOf(Log::Velocity))};
}

bool mayAnswer(const Dialect &dialect, const Question &question, int offset, std::uint32_t identifier)
{
    for (std::size_t i = 0; i < logCount && dialect.request == question.base; ++i) {
        const auto log = static_cast<Log>(i);
        if (dialect.has(log) && dialect.codeOf(log) == question.code && replyId(dialect, offset, log) == identifier)
            return true;
    }
    return false;
}

bool mayAnswer(const Question &question, std::uint32_t identifier)
{
    return std::ranges::any_of(dialects, [&](const Dialect *dialect) {
        const int first = static_cast<int>(identifier)
            - static_cast<int>(dialect->reply.at(static_cast<std::size_t>(Log::Velocity)));
        const int offset = isToAll(question) && first >= 0 && first <= maxOffset ? first : question.offset;
        return mayAnswer(*dialect, question, offset, identifier);
    });
}

} // namespace

std::optional<Question> questionIn(const CanFrame &frame)
{
    for (const std::uint32_t base : {id::logRequest, id::logRequestOld}) {
        if (frame.size == 1 && frame.id >= base && frame.id <= base + maxOffset)
            return Question{static_cast<int>(frame.id - base), base, frame.data[0]};
    }
    return std::nullopt;
}

QuestionWatch::QuestionWatch(CanLink &link, Clock &clock)
    : m_link(link)
    , m_clock(clock)
    , m_traffic(link.traffic().add([this](const Traffic &traffic) {
        if (traffic.can)
            pass(*traffic.can);
        if (traffic.can && traffic.can->extended && traffic.direction == Direction::Sent)
            holdBack(*traffic.can);
    }))
{
}

void QuestionWatch::pass(const CanFrame &frame)
{
    m_explained.clear();
    if (frame.extended || frame.error || frame.remote)
        return;
    if (const auto question = questionIn(frame))
        ask(*question, frame.time);
    else if (frame.size == 4) {
        std::erase_if(m_open, [&frame](const Open &open) { return open.until <= frame.time; });
        answer(frame.id);
    }
}

/// It wins over every answer on the wire, which comes so much later.
void QuestionWatch::holdBack(const CanFrame &order)
{
    const Duration time = m_link.wireTime(order);
    if (time == Duration::zero())
        return;
    for (Open &open : m_open)
        open.until = std::min(open.until + time, m_clock.now() + longestHeldBack);
}

void QuestionWatch::ask(const Question &question, Instant time)
{
    std::erase_if(m_open, [&](const Open &open) { return open.question == question || open.until <= time; });
    m_open.push_back({question, time + 2 * answerTime(m_link)});
}

void QuestionWatch::answer(std::uint32_t identifier)
{
    m_passing = identifier;
    for (const Open &open : m_open) {
        if (mayAnswer(open.question, identifier))
            m_explained.push_back(open.question);
    }
    if (m_explained.size() != 1 || isToAll(m_explained.front()))
        return;
    learn(m_explained.front());
    std::erase_if(m_open, [this](const Open &open) { return open.question == m_explained.front(); });
}

void QuestionWatch::learn(const Question &question)
{
    std::vector<const Dialect *> fitting;
    for (const Dialect *dialect : dialects) {
        if (mayAnswer(*dialect, question, question.offset, m_passing))
            fitting.push_back(dialect);
    }
    if (fitting.size() == 1)
        m_heard.at(static_cast<std::size_t>(question.offset)) = fitting.front();
}

bool QuestionWatch::isAnswerTo(const Question &question) const
{
    const auto is = [&question](const Question &other) { return other == question; };
    return std::ranges::any_of(m_explained, is)
        && std::ranges::all_of(m_explained, [&](const Question &other) { return is(other) || isToAll(other); });
}

bool QuestionWatch::answersOnly(std::uint8_t code) const
{
    return !m_explained.empty()
        && std::ranges::all_of(m_explained, [code](const Question &question) { return question.code == code; });
}

bool QuestionWatch::isOf(int offset, const Dialect *dialect) const
{
    if (!dialect) {
        return isAnswerTo({offset, id::logRequest, static_cast<std::uint8_t>(dialectF.codeOf(Log::Velocity))});
    }
    bool asked = false;
    for (const Question &question : m_explained) {
        if (question.offset == offset || isToAll(question)) {
            asked = asked || mayAnswer(*dialect, question, offset, m_passing);
            continue;
        }
        // A scan looks for drives of the oldest dialect under every offset, and there is hardly ever one.
        const Dialect *const heard = m_heard.at(static_cast<std::size_t>(question.offset));
        if (question.base == id::logRequest && (!heard || mayAnswer(*heard, question, question.offset, m_passing)))
            return false;
    }
    return asked;
}

bool QuestionWatch::isOpen(const Question &question) const
{
    return std::ranges::any_of(
        m_open, [&, now = m_clock.now()](const Open &open) { return open.question == question && open.until > now; });
}

bool QuestionWatch::isFree(const Question &question, std::uint32_t answer) const
{
    return std::ranges::none_of(m_open, [&, now = m_clock.now()](const Open &open) {
        return !(open.question == question) && !isToAll(open.question) && open.question.base == id::logRequest
            && open.until > now && mayAnswer(open.question, answer);
    });
}

} // namespace mb::abstractdc
