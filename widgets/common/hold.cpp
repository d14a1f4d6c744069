// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/hold.h"

#include <QTimerEvent>

#include <algorithm>

namespace mb {

void Hold::begin(QObject *receiver)
{
    m_sum = 0;
    m_sinceTick.start();
    m_ticks.start(std::clamp(m_whole / 10, 1, 16), Qt::PreciseTimer, receiver);
}

double Hold::progress() const
{
    return isUnderWay() ? std::min(1.0, static_cast<double>(m_sum) / std::max(m_whole, 1)) : 0.0;
}

bool Hold::tick(const QTimerEvent &event)
{
    if (event.timerId() != m_ticks.timerId())
        return false;
    m_sum += std::min(m_sinceTick.restart(), mostOfATick);
    return true;
}

} // namespace mb
