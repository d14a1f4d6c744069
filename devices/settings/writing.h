// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/parametertransfer.h"
#include "settings/settingslog.h"

#include <functional>

namespace mb::settings {

/// Told the number of a change when it is in the history, before the first value is written.
using Begun = std::function<void(std::int64_t)>;

struct Order {
    Origin origin = Origin::Window;
    Purpose purpose = Purpose::Write;
    std::optional<std::int64_t> of{}; ///< SettingsChange::of
    Begun begun{};
};

/// writeParameters() that is in the history: what is there is read first where it can be, the change is on the disk before the
/// first value is written, and what came of each value after the last. A disk that fails costs the entry, not the write, and the
/// progress says so; but what somebody has to keep is not written then: NotKept. Of the window that is whatever toConfirm() has of
/// its write: it becomes Purpose::Provisional. `log` may be nullptr: nothing is kept.
[[nodiscard]] Task<std::vector<TransferOutcome>> writeKept(
    Device &device, std::vector<ParameterChange> changes, Order order, SettingsLog *log, Progress &progress);

/// By key, in the unit of the parameter; nothing for what is not known.
using Numbers = std::vector<std::pair<std::string, std::optional<double>>>;

/// What `changes` are about to replace, read where it can be.
[[nodiscard]] Task<Numbers> numbersBefore(Device &device, std::vector<ParameterChange> changes);

/// Keeps what something else has replaced, such as a tuning: what was there before; what is there now is known of the device.
[[nodiscard]] Task<void> keepReplaced(const Device &device, Numbers before, Origin origin, SettingsLog &log);

/// mb::rewriteSettings() that is in the history; yields how many values were written again.
[[nodiscard]] Task<int> rewriteKept(Device &device, Origin origin, SettingsLog *log, Progress &progress);

/// Device::renumber() that is in the history, of the unit as it was called before; its tag goes with it. Not undone by undo():
/// others may have its old number by now.
[[nodiscard]] Task<void> renumberKept(Device &device, int number, Origin origin, SettingsLog *log, Progress &progress);

/// Writes what was there before the last change that can be undone, and reads it back: a change of its own. Refused where there
/// is none; BadCheck, or the cause, where a value did not come back: then the change can still be undone.
/// Yields the change that it undid.
[[nodiscard]] Task<SettingsChange> undo(
    Device &device, Origin origin, SettingsLog &log, Progress &progress, Begun begun = {});
/// Writes again what the last undo took back.
[[nodiscard]] Task<SettingsChange> redo(
    Device &device, Origin origin, SettingsLog &log, Progress &progress, Begun begun = {});

/// What is known of the device by now, against the history: parameters that are not what they were left as go into it as
/// changed elsewhere. Yields how many; none of a unit that only its place tells. Nothing is asked of the device.
[[nodiscard]] Task<int> noticeForeign(const Device &device, SettingsLog &log);

} // namespace mb::settings
