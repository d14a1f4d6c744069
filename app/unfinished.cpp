// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/unfinished.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/serviceview.h"
#include "widgets/common/updates.h"
#include "widgets/control/motionwords.h"
#include "widgets/plots/exportjob.h"

#include <algorithm>

namespace mb {
namespace {

bool onlyLooks(const OperationStatus &status)
{
    return status.kind == OperationKind::Look || status.kind == OperationKind::ReadParameters;
}

Unfinished showing(const OperationView &job, Workbench &workbench)
{
    const Snapshot &shot = workbench.snapshot();
    const bool updates = job.status.kind == OperationKind::UpdateFirmware;
    Unfinished one{updates ? Unfinished::Kind::Update : Unfinished::Kind::Job,
        updates ? placeOf(shot, job) : messageText(job.status.title), job.status.mayInterrupt, {}, {}};
    if (const DeviceView *unit = shot.device(job.device); updates && unit)
        one.left = leftAfter(job.status.update.pages, updateWords(*unit->family)) + QLatin1Char('.');
    if (updates || isTried(shot, job.device))
        one.cancel = [&workbench, id = job.id] { workbench.send(orders::CancelOperation{id}); };
    return one;
}

} // namespace

std::vector<Unfinished> unfinishedIn(const QWidget &window, Workbench &workbench)
{
    std::vector<Unfinished> all;
    if (const ServiceView &service = workbench.service(); service.running) {
        const bool may
            = std::ranges::all_of(service.rows, [](const service::QueueRow &row) { return row.mayInterrupt; });
        all.push_back(
            {Unfinished::Kind::Service, {}, may, {}, [&workbench] { workbench.send(orders::CancelService{}); }});
    }
    for (ExportJob *job : window.findChildren<ExportJob *>()) {
        if (job->isRunning())
            all.push_back({Unfinished::Kind::Export, job->path(), true, {}, [job] { job->cancel(); }});
    }
    for (const OperationView &job : workbench.snapshot().operations) {
        if (job.status.state == OperationStatus::State::Running && !onlyLooks(job.status))
            all.push_back(showing(job, workbench));
    }
    return all;
}

} // namespace mb
