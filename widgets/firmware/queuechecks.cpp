// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/firmware/queuechecks.h"

#include "model/family.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/livetext.h"
#include "widgets/common/numberformat.h"

#include <algorithm>

namespace mb {

void setSupply(CheckRow &checks, int place, std::optional<double> volts, bool enough)
{
    checks.set(place,
        !volts       ? GlyphState::Assumed
            : enough ? GlyphState::Done
                     : GlyphState::Warning,
        volts ? QueueChecks::tr("bus %1 V").arg(formatNumber(*volts, 1)) : QueueChecks::tr("bus voltage not known"));
}

QueueChecks::QueueChecks(const ThemeSource &theme, QWidget *parent)
    : CheckRow(theme, tr("Before start"), Checks, parent)
{
}

void QueueChecks::follow(const Snapshot &snapshot, const std::vector<DeviceId> &ticked, bool hasRecipe, Instant now)
{
    bool stands = true;
    bool alone = true;
    std::optional<double> lowest;
    bool strong = true;
    for (const DeviceId id : ticked) {
        const DeviceView *device = snapshot.device(id);
        if (!device)
            continue;
        stands = stands && !device->liveness.moving;
        alone = alone && !device->liveness.foreignMaster && device->identity->state != DeviceState::Duplicate;
        const auto supply = liveValue(*device, "bus_voltage", now);
        if (supply) {
            lowest = std::min(lowest.value_or(*supply), *supply);
            strong = strong && *supply >= device->family->capabilities.lowestSupply;
        }
    }
    set(RecipeFits, hasRecipe, hasRecipe ? tr("recipe checked") : tr("no image, no recipe"));
    set(AllStand, stands, stands ? tr("all motors stopped") : tr("a motor is moving"));
    set(AllAlone, alone ? GlyphState::Done : GlyphState::Warning,
        alone ? tr("no other master") : tr("another master, or a number taken twice"));
    setSupply(*this, AllSupplied, lowest, strong);
}

} // namespace mb
