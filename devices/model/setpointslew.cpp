// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/setpointslew.h"

#include <algorithm>

namespace mb {

void SetPointSlew::start(double present, Instant now)
{
    m_value = present;
    m_target = present;
    m_at = now;
}

double SetPointSlew::advance(Instant now)
{
    const double seconds = std::chrono::duration<double>(now - m_at).count();
    m_at = now;
    if (m_rate <= 0.0) {
        m_value = m_target;
        return m_value;
    }
    const double most = m_rate * std::max(seconds, 0.0);
    m_value += std::clamp(m_target - m_value, -most, most);
    return m_value;
}

} // namespace mb
