// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engine/firstsnapshots.h"

#include "model/unit.h"
#include "settings/history.h"
#include "settings/snapshots.h"

namespace mb {
namespace {

/// Everything is read, and what something else has changed goes into the history before the snapshot.
Task<settings::ParameterSnapshot> meetUnit(Device &device, settings::SettingsLog &log, Progress &progress)
{
    auto taking = settings::takeSnapshot(device, settings::Occasion::Found, {}, log, progress);
    settings::ParameterSnapshot taken = co_await std::move(taking);
    const int foreign = co_await settings::noticeForeign(device, log);
    const bool isFresh = device.link().address().isSimulated(); // a bench of this process was never left as anything
    if (foreign > 0 && !isFresh)
        progress.log(Severity::Caution, say("%1 values are not what they were left as; the history has both", foreign));
    co_return taken;
}

} // namespace

bool FirstSnapshots::isReady(const Device &device) const
{
    return m_parameters.log() && device.liveness().heard && !device.liveness().moving
        && device.identity().state == DeviceState::Online && device.gate().busy().empty()
        && !m_context.operations.has(m_context.session.idOf(device)) && !device.link().address().isRecording()
        && !readable(device).empty();
}

void FirstSnapshots::look()
{
    for (Device *device : m_context.session.devices()) {
        const DeviceId id = m_context.session.idOf(*device);
        const std::string unit = unitKeyOf(*device);
        if (!isReady(*device) || m_met[id] == unit)
            continue;
        m_met[id] = unit;
        Operations::Job *const job = m_context.operations.begin<settings::ParameterSnapshot>(
            id, {say("Take a snapshot"), OperationKind::Look},
            [log = m_parameters.log()](Device &found, Progress &progress) { return meetUnit(found, *log, progress); },
            [this](Operations::Job &done, const Result<settings::ParameterSnapshot> &taken) { met(done, taken); },
            [](const Result<void> &) {});
        if (job)
            job->yields = true;
    }
    std::erase_if(m_met, [this](const auto &entry) { return !m_context.session.find(entry.first); });
}

void FirstSnapshots::met(const Operations::Job &job, const Result<settings::ParameterSnapshot> &taken)
{
    const Device *device = m_context.session.find(job.device);
    if (!device)
        return;
    if (!taken && taken.error().fault != Fault::NotKept) // a full disk is told once; others are tried again
        m_met.erase(job.device);
    else if (!taken)
        m_context.log.tell(
            Severity::Caution, *device, say("no snapshot of what was found: %1", taken.error().message()));
    for (const LogLine &line : job.operation->status().log)
        m_context.log.tell(line.severity, *device, line.text);
    m_provisional.look(job.device);
}

} // namespace mb
