// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/scope.h"
#include "model/bench.h"
#include "model/family.h"
#include "model/scanbook.h"
#include "model/setpointstream.h"
#include "transport/backends/replay.h"

#include <atomic>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <vector>

namespace mb {

/// Names a device of a session for its whole life, across rescans, renumbering and restarts; never used twice.
struct DeviceId {
    std::uint32_t value = 0;
    friend auto operator<=>(const DeviceId &, const DeviceId &) = default;
};

struct ScanOptions {
    ScanExtent extent = ScanExtent::Quick;
    /// What is looked for, of families that take long; in the thread of the session.
    std::function<void(const Message &what, int done, int total)> progress;
};

/// Everything that one process works on: links, the devices found on them, their set-point streams. One thread: the engine's
/// in the window, the only one in the console and in tests.
class Session {
public:
    /// Without a guard, devices that have no watchdog cannot be driven on real links.
    Session(Clock &clock, std::span<const Family *const> families, MotionGuard *guard = nullptr);
    Session(const Session &) = delete;
    Session &operator=(const Session &) = delete;
    /// Stops every motor that was driven.
    ~Session();

    [[nodiscard]] Clock &clock() const { return m_clock; }
    [[nodiscard]] std::span<const Family *const> families() const { return m_families; }

    /// Where the recordings of all devices go beyond a memory budget; for devices found from now on.
    void keepHistoriesIn(std::shared_ptr<ChunkStore> store) { m_store = std::move(store); }
    /// From now on what is known of devices on real links is kept in this directory. Simulated ones are factory-fresh.
    void keepProfiles(std::string directory);
    /// From now on who answered in scans of real links is kept in this directory, for families whose scans take long: the
    /// next scan, of another run too, asks them first.
    void keepScans(std::string directory);
    /// What was kept of scans is lost, or cannot be kept: scans are slower, nothing else. Once a link and cause.
    [[nodiscard]] Listeners<const Message &> &memoryTrouble() { return m_memoryTrouble; }
    /// A profile could not be read or kept: one line for people.
    [[nodiscard]] Listeners<const Message &> &profileTrouble() { return m_profileTrouble; }

    /// Opens a link, or yields the one that is open under this address. `sim:` alone must be expanded first (expandLink).
    [[nodiscard]] Result<Link *> openLink(const LinkAddress &address);
    /// openLink() for a thread that must not wait for a driver (Link::openSoon).
    [[nodiscard]] Task<Link *> openLinkSoon(LinkAddress address);
    /// The same for a lost link that may be back; its state tells what comes of it.
    void reopen(Link &link);
    /// From now on what may block, opening ports and writing what is kept, is done there. Outlives the session.
    void setBackground(Background *background) { m_background = background; }
    /// Stops its motors, forgets its devices.
    void closeLink(Link &link);
    [[nodiscard]] std::vector<Link *> links() const;
    [[nodiscard]] Link *findLink(const LinkAddress &address) const;
    /// The bench behind a simulated link; nullptr for others. For tests and for disturbing a simulated load.
    [[nodiscard]] Bench *bench(const Link &link) const;

    /// The time that devices of a link live on: the session's, but for a recording and for a simulated bench its own.
    [[nodiscard]] Clock &clockOf(Link &link) const;
    /// The replay behind a `replay:` link; nullptr for others.
    [[nodiscard]] static ReplayLink *replayOf(Link &link);
    /// Takes a replay to another place. Its devices keep their ids and begin anew there, telemetry too: time may go back. Nobody
    /// may hold on to a Device of the link, or run a task of it.
    [[nodiscard]] Result<void> seek(ReplayLink &link, Duration position);

    /// Scans with every family that speaks this kind of link, all at once; devices() grows as answers come. A recording
    /// cannot be asked: the whole file is looked through, in pieces, for what devices sent. Yields what
    /// answered this time, family by family, in order of address. A device that did not answer stays in devices() and is not heard.
    [[nodiscard]] Task<std::vector<Device *>> scan(Link &link) { return scan(link, ScanOptions()); }
    [[nodiscard]] Task<std::vector<Device *>> scan(Link &link, ScanOptions options);
    /// Opens the link, asks whether exactly this device is there. Timeout when not; Refused when the number is taken twice
    /// and the selector does not say which.
    [[nodiscard]] Task<Device *> connect(DeviceSelector selector);

