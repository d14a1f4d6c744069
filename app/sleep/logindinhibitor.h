// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/sleep/sleepinhibitor.h"

#include <memory>

namespace mb {

/// Asks logind over D-Bus to put the computer to sleep neither by itself nor because its lid was closed. Has a thread of its own
/// for that, because a bus may let its callers wait. Needs the event loop of the thread that uses it.
class LogindInhibitor final : public SleepInhibitor {
public:
    /// `bus` is the address of another bus than the system's, for tests.
    explicit LogindInhibitor(std::string bus = {});
    ~LogindInhibitor() override;

    void keepAwake(bool awake) override;

private:
    class Worker;

    std::string m_bus;
    std::unique_ptr<Worker> m_worker; ///< from the first wish on
};

} // namespace mb
