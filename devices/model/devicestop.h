// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "async/listeners.h"
#include "async/noncopyable.h"

namespace mb {

class Stoppable;

/// Why motors are stopped; it decides which.
enum class StopCause {
    User,    ///< STOP: every device for which its family has a harmless stop, moving or not
    Program, ///< lost focus, the end of the program: what this program has moved, nothing else
};

/// Where the last stop of a device stands.
enum class StopState {
    None,        ///< it was not told to stop, or was driven since
    Stopping,    ///< told, and told again until it is seen to stand
    Owed,        ///< its link is gone: the first thing that is sent there when it is back
    Seen,        ///< seen to stand, later than it was told
    ByWatchdog,  ///< not heard of, but its own watchdog has switched its output off
    Silent,      ///< told several times and not heard of; nobody knows of a motion
    Unconfirmed, ///< told for as long as makes sense, and not seen to stand: it may still turn
};

/// Follows each stop of a device until it is seen to stand: repeats it, keeps it while the link is gone, and says when nobody
/// knows. One for all families: what is sent is the family's. Engine thread.
class DeviceStop : NonCopyable {
public:
    /// No stop is owed for longer.
    static constexpr Duration debtLimit = std::chrono::minutes(10);
    /// One that was told at `since`; an older one is only shown.
    [[nodiscard]] static bool isStillOwed(Instant since, Instant now) { return now - since < debtLimit; }

    explicit DeviceStop(Stoppable &device);

    [[nodiscard]] StopState state() const { return m_state; }
    /// This program has set the device in motion and has not seen it stand since.
    [[nodiscard]] bool hasMoved() const { return m_moved; }
    /// The stop was for a motion that somebody knows of: of this program, or seen.
    [[nodiscard]] bool isForMotion() const { return m_forMotion; }
    /// Somebody must look at the motor, or cut its power: nobody has seen it stand, and nothing of its own stops it.
    [[nodiscard]] bool mayTurn() const;
    /// The same of any motion of this program, for as long as a stop is owed: nobody can see one stand that went mute.
    [[nodiscard]] bool mayStillTurn() const;
    /// The device is still to be told: on a link that comes back, before anything else.
    [[nodiscard]] bool isDue() const;
    /// When it was last told by somebody, not by a repetition: a debt counts from then.
    [[nodiscard]] Instant toldAt() const { return m_toldAt; }
    [[nodiscard]] Listeners<> &changed() { return m_changed; }

    /// The user has looked: nothing more is sent or shown.
    void dismiss();

    // For Device: it was told to stop; it is driven.
    void told();
    void driven();
    // For Session: the link is open again. A stop that is due goes out at once.
    void linkIsBack();
    /// A stop that an earlier opening of the link, or an earlier run of the program, has left. Told again unless it is too old: then
    /// it is only shown until the device is seen to stand.
    void inherit(Instant since);

private:
    void look();
    void lookAtCutLine();
    void lookAtOpenLine();
    void enter(StopState state);

    Stoppable &m_device;
    StopState m_state = StopState::None;
    bool m_moved = false;
    bool m_forMotion = false;
    bool m_isGivenUp = false; ///< it was told for debtLimit
    Instant m_toldAt{};
    Instant m_sentAt{};
    Timer m_look;
    Listeners<> m_changed;
};

} // namespace mb
