// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/provisionalchanges.h"

#include "model/family.h"
#include "settings/history.h"

#include <algorithm>

namespace mb {
namespace {

using settings::Confirmation;
using settings::SettingsChange;

constexpr Duration lookEvery = std::chrono::milliseconds(100);

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
    return std::any_of(change.values.begin(), change.values.end(), [&family](const settings::ValueChange &value) {
        const auto index = findParameter(family.parameters, value.key);
        return index && family.parameters[index->value].afterRestart;
    });
}

} // namespace

ProvisionalChanges::ProvisionalChanges(Session &session, Surroundings surroundings)
    : m_session(session)
    , m_surroundings(std::move(surroundings))
    , m_timer(session.clock())
    , m_asking(session.clock())
{
}

ProvisionalChanges::Entry *ProvisionalChanges::find(DeviceId id, std::int64_t change)
{
    const auto found = std::find_if(m_entries.begin(), m_entries.end(),
        [&](const Entry &entry) { return entry.device == id && entry.change.number == change; });
    return found == m_entries.end() ? nullptr : &*found;
}

void ProvisionalChanges::look(DeviceId id, bool counting)
{
    const Device *device = m_session.find(id);
    settings::SettingsLog *log = m_surroundings.log();
    if (!device || !log)
        return;
    m_asking.spawn<std::vector<SettingsChange>>(settings::findUnconfirmed(*device, *log),
        [this, id, counting](const Result<std::vector<SettingsChange>> &open) {
            if (open)
                take(id, *open, counting);
        });
}

void ProvisionalChanges::take(DeviceId id, const std::vector<SettingsChange> &open, bool counting)
{
    Device *device = m_session.find(id);
    std::erase_if(m_entries, [&](const Entry &entry) {
        return !m_session.find(entry.device)
            || (entry.device == id && std::none_of(open.begin(), open.end(), [&entry](const SettingsChange &change) {
                   return change.number == entry.change.number;
               }));
    });
    for (const SettingsChange &change : open) {
        if (!device || find(id, change.number))
            continue;
        m_entries.push_back({id, change, std::nullopt});
        const bool isNew = counting && &change == &open.back();
        if (isNew || actsLater(device->family(), change))
            m_entries.back().confirmation.emplace(change.values);
    }
    tick();
    m_surroundings.changed();
}

/// What is due is offered until it went back: a busy device, or a lost link, is no reason to forget it.
void ProvisionalChanges::tick()
{
    const Instant now = m_session.clock().now();
    std::vector<std::pair<DeviceId, std::int64_t>> due;
    bool counts = false;
    for (Entry &entry : m_entries) {
        const Device *device = m_session.find(entry.device);
        if (!device || !entry.confirmation)
            continue;
        counts = true;
        if (entry.confirmation->look(*device, now) != Confirmation::State::Due)
            continue;
        entry.confirmation.reset();
        due.emplace_back(entry.device, entry.change.number);
    }
    if (counts)
        m_timer.startIn(lookEvery, [this] { tick(); });
    for (const auto &[id, change] : due)
        putBack(id, change, {});
    if (counts)
        m_surroundings.changed();
}

void ProvisionalChanges::keep(DeviceId id, std::int64_t change, Finished finished)
{
    Entry *entry = find(id, change);
    const Device *device = m_session.find(id);
    settings::SettingsLog *log = m_surroundings.log();
    if (!entry || !device || !log) {
        if (finished)
            finished(fail(Fault::OutOfRange, "this change waits for nobody"));
        return;
    }
    entry->confirmation.reset(); // somebody has decided, whatever the disk does
    m_asking.spawn<void>(settings::keepChange(*device, change, *log),
        [this, id, change, finished = std::move(finished)](const Result<void> &kept) {
            if (const Device *still = m_session.find(id); still && !kept)
                m_surroundings.notice(Severity::Caution, *still, kept.error().text());
            if (Entry *decided = find(id, change); decided && kept)
                m_entries.remove_if([decided](const Entry &other) { return &other == decided; });
            m_surroundings.changed();
            if (finished)
                finished(kept);
        });
}

void ProvisionalChanges::putBack(DeviceId id, std::int64_t change, Finished finished)
{
    const Entry *entry = find(id, change);
    settings::SettingsLog *log = m_surroundings.log();
    if (!entry || !log) {
        if (finished)
            finished(fail(Fault::OutOfRange, "this change waits for nobody"));
        return;
    }
    m_surroundings.operate(
        id, "Put values back",
        [log, wanted = entry->change](
            Device &device, Progress &progress) { return settings::putBack(device, wanted, *log, progress); },
        [this, id, finished = std::move(finished)](const Result<void> &result) {
            if (const Device *device = m_session.find(id))
                m_surroundings.notice(result ? Severity::Good : Severity::Danger, *device,
                    result ? "the values are put back" : "the values are not put back: " + result.error().text());
            look(id, false);
            if (finished)
                finished(result);
        });
}

std::vector<UnconfirmedView> ProvisionalChanges::views() const
{
    std::vector<UnconfirmedView> views;
    for (const Entry &entry : m_entries) {
        const Device *device = m_session.find(entry.device);
        if (!device)
            continue;
        UnconfirmedView view{entry.device, entry.change.number, settings::textOf(device->family(), entry.change),
            stateOf(entry.confirmation), 0.0};
        if (entry.confirmation)
            view.left = std::chrono::duration<double>(entry.confirmation->left(m_session.clock().now())).count();
        views.push_back(std::move(view));
    }
    return views;
}

} // namespace mb
