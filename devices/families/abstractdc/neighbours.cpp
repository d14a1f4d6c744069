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

bool isAnswered(const Dialect &dialect, const Question &question, std::uint32_t identifier)
{
    const bool toAll = question.offset == 0 && question.base == id::logRequest;
    for (std::size_t i = 0; i < logCount && dialect.request == question.base; ++i) {
        const int offset = static_cast<int>(identifier) - dialect.reply.at(i);
        if (dialect.has(static_cast<Log>(i)) && dialect.log.at(i) == question.code && offset > 0 && offset <= maxOffset
            && (toAll || offset == question.offset))
            return true;
    }
    return false;
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
        ask(*question, frame.time);
        return;
    }
    if (frame.size != 4 || isOfOffsetZero(frame.id))
        return;
    const bool isHeard = std::ranges::any_of(m_asked, [&frame](const Asked &asked) {
        return asked.until > frame.time && std::ranges::any_of(dialects, [&](const Dialect *dialect) {
            return isAnswered(*dialect, asked.question, frame.id);
        });
    });
    if (isHeard)
        m_heardAt = frame.time;
}

void Neighbours::ask(const Question &question, Instant time)
{
    std::erase_if(m_asked, [&](const Asked &asked) { return asked.question == question || asked.until <= time; });
    m_asked.push_back({question, time + 2 * answerTime(m_link)});
}

bool Neighbours::areHeard() const
{
    return m_heardAt && m_clock.now() - *m_heardAt <= neighbourMemory;
}

} // namespace mb::abstractdc
