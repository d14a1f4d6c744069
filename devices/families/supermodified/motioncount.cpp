// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/motioncount.h"

#include "families/supermodified/movebounds.h"

#include <cmath>

namespace mb::supermodified {

std::int64_t MotionCount::targetOf(const SetPoint &setPoint) const
{
    const auto target = static_cast<std::int64_t>(std::llround(setPoint.target));
    return isPosition(setPoint.mode) && !setPoint.relative ? target - m_origin : target;
}

void MotionCount::started()
{
    m_origin += m_position.value_or(0);
    m_position = 0;
}

void MotionCount::zeroed()
{
    m_origin = 0;
    m_position = 0;
}

} // namespace mb::supermodified
