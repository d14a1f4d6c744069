// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "model/device.h"
#include "model/family.h"
#include "model/linkbook.h"
#include "model/sessionmemory.h"
#include "model/setpointstream.h"

#include <atomic>
#include <compare>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace mb {

/// Names a device of a session for its whole life, across rescans, renumbering and restarts; never used for another one. A unit whose
/// serial number is another than that of the unit before it has an id of its own, and the former one its own again when it is back.
struct DeviceId {
    std::uint32_t value = 0;
    friend auto operator<=>(const DeviceId &, const DeviceId &) = default;
};

/// The devices of a session, each with its id and its set-point stream. Thread of the session.
class DeviceBook : NonCopyable {
public:
    struct Entry {
        DeviceId id;
        std::unique_ptr<Device> device;
        std::unique_ptr<SetPointStream> stream; ///< nullptr: nobody has asked for it
        std::map<std::string, DeviceId> units;  ///< who stood here, by serial number
        Subscription changed;
        Subscription profileChanged;
        Subscription stopChanged;
        [[nodiscard]] bool isStreaming() const { return stream && stream->isRunning(); }
    };

    /// All of them outlive it. Without a guard, devices that have no watchdog cannot be driven on real links.
    DeviceBook(Clock &clock, LinkBook &links, SessionMemory &memory, MotionGuard *guard);

    /// For devices found from now on: where recordings go beyond their memory budget (Telemetry::keepIn), and what keeps them from
    /// being driven.
    void keepHistoriesIn(std::shared_ptr<ChunkStore> store) { m_store = std::move(store); }
    void setStopGate(const std::atomic<bool> *gate) { m_stopGate = gate; }

    /// The device that has answered, known or new. Another session under the same number is the same unit after a power cycle,
    /// unless both answered in this scan: `seen`.
    Device &adopt(Link &link, const Family &family, const Identity &identity, const std::vector<Device *> &seen);
    /// The device that sends in a recording, whatever its session.
    Device &adoptRecorded(Link &link, const Family &family, const Identity &identity);
    /// New objects for the devices of a link, with their ids; telemetry begins anew.
    void renew(Link &link);
    void forget(const Link &link);

    [[nodiscard]] const std::list<Entry> &entries() const { return m_entries; }
    [[nodiscard]] std::vector<Device *> all() const;
    [[nodiscard]] std::vector<Device *> on(const Link &link) const;
    [[nodiscard]] std::vector<Identity> known(const Link &link, const Family &family) const;
    [[nodiscard]] Device *find(DeviceId id) const;
    [[nodiscard]] DeviceId idOf(const Device &device) const;
    /// It has told who it is since it restarted, or never could: what is meant for one unit may be written to it.
    [[nodiscard]] bool isRecognised(const Device &device) const;
    /// One per device, made when first asked for.
    [[nodiscard]] SetPointStream &stream(const Device &device);

    /// A device was found that was not here.
    [[nodiscard]] Listeners<Device &> &added() { return m_added; }
    /// A device's stop reached another state (DeviceStop).
    [[nodiscard]] Listeners<Device &> &stopChanged() { return m_stopChanged; }
    /// Devices came, went or changed.
    [[nodiscard]] Listeners<> &changed() { return m_changed; }

private:
    Device &add(Link &link, const Family &family, const Identity &identity);
    void open(Entry &entry, Link &link, const Family &family, const Identity &identity);
    void recognise(Entry &entry);
    void scheduleCommit();

    LinkBook &m_links;
    SessionMemory &m_memory;
    MotionGuard *m_guard;
    std::optional<std::shared_ptr<ChunkStore>> m_store;
    const std::atomic<bool> *m_stopGate = nullptr;
    std::uint32_t m_lastId = 0;
    Listeners<Device &> m_added;
    Listeners<Device &> m_stopChanged;
    Listeners<> m_changed;
    std::list<Entry> m_entries; // an element is destroyed whole, in the reverse order of its members
    Timer m_commit;
    Subscription m_batchEnded;
};

} // namespace mb
