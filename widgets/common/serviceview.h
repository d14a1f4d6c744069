// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "service/servicequeue.h"

#include <memory>
#include <string>
#include <vector>

namespace mb {

/// Where the journal is kept, and how far that has got. A value.
struct JournalState {
    std::string server;  ///< address that stations share; empty: this computer's file alone
    std::string station; ///< name of this one in it
    int waiting = 0;     ///< entries that the server has not got
    Message trouble;     ///< why it did not take them; empty: it did

    friend bool operator==(const JournalState &, const JournalState &) = default;
};

/// A queue of units that is served, as the window sees it at one moment. A value.
struct ServiceView {
    bool running = false;   ///< units are served, or waited for
    bool pausing = false;   ///< after this unit
    bool armed = false;     ///< self-tests may turn the motor
    Instant armedUntil{};   ///< without a unit until then
    bool permitted = false; ///< that runs already what turns a motor; a FAIL disarms what is to come and leaves it this
    bool announces = false; ///< a motor turns within three seconds
    bool waits = false;     ///< a unit waits for its self-test until the station is armed
    std::vector<std::string> links;
    std::shared_ptr<const service::RecipeMatter> matter; ///< by which they are; nullptr: nothing has begun
    std::string run;                                     ///< to be gone on with; empty: nothing has begun
    Message trouble;                                     ///< what ended it before its time
    std::vector<service::QueueRow> rows;                 ///< in the order in which units were found
    service::QueueCounts counts;

    /// The recipe has a self-test that turns the motor: it can be armed while it runs.
    [[nodiscard]] bool moves() const { return matter && matter->recipe.test; }
};

} // namespace mb
