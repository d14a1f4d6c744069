// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/operation.h"
#include "model/session.h"
#include "model/shared.h"
#include "service/visit.h"

#include <map>
#include <memory>

namespace mb::service {

/// Where a row of the queue stands. The last three are the words of Outcome.
enum class RowState { Waiting, Running, Skipped, Passed, Failed, Refused };
/// The word of a verdict for a row; Waiting while there is none.
[[nodiscard]] RowState stateOf(Outcome outcome);

/// One unit of the queue, for a window. What is empty is not known.
struct QueueRow {
    std::uint32_t id = 0; ///< stable while the queue lives
    DeviceId device;      ///< in the session of its bus
    std::string link;     ///< address
    RowState state = RowState::Waiting;
    Visit visit;  ///< as the journal has it; before its turn unit, serial and device only
    Message what; ///< what is being done now
    int done = 0;
    int total = 0;                  ///< 0: unknown length
    bool mayInterrupt = true;       ///< false: power must stay on
    std::map<int, PartState> parts; ///< of an update
    Instant startedAt{};            ///< of the queue's clock
    int tries = 0;                  ///< begun so often in this queue
    /// What was said of it, oldest first, of all its tries; never changed, another one takes its place. nullptr: nothing.
    std::shared_ptr<const std::vector<LogLine>> log;
};

} // namespace mb::service
