// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/editdesk.h"

#include "widgets/parameters/readstatus.h"

#include <algorithm>

namespace mb {

EditDesk &EditDesk::of(Workbench &workbench)
{
    auto *desk = workbench.findChild<EditDesk *>(QString(), Qt::FindDirectChildrenOnly);
    return desk ? *desk : *new EditDesk(workbench);
}

EditDesk::EditDesk(Workbench &workbench)
    : QObject(&workbench)
    , m_workbench(workbench)
{
    connect(&workbench, &Workbench::changed, this, &EditDesk::follow);
}

void EditDesk::follow()
{
    for (const DeviceView &device : m_workbench.snapshot().devices) {
        if (m_desks.count(device.id) != 0)
            (void)editsOf(device);
    }
}

StagedEdits &EditDesk::editsOf(const DeviceView &device)
{
    Desk &desk = m_desks[device.id];
    if (!desk.edits)
        desk.edits = std::make_unique<StagedEdits>(*device.family);
    const bool complete = device.parameters->size() == device.family->parameters.size();
    if (complete && desk.revision != device.parameterRevision) {
        desk.revision = device.parameterRevision; // before anybody hears of it and asks again
        desk.edits->setEntries(*device.parameters);
    }
    return *desk.edits;
}

void EditDesk::readOnce(const DeviceView &device)
{
    const bool unknown = std::ranges::all_of(
        *device.parameters, [](const auto &entry) { return entry.state == ParameterState::Unknown; });
    const bool ready = device.identity->state == DeviceState::Online && device.liveness.heard && device.busy.empty()
        && device.family->capabilities.readback;
    if (unknown && ready && !isUnderWay(m_workbench.snapshot().operation(device.id)) && m_read.insert(device.id).second)
        m_workbench.send(orders::ReadParameters{device.id});
}

StagedEdits *EditDesk::find(DeviceId device)
{
    const auto found = m_desks.find(device);
    return found == m_desks.end() ? nullptr : found->second.edits.get();
}

} // namespace mb
