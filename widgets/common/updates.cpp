// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/updates.h"

#include "widgets/common/devicetext.h"

#include <QCoreApplication>

#include <algorithm>

namespace mb {
namespace {

struct UpdateText {
    Q_DECLARE_TR_FUNCTIONS(UpdateText)
};

} // namespace

std::vector<const OperationView *> runningUpdates(const Snapshot &shot)
{
    std::vector<const OperationView *> found;
    for (const OperationView &operation : shot.operations) {
        const OperationStatus &status = operation.status;
        if (status.state == OperationStatus::State::Running && status.kind == OperationKind::UpdateFirmware)
            found.push_back(&operation);
    }
    return found;
}

const OperationView *updateOn(const Snapshot &shot, std::string_view link)
{
    const auto all = runningUpdates(shot);
    const auto found = std::ranges::find_if(all, [&](const OperationView *operation) {
        const DeviceView *device = shot.device(operation->device);
        return device && device->link == link;
    });
    return found == all.end() ? nullptr : *found;
}

QString placeOf(const Snapshot &shot, const OperationView &operation)
{
    const DeviceView *device = shot.device(operation.device);
    if (!device)
        return UpdateText::tr("a device that is gone");
    const LinkView *link = shot.link(device->link);
    return UpdateText::tr("%1 on %2").arg(titleOf(*device), qt(link ? link->name : device->link));
}

} // namespace mb
