// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/console.h"
#include "settings/writing.h"
#include "storage/settingsbook.h"
#include "storage/trialbook.h"

#include <memory>

namespace mb::console {

/// The user's notebook of trials, snapshots and writes, as a verb uses it. What goes wrong with it is noted, and is no end of the verb.
class Notebook {
public:
    explicit Notebook(Console &console);

    /// nullptr when it cannot be opened for writing.
    [[nodiscard]] tuning::ExperimentJournal *book() { return m_book.get(); }
    /// The same for snapshots and writes.
    [[nodiscard]] SettingsBook *settings() { return m_settings.get(); }
    /// Takes a snapshot of a device before many of its values change; a note says which.
    [[nodiscard]] Task<void> keepBefore(Device &device, settings::Occasion occasion);
    /// Into the history: what the values of a device were before this verb, which is `origin`, replaced them (settings/writing.h).
    [[nodiscard]] Task<void> keepReplaced(Device &device, settings::Numbers before, settings::Origin origin);
    /// What earlier experiments owe to this unit: settled where the unit has it; else put back, with `agreed` or when somebody
    /// at the terminal says so, or named with its remedy.
    [[nodiscard]] Task<void> settleOwed(Device &device, bool agreed);

private:
    Console &m_console;
    std::unique_ptr<Database> m_database;
    std::unique_ptr<TrialBook> m_book;
    std::unique_ptr<SettingsBook> m_settings;
};

} // namespace mb::console
