// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/motionrenewal.h"

#include "model/leaserenewal.h"

#include <algorithm>

namespace mb {

MotionRenewal::MotionRenewal(Workbench &workbench)
    : m_workbench(workbench)
{
    m_timer.setInterval(LeaseRenewal::period);
    connect(&m_timer, &QTimer::timeout, this, &MotionRenewal::renew);
}

void MotionRenewal::keep(std::vector<DeviceId> devices)
{
    m_devices = std::move(devices);
    m_silence = {};
    m_renewedAt = m_workbench.now();
    if (m_devices.empty())
        m_timer.stop();
    else
        m_timer.start();
}

Duration MotionRenewal::silence() const
{
    return std::max<Duration>(m_silence, m_workbench.now() - m_renewedAt);
}

void MotionRenewal::renew()
{
    if (m_condition && !m_condition())
        return;
    m_silence = silence();
    m_renewedAt = m_workbench.now();
    for (const DeviceId device : m_devices)
        m_workbench.send(orders::RenewMotion{device});
}

} // namespace mb
