// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/experiment.h"
#include "service/recipematter.h"
#include "service/servicejournal.h"
#include "settings/settingslog.h"

#include <functional>
#include <set>

namespace mb::service {

/// Who lets a motor turn. Thread of the session.
class MotionPermit {
public:
    virtual ~MotionPermit() = default;
    /// Before each self-test: ends when the motor may turn, which somebody was told before; says what it waits for. Fails where it
    /// may not (Unsafe), where the unit is gone meanwhile (Timeout, LinkLost), and with Cancelled, which leaves the visit open.
    [[nodiscard]] virtual Task<void> beforeMotion(const Device &device, const SelfTest &test, Progress &progress) = 0;
};

/// What a service of a unit shares with who started it, who outlives it. Thread of the session.
struct ServiceSurroundings {
    const RecipeMatter &matter;
    ServiceJournal &journal;
    settings::SettingsLog *settings = nullptr; ///< nullptr: no backup is kept, and the row says so
    tuning::ExperimentSurroundings experiments;
    MotionPermit *permit = nullptr;             ///< nullptr: nothing moves, and a recipe with a self-test fails
    std::set<int> taken;                        ///< numbers of others on this link
    std::function<void(const Visit &)> written; ///< what the journal has by now
};

} // namespace mb::service
