// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/checkrow.h"

#include <string>

namespace mb {

struct JournalState;
struct Snapshot;

/// What must hold before a unit is served. GUI thread.
class UnitChecks : public CheckRow {
    Q_OBJECT
public:
    enum Check { LinkOpen, UnitAnswers, NothingTurns, JournalTakes, Checks };

    explicit UnitChecks(const ThemeSource &theme, QWidget *parent);
    /// What the window knows of the link that units are put on, of what is on it, and of the journal.
    void follow(const Snapshot &shot, const JournalState &journal, const std::string &link);
};

} // namespace mb
