// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/presentvalue.h"

#include "model/axis.h"
#include "widgets/common/devicetext.h"
#include "widgets/plots/displayunits.h"

namespace mb {

std::optional<double> presentValue(const DeviceView &view, Mode mode, int axis, Instant now)
{
    const Quantity quantity = quantityOf(mode);
    if (quantity == Quantity::Voltage) // of the supply, not of the motor
        return std::nullopt;
    for (const Channel &channel : view.family->channels) {
        if (channel.quantity == quantity && axisOf(channel.key) == axis)
            return liveValue(view, channel.key, now);
    }
    return std::nullopt;
}

} // namespace mb