    [[nodiscard]] std::vector<Device *> devices() const;
    [[nodiscard]] Device *find(DeviceId id) const;
    [[nodiscard]] DeviceId idOf(const Device &device) const;
    /// One per device, made when first asked for.
    [[nodiscard]] SetPointStream &stream(Device &device);
    /// Stops every stream. By the user also every device for which its family has a harmless stop (Device::mayStop), moving or
    /// not; by the program only what it has moved. Each is followed up (Device::stopping), also over a link that is lost: that is
    /// opened again as soon as it can be, and its first frames are the stops. Waits for nothing.
    void stopAll(StopCause cause);
    /// A device's stop reached another state (DeviceStop).
    [[nodiscard]] Listeners<const Device &> &stopChanged() { return m_stopChanged; }
    /// Stops that are owed to devices nobody sees now: their link was closed before they were seen to stand, or another run of
    /// the program left them. Sent when the link is opened; they end when the device is found and seen to stand.
    [[nodiscard]] const std::list<OwedStop> &owedStops() const { return m_owed; }
    /// The user has looked at the motors: nothing is owed any more.
    void dismissStops();
    /// While it is true nothing is driven (Device::setStopGate); for devices found from now on. Outlives the session.
    void setStopGate(const std::atomic<bool> *gate) { m_stopGate = gate; }
    /// Starts the buffered moves of every device on the link of `lead` at the same moment. Unsafe when one of them is not
    /// guarded, or keeps a move whose motion was stopped before it began.
    [[nodiscard]] Result<void> releaseMoves(Device &lead);

    /// A link was opened, and its user should know something about it, told in one clause.
    [[nodiscard]] Listeners<const Link &, const Message &> &remarked() { return m_remarked; }
    /// Links or devices came, went or changed.
    [[nodiscard]] Listeners<> &changed() { return m_changed; }

private:
    struct Entry {
        DeviceId id;
        std::unique_ptr<Device> device;
        std::unique_ptr<SetPointStream> stream;
        Subscription changed;
        Subscription profileChanged;
        Subscription stopChanged;
    };
    struct OpenLink {
        std::unique_ptr<Bench> bench;
        std::unique_ptr<Link> link;
        std::string line; ///< linkIdentity() when it was opened last
        Subscription state;
        Subscription batch;
        std::unique_ptr<Scope> opening; ///< again
    };
    class ScanRound;
    struct UnsavedProfile {
        DeviceProfile profile;
        int writes = 0; ///< under way
    };

    [[nodiscard]] Task<std::vector<Device *>> ask(Link &link, DeviceSelector selector);
    [[nodiscard]] Task<std::vector<Device *>> overhear(ReplayLink &link);
    void overheard(Link &link, const Family &family, const Identity &identity);
    Entry &addEntry(Link &link, const Family &family, const Identity &identity);
    void openDevice(Entry &entry, Link &link, const Family &family, const Identity &identity);
    [[nodiscard]] Result<OpenLink> makeLink(const LinkAddress &address);
    Link &enlist(OpenLink made);
    Device &adopt(Link &link, const Family &family, const Identity &identity, std::vector<Device *> &seen);
    void remark(const Link &link);
    void scheduleCommit();
    void recall(Device &device);
    void keep(const Device &device);
    void keepInBackground(const std::string &selector, const DeviceProfile &profile);
    [[nodiscard]] std::vector<Identity> rememberedOn(const Link &link, const Family &family);
    [[nodiscard]] std::vector<Identity> knownOn(const Link &link, const Family &family) const;
    void remember(const Link &link, const std::vector<Device *> &seen, bool complete);
    void tellMemoryTrouble(const std::string &link, const Error &error);
    void linkChanged(OpenLink &open, LinkState state);
    void payStops(OpenLink &open);
    void passOnStop(Entry &entry);
    void inheritStop(Entry &entry);
    void followStop(Entry &entry);
    void retryOwing();
    [[nodiscard]] bool isOwing(const Link &link) const;
    [[nodiscard]] const OpenLink *openLinkOf(const Link &link) const;

    Clock &m_clock;
    std::span<const Family *const> m_families;
    MotionGuard *m_guard;
    Listeners<> m_changed;
    Listeners<const Link &, const Message &> m_remarked;
    Listeners<const Message &> m_profileTrouble;
    Listeners<const Message &> m_memoryTrouble;
    std::optional<ProfileBook> m_profiles;
    std::optional<ScanBook> m_scans;
    Background *m_background = nullptr;
    std::map<std::string, UnsavedProfile> m_unsaved;                       ///< by selector
    std::shared_ptr<Session *> m_self = std::make_shared<Session *>(this); ///< for what comes back from the background
    std::set<std::string> m_toldOfMemory;                                  ///< links and causes
    Listeners<const Device &> m_stopChanged;
    std::list<OwedStop> m_owed;
    const std::atomic<bool> *m_stopGate = nullptr;
    Timer m_retry;
    std::list<OpenLink> m_links; // lists: an element is destroyed whole, in the reverse order of its members
    std::list<Entry> m_devices;
    std::uint32_t m_lastId = 0;
    std::shared_ptr<ChunkStore> m_store;
    Timer m_commit;
};

} // namespace mb
