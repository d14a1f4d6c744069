// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/snapshot.h"
#include "widgets/common/checkrow.h"

#include <optional>

namespace mb {

/// A supply of less than a unit wants is warned of, no more; not every family tells it.
void setSupply(CheckRow &checks, int place, std::optional<double> volts, bool enough);

/// What must hold before a queue; of each unit its own preflight looks again. GUI thread.
class QueueChecks : public CheckRow {
    Q_OBJECT
public:
    enum Check { RecipeFits, AllStand, AllAlone, AllSupplied, Checks };

    explicit QueueChecks(const ThemeSource &theme, QWidget *parent);
    /// Of the units that are ticked; `now` is the time of the snapshot.
    void follow(const Snapshot &snapshot, const std::vector<DeviceId> &ticked, bool hasRecipe, Instant now);
};

} // namespace mb
