// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "model/devicebook.h"
#include "model/linkbook.h"
#include "model/scanround.h"
#include "model/sessionmemory.h"
#include "model/sessionstops.h"

#include <memory>
#include <span>
#include <vector>

namespace mb {

/// Everything that one process works on: links, the devices found on them, their set-point streams. One thread: the engine's
/// in the window, the only one in the console and in tests.
class Session : NonCopyable {
public:
    /// Without a guard, devices that have no watchdog cannot be driven on real links.
    Session(Clock &clock, std::span<const Family *const> families, MotionGuard *guard = nullptr);
    /// Stops every motor that was driven.
    ~Session();

    [[nodiscard]] Clock &clock() const { return m_clock; }
    [[nodiscard]] std::span<const Family *const> families() const { return m_families; }
    /// What is kept from one run of the program to the next; nothing, until it is told where.
    [[nodiscard]] SessionMemory &memory() { return m_memory; }
    [[nodiscard]] LinkBook &linkBook() { return m_links; }

    /// Where the recordings of all devices go beyond a memory budget; nullptr: nothing is recorded, and memory does not grow with what
    /// devices send (Telemetry::keepIn). For devices found from now on.
    void keepHistoriesIn(std::shared_ptr<ChunkStore> store) { m_devices.keepHistoriesIn(std::move(store)); }
    /// While it is true nothing is driven (MotionGate::setStopGate); for devices found from now on. Outlives the session.
    void setStopGate(const std::atomic<bool> *gate) { m_devices.setStopGate(gate); }
    /// From now on what may block, opening ports and writing what is kept, is done there. Outlives the session.
    void setBackground(Background *background);

    /// Opens a link, or yields the one that is open under this address. `sim:` alone must be expanded first (expandLink).
    [[nodiscard]] Result<Link *> openLink(const LinkAddress &address) { return m_links.open(address); }
    /// openLink() for a thread that must not wait for a driver (Link::openSoon).
    [[nodiscard]] Task<Link *> openLinkSoon(LinkAddress address) { return m_links.openSoon(std::move(address)); }
    /// Stops its motors, forgets its devices.
    void closeLink(Link &link);
    [[nodiscard]] std::vector<Link *> links() const { return m_links.all(); }
    /// The bench behind a simulated link; nullptr for others. For tests and for disturbing a simulated load.
    [[nodiscard]] Bench *bench(const Link &link) const { return m_links.bench(link); }
    /// The time that devices of a link live on: the session's, but for a recording and for a simulated bench its own.
    [[nodiscard]] Clock &clockOf(Link &link) const { return m_links.clockOf(link); }
    /// Takes a replay to another place. Its devices keep their ids and begin anew there, telemetry too: time may go back. Nobody
    /// may hold on to a Device of the link, or run a task of it.
    [[nodiscard]] Result<void> seek(ReplayLink &link, Duration position);

    /// Scans with every family that speaks this kind of link, all at once; devices() grows as answers come. A recording
    /// cannot be asked: the whole file is looked through, in pieces, for what devices sent. Yields what
    /// answered this time, family by family, in order of address. A device that did not answer stays in devices() and is not heard.
    [[nodiscard]] Task<std::vector<Device *>> scan(Link &link) { return scan(link, ScanOptions()); }
    [[nodiscard]] Task<std::vector<Device *>> scan(Link &link, ScanOptions options);
    /// Opens the link, asks whether exactly this device is there. Timeout when not; Refused when the number is taken twice
    /// and the selector does not say which. `mayBeSilent`: where firmware takes another way in than the bus (Family::routes), one
    /// that does not answer is yielded as DeviceState::Bootloader: its update was cut, or it never had a program. But Timeout where
    /// another of its family answers on the link, which may be the one that is written then, and Unsafe where its motor may turn.
    [[nodiscard]] Task<Device *> connect(DeviceSelector selector, bool mayBeSilent = false);

    [[nodiscard]] std::vector<Device *> devices() const { return m_devices.all(); }
    [[nodiscard]] Device *find(DeviceId id) const { return m_devices.find(id); }
    [[nodiscard]] DeviceId idOf(const Device &device) const { return m_devices.idOf(device); }
    [[nodiscard]] bool isRecognised(const Device &device) const { return m_devices.isRecognised(device); }
    /// One per device, made when first asked for.
    [[nodiscard]] SetPointStream &stream(Device &device) { return m_devices.stream(device); }

    /// STOP, and what is still owed to whom.
    [[nodiscard]] SessionStops &stops() { return m_stops; }
    void stopAll(StopCause cause) { m_stops.stopAll(cause); }
    /// A device's stop reached another state (DeviceStop).
    [[nodiscard]] Listeners<Device &> &stopChanged() { return m_devices.stopChanged(); }
    /// Links or devices came, went or changed.
    [[nodiscard]] Listeners<> &changed() { return m_changed; }

private:
    [[nodiscard]] ScanRound::Surroundings aroundScan(Link &link);
    [[nodiscard]] Task<std::vector<Device *>> ask(Link &link, DeviceSelector selector);
    [[nodiscard]] Task<std::vector<Device *>> discoverPassively(ReplayLink &link);
    [[nodiscard]] Task<Device *> adoptSilent(Link &link, DeviceSelector selector, std::vector<Device *> seen);

    Clock &m_clock;
    std::span<const Family *const> m_families;
    Listeners<> m_changed;
    SessionMemory m_memory;
    LinkBook m_links;
    DeviceBook m_devices;
    SessionStops m_stops;
    Subscription m_linksChanged;
    Subscription m_devicesChanged;
};

} // namespace mb
