// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "async/noncopyable.h"
#include "model/motionguard.h"

#include <memory>

namespace mb {

class Stoppable;

/// Keeps a device without a watchdog under guard while it may be driven (docs/architecture.md#guardian). Nothing of it is needed
/// for devices with a watchdog, and for simulated ones, which end with this process. Engine thread.
class DeviceGuard : NonCopyable {
public:
    explicit DeviceGuard(Stoppable &device);
    ~DeviceGuard();

    /// Where guardians come from; nullptr: none. Outlives the device.
    void setSource(MotionGuard *source) { m_source = source; }

    /// The device has no watchdog and does not end with this process.
    [[nodiscard]] bool isNeeded() const;
    /// Unsafe where the device may never move because nobody could stop it.
    [[nodiscard]] Result<void> possible() const;

    /// Asks for a guardian; from then on it is renewed every 100 ms, by this thread, until it is dismissed.
    /// Success when it stands or will tell by changed(), and at once where none is needed.
    [[nodiscard]] Result<void> call();
    /// Motion is allowed: none is needed, or one has confirmed and was renewed within 400 ms. Its own limit is 500 ms, so
    /// a program that was frozen knows first, and does not drive a motor that the guardian has stopped.
    [[nodiscard]] bool stands() const;
    /// It cannot come to stand any more: it acted, it died, or this program was frozen too long.
    [[nodiscard]] bool hasFailed() const;
    /// Why it does not stand, in one clause.
    [[nodiscard]] Message reason() const;
    [[nodiscard]] Listeners<> &changed() { return m_changed; }

    /// The motor was told to stop: the guardian goes once the device is seen stopped, not before.
    void dismiss();
    /// The same now, without waiting: it goes if the device is seen stopped, and is left to stop it otherwise. For an end.
    void leave();

private:
    void renew();
    void look();
    void release();
    void drop();
    [[nodiscard]] bool hasLapsed() const;

    Stoppable &m_device;
    MotionGuard *m_source = nullptr;
    std::unique_ptr<GuardWatch> m_watch;
    Subscription m_watchChanged;
    Subscription m_linkChanged;
    Instant m_renewedAt{};
    bool m_lapsed = false;
    Timer m_renewal;
    Timer m_look;
    Listeners<> m_changed;
};

} // namespace mb
