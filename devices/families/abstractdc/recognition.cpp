// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/recognition.h"

#include "families/abstractdc/scan.h"

#include <QtGlobal>

#include <algorithm>

namespace mb::abstractdc {
namespace {

constexpr Duration answerPatience = std::chrono::seconds(1); ///< an answer at 1250 bit/s takes 128 ms

} // namespace

std::optional<Identity> Recognition::take(const CanFrame &frame)
{
    if (frame.extended || frame.remote || frame.error)
        return std::nullopt;
    if (const auto question = questionIn(frame))
        m_book.ask(*question, frame.time, answerPatience);
    if (frame.size != 4)
        return std::nullopt;
    m_book.expire(frame.time);
    const std::vector<Explanation> all = m_book.explain(frame.id);
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
