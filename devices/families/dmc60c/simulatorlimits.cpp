// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/simulatorlimits.h"

namespace mb::dmc60c::simulation {

void Limits::read(const Rig &rig, const ParameterBank &bank, const ControlWord &word, std::int32_t position)
{
    forward.level = !rig.isForwardSwitchClosed();
    forward.normallyClosed = bank.flag(number::forwardNormallyClosed);
    forward.disabled = bank.flag(number::forwardDisabled);
    forward.disabledByFrame = word.forwardLimitOff;
    forward.softEnabled = bank.flag(number::softForwardEnable);
    forward.softHit = forward.softEnabled && position >= bank.value(number::softForwardThreshold);
    reverse.level = !rig.isReverseSwitchClosed();
    reverse.normallyClosed = bank.flag(number::reverseNormallyClosed);
    reverse.disabled = bank.flag(number::reverseDisabled);
    reverse.disabledByFrame = word.reverseLimitOff;
    reverse.softEnabled = bank.flag(number::softReverseEnable);
    reverse.softHit = reverse.softEnabled && position <= bank.value(number::softReverseThreshold);
    for (LimitPin *pin : {&forward, &reverse})
        pin->hit = pin->level == pin->normallyClosed;
}

bool Limits::block(std::int32_t duty, bool overridden) const
{
    const auto isHit = [overridden](const LimitPin &pin) {
        return (pin.hit && !(overridden ? pin.disabledByFrame : pin.disabled)) || pin.softHit;
    };
    return (duty > 0 && isHit(forward)) || (duty < 0 && isHit(reverse));
}

} // namespace mb::dmc60c::simulation
