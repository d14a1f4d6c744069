// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine/operations.h"
#include "async/scope.h"
#include "model/heardsince.h"
#include "settings/confirmation.h"
#include "widgets/orders/settingsorders.h"

#include <list>
#include <map>
#include <memory>
#include <set>

namespace mb {

/// Provisional changes (settings/confirmation.h) of the devices of a session: those that this program has written count down
/// and go back by themselves, those that an earlier one has left are offered. Engine thread.
class ProvisionalChanges {
public:
    explicit ProvisionalChanges(const EngineContext &context);

    /// Without a log nothing is provisional. It outlives this.
    void setLog(settings::SettingsLog *log) { m_log = log; }
    /// A write begins, which is this change: if it is provisional, it goes back by itself. Those that were there are offered.
    void begins(DeviceId id, std::int64_t change) { m_begun[id] = change; }
    /// What the history has now of a device: after a write, and when it is met. Again after a while where it does not answer.
    void look(DeviceId id);
    /// Somebody keeps a change. OutOfRange when it is none of these.
    void carryOut(const orders::KeepChange &order, const Finished &finished);
    /// It goes back now. Unsafe while the motor is not seen to stand; then it is still there.
    void carryOut(const orders::PutBackChange &order, const Finished &finished);
    [[nodiscard]] std::vector<UnconfirmedView> views() const;

private:
    struct Entry {
        DeviceId device;
        settings::SettingsChange change;
        std::optional<settings::Confirmation> confirmation; ///< nothing: it is offered
        std::unique_ptr<HeardSince> heard{};                ///< since its time began
        [[nodiscard]] bool isCutOff(Device &unit);
    };
    void take(DeviceId id, const std::vector<settings::SettingsChange> &changes);
    [[nodiscard]] bool isNew(DeviceId id, std::int64_t change);
    void lookAgain();
    void tick();
    [[nodiscard]] bool mayPutBack(DeviceId device) const;
    [[nodiscard]] Entry *find(DeviceId id, std::int64_t change);

    EngineContext m_context;
    settings::SettingsLog *m_log = nullptr;
    std::list<Entry> m_entries;
    std::map<DeviceId, std::int64_t> m_begun; ///< by the last write, until it was found in the history
    std::set<DeviceId> m_unanswered;          ///< the history could not be asked
    Timer m_timer;
    Timer m_again;
    Scope m_asking; ///< last: what it asks uses everything above
};

} // namespace mb
