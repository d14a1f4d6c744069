// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/busrows.h"

#include "model/family.h"
#include "model/heardsince.h"
#include "model/identity.h"
#include "model/unit.h"

#include <algorithm>
#include <string>
#include <utility>

namespace mb::service {
namespace {

/// Where the unit of a visit was.
std::string linkOf(const Visit &visit)
{
    return std::string(partsOf(visit.device).link);
}

/// Who answers as its unit does is the one of this visit. Who stands in a place may be another than the one that has ended there, or
/// that was given another number there; one that was cut off before that goes on.
bool goesOnHere(const Visit &visit)
{
    const bool isRenumbered = visit.number && visit.unit != renumberedPlaceKey(visit.unit, *visit.number);
    const auto isGiven
        = [isRenumbered](const StepEntry &entry) { return isRenumbered && entry.step == Step::Number && entry.ended; };
    return unitByOf(visit.unit) != UnitBy::Place
        || (visit.outcome == Outcome::Open && std::ranges::none_of(visit.steps, isGiven));
}

} // namespace

BusRows::BusRows(Session &session, Link &link, Wanted wanted, std::uint32_t &lastRow)
    : m_session(session)
    , m_link(link)
    , m_wanted(wanted)
    , m_lastRow(lastRow)
{
}

void BusRows::take(const std::vector<Device *> &found, const Row *serving)
{
    for (Row &row : m_rows) {
        row.seen = false;
        row.gone = row.gone || isGone(row, row.silentAt);
    }
    for (Device *const device : found) {
        if (device->family().key == m_wanted.family->key)
            notice(*device);
    }
    if (m_isFirstLook) {
        recall(found);
        addMissing();
    }
    markAbsent(serving);
    m_isFirstLook = false;
}

void BusRows::notice(Device &device)
{
    const std::string unit = unitKeyOf(device);
    Row *known = rowOf(device, unit);
    if (!known)
        known = missingOf(device);
    if (!known) {
        if (!m_wanted.once || m_isFirstLook)
            addRow(device, unit);
        return;
    }
    if (std::exchange(known->missing, false))
        known->shown.edit().what = {};
    known->moved = known->moved || isMoved(known->shown->visit, device);
    known->seen = true;
    known->absentAt.reset();
    known->gone = false;
    if (known->shown->device != m_session.idOf(device)) {
        known->shown.edit().device = m_session.idOf(device);
        follow(*known, device);
    }
}

void BusRows::follow(Row &row, Device &device)
{
    row.silentAt.reset();
    row.hearing = device.changed().add([this, &row, &device] { hear(row, device); });
}

/// A look asks a place once, and may take longer than it takes to change the unit in it; a device is asked all the time. Of the
/// silence of a link that is lost nothing follows, nor of that of a bootloader, which speaks only when it is asked.
void BusRows::hear(Row &row, const Device &device)
{
    if (device.identity().state == DeviceState::Bootloader) {
        row.silentAt.reset();
    } else if (!device.liveness().heard) {
        if (!row.silentAt && m_link.state() == LinkState::Open)
            row.silentAt = now();
    } else if (isGone(row, std::exchange(row.silentAt, {}))) {
        row.gone = true;
        m_isAnyBack = true;
    }
}

bool BusRows::isHeard(const Row &row) const
{
    const Device *const device = m_session.find(row.shown->device);
    return device && device->liveness().heard && unitKeyOf(*device) == row.shown->visit.unit;
}

void BusRows::served(Row &row)
{
    row.silentAt.reset();
    if (const Device *const device = m_session.find(row.shown->device))
        hear(row, *device);
}

bool BusRows::isGone(const Row &row, const std::optional<Instant> &since) const
{
    return since && !m_wanted.once && !row.missing && row.shown->state != RowState::Running
        && now() - *since >= exchangeTime;
}

/// By the number that was given here first, however long it was gone; else by its name, while it was not gone. One that another
/// has taken in this look is no longer free.
BusRows::Row *BusRows::rowOf(const Device &device, const std::string &unit)
{
    Row *known = nullptr;
    for (Row &row : m_rows) {
        if (isMoved(row.shown->visit, device))
            return &row;
        if (row.shown->visit.unit == unit && !row.gone && !row.moved && !row.seen
            && (!known || known->shown->device != m_session.idOf(device)))
            known = &row;
    }
    return known;
}

void BusRows::addRow(Device &device, const std::string &unit)
{
    Row &row = m_rows.emplace_back();
    row.seen = true;
    follow(row, device);
    QueueRow &shown = row.shown.edit();
    shown.id = ++m_lastRow;
    shown.device = m_session.idOf(device);
    shown.link = m_link.address().text();
    shown.visit.unit = unit;
    shown.visit.serial = device.identity().serial;
    shown.visit.device = device.selector();
    shown.visit.family = device.identity().family;
    shown.visit.from = device.identity().firmware;
    shown.state = m_wanted.onlyChosen ? RowState::Skipped : RowState::Waiting;
}

/// What the run that is resumed knows of those that are here: done, or cut off.
void BusRows::recall(const std::vector<Device *> &found)
{
    for (const Visit &visit : m_wanted.earlier) {
        const auto moved = std::ranges::find_if(found, [&](const Device *device) { return isMoved(visit, *device); });
        const DeviceId id = moved == found.end() ? DeviceId{} : m_session.idOf(**moved);
        for (Row &row : m_rows) {
            const bool here = row.shown->visit.unit == visit.unit && goesOnHere(visit);
            if (moved == found.end() ? !here : row.shown->device != id)
                continue;
            row.moved = moved != found.end();
            row.shown.edit().visit = visit;
            row.shown.edit().state = stateOf(visit.outcome);
        }
    }
}

/// It answers under the number that this visit has given to a unit without a serial number.
bool BusRows::isMoved(const Visit &visit, const Device &device) const
{
    const std::string unit = unitKeyOf(device);
    return visit.unit != unit && visit.number == device.identity().address && unitByOf(unit) == UnitBy::Place
        && unitByOf(visit.unit) == UnitBy::Place && linkOf(visit) == m_link.address().text();
}

/// Units that were being served here when the program ended, and do not answer now: they stay in sight.
void BusRows::addMissing()
{
    for (const Visit &visit : m_wanted.earlier) {
        const bool known = std::ranges::any_of(m_rows, [&visit](const Row &row) {
            return row.shown->visit.id == visit.id || (row.shown->visit.unit == visit.unit && goesOnHere(visit));
        });
        if (known || visit.outcome != Outcome::Open || linkOf(visit) != m_link.address().text())
            continue;
        Row &row = m_rows.emplace_back();
        row.missing = true;
        QueueRow &shown = row.shown.edit();
        shown.id = ++m_lastRow;
        shown.link = m_link.address().text();
        shown.visit = visit;
        shown.what = say("does not answer");
    }
}

BusRows::Row *BusRows::missingOf(const Device &device)
{
    const std::string unit = unitKeyOf(device);
    const auto found = std::ranges::find_if(m_rows, [&](const Row &row) {
        return row.missing && (row.shown->visit.unit == unit || isMoved(row.shown->visit, device));
    });
    return found == m_rows.end() ? nullptr : &*found;
}

bool BusRows::isAnyMissing() const
{
    return std::ranges::any_of(m_rows, [](const Row &row) { return row.isMissed(); });
}

/// Where units come and go: who waits and is gone leaves the list, who has ended may begin again when it was gone for long enough.
void BusRows::markAbsent(const Row *serving)
{
    for (Row &row : m_rows) {
        if (row.seen)
            continue;
        if (isHeard(row)) { // one look has missed it
            row.absentAt.reset();
            continue;
        }
        row.absentAt = row.absentAt.value_or(now());
        row.gone = row.gone || isGone(row, row.absentAt);
    }
    if (!m_wanted.once)
        m_rows.remove_if([serving](const Row &row) {
            return &row != serving && row.gone && row.shown->state == RowState::Waiting && row.shown->visit.id.empty();
        });
}

bool BusRows::hasTwin(const Row &row) const
{
    const std::string &unit = row.shown->visit.unit;
    return row.seen && unitByOf(unit) == UnitBy::Serial && std::ranges::any_of(m_rows, [&](const Row &other) {
        return &other != &row && other.seen && other.shown->visit.unit == unit;
    });
}

bool BusRows::hasWaiting() const
{
    return std::ranges::any_of(m_rows, [](const Row &row) { return row.shown->state == RowState::Waiting; });
}

BusRows::Row *BusRows::next()
{
    const auto found = std::ranges::find_if(m_rows, [this](const Row &row) {
        return row.shown->state == RowState::Waiting && !row.missing && (row.seen || m_wanted.once);
    });
    return found == m_rows.end() ? nullptr : &*found;
}

BusRows::Row *BusRows::find(std::uint32_t id)
{
    const auto found = std::ranges::find_if(m_rows, [id](const Row &row) { return row.shown->id == id; });
    return found == m_rows.end() ? nullptr : &*found;
}

std::set<int> BusRows::numbersBeside(const Row &row) const
{
    std::set<int> taken;
    for (const Row &other : m_rows) {
        const Device *const device = m_session.find(other.shown->device);
        if (&other != &row && device && !other.gone)
            taken.insert(device->identity().address);
    }
    return taken;
}

} // namespace mb::service
