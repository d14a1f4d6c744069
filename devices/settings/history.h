// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "settings/settingslog.h"

#include <map>
#include <optional>
#include <span>

namespace mb {
struct Family;
struct Parameter;
} // namespace mb

namespace mb::settings {

/// What the history of one unit says.
struct HistoryView {
    std::optional<SettingsChange> undo; ///< which change the next undo takes back; nothing: there is none
    std::optional<SettingsChange> redo; ///< which one a redo does again
    /// What each parameter must be now, by key, raw: where the last word about it was seen to be true. A parameter whose last
    /// word is open is not in it.
    std::map<std::string, std::int64_t> values;
};

/// Reads the changes of one unit, oldest first. A change that undid or redid another one moves it; any other one makes an end
/// to redoing. A change of which nothing is known that could be put back is passed over, and so are parameters that must
/// never be part of an undo (TrialTraits::never).
[[nodiscard]] HistoryView viewOf(const Family &family, std::span<const SettingsChange> changes);

/// Those values of a change that were or may have been written, whose value before is known, and that undoing would change.
[[nodiscard]] std::vector<ValueChange> undoable(const Family &family, const SettingsChange &change);

/// Its values can cut a unit off (its number on the bus, its bit rate), or make a motor livelier (a limit).
[[nodiscard]] bool mayHaveToConfirm(const Parameter &parameter);
/// Those of the values that can do so and were not refused, each with what it goes back to as `before`: of a limit that became wider, or
/// was switched off, what was there; of one that nobody can read and nobody knew the tightest. What became safer stays.
[[nodiscard]] std::vector<ValueChange> toConfirm(const Family &family, std::span<const ValueChange> values);

/// A value in a sentence for people: "on", "off", a number.
[[nodiscard]] MessageArgument worded(const Parameter &parameter, std::int64_t raw);
/// "slot0.p: 1.166 → 1.000, slot0.i: ? → 0": what it wrote, for people; empty where the unit took nothing of it.
[[nodiscard]] Message textOf(const Family &family, const SettingsChange &change);

} // namespace mb::settings
