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

/// What turns a motor by itself where units are served. After a FAIL it is what turns already, and no other.
enum class MayTurn { Nothing, WhatTurns, Every };

/// A queue of units that is served, as the window sees it at one moment. A value.
struct ServiceView {
    bool running = false;   ///< units are served, or waited for
    bool pausing = false;   ///< after this unit
    bool finishing = false; ///< ended by its user or its numbers: nothing is served again in it
    MayTurn mayTurn = MayTurn::Nothing;
    Instant armedUntil{}; ///< without a unit until then
    int announced = 0;    ///< units whose motor turns within three seconds
    int waiting = 0;      ///< units that were in their self-test before the station was armed
    std::vector<std::string> links;
    std::shared_ptr<const service::RecipeMatter> matter; ///< by which they are; nullptr: nothing has begun
    std::string run;                                     ///< to be gone on with; empty: nothing has begun
    Message trouble;                                     ///< what ended it before its time
    std::vector<Shared<service::QueueRow>> rows;         ///< in the order in which units were found
    service::QueueCounts counts;

    [[nodiscard]] bool isArmed() const { return mayTurn == MayTurn::Every; }
    [[nodiscard]] bool waitsForArm() const { return waiting > 0 && !isArmed(); }
    /// The recipe has a self-test that turns the motor: it can be armed while it runs.
    [[nodiscard]] bool moves() const { return matter && matter->recipe.test; }
};

} // namespace mb
