// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/experimentjournal.h"
#include "model/device.h"

namespace mb::tuning {

/// After this a unit that stores by itself has done so.
[[nodiscard]] Duration storingTime(const Device &device);
/// It stores what is written by itself, and not at once: what was put back counts when that is proved.
[[nodiscard]] bool storesLater(const Device &device);

/// What earlier experiments still owe to this unit and it has not, oldest first; not what another program is about. What it has is settled on the way; where it
/// stores later, only once it must have stored it and its flash says so, until when nobody is asked. What was put back and is
/// neither as before nor as tried was written since, and is owed no more. Reads, and writes nothing to the unit.
[[nodiscard]] Task<std::vector<OwedGains>> lookForOwed(Device &device, ExperimentJournal &journal);
/// The same of what the journal was asked for already. Who may not wait for a unit to store leaves what it has owed, and is told of the rest.
[[nodiscard]] Task<std::vector<OwedGains>> stillOwed(
    Device &device, ExperimentJournal &journal, std::vector<OwedGains> owed, bool mayWait = true);

/// What a trial has changed is as before again: settled, or, where the unit stores later, owed from now on until that is proved.
[[nodiscard]] Task<void> markPutBack(Device &device, ExperimentJournal &journal, std::int64_t trial);

/// Puts back what a trial owes, as above; first waits at most 5 s for the motor to come to rest. Fails, and owes on, when another master
/// drives it or it turns on, where no stop is sent, when it is not seen to stand (Unsafe), when a value reads back different (BadCheck), or
/// with the link.
[[nodiscard]] Task<void> payOwed(Device &device, ExperimentJournal &journal, OwedGains owed);

/// "slot0.p=1.165 slot0.i=0.00346", as `set` takes it.
[[nodiscard]] std::string assignmentsOf(const Family &family, const std::vector<OwedValue> &values);

} // namespace mb::tuning
