// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/busrows.h"

#include "model/family.h"
#include "settings/unit.h"

#include <algorithm>
#include <utility>

namespace mb::service {
namespace {

using namespace std::chrono_literals;

constexpr Duration goneAfter = 2s;

/// Where the unit of a visit was.
std::string linkOf(const Visit &visit)
{
    return visit.device.substr(0, visit.device.rfind('/'));
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
    for (Row &row : m_rows)
        row.seen = false;
    for (const Device *const device : found) {
        if (device->family().key == m_wanted.family->key)
            notice(*device);
    }
    if (m_isFirstLook)
        addMissing();
    markAbsent(serving);
    m_isFirstLook = false;
}

void BusRows::notice(const Device &device)
{
    const std::string unit = settings::unitOf(device).key;
    Row *known = nullptr;
    for (Row &row : m_rows) {
        if (row.shown.visit.unit == unit && !row.gone)
            known = &row;
    }
    if (!known)
        known = missingOf(device);
    if (!known) {
        if (!m_wanted.once || m_isFirstLook)
            addRow(device, unit);
        return;
    }
    if (std::exchange(known->missing, false))
        known->shown.what = {};
    known->seen = true;
    known->absentAt.reset();
    known->shown.device = m_session.idOf(device);
}

void BusRows::addRow(const Device &device, const std::string &unit)
{
    Row &row = m_rows.emplace_back();
    row.seen = true;
    row.shown.id = ++m_lastRow;
    row.shown.device = m_session.idOf(device);
    row.shown.link = m_link.address().text();
    row.shown.visit.unit = unit;
    row.shown.visit.serial = device.identity().serial;
    row.shown.visit.device = device.selector();
    row.shown.visit.family = device.identity().family;
    row.shown.visit.from = device.identity().firmware;
    row.shown.state = m_wanted.onlyChosen ? RowState::Skipped : RowState::Waiting;
    if (m_isFirstLook)
        recallInto(row, device);
}

/// What the run that is resumed knows of this unit: done, or cut off. One that was given its number may be told by that only.
void BusRows::recallInto(Row &row, const Device &device)
{
    const std::string unit = row.shown.visit.unit;
    for (const Visit &visit : m_wanted.earlier) {
        if (!isThis(visit, unit, device))
            continue;
        row.shown.visit = visit;
        row.shown.state = stateOf(visit.outcome);
    }
}

bool BusRows::isThis(const Visit &visit, const std::string &unit, const Device &device) const
{
    const bool atItsNumber = settings::byOf(unit) != settings::Unit::By::Serial
        && visit.number == device.identity().address && settings::byOf(visit.unit) != settings::Unit::By::Serial
        && linkOf(visit) == m_link.address().text();
    return visit.unit == unit || atItsNumber;
}

/// Units that were being served here when the program ended, and do not answer now: they stay in sight.
void BusRows::addMissing()
{
    for (const Visit &visit : m_wanted.earlier) {
        const bool known = std::any_of(m_rows.begin(), m_rows.end(),
            [&visit](const Row &row) { return row.shown.visit.id == visit.id || row.shown.visit.unit == visit.unit; });
        if (known || visit.outcome != Outcome::Open || linkOf(visit) != m_link.address().text())
            continue;
        Row &row = m_rows.emplace_back();
        row.missing = true;
        row.shown.id = ++m_lastRow;
        row.shown.link = m_link.address().text();
        row.shown.visit = visit;
        row.shown.what = say("does not answer");
    }
}

BusRows::Row *BusRows::missingOf(const Device &device)
{
    const std::string unit = settings::unitOf(device).key;
    const auto found = std::find_if(m_rows.begin(), m_rows.end(),
        [&](const Row &row) { return row.missing && isThis(row.shown.visit, unit, device); });
    return found == m_rows.end() ? nullptr : &*found;
}

bool BusRows::isAnyMissing() const
{
    return std::any_of(m_rows.begin(), m_rows.end(), [](const Row &row) { return row.isMissed(); });
}

/// Where units come and go: who waits and is gone leaves the list, who has ended may begin again when it was gone for long enough.
void BusRows::markAbsent(const Row *serving)
{
    const Instant now = m_session.clockOf(m_link).now();
    for (Row &row : m_rows) {
        if (row.seen)
            continue;
        if (!row.absentAt)
            row.absentAt = now;
        row.gone = row.gone || (!m_wanted.once && !row.missing && now - *row.absentAt >= goneAfter);
    }
    if (!m_wanted.once)
        m_rows.remove_if([serving](const Row &row) {
            return &row != serving && row.gone && row.shown.state == RowState::Waiting && row.shown.visit.id.empty();
        });
}

bool BusRows::hasWaiting() const
{
    return std::any_of(
        m_rows.begin(), m_rows.end(), [](const Row &row) { return row.shown.state == RowState::Waiting; });
}

BusRows::Row *BusRows::next()
{
    const auto found = std::find_if(m_rows.begin(), m_rows.end(), [this](const Row &row) {
        return row.shown.state == RowState::Waiting && !row.missing && (row.seen || m_wanted.once);
    });
    return found == m_rows.end() ? nullptr : &*found;
}

BusRows::Row *BusRows::find(std::uint32_t id)
{
    const auto found = std::find_if(m_rows.begin(), m_rows.end(), [id](const Row &row) { return row.shown.id == id; });
    return found == m_rows.end() ? nullptr : &*found;
}

std::set<int> BusRows::numbersBeside(const Row &row) const
{
    std::set<int> taken;
    for (const Row &other : m_rows) {
        const Device *const device = m_session.find(other.shown.device);
        if (&other != &row && device && !other.gone)
            taken.insert(device->identity().address);
    }
    return taken;
}

} // namespace mb::service
