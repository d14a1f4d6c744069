// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engine/snapshotpublisher.h"

#include "model/identity.h"

#include <algorithm>

namespace mb {
namespace {

bool inOrder(const DeviceView &a, const DeviceView &b)
{
    return a.link == b.link
        && (a.family == b.family ? a.identity->address < b.identity->address : a.family->key < b.family->key);
}

OperationView showing(const Operations::Job &job)
{
    return {job.id, job.device, job.operation->status(), job.update};
}

bool isElsewhere(Session &session, const OwedStop &owed)
{
    const std::vector<Link *> links = session.links();
    return std::ranges::any_of(links, [&owed](const Link *link) {
        return partsOf(owed.device).link == link->address().text() && link->line() != owed.line;
    });
}

} // namespace

Snapshot SnapshotPublisher::withoutOperations() const
{
    Session &session = m_context.session;
    Snapshot shot;
    shot.time = m_context.clock.now();
    m_links.describe(shot);
    for (const Link *link : session.links()) {
        for (Device *device : session.devices()) {
            if (&device->link() == link)
                shot.devices.push_back(viewOf(session, *device));
        }
    }
    shot.unconfirmed = m_provisional.views();
    std::ranges::stable_sort(shot.devices, inOrder);
    for (const OwedStop &owed : session.stops().owed())
        shot.owedStops.push_back({owed.device, isElsewhere(session, owed)});
    return shot;
}

Snapshot SnapshotPublisher::take() const
{
    Snapshot shot = withoutOperations();
    for (const Operations::Job &job : m_context.operations.jobs())
        shot.operations.push_back(showing(job));
    return shot;
}

SnapshotChanges SnapshotPublisher::changes()
{
    SnapshotChanges changes{withoutOperations(), {}};
    std::map<OperationId, std::uint64_t> shown;
    for (const Operations::Job &job : m_context.operations.jobs()) {
        const std::uint64_t revision = job.operation->revision();
        const auto before = m_shown.find(job.id);
        if (before == m_shown.end() || before->second != revision)
            changes.snapshot.operations.push_back(showing(job));
        changes.operations.push_back(job.id);
        shown[job.id] = revision;
    }
    m_shown = std::move(shown);
    return changes;
}

Snapshot merged(Snapshot before, SnapshotChanges changes)
{
    std::vector<OperationView> operations;
    const auto takeFrom = [&operations](std::vector<OperationView> &views, OperationId id) {
        const auto found = std::ranges::find(views, id, &OperationView::id);
        if (found == views.end())
            return false;
        operations.push_back(std::move(*found));
        return true;
    };
    for (const OperationId id : changes.operations) {
        if (!takeFrom(changes.snapshot.operations, id))
            takeFrom(before.operations, id);
    }
    changes.snapshot.operations = std::move(operations);
    return std::move(changes.snapshot);
}

} // namespace mb
