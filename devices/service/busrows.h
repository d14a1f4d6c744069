// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/session.h"
#include "service/queuerow.h"

#include <list>
#include <set>
#include <string>
#include <utility>

namespace mb::service {

/// Who is on one bus of a queue, as one look after the other tells it: units that come and go, those that the journal knows of an
/// earlier run, and those that were cut off then and do not answer now. Thread of the queue.
class BusRows {
public:
    struct Row {
        Published<QueueRow> shown;
        bool seen = false;               ///< in the last look
        std::optional<Instant> absentAt; ///< since when no look saw it
        std::optional<Instant> silentAt; ///< since when it is not heard, however long a look takes; not of a bootloader
        bool gone = false;               ///< long enough to begin again
        bool missing = false;            ///< cut off in the run that is resumed, and not seen since
        bool moved = false;              ///< seen under the number that it was given: its first place is another's now
        Subscription hearing;
        [[nodiscard]] bool isMissed() const { return missing && shown->state == RowState::Waiting; }
    };
    /// All of it outlives the rows.
    struct Wanted {
        const Family *family;
        const std::vector<Visit> &earlier; ///< of the run that is resumed
        bool once;                         ///< what the first look finds; else units as they are put on
        bool onlyChosen;                   ///< what is found waits as Skipped
    };
    /// `lastRow`: of the whole queue, counted up.
    BusRows(Session &session, Link &link, Wanted wanted, std::uint32_t &lastRow);

    /// What a scan of the link has found; `serving` stays whatever it was.
    void take(const std::vector<Device *> &found, const Row *serving);
    /// One of them; also without a look.
    void notice(Device &device);
    /// It was served: what was not heard meanwhile was its own doing.
    void served(Row &row);
    /// Somebody is heard where one was gone, since the last call; a look tells who.
    [[nodiscard]] bool isAnyBack() { return std::exchange(m_isAnyBack, false); }
    [[nodiscard]] std::list<Row> &all() { return m_rows; }
    [[nodiscard]] const std::list<Row> &all() const { return m_rows; }
    [[nodiscard]] bool hasWaiting() const;
    [[nodiscard]] bool isAnyMissing() const;
    /// nullptr: nobody is there whose turn it is.
    [[nodiscard]] Row *next();
    [[nodiscard]] Row *find(std::uint32_t id);
    /// Of the other units that are there.
    [[nodiscard]] std::set<int> numbersBeside(const Row &row) const;
    /// Another one that was here at the last look tells the same serial number.
    [[nodiscard]] bool hasTwin(const Row &row) const;

private:
    [[nodiscard]] Row *rowOf(const Device &device, const std::string &unit);
    void addRow(Device &device, const std::string &unit);
    void follow(Row &row, Device &device);
    void hear(Row &row, const Device &device);
    [[nodiscard]] Instant now() const { return m_session.clockOf(m_link).now(); }
    [[nodiscard]] bool isHeard(const Row &row) const;
    [[nodiscard]] bool isGone(const Row &row, const std::optional<Instant> &since) const;
    void recall(const std::vector<Device *> &found);
    [[nodiscard]] bool isMoved(const Visit &visit, const Device &device) const;
    void addMissing();
    [[nodiscard]] Row *missingOf(const Device &device);
    void markAbsent(const Row *serving);

    Session &m_session;
    Link &m_link;
    Wanted m_wanted;
    std::uint32_t &m_lastRow;
    std::list<Row> m_rows;
    bool m_isFirstLook = true;
    bool m_isAnyBack = false;
};

} // namespace mb::service
