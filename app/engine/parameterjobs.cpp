// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engine/parameterjobs.h"

#include "model/family.h"
#include "model/unit.h"
#include "settings/history.h"
#include "settings/snapshots.h"
#include "settings/storing.h"

#include <algorithm>

namespace mb {
namespace {

constexpr std::size_t manyValues = 8; ///< more are worth a snapshot before they are written

using Outcomes = std::vector<TransferOutcome>;

Task<void> rewrite(Device &device, settings::SettingsLog *log, Progress &progress)
{
    co_await settings::rewriteKept(device, settings::Origin::Window, log, progress);
    co_return {};
}

/// Which key went from what to what. A value that was not known stays a question mark.
void tellChanges(const EngineLog &log, const Device &device, const std::vector<ParameterStore::Entry> &before,
    const Outcomes &outcomes)
{
    for (const TransferOutcome &outcome : outcomes) {
        if (!outcome.raw)
            continue;
        const Parameter &row = device.family().parameters[outcome.index.value];
        const auto &old = before.size() > outcome.index.value ? before[outcome.index.value].raw : std::nullopt;
        log.tell(Severity::Info, device,
            say("%1: %2 → %3", row.key, old ? settings::worded(row, *old) : MessageArgument(std::string("?")),
                settings::worded(row, *outcome.raw)));
    }
}

/// Of writes that all went well: what is known of them.
Message proofOf(const Outcomes &outcomes)
{
    const auto blind
        = std::ranges::count_if(outcomes, [](const TransferOutcome &outcome) { return !outcome.verified; });
    if (blind == 0)
        return say("%1 written, read back and equal", outcomes.size());
    if (static_cast<std::size_t>(blind) == outcomes.size())
        return say("%1 written; they cannot be read back", outcomes.size());
    return say("%1 written; %2 of them cannot be read back", outcomes.size(), blind);
}

} // namespace

void ParameterJobs::carryOut(const orders::ReadParameters &order, const Finished &finished)
{
    m_context.operations.begin<Outcomes>(
        order.device, {say("Read parameters"), OperationKind::ReadParameters},
        [this](Device &device, Progress &progress) {
            return settings::readKept(device, readable(device), m_settings, progress);
        },
        [this, finished](Operations::Job &job, const Result<Outcomes> &outcomes) { finished(tellRead(job, outcomes)); },
        finished);
}

Result<void> ParameterJobs::tellRead(Operations::Job &job, const Result<Outcomes> &outcomes) const
{
    if (!outcomes)
        return fail(outcomes.error());
    const Device *device = m_context.session.find(job.device);
    const auto silent
        = std::find_if(outcomes->begin(), outcomes->end(), [](const TransferOutcome &o) { return !o.raw; });
    const auto failed
        = std::count_if(outcomes->begin(), outcomes->end(), [](const TransferOutcome &o) { return !o.raw; });
    if (device) {
        const auto missing = readable(*device).size() - outcomes->size() + static_cast<std::size_t>(failed);
        if (missing > 0)
            m_context.log.tell(Severity::Caution, *device, say("%1 parameters gave no answer", missing));
        else
            job.operation->log(Severity::Good, say("all %1 read", outcomes->size()));
    }
    return silent == outcomes->end() ? Result<void>() : fail(silent->raw.error());
}

void ParameterJobs::carryOut(const orders::StoreParameters &order, const Finished &finished)
{
    m_context.operations.begin<bool>(
        order.device, say("Store to flash"),
        [this](Device &device, Progress &progress) {
            return settings::storeKept(device, settings::Origin::Window, m_settings, progress);
        },
        [this, finished](Operations::Job &job, const Result<bool> &proved) {
            if (proved)
                m_context.log.tell(*proved ? Severity::Good : Severity::Caution, job.device,
                    *proved ? say("stored, and the unit has proved it") : say("stored, not verifiable"));
            else
                m_context.log.tell(Severity::Danger, job.device, proved.error().message());
            finished(proved ? Result<void>() : fail(proved.error()));
        },
        finished);
}

void ParameterJobs::carryOut(const orders::RewriteSettings &order, const Finished &finished)
{
    m_context.operations.begin(
        order.device, {say("Write settings again"), OperationKind::RewriteSettings},
        [this](Device &device, Progress &progress) { return rewrite(device, m_settings, progress); },
        [this, id = order.device, finished](const Result<void> &result) {
            m_provisional.look(id); // a change that waits may be part of it by now
            if (result)
                m_context.log.tell(Severity::Good, id, say("the settings that the reset took are written again"));
            finished(result);
        });
}

Task<void> ParameterJobs::keepBefore(Device &device, settings::Occasion occasion, Progress &progress) const
{
    if (!m_settings || device.identity().state == DeviceState::Bootloader)
        co_return {};
    auto taking = settings::takeSnapshot(device, occasion, {}, *m_settings, progress);
    const auto taken = co_await std::move(taking).attempt();
    if (!taken && taken.error().fault == Fault::NotKept)
        co_return fail(settings::keepsNothing(taken.error()));
    if (!taken)
        progress.log(Severity::Caution, say("no snapshot of what was there: %1", taken.error().message()));
    co_return {};
}

Task<Outcomes> ParameterJobs::writeWhole(
    Device &device, std::vector<ParameterChange> changes, settings::Purpose purpose, Progress &progress)
{
    const bool restores = purpose == settings::Purpose::Restore;
    if (restores)
        co_await askWhose(device);
    if (restores || changes.size() > manyValues) {
        auto keeping
            = keepBefore(device, restores ? settings::Occasion::Restore : settings::Occasion::Import, progress);
        co_await std::move(keeping);
    }
    settings::Order order{settings::Origin::Window, purpose, {}, begins(device)};
    auto writing = settings::writeKept(device, std::move(changes), std::move(order), m_settings, progress);
    co_return co_await std::move(writing).attempt();
}

settings::Begun ParameterJobs::begins(const Device &device)
{
    return [this, id = m_context.session.idOf(device)](std::int64_t change) { m_provisional.begins(id, change); };
}

/// What is kept of a place may be of another unit than the one that stands there now. Whoever orders it once more says that it is the same.
Task<void> ParameterJobs::askWhose(Device &device)
{
    if (!m_settings)
        co_return {};
    const std::vector<settings::SettingsChange> changes = co_await m_settings->changesOf(unitKeyOf(device));
    const std::string unit = changes.empty() ? unitKeyOf(device) : changes.back().unit;
    std::unique_ptr<HeardSince> &consent = m_consents[m_context.session.idOf(device)];
    if (unitByOf(unit) != UnitBy::Place || (consent && consent->holds(device)))
        co_return {};
    consent = std::make_unique<HeardSince>(device);
    co_return fail(Fault::Unsafe, say("this place, not this unit: what is kept may be of another"),
        say("do it once more if it is the same"));
}

void ParameterJobs::carryOut(const orders::WriteParameters &order, const Finished &finished)
{
    write(order.device, order.changes, settings::Purpose::Write, finished);
}

void ParameterJobs::carryOut(const orders::RestoreParameters &order, const Finished &finished)
{
    write(order.device, order.changes, settings::Purpose::Restore, finished);
}

void ParameterJobs::write(
    DeviceId id, std::vector<ParameterChange> changes, settings::Purpose purpose, const Finished &finished)
{
    if (auto same = m_context.operations.checkRecognised(id); !same)
        return finished(same);
    std::vector<ParameterStore::Entry> before;
    if (const Device *device = m_context.session.find(id))
        before.assign(device->parameters().entries().begin(), device->parameters().entries().end());
    m_context.operations.begin<Outcomes>(
        id, say("Write parameters"),
        [this, changes, purpose](
            Device &device, Progress &progress) { return writeWhole(device, changes, purpose, progress); },
        [this, id, finished, before](Operations::Job &, const Result<Outcomes> &outcomes) {
            m_provisional.look(id);
            finished(tellWritten(id, before, outcomes));
        },
        finished);
}

Result<void> ParameterJobs::tellWritten(
    DeviceId id, const std::vector<ParameterStore::Entry> &before, const Result<Outcomes> &outcomes) const
{
    const Device *device = m_context.session.find(id);
    if (device && outcomes)
        tellChanges(m_context.log, *device, before, *outcomes);
    Result<void> result;
    if (!outcomes)
        result = fail(outcomes.error());
    else if (!outcomes->empty() && !outcomes->back().raw)
        result = fail(outcomes->back().raw.error());
    if (device && result)
        m_context.log.tell(Severity::Good, *device, proofOf(*outcomes));
    else if (device)
        m_context.log.tell(Severity::Danger, *device, result.error().message());
    return result;
}

Task<settings::SettingsChange> ParameterJobs::takeBack(Device &device, bool again, Progress &progress)
{
    co_await askWhose(device);
    auto writing = again ? settings::redo(device, settings::Origin::Window, *m_settings, progress, begins(device))
                         : settings::undo(device, settings::Origin::Window, *m_settings, progress, begins(device));
    co_return co_await std::move(writing).attempt();
}

void ParameterJobs::carryOut(const orders::UndoWrite &order, const Finished &finished)
{
    if (!m_settings)
        return finished(fail(Fault::Unsupported, say("no history is kept here")));
    if (auto same = m_context.operations.checkRecognised(order.device); !same)
        return finished(same);
    m_context.operations.begin<settings::SettingsChange>(
        order.device, order.again ? say("Do a write again") : say("Undo a write"),
        [this, again = order.again](Device &device, Progress &progress) { return takeBack(device, again, progress); },
        [this, again = order.again, finished](Operations::Job &job, const Result<settings::SettingsChange> &change) {
            m_provisional.look(job.device);
            if (const Device *device = m_context.session.find(job.device); device && change)
                m_context.log.tell(Severity::Good, *device,
                    again ? say("written again: %1", settings::textOf(device->family(), *change))
                          : say("undone: %1", settings::textOf(device->family(), *change)));
            else if (device)
                m_context.log.tell(Severity::Danger, *device, change.error().message());
            finished(change ? Result<void>() : fail(change.error()));
        },
        finished);
}

void ParameterJobs::carryOut(const orders::TakeSnapshot &order, const Finished &finished)
{
    if (!m_settings)
        return finished(fail(Fault::Unsupported, say("no snapshots are kept here")));
    m_context.operations.begin<settings::ParameterSnapshot>(
        order.device, say("Take a snapshot"),
        [this, name = order.name](Device &device, Progress &progress) {
            return settings::takeSnapshot(device, settings::Occasion::Hand, name, *m_settings, progress);
        },
        [this, finished](Operations::Job &job, const Result<settings::ParameterSnapshot> &taken) {
            if (taken)
                m_context.log.tell(Severity::Good, job.device,
                    say("snapshot %1, %2: %3 values", taken->number, taken->name, taken->count));
            else
                m_context.log.tell(Severity::Danger, job.device, say("no snapshot: %1", taken.error().message()));
            finished(taken ? Result<void>() : fail(taken.error()));
        },
        finished);
}

} // namespace mb
