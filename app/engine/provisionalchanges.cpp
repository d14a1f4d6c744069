// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engine/provisionalchanges.h"

#include "model/family.h"
#include "model/unit.h"
#include "settings/history.h"

#include <algorithm>
#include <utility>

namespace mb {
namespace {

using settings::Confirmation;
using settings::SettingsChange;

constexpr Duration lookEvery = std::chrono::milliseconds(100);
constexpr Duration askAgain = std::chrono::seconds(5);

UnconfirmedView::State stateOf(const std::optional<Confirmation> &confirmation)
{
    if (!confirmation)
        return UnconfirmedView::State::Offered;
    switch (confirmation->state()) {
    case Confirmation::State::AwaitsRestart: return UnconfirmedView::State::AwaitsRestart;
    case Confirmation::State::Counting: return UnconfirmedView::State::Counting;
    case Confirmation::State::AwaitsStandstill:
    case Confirmation::State::Due: return UnconfirmedView::State::AwaitsStandstill;
    }
    return UnconfirmedView::State::Offered;
}

/// In force only when it has restarted: then nobody could offer it before.
bool actsLater(const Family &family, const SettingsChange &change)
{
    return std::ranges::any_of(change.values, [&family](const settings::ValueChange &value) {
        const auto index = findParameter(family.parameters, value.key);
        return index && family.parameters[index->value].afterRestart;
    });
}

} // namespace

ProvisionalChanges::ProvisionalChanges(const EngineContext &context)
    : m_context(context)
    , m_timer(context.clock)
    , m_again(context.clock)
    , m_asking(context.clock)
{
}

/// What was counted while the link was there is offered when it is back: people may have been at the unit meanwhile. Of a place another
/// unit may stand there (HeardSince).
bool ProvisionalChanges::Entry::isCutOff(Device &unit)
{
    if (confirmation->state() == Confirmation::State::AwaitsRestart)
        return false;
    if (!heard)
        heard = std::make_unique<HeardSince>(unit);
    return unit.link().state() != LinkState::Open || (unitByOf(change.unit) == UnitBy::Place && !heard->holds(unit));
}

ProvisionalChanges::Entry *ProvisionalChanges::find(DeviceId id, std::int64_t change)
{
    const auto found = std::ranges::find_if(
        m_entries, [&](const Entry &entry) { return entry.device == id && entry.change.number == change; });
    return found == m_entries.end() ? nullptr : &*found;
}

void ProvisionalChanges::look(DeviceId id)
{
    const Device *device = m_context.session.find(id);
    if (!device || !m_log)
        return;
    m_asking.spawn<std::vector<SettingsChange>>(
        m_log->changesOf(unitKeyOf(*device)), [this, id](const Result<std::vector<SettingsChange>> &changes) {
            if (changes)
                return take(id, *changes);
            m_unanswered.insert(id);
            m_again.startIn(askAgain, [this] { lookAgain(); });
        });
}

void ProvisionalChanges::lookAgain()
{
    for (const DeviceId id : std::exchange(m_unanswered, {}))
        look(id);
}

void ProvisionalChanges::take(DeviceId id, const std::vector<SettingsChange> &changes)
{
    Device *const device = m_context.session.find(id);
    const auto open = device ? settings::unconfirmedOf(*device, changes) : std::vector<SettingsChange>();
    std::erase_if(m_entries, [&](const Entry &entry) {
        return !m_context.session.find(entry.device)
            || (entry.device == id && std::ranges::none_of(open, [&entry](const SettingsChange &change) {
                   return change.number == entry.change.number;
               }));
    });
    for (const SettingsChange &change : open) {
        if (Entry *known = find(id, change.number)) {
            known->change = change; // what was written over is no more of it
            continue;
        }
        m_entries.push_back({id, change, std::nullopt});
        if (isNew(id, change.number) || actsLater(device->family(), change))
            m_entries.back().confirmation.emplace(change.values);
    }
    tick();
}

bool ProvisionalChanges::isNew(DeviceId id, std::int64_t change)
{
    const auto begun = m_begun.find(id);
    if (begun == m_begun.end() || begun->second != change)
        return false;
    m_begun.erase(begun);
    return true;
}

/// A device that a job has, or of which nobody knows which unit it is, is looked at again: what is due goes back by itself.
bool ProvisionalChanges::mayPutBack(DeviceId device) const
{
    return !m_context.operations.has(device) && m_context.operations.checkRecognised(device);
}

/// What is due is offered until it went back: a lost link is no reason to forget it.
void ProvisionalChanges::tick()
{
    const Instant now = m_context.clock.now();
    std::vector<std::pair<DeviceId, std::int64_t>> due;
    bool counts = false;
    for (Entry &entry : m_entries) {
        Device *device = m_context.session.find(entry.device);
        if (device && entry.confirmation && entry.isCutOff(*device)) {
            entry.confirmation.reset();
            m_context.log.tell(Severity::Caution, entry.device,
                say("%1 no longer goes back by itself: the unit was gone or has restarted",
                    settings::textOf(device->family(), entry.change)));
        }
        if (!device || !entry.confirmation)
            continue;
        counts = true;
        if (entry.confirmation->look(*device, now) != Confirmation::State::Due || !mayPutBack(entry.device))
            continue;
        entry.confirmation.reset();
        due.emplace_back(entry.device, entry.change.number);
    }
    if (counts)
        m_timer.startIn(lookEvery, [this] { tick(); });
    for (const auto &[id, change] : due)
        carryOut(orders::PutBackChange{id, change}, [](const Result<void> &) {});
}

void ProvisionalChanges::carryOut(const orders::KeepChange &order, const Finished &finished)
{
    Entry *entry = find(order.device, order.change);
    const Device *device = m_context.session.find(order.device);
    if (!entry || !device || !m_log)
        return finished(fail(Fault::OutOfRange, say("this change waits for nobody")));
    entry->confirmation.reset(); // somebody has decided, whatever the disk does
    m_asking.spawn<void>(
        settings::keepChange(*device, order.change, *m_log), [this, order, finished](const Result<void> &kept) {
            if (!kept)
                m_context.log.tell(Severity::Caution, order.device, kept.error().message());
            if (Entry *decided = find(order.device, order.change); decided && kept)
                m_entries.remove_if([decided](const Entry &other) { return &other == decided; });
            finished(kept);
        });
}

void ProvisionalChanges::carryOut(const orders::PutBackChange &order, const Finished &finished)
{
    if (!find(order.device, order.change) || !m_log)
        return finished(fail(Fault::OutOfRange, say("this change waits for nobody")));
    if (auto same = m_context.operations.checkRecognised(order.device); !same)
        return finished(same);
    m_context.operations.begin<bool>(
        order.device, say("Put values back"),
        [log = m_log, number = order.change](
            Device &device, Progress &progress) { return settings::putBack(device, number, *log, progress); },
        [this, id = order.device, finished](const Operations::Job &, const Result<bool> &written) {
            if (!written)
                m_context.log.tell(
                    Severity::Danger, id, say("the values are not put back: %1", written.error().message()));
            else if (*written)
                m_context.log.tell(Severity::Good, id, say("the values are put back"));
            look(id);
            finished(written ? Result<void>() : fail(written.error()));
        },
        finished);
}

std::vector<UnconfirmedView> ProvisionalChanges::views() const
{
    std::vector<UnconfirmedView> views;
    for (const Entry &entry : m_entries) {
        const Device *device = m_context.session.find(entry.device);
        if (!device)
            continue;
        UnconfirmedView view{entry.device, entry.change.number, settings::textOf(device->family(), entry.change),
            stateOf(entry.confirmation), 0.0, entry.change.unit};
        if (entry.confirmation)
            view.left = std::chrono::duration<double>(entry.confirmation->left(m_context.clock.now())).count();
        views.push_back(std::move(view));
    }
    return views;
}

} // namespace mb
