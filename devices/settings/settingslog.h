// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/task.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mb::settings {

/// Why a snapshot was taken.
enum class Occasion { Hand, Found, Restore, Import, Tuning, Update };
[[nodiscard]] std::string_view toString(Occasion occasion);
[[nodiscard]] Occasion occasionFromString(std::string_view text);
/// What a snapshot is called when nobody has named it: "as found", "before restore".
[[nodiscard]] std::string_view usualName(Occasion occasion);

/// Everything that was known of a unit's parameters at one moment.
struct ParameterSnapshot {
    std::int64_t number = 0;
    double time = 0.0; ///< Unix, s
    std::string unit;  ///< Unit::key
    std::string device;
    std::string family;
    std::string serial; ///< empty: the unit has none
    std::string firmware;
    std::string name;
    Occasion occasion = Occasion::Hand;
    int count = 0;    ///< values that were known
    std::string file; ///< the object of `motorbenchctl get`, as a parameter file has it; empty in a list
};

/// Where a write comes from.
enum class Origin {
    Window,
    Console,
    Tuning,
    Recipe,
    Elsewhere ///< found changed: another program, another computer, or a power cut before it was stored
};
[[nodiscard]] std::string_view toString(Origin origin);
[[nodiscard]] Origin originFromString(std::string_view text);

/// What a write was for.
enum class Purpose {
    Write,
    Restore,
    Undo,
    Redo,
    Revert,      ///< a provisional change went back: SettingsChange::of
    Provisional, ///< goes back unless somebody keeps it (confirmation.h)
    Keep,        ///< somebody kept that of SettingsChange::of; writes nothing
    Store,       ///< seen to be stored, whatever was written before; writes nothing
};
/// Whether what such a change makes livelier goes back unless somebody keeps it: without its record nothing would take it back.
[[nodiscard]] constexpr bool asksToBeKept(Purpose purpose)
{
    return purpose == Purpose::Provisional || purpose == Purpose::Undo || purpose == Purpose::Redo;
}
[[nodiscard]] std::string_view toString(Purpose purpose);
[[nodiscard]] Purpose purposeFromString(std::string_view text);

/// What is known of a value that was to be written.
enum class Proof {
    Open,    ///< begun, and nobody saw what came of it: it may have been written
    Equal,   ///< read back and equal
    Blind,   ///< written; it cannot be read back
    Differs, ///< written, and something else was read back: `after` is that
    Refused, ///< not written
};
[[nodiscard]] std::string_view toString(Proof proof);
[[nodiscard]] Proof proofFromString(std::string_view text);

struct ValueChange {
    std::string key;
    std::optional<std::int64_t> before; ///< raw; nothing where it was not known
    std::int64_t after = 0;
    Proof proof = Proof::Open;

    friend bool operator==(const ValueChange &, const ValueChange &) = default;
};

/// Values of one unit that were written by one order.
struct SettingsChange {
    std::int64_t number = 0;
    double time = 0.0; ///< Unix, s
    std::string unit;  ///< Unit::key
    std::string device;
    std::string person; ///< name of the account at the computer
    Origin origin = Origin::Window;
    Purpose purpose = Purpose::Write;
    std::optional<std::int64_t> of; ///< the change that this one undid, did again, put back or kept
    std::vector<ValueChange> values;
};

/// What is kept of the settings of all units, for good: nothing is ever overwritten. Thread of the session; whoever implements
/// it waits for a disk in a thread of its own where that matters. Fails with NotKept and the cause, such as a full disk.
class SettingsLog {
public:
    virtual ~SettingsLog() = default;

    /// The same with its number and the present time of day.
    [[nodiscard]] virtual Task<ParameterSnapshot> keep(ParameterSnapshot snapshot) = 0;
    /// A change that is about to be written; its number. Time of day and person are filled in.
    [[nodiscard]] virtual Task<std::int64_t> begin(SettingsChange change) = 0;
    /// What came of it. Values that were never tried are not among them.
    [[nodiscard]] virtual Task<void> complete(std::int64_t number, std::vector<ValueChange> values) = 0;
    /// All changes of a unit, oldest first.
    [[nodiscard]] virtual Task<std::vector<SettingsChange>> changesOf(std::string unit) = 0;
    /// A unit that is known by its place was given another: its tag and what is owed to it go with it, and who had that place before
    /// has it no more.
    [[nodiscard]] virtual Task<void> moved(std::string from, std::string to) = 0;
};

} // namespace mb::settings
