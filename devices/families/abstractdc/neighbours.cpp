// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/neighbours.h"

#include "families/abstractdc/answertime.h"

#include <algorithm>

namespace mb::abstractdc {
namespace {

constexpr Duration neighbourMemory = std::chrono::seconds(5);

bool isOfOffsetZero(std::uint32_t identifier)
{
    return std::ranges::any_of(dialects, [identifier](const Dialect *dialect) {
        return std::ranges::find(dialect->reply, static_cast<int>(identifier)) != dialect->reply.end();
    });
}

} // namespace

Neighbours::Neighbours(CanLink &link, Clock &clock)
    : m_link(link)
    , m_clock(clock)
    , m_traffic(link.traffic().add([this](const Traffic &traffic) {
        if (traffic.can)
            pass(*traffic.can);
    }))
{
}

void Neighbours::pass(const CanFrame &frame)
{
    if (frame.extended || frame.error || frame.remote)
        return;
    if (const auto question = questionIn(frame)) {
        m_book.ask(*question, frame.time, 2 * answerTime(m_link));
        return;
    }
    if (frame.size != 4 || isOfOffsetZero(frame.id))
        return;
    m_book.expire(frame.time);
    const bool isHeard = std::ranges::any_of(m_book.open(), [&frame](const QuestionBook::Open &open) {
        const bool everybody = open.question.offset == 0 && open.question.base == id::logRequest;
        return !explain(open.question, frame.id, everybody).empty();
    });
    if (isHeard)
        m_heardAt = frame.time;
}

bool Neighbours::areHeard() const
{
    return m_heardAt && m_clock.now() - *m_heardAt <= neighbourMemory;
}

} // namespace mb::abstractdc
