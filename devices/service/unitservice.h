// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/setpointstream.h"
#include "service/recipe.h"
#include "service/servicejournal.h"
#include "settings/settingslog.h"
#include "tuning/experiment.h"

namespace mb::service {

/// Who lets a motor turn. Thread of the session.
class MotionPermit {
public:
    virtual ~MotionPermit() = default;
    /// Before each self-test: ends when the motor may turn, which somebody was told before; fails where it may not (Unsafe).
    [[nodiscard]] virtual Task<void> beforeMotion(const Device &device, const SelfTest &test) = 0;
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

/// What can be said against this unit before anything is done to it: duplicate, wrong hardware, an image that does not fit.
/// Reads only. The error is the cause for its row.
[[nodiscard]] Task<void> preflight(Device &device, const RecipeMatter &matter, Progress &progress);

/// One unit by the recipe, in the order of Step, each written to the journal before it begins and when it has ended; the last
/// entry is the verdict. `visit` is open in the journal; one that was cut off goes on, and does nothing twice. The stream is of
/// the device, idle, and its lease (experimentLease) is the caller's to renew. Yields what the journal has. Fails only where
/// the journal could not be written (the cause), or with Cancelled: then the visit is open still.
[[nodiscard]] Task<Visit> serveUnit(
    Device &device, SetPointStream &stream, Visit visit, ServiceSurroundings surroundings, Progress &progress);

} // namespace mb::service
