// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connection/firstselection.h"

#include <algorithm>

namespace mb {

bool canBeTuned(const DeviceView &device)
{
    const Family &family = *device.family;
    return device.identity->state == DeviceState::Online && device.mayNotMove.empty() && family.capabilities.readback
        && family.trials && !family.trials->loops.empty();
}

void FirstSelection::follow(const Snapshot &shot)
{
    const DeviceId selected = m_selection.device();
    const bool mayChoose = selected.value == 0 || selected == m_chosen;
    if (shot.devices.empty() || !mayChoose)
        return;
    const auto found = std::ranges::find_if(shot.devices, canBeTuned);
    const DeviceId next = found == shot.devices.end() ? shot.devices.front().id : found->id;
    m_chosen = found == shot.devices.end() ? next : DeviceId{};
    if (selected.value == 0 || found != shot.devices.end())
        m_selection.offer(next);
}

} // namespace mb
