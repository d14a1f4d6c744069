// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "experiment/experiment.h"
#include "service/recipematter.h"
#include "service/servicejournal.h"
#include "settings/settingslog.h"

#include <functional>
#include <set>
#include <vector>

namespace mb::service {

/// Who lets a motor turn, and may take that back while it turns. Thread of the session.
class MotionPermit : NonCopyable {
public:
    virtual ~MotionPermit() = default;
    /// Before each self-test: ends when the motor may turn, which somebody was told before; says what it waits for. Fails where it
    /// may not (Unsafe), where the unit is gone meanwhile (Timeout, LinkLost), and with Cancelled, which leaves the visit open.
    [[nodiscard]] virtual Task<void> beforeMotion(const Device &device, const SelfTest &test, Progress &progress) = 0;

protected:
    /// Every motor that turns by this permit stops, and its self-test ends as one that was stopped by hand.
    void takeBack();

private:
    friend class PermittedMotion;
    std::vector<tuning::Interruption *> m_turning;
};

/// A self-test whose motor turns by a permit, as long as it lives. Permit and interruption outlive it; without an interruption nobody
/// can end it.
class PermittedMotion : NonCopyable {
public:
    PermittedMotion(MotionPermit &permit, tuning::Interruption *interruption);
    ~PermittedMotion();

private:
    MotionPermit &m_permit;
    tuning::Interruption *m_interruption;
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
    const bool *leftOut = nullptr;              ///< whether nothing is to be judged any more: the visit stays open
};

} // namespace mb::service
