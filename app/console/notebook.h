// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/console.h"
#include "storage/trialbook.h"

#include <memory>

namespace mb::console {

/// The user's notebook of trials, as a verb uses it. What goes wrong with it is noted, and is no end of the verb.
class Notebook {
public:
    explicit Notebook(Console &console);

    /// nullptr when it cannot be opened for writing.
    [[nodiscard]] tuning::ExperimentJournal *book();
    /// Of the trial that was begun last.
    [[nodiscard]] std::optional<std::int64_t> number() const;
    /// What earlier experiments owe to this unit: settled where the unit has it, named with its remedy where not.
    [[nodiscard]] Task<void> lookForDebts(Device &device);

private:
    class Numbered;

    Console &m_console;
    std::unique_ptr<Database> m_database;
    std::shared_ptr<Numbered> m_book;
};

} // namespace mb::console
