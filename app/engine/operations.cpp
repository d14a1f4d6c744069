// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engine/operations.h"

#include <algorithm>

namespace mb {
namespace {

constexpr std::size_t keptOperations = 32;

bool isRunning(const Operations::Job &job)
{
    return job.operation->isRunning();
}

bool isExperiment(const Operations::Job &job)
{
    const OperationKind kind = job.operation->status().kind;
    return kind == OperationKind::Trial || kind == OperationKind::FamilyExperiment;
}

} // namespace

Operations::Operations(Clock &clock, Session &session, EngineLog &log)
    : m_clock(clock)
    , m_session(session)
    , m_log(log)
    , m_pruning(clock)
{
}

Result<Device *> Operations::freeDevice(DeviceId id)
{
    Device *device = m_session.find(id);
    if (!device)
        return fail(Fault::Timeout, say("the device is gone"));
    if (isLent(device->link()))
        return fail(Fault::Unsafe, say("units are served on this link"));
    makeWay(id);
    if (has(id))
        return fail(Fault::Unsafe, say("the device is busy with something else"));
    return device;
}

Result<void> Operations::checkRecognised(DeviceId id) const
{
    const Device *const device = m_session.find(id);
    if (!device || m_session.isRecognised(*device))
        return {};
    return fail(Fault::Unsafe,
        say("%1 has restarted and did not say yet whether it is the same unit", device->selector()),
        say("look at what it says, then order it again"));
}

Operations::Job &Operations::add(const Device &device, const Name &name)
{
    m_pruning.startIn(
        Duration::zero(), [this] { prune(); }); // not now: whoever begins this may be told of a job that has ended
    return m_jobs.emplace_back(Job{OperationId{++m_last}, m_session.idOf(device), &device, {},
        std::make_unique<Operation>(m_clock, name.title, name.kind), std::nullopt, false});
}

Operations::Job *Operations::begin(DeviceId id, const Name &name, const Make<void> &make, const Finished &finished)
{
    return begin<void>(
        id, name, make,
        [this, id, title = name.title, finished](Job &, const Result<void> &result) {
            if (!result)
                m_log.tell(Severity::Danger, id, say("%1: %2", title, result.error().message()));
            finished(result);
        },
        finished);
}

void Operations::carryOut(const orders::CancelOperation &order, const Finished &finished)
{
    for (Job &job : m_jobs) {
        if (job.id == order.operation && job.interruption)
            job.interruption->interrupt();
        else if (job.id == order.operation)
            (void)job.operation->cancel();
    }
    finished({});
}

bool Operations::lend(const Link &link)
{
    for (const Device *device : m_session.devices()) {
        if (&device->link() == &link)
            makeWay(m_session.idOf(*device));
    }
    const bool isFree = !hasOn(link);
    if (isFree)
        m_lent.insert(&link);
    return isFree;
}

/// Also when it began for the unit that stood there before.
bool Operations::isOf(const Job &job, DeviceId device) const
{
    const Device *const found = m_session.find(device);
    return job.device == device || (found && job.unit == found);
}

bool Operations::has(DeviceId device) const
{
    const Device *found = m_lent.empty() ? nullptr : m_session.find(device);
    if (found && isLent(found->link()))
        return true;
    return std::ranges::any_of(m_jobs, [this, device](const Job &job) { return isRunning(job) && isOf(job, device); });
}

bool Operations::isTried(DeviceId device) const
{
    return std::ranges::any_of(
        m_jobs, [this, device](const Job &job) { return isRunning(job) && isExperiment(job) && isOf(job, device); });
}

bool Operations::hasOn(const Link &link) const
{
    const auto devices = m_session.devices();
    return std::ranges::any_of(
        devices, [&](const Device *device) { return &device->link() == &link && has(m_session.idOf(*device)); });
}

bool Operations::runsOn(const Link &link, OperationKind kind) const
{
    const auto devices = m_session.devices();
    return std::ranges::any_of(m_jobs, [&](const Job &job) {
        const auto unit = std::ranges::find(devices, job.unit);
        return isRunning(job) && job.operation->status().kind == kind && unit != devices.end()
            && &(*unit)->link() == &link;
    });
}

bool Operations::isAnyRunning() const
{
    if (!m_lent.empty())
        return true;
    return std::ranges::any_of(m_jobs, isRunning);
}

/// An experiment that prepares has nothing to stop yet, and would move later: it ends, whatever it is doing.
void Operations::stopExperiments()
{
    for (Job &job : m_jobs) {
        if (job.operation->status().kind == OperationKind::FamilyExperiment)
            (void)job.operation->cancel();
    }
    interruptTrials(std::nullopt);
}

void Operations::interruptTrials(std::optional<DeviceId> device)
{
    for (Job &job : m_jobs) {
        if (job.interruption && (!device || isOf(job, *device)))
            job.interruption->interrupt();
    }
}

/// What began by itself makes way for what somebody asked for.
void Operations::makeWay(DeviceId device)
{
    for (Job &job : m_jobs) {
        if (job.yields && isRunning(job) && isOf(job, device))
            job.operation->dismiss({Fault::Cancelled, say("made way for an order")});
    }
}

void Operations::dismiss(const Device &device, const Error &error)
{
    const auto runs = [&device](const Job &job) { return job.unit == &device && isRunning(job); };
    for (auto found = std::ranges::find_if(m_jobs, runs); found != m_jobs.end();
         found = std::ranges::find_if(m_jobs, runs))
        found->operation->dismiss(error);
}

void Operations::forget(const Link &link)
{
    m_lent.erase(&link);
    for (const Device *device : m_session.devices()) {
        if (&device->link() != &link)
            continue;
        dismiss(*device, {Fault::LinkLost, say("the device is gone")});
        std::erase_if(m_jobs, [device](const Job &job) { return job.unit == device; });
    }
}

void Operations::prune()
{
    for (auto job = m_jobs.begin(); job != m_jobs.end() && m_jobs.size() > keptOperations;)
        job = isRunning(*job) ? std::next(job) : m_jobs.erase(job);
}

} // namespace mb
