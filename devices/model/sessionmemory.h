// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/background.h"
#include "async/listeners.h"
#include "async/noncopyable.h"
#include "model/device.h"
#include "model/scanbook.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace mb {

/// What a session knows from earlier runs of the program, and keeps for later ones: profiles of devices and who answered on which
/// link. Of real links only: simulated devices are factory-fresh in every process, and a recording has its own. Thread of the session.
class SessionMemory : NonCopyable {
public:
    explicit SessionMemory(Clock &clock);

    /// From now on what is known of devices is kept in this directory.
    void keepProfiles(std::string directory) { m_profiles.emplace(std::move(directory)); }
    /// From now on who answered in scans is kept in this directory, for families whose scans take long: the
    /// next scan, of another run too, asks them first.
    void keepScans(std::string directory) { m_scans.emplace(std::move(directory)); }
    /// From now on files are written there. Outlives this.
    void setBackground(Background *background) { m_background = background; }
    /// What was kept of scans is lost, or cannot be kept: scans are slower, nothing else. Once a link and cause.
    [[nodiscard]] Listeners<const Message &> &scanTrouble() { return m_scanTrouble; }
    /// A profile could not be read or kept: one line for people.
    [[nodiscard]] Listeners<const Message &> &profileTrouble() { return m_profileTrouble; }

    /// Gives a device that was just opened the profile that was kept of it.
    void recall(Device &device);
    /// Its profile has changed. One that the disk refuses is kept here, and written again from time to time.
    void keep(const Device &device);
    /// Ends when its profile is on the disk, at once where none is kept; NotKept with the cause when the disk refuses it, or takes 10 s.
    [[nodiscard]] Task<void> kept(const Device &device);
    /// Who answered on the link before, of a family that can be asked one by one.
    [[nodiscard]] std::vector<Identity> seenOn(const Link &link, const Family &family);
    /// A scan has found these; `complete`: and nobody else is there. One that finds nobody forgets nobody: as a rule the supply is off.
    void remember(const Link &link, const std::vector<Device *> &seen, bool complete);

private:
    struct UnsavedProfile {
        DeviceProfile profile;
        int writes = 0;    ///< under way
        Result<void> kept; ///< of the last one that has ended
    };
    void save(const std::string &key, bool tells);
    void saved(const std::string &key, const Result<void> &kept);
    void saveUnsaved();
    void write(const std::string &file, const std::function<void()> &work, const std::function<void()> &done);
    void tellScanTrouble(const std::string &link, const Error &error);

    Clock &m_clock;
    Timer m_again;
    std::optional<ProfileBook> m_profiles;
    std::optional<ScanBook> m_scans;
    Background *m_background = nullptr;
    std::map<std::string, UnsavedProfile> m_unsaved; ///< by key
    std::set<std::string> m_told;                    ///< links and causes
    Listeners<> m_saved;                             ///< a profile, or not
    Listeners<const Message &> m_profileTrouble;
    Listeners<const Message &> m_scanTrouble;
    std::shared_ptr<SessionMemory *> m_self
        = std::make_shared<SessionMemory *>(this); ///< for what comes back from the background
};

} // namespace mb
