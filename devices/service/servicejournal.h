// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/task.h"
#include "service/visit.h"

#include <set>

namespace mb::service {

/// A number that a unit is to get.
struct NumberWish {
    std::string scope; ///< numberScopeOf()
    std::string
        unit; ///< numberOwnerOf(): it gets the same number whenever it asks again, at any station of the journal
    std::string visit;
    int first = 1;
    int last = 63;       ///< of the family
    std::set<int> taken; ///< by others that are connected now
    bool simulated = false;
};

/// Which visits are meant; what is empty, or nothing, leaves it open.
struct VisitFilter {
    std::string recipe;
    std::string recipeHash;
    std::string run;
    std::string station;
    std::string unit;
    std::string serial;
    std::optional<double> since; ///< Unix, s
    std::optional<Outcome> outcome;
    std::optional<bool> simulated;
    int newest = 0;    ///< only so many, the last of them; 0: all
    bool steps = true; ///< with their steps
};

/// Where every unit is written down. Thread of the session; whoever implements it waits for disk and server in a thread of its
/// own where that matters. Everything that write() has taken is on this computer's disk when it ends, whether a server answers or not.
class ServiceJournal {
public:
    virtual ~ServiceJournal() = default;

    /// A new visit: it with its id, the present time, station and person.
    [[nodiscard]] virtual Task<Visit> open(Visit visit) = 0;
    /// What is known of a visit by now, in place of what was; its last step gets the present time. NotKept with the cause,
    /// such as a full disk.
    [[nodiscard]] virtual Task<Visit> write(Visit visit) = 0;
    /// Oldest first.
    [[nodiscard]] virtual Task<std::vector<Visit>> visits(VisitFilter filter) = 0;
    /// Reserved for this unit for good, by nobody else; nothing where all are given, up to the highest. Timeout: there is none
    /// left here, and the server that has more does not answer.
    [[nodiscard]] virtual Task<std::optional<int>> number(NumberWish wish) = 0;
};

} // namespace mb::service
