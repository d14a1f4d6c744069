// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/experimentjournal.h"
#include "experiment/trial.h"
#include "model/parametertransfer.h"

namespace mb::tuning {

/// The remedy where gains could not be put back because they cannot be read.
[[nodiscard]] Message writeOrKeep();
/// OutOfRange for a parameter that is no part of an experiment: read-only, live, or named so by the family.
[[nodiscard]] Result<void> checkTried(const Family &family, ParameterIndex index);
/// Those that an experiment may write.
[[nodiscard]] std::vector<ParameterChange> triable(const Family &family, const std::vector<ParameterChange> &changes);

/// Values of the loop's parameters, read where they can be; nothing for what is not known.
[[nodiscard]] Task<std::vector<std::pair<std::string, std::optional<double>>>> readGains(
    Device &device, Mode mode, int axis, int slot);

/// Whether every gain of the loop can be put back: is read, or was written by this program since the unit's last known reset. OutOfRange
/// with the remedy; asks the device nothing.
[[nodiscard]] Result<void> checkPutBack(const Device &device, Mode mode, int axis, int slot);

/// What `changes` would replace. OutOfRange with the remedy where that cannot be read, and was not written by this program
/// since the unit's last known reset.
[[nodiscard]] Task<std::vector<OwedValue>> readReplaced(Device &device, std::vector<ParameterChange> changes);

/// Writes in the order of writeParameters() and compares; BadCheck when a read-back differs. Where one cannot be read back, all of
/// them twice: what the wire lost would leave a mixture in force. Ends at the first error.
[[nodiscard]] Task<void> writeGains(Device &device, std::vector<ParameterChange> changes);

[[nodiscard]] std::vector<ParameterChange> changesOf(const Family &family, const std::vector<OwedValue> &values);

/// The same as a trial keeps them: in their units, by key.
[[nodiscard]] std::vector<std::pair<std::string, std::optional<double>>> numbersOf(
    const Family &family, const std::vector<ParameterChange> &changes);

/// A changed value that is fully in force after a restart only (TrialTraits::atBoot).
[[nodiscard]] bool needsRestart(const Device &device, const std::vector<ParameterChange> &changes);

} // namespace mb::tuning
