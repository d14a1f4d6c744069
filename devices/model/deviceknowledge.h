// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/listeners.h"
#include "async/noncopyable.h"
#include "async/task.h"
#include "model/deviceprofile.h"
#include "model/identity.h"
#include "model/parameterstore.h"
#include "model/shared.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace mb {

struct Family;
class DeviceKnowledge;

/// An order to set what cannot be read back, from when it is given: ended without settle(), whoever gave it was cut, and nobody knows
/// whether it had gone out, so that the value is in doubt. May outlive the knowledge.
class UnsettledWrite : NonCopyable {
public:
    UnsettledWrite() = default;
    UnsettledWrite(std::weak_ptr<DeviceKnowledge *> knowledge, ParameterIndex index);
    ~UnsettledWrite();

    void settle() { m_knowledge.reset(); }

private:
    std::weak_ptr<DeviceKnowledge *> m_knowledge;
    ParameterIndex m_index{};
};

/// What this program knows of a device that the device cannot tell: its profile, and what follows from it. Engine thread.
class DeviceKnowledge : NonCopyable {
public:
    /// `parameters` of the device outlive it.
    DeviceKnowledge(const Family &family, ParameterStore &parameters, const Identity &identity);

    [[nodiscard]] const DeviceProfile &profile() const { return *m_profile; }
    /// The same object until it changes; for other threads.
    [[nodiscard]] const Shared<DeviceProfile> &sharedProfile() const { return m_profile.shared(); }
    /// What a file kept. Write-only parameters become assumed, those that a reset took stay unknown.
    void setProfile(DeviceProfile profile);
    /// For a store that was forgotten: what was written and is not lost is assumed again.
    void reassume();
    /// A number that only its user knows, in the unit of the row (Family::calibrations); nothing makes it unknown again.
    [[nodiscard]] Result<void> calibrate(std::string_view key, std::optional<double> value);
    /// Speaks this dialect (Family::dialects) whatever the scan found; empty: as the scan finds it.
    [[nodiscard]] Result<void> setDialect(std::string_view key);
    /// Keeps what a check of this device found out, such as "direction"; shown, never relied on.
    void setVerdict(const std::string &key, DirectionVerdict verdict);
    void setCounter(const std::string &key, std::int64_t value) { setCounters({{key, value}}); }
    /// The same of several that belong together: told, and kept on the disk, once.
    void setCounters(const std::map<std::string, std::int64_t> &values);

    /// A write-only parameter is known to have been set to this, by us or by somebody we heard.
    void assume(ParameterIndex index, std::int64_t raw);
    /// It may have another value now: a restart took what was not saved, or an order had no answer. It is lost until it is written again.
    void doubt(ParameterIndex index, ParameterState state = ParameterState::Unknown);
    /// Keep it while the device is told another value.
    [[nodiscard]] UnsettledWrite writing(ParameterIndex index) { return {m_self, index}; }
    /// For devices that keep nothing: something was written that is believed to be in force.
    [[nodiscard]] bool holdsSettings() const { return m_profile->lost.size() < m_profile->written.size(); }
    /// The same: a reset was noticed. Everything is unknown, what was written is lost until it is written again.
    void settingsLost();
    /// Another unit may stand in its place now, of which nothing is known but what its user knows: what was written to the one before,
    /// and counted of it, tells nothing of this one. What the one before owes stands: it is not proved that it is gone.
    void unitExchanged();

    /// Who keeps the profile says there when it is on the disk.
    void setKeeper(std::function<Task<void>()> keeper) { m_keeper = std::move(keeper); }
    /// Ends when the profile as it is now is on the disk, at once where nobody keeps it; NotKept where it cannot be.
    [[nodiscard]] Task<void> kept() const;

    /// Of what a scan has found, what is shown: with the dialect that was proven before or that the user chose, and what that means.
    [[nodiscard]] Identity probed(Identity identity);
    [[nodiscard]] Identity shown(Identity identity) const;

    /// Of unitExchanged(): for what a family itself keeps of the one before.
    [[nodiscard]] Listeners<> &exchanged() { return m_exchanged; }
    /// The profile is to be kept.
    [[nodiscard]] Listeners<> &changed() { return m_changed; }
    /// Calibration or dialect are others.
    [[nodiscard]] Listeners<> &applied() { return m_applied; }

private:
    const Family &m_family;
    ParameterStore &m_parameters;
    Published<DeviceProfile> m_profile;
    std::string m_probedDialect; ///< what the scan said, where the user chose another
    Message m_probedDetail;
    std::function<Task<void>()> m_keeper;
    Listeners<> m_changed;
    Listeners<> m_applied;
    Listeners<> m_exchanged;
    std::shared_ptr<DeviceKnowledge *> m_self = std::make_shared<DeviceKnowledge *>(this); ///< for what may outlive it
};

} // namespace mb
