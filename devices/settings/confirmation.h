// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/device.h"
#include "settings/history.h"
#include "settings/settingslog.h"

#include <cstdint>
#include <span>

namespace mb::settings {

/// After this a value that nobody has kept goes back.
inline constexpr Duration confirmTime = std::chrono::seconds(30);

/// The changes of a unit whose values nobody has kept or reverted, oldest first, with what of them is still in force as far as
/// the history knows: those of Purpose::Provisional, and what an undo or a redo has made livelier. What the window writes over
/// such a value takes its place, measured by what was kept last; what anybody else writes is decided.
/// `changes`: all of the unit, oldest first.
[[nodiscard]] std::vector<SettingsChange> unconfirmed(const Family &family, std::span<const SettingsChange> changes);

/// The same, and only what the device is not known to have otherwise by now: after a write, and of a unit that was just met, what a
/// program that is gone or a lost link has left.
[[nodiscard]] std::vector<SettingsChange> unconfirmedOf(const Device &device, std::span<const SettingsChange> changes);
/// The same, asked for. The device outlives it.
[[nodiscard]] Task<std::vector<SettingsChange>> findUnconfirmed(const Device &device, SettingsLog &log);

/// Somebody keeps a provisional change.
[[nodiscard]] Task<void> keepChange(const Device &device, std::int64_t number, SettingsLog &log);

/// What nobody has kept of this change by now goes back, and is read back: a change of its own. False, with nothing written, where
/// somebody has decided meanwhile; Unsafe, the same, while the unit is not heard, or its motor is not seen to stand.
[[nodiscard]] Task<bool> putBack(Device &device, std::int64_t number, SettingsLog &log, Progress &progress);

/// The time of one provisional change, from when its values are in force: at once, or, of what acts after a restart, when the
/// unit has answered with the new value. A value that is asked; the caller brings device and time.
class Confirmation {
public:
    enum class State {
        AwaitsRestart, ///< what was written is not in force yet
        Counting,
        AwaitsStandstill, ///< the time is over, and the motor is not seen to stand
        Due,              ///< it can go back now
    };
    /// Of what has to be confirmed of it; see toConfirm().
    explicit Confirmation(std::vector<ValueChange> values)
        : m_values(std::move(values))
    {
    }
    /// Times do not run backwards.
    [[nodiscard]] State look(const Device &device, Instant now);
    [[nodiscard]] State state() const { return m_state; }
    /// Until the values go back; the whole time before it has begun, zero after it.
    [[nodiscard]] Duration left(Instant now) const;

private:
    std::vector<ValueChange> m_values;
    State m_state = State::AwaitsRestart;
    Instant m_until{};
};

} // namespace mb::settings
