// SPDX-License-Identifier: GPL-3.0-or-later
// Settings that can be trusted: snapshots, writes that are kept, undo.
#include "app/enginework.h"
#include "model/family.h"
#include "settings/history.h"
#include "settings/snapshots.h"
#include "settings/unit.h"
#include "settings/writing.h"

#include <algorithm>

namespace mb {
namespace {

using settings::Occasion;
using settings::Origin;
using settings::ParameterSnapshot;
using settings::Purpose;

constexpr std::size_t manyValues = 8; ///< more are worth a snapshot before they are written

/// What fell short of a snapshot is told, and no reason to do nothing.
Task<void> keepBefore(Device &device, Occasion occasion, settings::SettingsLog *log, Progress &progress)
{
    if (!log || device.identity().state == DeviceState::Bootloader)
        co_return {};
    auto taking = settings::takeSnapshot(device, occasion, {}, *log, progress);
    if (const auto taken = co_await std::move(taking).attempt(); !taken)
        progress.log(Severity::Caution, "no snapshot of what was there: " + taken.error().text());
    co_return {};
}

Task<std::vector<TransferOutcome>> writeWhole(Device &device, std::vector<ParameterChange> changes, Purpose purpose,
    settings::SettingsLog *log, Progress &progress)
{
    const bool restores = purpose == Purpose::Restore;
    if (restores || changes.size() > manyValues) {
        auto keeping = keepBefore(device, restores ? Occasion::Restore : Occasion::Import, log, progress);
        co_await std::move(keeping);
    }
    if (log && settings::mustBeConfirmed(device, changes))
        purpose = Purpose::Provisional;
    auto writing = settings::writeKept(device, std::move(changes), {Origin::Window, purpose}, log, progress);
    co_return co_await std::move(writing).attempt();
}

/// Everything is read, and what something else has changed goes into the history before the snapshot.
Task<ParameterSnapshot> meetUnit(Device &device, settings::SettingsLog &log, Progress &progress)
{
    auto taking = settings::takeSnapshot(device, Occasion::Found, {}, log, progress);
    ParameterSnapshot taken = co_await std::move(taking);
    auto noticing = settings::noticeForeign(device, log);
    const int foreign = co_await std::move(noticing);
    const bool isFresh = device.link().address().isSimulated(); // a bench of this process was never left as anything
    if (foreign > 0 && !isFresh)
        progress.log(Severity::Caution,
            std::to_string(foreign) + " values are not what they were left as; the history has both");
    co_return taken;
}

} // namespace

Task<void> EngineCore::keptBefore(Device &device, Occasion occasion, Progress &progress)
{
    return keepBefore(device, occasion, m_settingsLog, progress);
}

void EngineCore::writeParameters(DeviceId id, std::vector<ParameterChange> changes, Finished finished)
{
    write(id, std::move(changes), Purpose::Write, std::move(finished));
}

void EngineCore::restoreParameters(DeviceId id, std::vector<ParameterChange> changes, Finished finished)
{
    write(id, std::move(changes), Purpose::Restore, std::move(finished));
}

void EngineCore::write(DeviceId id, std::vector<ParameterChange> changes, Purpose purpose, Finished finished)
{
    std::vector<ParameterStore::Entry> before;
    if (const Device *device = m_session.find(id))
        before.assign(device->parameters().entries().begin(), device->parameters().entries().end());
    begin<std::vector<TransferOutcome>>(
        id, "Write parameters",
        [this, changes, purpose](Device &device, Progress &progress) {
            return writeWhole(device, changes, purpose, m_settingsLog, progress);
        },
        [this, id, finished, before](Running &, const Result<std::vector<TransferOutcome>> &outcomes) {
            m_provisional.look(id, true);
            const Device *device = m_session.find(id);
            if (device && outcomes)
                noteWrites(*device, before, *outcomes);
            Result<void> result;
            if (!outcomes)
                result = fail(outcomes.error());
            else if (!outcomes->empty() && !outcomes->back().raw)
                result = fail(outcomes->back().raw.error());
            if (device && result)
                notice(Severity::Good, labelOf(*device), proofOf(*outcomes));
            else if (device)
                notice(Severity::Danger, labelOf(*device), result.error().text());
            answer(finished, result);
        },
        finished);
}

/// Which key went from what to what. A value that was not known stays a question mark.
void EngineCore::noteWrites(const Device &device, const std::vector<ParameterStore::Entry> &before,
    const std::vector<TransferOutcome> &outcomes)
{
    for (const TransferOutcome &outcome : outcomes) {
        if (!outcome.raw)
            continue;
        const Parameter &row = device.family().parameters[outcome.index.value];
        const auto &old = before.size() > outcome.index.value ? before[outcome.index.value].raw : std::nullopt;
        notice(Severity::Info, labelOf(device),
            std::string(row.key) + ": " + (old ? toText(row, *old) : "?") + " -> " + toText(row, *outcome.raw));
    }
}

/// Of writes that all went well: what is known of them.
std::string EngineCore::proofOf(const std::vector<TransferOutcome> &outcomes)
{
    const auto blind = std::count_if(
        outcomes.begin(), outcomes.end(), [](const TransferOutcome &outcome) { return !outcome.verified; });
    const std::string all = std::to_string(outcomes.size());
    if (blind == 0)
        return all + " written, read back and equal";
    if (static_cast<std::size_t>(blind) == outcomes.size())
        return all + " written; they cannot be read back";
    return all + " written; " + std::to_string(blind) + " of them cannot be read back";
}

void EngineCore::undoWrite(DeviceId id, bool again, Finished finished)
{
    if (!m_settingsLog)
        return answer(finished, fail(Fault::Unsupported, "no history is kept here"));
    begin<settings::SettingsChange>(
        id, again ? "Do a write again" : "Undo a write",
        [this, again](Device &device, Progress &progress) {
            return again ? settings::redo(device, Origin::Window, *m_settingsLog, progress)
                         : settings::undo(device, Origin::Window, *m_settingsLog, progress);
        },
        [this, id, again, finished](Running &, const Result<settings::SettingsChange> &change) {
            m_provisional.look(id, false);
            if (const Device *device = m_session.find(id); device && change)
                notice(Severity::Good, labelOf(*device),
                    (again ? "written again: " : "undone: ") + settings::textOf(device->family(), *change));
            else if (device)
                notice(Severity::Danger, labelOf(*device), change.error().text());
            answer(finished, change ? Result<void>() : Result<void>(fail(change.error())));
        },
        finished);
}

void EngineCore::takeSnapshot(DeviceId id, const std::string &name, Finished finished)
{
    if (!m_settingsLog)
        return answer(finished, fail(Fault::Unsupported, "no snapshots are kept here"));
    begin<ParameterSnapshot>(
        id, "Take a snapshot",
        [this, name](Device &device, Progress &progress) {
            return settings::takeSnapshot(device, Occasion::Hand, name, *m_settingsLog, progress);
        },
        [this, id, finished](Running &, const Result<ParameterSnapshot> &taken) {
            if (const Device *device = m_session.find(id); device && taken)
                notice(Severity::Good, labelOf(*device),
                    "snapshot " + std::to_string(taken->number) + ", " + taken->name + ": "
                        + std::to_string(taken->count) + " values");
            else if (device)
                notice(Severity::Danger, labelOf(*device), "no snapshot: " + taken.error().text());
            answer(finished, taken ? Result<void>() : Result<void>(fail(taken.error())));
        },
        finished);
}

/// Once for each unit that is there, when it has told who it is and nothing else works on it.
void EngineCore::meetUnits()
{
    for (Device *device : m_session.devices()) {
        const DeviceId id = m_session.idOf(*device);
        const bool ready = m_settingsLog && device->liveness().heard && !device->liveness().moving
            && device->identity().state == DeviceState::Online && device->busy().empty() && !hasOperation(id)
            && !device->link().address().isRecording() && !readable(*device).empty();
        const std::string unit = settings::unitOf(*device).key;
        if (!ready || m_met[id] == unit)
            continue;
        m_met[id] = unit;
        Running *const running = begin<ParameterSnapshot>(
            id, "Take a snapshot",
            [this](Device &unitMet, Progress &progress) { return meetUnit(unitMet, *m_settingsLog, progress); },
            [this, id](Running &done, const Result<ParameterSnapshot> &taken) { met(id, done, taken); }, {});
        if (running)
            running->yields = true;
    }
    std::erase_if(m_met, [this](const auto &entry) { return !m_session.find(entry.first); });
}

void EngineCore::met(DeviceId id, const Running &running, const Result<ParameterSnapshot> &taken)
{
    const Device *device = m_session.find(id);
    if (!device)
        return;
    if (!taken && taken.error().fault != Fault::OutOfRange) // a full disk is told once; others are tried again
        m_met.erase(id);
    else if (!taken)
        notice(Severity::Caution, labelOf(*device), "no snapshot of what was found: " + taken.error().text());
    for (const LogLine &line : running.operation->status().log)
        notice(line.severity, labelOf(*device), line.text);
    if (taken)
        m_provisional.look(id, false);
}

ProvisionalChanges::Surroundings EngineCore::provisionalSurroundings()
{
    return {[this] { return m_settingsLog; },
        [this](DeviceId id, const char *title, const auto &make, Finished finished) {
            beginSimple(id, title, make, std::move(finished));
        },
        [this](Severity severity, const Device &device, const std::string &text) {
            notice(severity, labelOf(device), text);
        },
        [this] { touch(); }};
}

/// What began by itself makes way for what somebody asked for.
void EngineCore::makeWay(DeviceId id)
{
    for (Running &running : m_operations) {
        if (running.device == id && running.yields && running.operation->isRunning())
            running.operation->dismiss({Fault::Cancelled, "made way for an order"});
    }
}

} // namespace mb
