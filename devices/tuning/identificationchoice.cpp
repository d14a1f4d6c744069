// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/identificationchoice.h"

#include "model/family.h"
#include "tuning/currentidentification.h"
#include "tuning/gainscale.h"
#include "tuning/pushidentification.h"
#include "tuning/twopointidentification.h"

namespace mb::tuning {

std::unique_ptr<MotorIdentification> identificationOf(const Family &family, Mode loop)
{
    if (!family.trials)
        return nullptr;
    if (family.trials->raw.cycle > 0.0 && loop == Mode::Position)
        return std::make_unique<TwoPointIdentification>();
    if (family.trials->nudge > 0.0 || !loopUnits(family, loop))
        return nullptr;
    if (loop == Mode::Current)
        return std::make_unique<CurrentIdentification>();
    return std::make_unique<PushIdentification>();
}

} // namespace mb::tuning
