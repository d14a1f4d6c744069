// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/lease.h"
#include "async/noncopyable.h"
#include "model/device.h"
#include "model/setpointslew.h"

#include <map>

namespace mb {

/// How a target is approached: no faster than `rate`, in its unit per second, from where its axis was told to be last. An axis
/// that was told nothing in this mode begins with `from`, which is where the motor is, in its first frame. A rate of 0 jumps
/// from there, and what has nowhere to come from jumps at once.
struct Glide {
    double rate = 0.0;
    std::optional<double> from{};
};

/// Keeps a motor's set-point alive, or those of several axes of one device: one control frame an axis every command period, only as long as somebody renews the lease
/// (docs/architecture.md#motion-lease). Whatever ends it ends in Device::stop(): the lease, another master, a lost link, a
/// restarted or silent device, a frame that is later than the device waits for one, a computer that slept, its destruction. It never starts again by itself. Engine thread.
class SetPointStream : NonCopyable {
public:
    enum class End {
        None,    ///< still running, or never started
        Stopped, ///< by stop()
        LeaseExpired,
        Late,  ///< this program was held up for longer than Capabilities::commandLimit
        Slept, ///< the computer did
        LinkLost,
        DeviceSilent,
        DeviceRestarted,
        ForeignMaster,
        Unguarded, ///< the guardian of a device without watchdog did not come, acted, or died
        Refused,   ///< mayMove() or check() said no while running
    };
    /// From when on a lease counts that begins: its start, which is somebody's order, or the last renew().
    enum class Since { Start, Renewal };

    SetPointStream(Device &device, Clock &clock);
    ~SetPointStream();

    /// Sends the first frame now, or, for a device that needs a guardian, once that has confirmed that it stands by (it has
    /// two seconds). Fails without sending when the device may not move or cannot do it. A story that begins by itself has no more
    /// than what is left of its lease Since::Renewal, and fails where that is over, as one that has ended so.
    [[nodiscard]] Result<void> start(
        const SetPoint &setPoint, Duration lease, const Glide &glide = {}, Since since = Since::Start);
    /// A new target for the next frame, sent now; renews the lease. Fails and goes on with the old one when it is not legal.
    /// For another axis than before it joins the others; Mode::Off takes an axis out while others run.
    [[nodiscard]] Result<void> update(const SetPoint &setPoint, const Glide &glide = {});
    /// The same for a story that moves the target by itself: what is not legal ends the stream, and the lease is not renewed.
    [[nodiscard]] Result<void> follow(const SetPoint &setPoint);
    /// Somebody watches, also while nothing runs.
    void renew();
    /// Stops the motor now. Safe at any time.
    void stop();
    /// While it is true start() is refused: whoever began what moves the motor by this stream has called it off. It outlives what is
    /// set; nullptr: nobody may.
    void setCalledOff(const bool *calledOff) { m_calledOff = calledOff; }

    [[nodiscard]] bool isRunning() const { return m_running; }
    /// And nothing was sent yet: its guardian does not stand by.
    [[nodiscard]] bool waitsForGuard() const { return m_running && m_waiting; }
    /// The latest; while it glides, with the target of the newest frame.
    [[nodiscard]] const SetPoint &setPoint() const { return m_setPoint; }
    /// Some axis is still on its way to its target.
    [[nodiscard]] bool isGliding() const { return !m_glides.empty(); }
    /// Of every axis that is kept alive.
    [[nodiscard]] const std::vector<SetPoint> &setPoints() const { return m_setPoints; }
    [[nodiscard]] End end() const { return m_end; }
    /// One clause for people about why it ended.
    [[nodiscard]] const Message &reason() const { return m_reason; }
    [[nodiscard]] Listeners<> &changed() { return m_changed; }

private:
    /// The set-point of this moment, with its glide begun or taken along.
    [[nodiscard]] SetPoint glided(SetPoint setPoint, const Glide &glide);
    void advanceGlides();
    [[nodiscard]] Result<void> followOne(const SetPoint &setPoint, const Glide &glide);
    [[nodiscard]] Result<void> sendOrWait();
    [[nodiscard]] Result<void> sendAll();
    void remember(const SetPoint &setPoint);
    void watch();
    void begin();
    void scheduleNext(Instant last);
    void guardChanged();
    void tick();
    void finish(End end, Message reason);
    [[nodiscard]] bool checkDevice();
    [[nodiscard]] bool isLate() const;
    [[nodiscard]] bool hasSlept() const;
    void sent();

    Device &m_device;
    Clock &m_clock;
    SetPoint m_setPoint;
    std::vector<SetPoint> m_setPoints;
    std::map<int, SetPointSlew> m_glides; ///< by axis, of those that are on their way
    const bool *m_calledOff = nullptr;
    bool m_running = false;
    bool m_waiting = false; ///< for the guardian; nothing was sent yet
    End m_end = End::None;
    Message m_reason;
    Instant m_startedAt{};
    Instant m_next{};
    Instant m_sentAt{};     ///< the newest control frames
    Duration m_sleptThen{}; ///< Clock::slept() at that time
    Timer m_timer;
    Lease m_lease;
    Subscription m_linkState;
    Subscription m_deviceChanged;
    Subscription m_guardChanged;
    Listeners<> m_changed;
};

[[nodiscard]] std::string_view toString(SetPointStream::End end);

} // namespace mb
