// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/leadprobe.h"

#include "families/abstractdc/protocol.h"

#include <algorithm>
#include <cstdlib>

namespace mb::abstractdc {
namespace {

constexpr double growth = 4.0;
constexpr double furthest = 2147483647.0;

} // namespace

void LeadProbe::limit(double most)
{
    m_most = std::min(m_most, most);
    m_far = false; // what was seen before says nothing of it
}

void LeadProbe::sent(bool far, Instant now)
{
    if (far && !m_far)
        m_since = now;
    m_far = far;
}

void LeadProbe::heard(std::int32_t output, Instant time)
{
    if (!m_far || time < m_since + 2 * loopPeriod || std::abs(std::int64_t{output}) >= fullPwm)
        return;
    m_most = std::min(furthest, m_most * growth);
    m_far = false; // begins anew with the next set-point
}

} // namespace mb::abstractdc
