// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/scope.h"
#include "model/session.h"
#include "model/snapshot.h"
#include "settings/confirmation.h"

#include <list>
#include <memory>

namespace mb {

/// Provisional changes (settings/confirmation.h) of the devices of a session: those that this program has written count down
/// and go back by themselves, those that an earlier one has left are offered. Knows no thread; thread of the session.
class ProvisionalChanges {
public:
    using Finished = std::function<void(Result<void>)>;
    /// What it needs of the engine.
    struct Surroundings {
        std::function<settings::SettingsLog *()> log; ///< nothing: no history is kept
        /// Runs it as the one operation of the device; refused while there is another.
        std::function<void(DeviceId, const char *title, std::function<Task<void>(Device &, Progress &)>, Finished)>
            operate;
        std::function<void(Severity, const Device &, const std::string &)> notice;
        std::function<void()> changed;
    };
    ProvisionalChanges(Session &session, Surroundings surroundings);

    /// What the history has now of a device: after a write (`counting`: what is new goes back by itself), and when it is met.
    void look(DeviceId id, bool counting);
    /// Somebody keeps a change. OutOfRange when it is none of these.
    void keep(DeviceId id, std::int64_t change, Finished finished);
    /// It goes back now. Unsafe while the motor is not seen to stand; then it is still there.
    void putBack(DeviceId id, std::int64_t change, Finished finished);
    [[nodiscard]] std::vector<UnconfirmedView> views() const;

private:
    struct Entry {
        DeviceId device;
        settings::SettingsChange change;
        std::optional<settings::Confirmation> confirmation; ///< nothing: it is offered
    };
    void take(DeviceId id, const std::vector<settings::SettingsChange> &open, bool counting);
    void tick();
    [[nodiscard]] Entry *find(DeviceId id, std::int64_t change);

    Session &m_session;
    Surroundings m_surroundings;
    std::list<Entry> m_entries;
    Timer m_timer;
    Scope m_asking; ///< last: what it asks uses everything above
};

} // namespace mb
