// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/console.h"
#include "settings/writing.h"
#include "storage/settingsbook.h"
#include "storage/trialbook.h"

#include <memory>
#include <optional>

namespace mb::console {

class Notebook;

/// The user's file, before anything is sent: Usage where it cannot be opened. What was wrong with it is told.
[[nodiscard]] Result<std::unique_ptr<Database>> openNotebook();

/// readParameters() beside the history (settings/storing.h); no notebook is begun for that.
[[nodiscard]] Task<std::vector<TransferOutcome>> readKept(
    Console &console, Device &device, std::vector<ParameterIndex> indices);
/// Into the history, where there is one: what a unit has after its restart is in its flash.
[[nodiscard]] Task<void> keepStored(Console &console, const Device &device);

/// Notebook::owedLines() of a verb that has no notebook; none is begun for that.
[[nodiscard]] Task<std::vector<std::string>> owedLines(Console &console, Device &device);
/// Tells them: what stands in the device is not what its user left there.
[[nodiscard]] Task<void> noteOwed(Console &console, Device &device);

/// What units are called: by themselves, or by what `rename` keeps on this computer for those that store no name. No notebook is
/// begun for that.
class UnitNames {
public:
    explicit UnitNames(Console &console);
    ~UnitNames();
    [[nodiscard]] std::string of(const Device &device);

private:
    Console &m_console;
    std::unique_ptr<Notebook> m_notebook;
};

/// The user's notebook of trials, snapshots and writes, as a verb uses it. One that cannot be opened ends the verbs that are
/// about what it keeps (trouble()), and is a note of those that go on without (noteTrouble()).
class Notebook {
public:
    explicit Notebook(Console &console);

    /// Why it cannot be opened, with its remedy. Usage; nothing where it is open.
    [[nodiscard]] const std::optional<Error> &trouble() const { return m_trouble; }
    /// That, for people: what this verb does is not kept. Once nothing else can be refused.
    void noteTrouble() const;
    /// nullptr when it cannot be opened for writing.
    [[nodiscard]] tuning::ExperimentJournal *book() { return m_book.get(); }
    /// The same for snapshots and writes.
    [[nodiscard]] SettingsBook *settings() { return m_settings.get(); }
    [[nodiscard]] Database &database() { return *m_database; }
    /// Takes a snapshot of a device before many of its values change; a note says which, or that the device could not be
    /// read. Usage where the notebook has no room for it.
    [[nodiscard]] Task<void> keepBefore(Device &device, settings::Occasion occasion);
    /// The same for a verb that writes nothing without it: Usage also where there is no notebook. Then the verb begins.
    [[nodiscard]] Task<void> keepOrRefuse(Device &device, settings::Occasion occasion);
    /// Into the history: what the values of a device were before this verb, which is `origin`, replaced them (settings/writing.h).
    [[nodiscard]] Task<void> keepReplaced(Device &device, settings::Numbers before, settings::Origin origin);
    /// What earlier experiments owe to this unit: settled where the unit has it; else put back, with `agreed` or when somebody
    /// at the terminal says so, or named with its remedy.
    [[nodiscard]] Task<void> settleOwed(Device &device, bool agreed);
    /// The same for who puts nothing back: a line for each trial, with its remedy, but not of what `written` is about to replace.
    [[nodiscard]] Task<std::vector<std::string>> owedLines(Device &device, std::vector<ParameterChange> written = {});

    /// s, the time constant of the motor of an axis, as its newest tuning found it; 0: none did.
    [[nodiscard]] double lagOf(const Device &device, int axis) const;

private:
    /// Owed by trials that have ended; a note says what a living program tries. `mayWait`: until a unit has stored what was put back.
    [[nodiscard]] Task<std::vector<tuning::OwedGains>> owedTo(Device &device, bool mayWait);

    Console &m_console;
    std::optional<Error> m_trouble;
    std::unique_ptr<Database> m_database;
    std::unique_ptr<TrialBook> m_book;
    std::unique_ptr<SettingsBook> m_settings;
};

} // namespace mb::console
