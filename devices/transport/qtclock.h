// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/sleeplog.h"

#include <functional>
#include <memory>
#include <mutex>

class QSocketNotifier;

namespace mb {

/// Two clocks of the kernel that differ by the time the computer has slept.
struct KernelClocks {
    std::function<Duration()> awake;  ///< CLOCK_MONOTONIC: stands while the computer sleeps
    std::function<Duration()> always; ///< CLOCK_BOOTTIME: goes on

    [[nodiscard]] static KernelClocks ofSystem();
};

/// The real clock: one timerfd with absolute deadlines, served by the event loop of the thread that made it. A QTimer
/// cannot do less than a millisecond. This file is the one place below `app` that asks the system for the time.
class QtClock final : public Clock {
public:
    /// `clocks` are those that slept() compares; now() and the deadlines are always the system's.
    explicit QtClock(KernelClocks clocks = KernelClocks::ofSystem());
    ~QtClock() override;

    [[nodiscard]] Instant now() const override;
    [[nodiscard]] Duration unixOffset() const override;
    [[nodiscard]] Duration slept() const override;
    /// When the computer slept, since this clock is there. Any thread.
    [[nodiscard]] SleepLog sleeps();

private:
    void rescheduled() override;
    void runDue();

    void lookForSleep();

    KernelClocks m_clocks;
    std::mutex m_sleepMutex;
    SleepLog m_sleeps;
    int m_descriptor = -1;
    bool m_running = false;
    Instant m_programmed{};
    std::unique_ptr<QSocketNotifier> m_notifier;
};

} // namespace mb
