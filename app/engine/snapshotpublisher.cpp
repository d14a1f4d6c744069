// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engine/snapshotpublisher.h"

#include <algorithm>

namespace mb {
namespace {

bool inOrder(const DeviceView &a, const DeviceView &b)
{
    return a.link == b.link
        && (a.family == b.family ? a.identity.address < b.identity.address : a.family->key < b.family->key);
}

} // namespace

Snapshot SnapshotPublisher::take() const
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
    std::stable_sort(shot.devices.begin(), shot.devices.end(), inOrder);
    for (const Operations::Job &job : m_context.operations.jobs())
        shot.operations.push_back({job.id, job.device, job.operation->status(), job.update});
    for (const OwedStop &owed : session.owedStops())
        shot.owedStops.push_back(owed.device);
    return shot;
}

} // namespace mb
