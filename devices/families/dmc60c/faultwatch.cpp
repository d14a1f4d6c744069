// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/faultwatch.h"

#include <utility>

namespace mb::dmc60c {
namespace {

constexpr Duration askEvery = std::chrono::seconds(1);

} // namespace

bool FaultWatch::isDue(Instant now)
{
    if (m_askedAt != Instant{} && now - m_askedAt < askEvery)
        return false;
    m_askedAt = now;
    return true;
}

void FaultWatch::Counter::take(std::uint32_t now, Instant at)
{
    if (const auto before = std::exchange(count, now); before && now > *before)
        roseAt = at;
}

bool FaultWatch::Counter::isFresh(Instant now) const
{
    return roseAt && now - *roseAt < faultHold;
}

void FaultWatch::take(const ParamResponse &response, Instant now)
{
    if (response.status != ParameterStatus::NoError)
        return;
    switch (response.parameter) {
    case param::activeFaults: m_active = response.field; break;
    case param::overCurrentCount: m_overCurrent.take(response.field, now); break;
    case param::communicationCount: m_communication.take(response.field, now); break;
    default: break;
    }
}

std::uint32_t FaultWatch::present(Instant now) const
{
    return (m_active & (faultbit::overCurrent | faultbit::communication))
        | (m_overCurrent.isFresh(now) ? faultbit::overCurrent : 0U)
        | (m_communication.isFresh(now) ? faultbit::communication : 0U);
}

} // namespace mb::dmc60c
