// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/recognition.h"

#include "families/abstractdc/codec.h"
#include "families/abstractdc/scan.h"

#include <QtGlobal>

#include <algorithm>

namespace mb::abstractdc {
namespace {

constexpr Duration answerPatience = std::chrono::seconds(1); ///< an answer at 1250 bit/s takes 128 ms
constexpr std::size_t mostAsked = 256;                       ///< in a second; a scan sends a hundred

bool isQuestion(const CanFrame &frame)
{
    return frame.size == 1 && frame.id >= id::logRequestOld && frame.id <= id::logRequest + maxOffset;
}

/// Only scans ask everybody at once, for the speed: the one code that all dialects share.
bool isToAll(int offset, int code)
{
    return offset == 0 && code == dialectF.codeOf(Log::Velocity);
}

bool answers(const Dialect &dialect, int offset, int code, std::uint32_t identifier)
{
    for (std::size_t i = 0; i < logCount; ++i) {
        const auto log = static_cast<Log>(i);
        if (dialect.has(log) && dialect.codeOf(log) == code && replyId(dialect, offset, log) == identifier)
            return true;
    }
    return false;
}

} // namespace

std::optional<Identity> Recognition::take(const CanFrame &frame)
{
    if (frame.extended || frame.remote || frame.error)
        return std::nullopt;
    if (isQuestion(frame))
        ask(frame);
    if (frame.size != 4)
        return std::nullopt;
    const std::vector<Explanation> all = explain(frame);
    if (all.empty())
        return std::nullopt;
    const Explanation &first = all.front();
    const auto differs = [&first](auto member) {
        return [&first, member](const Explanation &other) { return other.*member != first.*member; };
    };
    if (std::ranges::any_of(all, differs(&Explanation::offset)))
        return std::nullopt;
    const bool isProof = std::ranges::none_of(all, differs(&Explanation::dialect));
    return identityOf(first.offset, isProof ? first.dialect : nullptr);
}

void Recognition::ask(const CanFrame &frame)
{
    const std::uint32_t base = frame.id >= id::logRequest ? id::logRequest : id::logRequestOld;
    const Question question{base, static_cast<int>(frame.id - base), frame.data[0], frame.time};
    std::erase_if(m_asked, [&question](const Question &old) {
        const bool same = old.base == question.base && old.offset == question.offset && old.code == question.code;
        return same || question.time - old.time > answerPatience;
    });
    if (m_asked.size() >= mostAsked)
        m_asked.erase(m_asked.begin());
    m_asked.push_back(question);
}

/// Every drive that the questions of the last second could have made send this: those that were answered, too, because two
/// may have asked the same.
std::vector<Recognition::Explanation> Recognition::explain(const CanFrame &answer) const
{
    std::vector<Explanation> all;
    for (const Question &question : m_asked) {
        if (answer.time - question.time > answerPatience)
            continue;
        const int last = isToAll(question.offset, question.code) ? maxOffset : question.offset;
        for (const Dialect *dialect : dialects) {
            for (int offset = question.offset; offset <= last; ++offset) {
                if (dialect->request == question.base && answers(*dialect, offset, question.code, answer.id))
                    all.push_back({offset, dialect});
            }
        }
    }
    return all;
}

Identity Recognition::identityOf(int offset, const Dialect *dialect)
{
    const Dialect *&proven = m_proven.at(static_cast<std::size_t>(offset));
    const bool differs = proven && dialect && proven != dialect;
    proven = proven ? proven : dialect;
    Identity identity = abstractdc::identityOf(offset, proven);
    if (!proven)
        identity.detail
            = say("The recording does not tell which codes it speaks: it was asked for what all answer alike.");
    if (!differs)
        return identity;
    identity.state = DeviceState::Duplicate;
    identity.detail = say("Drives of two dialects answer with this offset in the recording.");
    return identity;
}

} // namespace mb::abstractdc
