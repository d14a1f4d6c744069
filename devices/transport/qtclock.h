// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

#include <memory>

class QSocketNotifier;

namespace mb {

/// The real clock: one timerfd with absolute deadlines, served by the event loop of the thread that made it. A QTimer
/// cannot do less than a millisecond. This file is the one place below `app` that asks the system for the time.
class QtClock final : public Clock {
public:
    QtClock();
    ~QtClock() override;

    [[nodiscard]] Instant now() const override;
    [[nodiscard]] Duration unixOffset() const override;

private:
    void rescheduled() override;
    void runDue();

    int m_descriptor = -1;
    bool m_running = false;
    Instant m_programmed{};
    std::unique_ptr<QSocketNotifier> m_notifier;
};

} // namespace mb
