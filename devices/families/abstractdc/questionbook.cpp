// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/questionbook.h"

#include <algorithm>

namespace mb::abstractdc {
namespace {

constexpr std::size_t mostOpen = 256; ///< a scan asks a hundred

} // namespace

std::optional<Question> questionIn(const CanFrame &frame)
{
    for (const std::uint32_t base : {id::logRequest, id::logRequestOld}) {
        if (frame.size == 1 && frame.id >= base && frame.id <= base + maxOffset)
            return Question{static_cast<int>(frame.id - base), base, frame.data[0]};
    }
    return std::nullopt;
}

bool isToAll(const Question &question)
{
    return question == Question{0, id::logRequest, static_cast<std::uint8_t>(dialectF.codeOf(Log::Velocity))};
}

std::vector<Explanation> explain(const Question &question, std::uint32_t identifier, bool everybody)
{
    std::vector<Explanation> all;
    for (const Dialect *dialect : dialects) {
        const auto log = std::ranges::find(dialect->log, static_cast<int>(question.code));
        if (dialect->request != question.base || log == dialect->log.end())
            continue;
        const auto which = static_cast<std::size_t>(log - dialect->log.begin());
        const int above = static_cast<int>(identifier) - dialect->reply.at(which);
        const bool isPlain = which == static_cast<std::size_t>(Log::Voltage) && !dialect->voltageOffset;
        const int offset = isPlain && above == 0 ? question.offset : above;
        const bool isLegal = offset >= 0 && offset <= maxOffset && (!isPlain || above == 0);
        if (isLegal && (everybody || offset == question.offset))
            all.push_back({question, offset, dialect});
    }
    return all;
}

void QuestionBook::ask(const Question &question, Instant time, Duration patience)
{
    expire(time);
    close(question);
    if (m_open.size() >= mostOpen)
        m_open.erase(m_open.begin());
    m_open.push_back({question, time + patience});
}

void QuestionBook::close(const Question &question)
{
    std::erase_if(m_open, [&question](const Open &open) { return open.question == question; });
}

void QuestionBook::expire(Instant now)
{
    std::erase_if(m_open, [now](const Open &open) { return open.until <= now; });
}

std::vector<Explanation> QuestionBook::explain(std::uint32_t identifier) const
{
    std::vector<Explanation> all;
    for (const Open &open : m_open) {
        const auto own = abstractdc::explain(open.question, identifier, isToAll(open.question));
        all.insert(all.end(), own.begin(), own.end());
    }
    return all;
}

} // namespace mb::abstractdc
