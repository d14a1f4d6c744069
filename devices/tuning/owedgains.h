// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/device.h"
#include "tuning/experimentjournal.h"

namespace mb::tuning {

/// What earlier experiments still owe to this unit, oldest first: what it has meanwhile is settled on the way. Reads the
/// values that are owed, and nothing else; writes nothing to the unit.
[[nodiscard]] Task<std::vector<OwedGains>> lookForOwed(Device &device, ExperimentJournal &journal);

/// Puts back what a trial owes, and settles it once the unit has it. Fails, and owes on, when the motor is not seen to stand
/// (Unsafe), when a value reads back different (BadCheck), or with the link.
[[nodiscard]] Task<void> payOwed(Device &device, ExperimentJournal &journal, OwedGains owed);

/// "slot0.p=1.165 slot0.i=0.00346", as `set` takes it.
[[nodiscard]] std::string assignmentsOf(const Family &family, const std::vector<OwedValue> &values);

} // namespace mb::tuning
