// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/updates.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/serviceview.h"
#include "widgets/common/workbench.h"

#include <QCoreApplication>

#include <algorithm>
#include <iterator>

namespace mb {
namespace {

struct UpdateText {
    Q_DECLARE_TR_FUNCTIONS(UpdateText)
};

bool isWritten(const service::QueueRow &row)
{
    return row.state == service::RowState::Running && row.visit.step == service::Step::Firmware;
}

OperationView showing(const service::QueueRow &row)
{
    OperationView update;
    update.device = row.device;
    update.status.kind = OperationKind::UpdateFirmware;
    update.status.step = row.what;
    update.status.done = row.done;
    update.status.total = row.total;
    update.status.mayInterrupt = row.mayInterrupt;
    update.status.parts = row.parts;
    return update;
}

} // namespace

std::vector<OperationView> runningUpdates(const Workbench &workbench)
{
    std::vector<OperationView> found;
    std::ranges::copy_if(
        workbench.snapshot().operations, std::back_inserter(found), [](const OperationView &operation) {
            const OperationStatus &status = operation.status;
            return status.state == OperationStatus::State::Running && status.kind == OperationKind::UpdateFirmware;
        });
    for (const service::QueueRow &row : workbench.service().rows) {
        if (isWritten(row))
            found.push_back(showing(row));
    }
    return found;
}

std::optional<OperationView> updateOn(const Workbench &workbench, const std::string &link)
{
    for (OperationView &update : runningUpdates(workbench)) {
        const DeviceView *device = workbench.snapshot().device(update.device);
        if (device && device->link == link)
            return std::move(update);
    }
    return {};
}

bool isServed(const Workbench &workbench, const std::string &link)
{
    const ServiceView &service = workbench.service();
    return service.running && std::ranges::find(service.links, link) != service.links.end();
}

QString placeOf(const Snapshot &shot, const OperationView &operation)
{
    const DeviceView *device = shot.device(operation.device);
    if (!device)
        return UpdateText::tr("a device that is gone");
    const LinkView *link = shot.link(device->link);
    return UpdateText::tr("%1 on %2").arg(titleOf(*device), qt(link ? link->name : device->link));
}

QString leftAfter(int pages, const UpdateWords &words)
{
    return tableText(pages > 0 && !words.written.empty() ? words.written : words.cancel);
}

} // namespace mb
