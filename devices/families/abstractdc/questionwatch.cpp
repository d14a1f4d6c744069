// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/questionwatch.h"

#include "families/abstractdc/codec.h"
#include "families/abstractdc/voltagewatch.h"

#include <algorithm>

namespace mb::abstractdc {
namespace {

bool mayAnswer(int offset, std::uint8_t code, std::uint32_t id)
{
    for (const Dialect *dialect : {&dialectF, &dialectL, &dialectD}) {
        for (std::size_t i = 0; i < logCount; ++i) {
            const auto log = static_cast<Log>(i);
            if (dialect->has(log) && dialect->codeOf(log) == code && replyId(*dialect, offset, log) == id)
                return true;
        }
    }
    return false;
}

} // namespace

QuestionWatch::QuestionWatch(CanLink &link, Clock &clock)
    : m_link(link)
    , m_clock(clock)
    , m_traffic(link.traffic().add([this](const Traffic &traffic) {
        if (traffic.can)
            pass(*traffic.can);
    }))
{
}

void QuestionWatch::attend(int offset, std::uint8_t code)
{
    m_attended = {offset, code, {}};
    std::erase_if(m_open, [&](const Question &open) { return open.offset == offset && open.code == code; });
}

void QuestionWatch::pass(const CanFrame &frame)
{
    m_isForOthers = false;
    if (frame.extended || frame.error || frame.remote)
        return;
    std::erase_if(m_open, [now = m_clock.now()](const Question &open) { return open.until <= now; });
    if (frame.size == 1 && frame.id >= id::logRequest && frame.id <= id::logRequest + maxOffset) {
        const int offset = static_cast<int>(frame.id - id::logRequest);
        if (offset != m_attended.offset || frame.data[0] != m_attended.code)
            m_open.push_back({offset, frame.data[0], m_clock.now() + 2 * answerTime(m_link)});
    } else if (frame.size == 4) {
        const auto asked = std::find_if(m_open.begin(), m_open.end(),
            [&frame](const Question &open) { return mayAnswer(open.offset, open.code, frame.id); });
        m_isForOthers = asked != m_open.end();
        if (m_isForOthers)
            m_open.erase(asked);
    }
}

} // namespace mb::abstractdc
