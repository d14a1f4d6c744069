// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/kepttrial.h"
#include "model/identity.h"
#include "model/parameterstore.h"
#include "service/visit.h"
#include "tuning/kepttuning.h"

#include <QString>

#include <functional>
#include <string>
#include <vector>

namespace mb {

struct Family;

/// What is told of one unit. Values; what is empty is left out.
struct ReportUnit {
    const Family *family = nullptr; ///< nullptr: of a family that this program does not know
    Identity identity;              ///< as far as it is known; from a notebook family and address only
    std::string unit;               ///< as Trial::unit
    std::string selector;
    bool simulated = false;
    std::vector<ParameterStore::Entry> parameters; ///< in table order; empty: nobody has read them
    std::vector<KeptTuning> tunings;               ///< in full, the trials of their proof with signals
    std::vector<KeptTrial> trials;                 ///< in full, with signals
    std::vector<KeptTrial> sines;                  ///< of a frequency response, the newest, with signals
    std::vector<KeptTrial> history;                ///< every trial of the unit, one line each
    std::vector<service::Visit> visits;            ///< every service of it, oldest first

    /// What it tells of itself, as a unit that answers does; what the notebook has of it stays, as whom it knows it too.
    void describe(const ReportUnit &who);
};

/// What a report is to be about: trials by number, of one unit (unitKeyOf()) where that is given, or all that matters of it.
struct ReportWish {
    std::vector<std::int64_t> trials;
    std::string unit;
    bool tuningsOnly = false; ///< the trials name the tunings that are wanted, and are not shown by themselves
    /// Of the unit's services the last that counts, and of one that is known by its place the only one; empty: all of them do.
    std::string visit{};
};

/// What a service engineer hands to a customer: who a unit is, what was measured, with which gains and how it was proven.
struct Report {
    double time = 0.0;   ///< Unix time when it was made, s
    std::string program; ///< "MotorBench 0.1.0"
    std::vector<ReportUnit> units;
    /// Words of devices and tables in the language of the reader; English as they are without it.
    std::function<QString(const Message &)> phrase;

    [[nodiscard]] bool isSimulated() const;
};

} // namespace mb
