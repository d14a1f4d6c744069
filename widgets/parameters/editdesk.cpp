// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/editdesk.h"

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

StagedEdits *EditDesk::find(DeviceId device)
{
    const auto found = m_desks.find(device);
    return found == m_desks.end() ? nullptr : found->second.edits.get();
}

} // namespace mb
