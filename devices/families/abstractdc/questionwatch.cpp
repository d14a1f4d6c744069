// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/questionwatch.h"

#include "families/abstractdc/answertime.h"

#include <algorithm>

namespace mb::abstractdc {
namespace {

constexpr Duration longestHeldBack = std::chrono::seconds(1);
constexpr Duration neighbourMemory = std::chrono::seconds(5);

} // namespace

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
    if (const auto question = questionIn(frame)) {
        m_book.ask(*question, frame.time, 2 * answerTime(m_link));
        if (question->offset == 0 && question->base == id::logRequest)
            m_toAll.ask(*question, frame.time, 2 * answerTime(m_link));
    } else if (frame.size == 4) {
        m_book.expire(frame.time);
        m_toAll.expire(frame.time);
        m_explained = m_book.explain(frame.id);
        if (isOfAnother(frame.id))
            m_othersAt = frame.time;
        settle();
    }
}

/// Offset 0 itself, in whatever dialect, is none.
bool QuestionWatch::isOfAnother(std::uint32_t identifier) const
{
    const bool isOfZero = std::ranges::any_of(dialects, [identifier](const Dialect *dialect) {
        return std::ranges::find(dialect->reply, static_cast<int>(identifier)) != dialect->reply.end();
    });
    return !isOfZero
        && (!m_explained.empty() || std::ranges::any_of(m_toAll.open(), [identifier](const QuestionBook::Open &open) {
               return !explain(open.question, identifier, true).empty();
           }));
}

bool QuestionWatch::hearsOthers() const
{
    return m_othersAt && m_clock.now() - *m_othersAt <= neighbourMemory;
}

/// It wins over every answer on the wire, which comes so much later.
void QuestionWatch::holdBack(const CanFrame &order)
{
    const Duration time = m_link.wireTime(order);
    if (time == Duration::zero())
        return;
    for (QuestionBook::Open &open : m_book.open())
        open.until = std::min(open.until + time, m_clock.now() + longestHeldBack);
}

/// Where one question explains what is passing, it is answered; where one dialect does, its drive speaks that.
void QuestionWatch::settle()
{
    if (m_explained.empty() || isToAll(m_explained.front().question))
        return;
    const Question question = m_explained.front().question;
    if (std::ranges::any_of(m_explained, [&](const Explanation &other) { return !(other.question == question); }))
        return;
    if (m_explained.size() == 1)
        m_heard.at(static_cast<std::size_t>(question.offset)) = m_explained.front().dialect;
    m_book.close(question);
}

bool QuestionWatch::isAnswerTo(const Question &question) const
{
    const auto is = [&question](const Explanation &one) { return one.question == question; };
    return std::ranges::any_of(m_explained, is)
        && std::ranges::all_of(m_explained, [&](const Explanation &one) { return is(one) || isToAll(one.question); });
}

bool QuestionWatch::answersOnly(std::uint8_t code) const
{
    return !m_explained.empty()
        && std::ranges::all_of(m_explained, [code](const Explanation &one) { return one.question.code == code; });
}

bool QuestionWatch::isOf(int offset, const Dialect *dialect) const
{
    if (!dialect)
        return isAnswerTo({offset, id::logRequest, static_cast<std::uint8_t>(dialectF.codeOf(Log::Velocity))});
    bool asked = false;
    for (const Explanation &one : m_explained) {
        if (one.question.offset == offset || isToAll(one.question)) {
            asked = asked || (one.offset == offset && one.dialect == dialect);
            continue;
        }
        // A scan looks for drives of the oldest dialect under every offset, and there is hardly ever one.
        const Dialect *const heard = m_heard.at(static_cast<std::size_t>(one.question.offset));
        if (one.question.base == id::logRequest && (!heard || heard == one.dialect))
            return false;
    }
    return asked;
}

bool QuestionWatch::hears(const Dialect &dialect) const
{
    return std::ranges::find(m_heard, &dialect) != m_heard.end();
}

bool QuestionWatch::isOpen(const Question &question) const
{
    return std::ranges::any_of(m_book.open(), [&, now = m_clock.now()](const QuestionBook::Open &open) {
        return open.question == question && open.until > now;
    });
}

bool QuestionWatch::isFree(const Question &question, std::uint32_t answer) const
{
    return std::ranges::none_of(m_book.open(), [&, now = m_clock.now()](const QuestionBook::Open &open) {
        return !(open.question == question) && !isToAll(open.question) && open.question.base == id::logRequest
            && open.until > now && !explain(open.question, answer, false).empty();
    });
}

} // namespace mb::abstractdc
