// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engine/firmwareupdates.h"

#include "async/background.h"
#include "model/family.h"
#include "model/standstill.h"
#include "service/busydevice.h"

#include <algorithm>

namespace mb {
namespace {
constexpr Duration transcriptLimit = std::chrono::seconds(30);
} // namespace

FirmwareUpdates::FirmwareUpdates(const EngineContext &context, const ParameterJobs &parameters, Scans &scans)
    : m_context(context)
    , m_parameters(parameters)
    , m_scans(scans)
    , m_files(context.clock)
{
}

void FirmwareUpdates::carryOut(const orders::UpdateFirmware &order, const Finished &finished)
{
    const Finished refused = [this, id = order.device, finished](const Result<void> &result) {
        m_context.log.tell(Severity::Caution, id, result.error().message());
        finished(result);
    };
    const Device *device = m_context.session.find(order.device);
    if (const Device *other = device ? updatedBeside(*device) : nullptr)
        return refused(fail(Fault::Unsafe,
            say("one update a bus: %1 is being written; nothing was sent", m_context.log.labelOf(*other))));
    m_context.operations.begin<UpdateReport>(
        order.device, {say("Update firmware"), OperationKind::UpdateFirmware},
        [this, image = order.image, options = order.options](
            Device &unit, Progress &progress) { return update(unit, image, options, progress); },
        [this, finished](Operations::Job &job, const Result<UpdateReport> &report) { ended(job, report, finished); },
        refused);
}

Task<UpdateReport> FirmwareUpdates::update(
    Device &device, std::shared_ptr<const FirmwareImage> image, UpdateOptions options, Progress &progress)
{
    m_scans.giveWay(device.link());
    const service::BusyDevice busy(device, say("firmware update"));
    auto standing = standsStill(device); // a click may be late, and what it was given on a picture
    co_await std::move(standing);
    co_await m_parameters.keepBefore(device, settings::Occasion::Update, progress);
    co_return co_await device.family().update(device, *image, std::move(options), progress).attempt();
}

/// The unit may have another id by now: another one took its place.
void FirmwareUpdates::ended(Operations::Job &job, const Result<UpdateReport> &result, const Finished &finished)
{
    const UpdateReport report = result ? *result : unfinished(job.operation->status().update, result.error());
    const bool good = report.outcome == UpdateOutcome::Done || report.outcome == UpdateOutcome::UpToDate;
    const Severity severity = !good                                 ? Severity::Danger
        : report.outcome == UpdateOutcome::Done && !report.verified ? Severity::Caution
                                                                    : Severity::Good;
    job.update = report;
    const auto devices = m_context.session.devices();
    if (const auto unit = std::ranges::find(devices, job.unit); unit != devices.end()) {
        saveTranscript(job, **unit);
        m_context.log.tell(severity, **unit, say("firmware: %1", report.summary()));
        m_scans.scan((*unit)->link());
    }
    if (!result)
        finished(fail(result.error()));
    else
        finished(good ? Result<void>() : fail(report.fault.value_or(Fault::Refused), report.evidence));
}

/// Pages of one image between those of another, on one bus: neither would end, and no log could tell why.
const Device *FirmwareUpdates::updatedBeside(const Device &device) const
{
    for (const Operations::Job &job : m_context.operations.jobs()) {
        const Device *other = m_context.session.find(job.device);
        if (other && other != &device && &other->link() == &device.link() && job.operation->isRunning()
            && job.operation->status().kind == OperationKind::UpdateFirmware)
            return other;
    }
    return nullptr;
}

/// What was said to a bootloader and what it answered, for whoever has to find out why it failed.
void FirmwareUpdates::saveTranscript(const Operations::Job &job, const Device &device)
{
    if (m_folder.empty())
        return;
    Transcript transcript
        = transcriptOf(m_folder, device, job.operation->status(), job.update.value_or(UpdateReport{}));
    m_files.spawn<std::string>(
        keep(std::move(transcript)), [this, label = m_context.log.labelOf(device)](const Result<std::string> &path) {
            if (path)
                m_context.log.tell(Severity::Info, label, say("the transcript of the update is in %1", *path));
            else
                m_context.log.tell(Severity::Caution, label,
                    say("the transcript of the update is not kept: %1", path.error().message()));
        });
}

Task<std::string> FirmwareUpdates::keep(Transcript transcript)
{
    if (!m_background)
        co_return save(transcript);
    const std::string path = transcript.path;
    auto saving = inBackground<std::string>(
        *m_background, m_context.clock, m_folder, transcriptLimit,
        [transcript = std::move(transcript)] { return save(transcript); }, WhenLate::Finish);
    const Result<std::string> saved = co_await std::move(saving).attempt();
    if (!saved && saved.error().fault == Fault::Timeout)
        co_return fail(Fault::Timeout, say("the disk has not taken %1 for 30 s", path));
    co_return saved;
}

} // namespace mb
