// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/loopparameters.h"

#include "model/axis.h"
#include "model/family.h"

#include <algorithm>

namespace mb {

const LoopGains *loopOf(const Family &family, Mode mode)
{
    if (!family.trials)
        return nullptr;
    const auto &loops = family.trials->loops;
    const auto found = std::ranges::find(loops, mode, &LoopGains::mode);
    return found == loops.end() ? nullptr : &*found;
}

std::string gainKey(const Family &family, std::string_view pattern, int axis, int slot)
{
    std::string key(pattern);
    if (const auto at = key.find('#'); at != std::string::npos)
        key.replace(at, 1, std::to_string(slot));
    return family.capabilities.axes > 1 ? axisKey(axis, key) : key;
}

std::vector<ParameterIndex> loopParameters(const Family &family, const LoopGains &loop, int axis, int slot)
{
    std::vector<ParameterIndex> rows;
    const std::string prefix = gainKey(family, loop.prefix, axis, slot);
    for (const std::string_view name : loop.names) {
        if (const auto index = findParameter(family.parameters, prefix + std::string(name)))
            rows.push_back(*index);
    }
    return rows;
}

std::optional<ParameterIndex> parameterOf(const Family &family, Mode loop, int axis, int slot, Role role)
{
    const LoopGains *const gains = loopOf(family, loop);
    if (!gains)
        return std::nullopt;
    for (const ParameterIndex index : loopParameters(family, *gains, axis, slot)) {
        if (family.parameters[index.value].role == role)
            return index;
    }
    return std::nullopt;
}

std::optional<ParameterIndex> parameterOfAxis(const Family &family, int axis, Role role)
{
    for (std::uint16_t i = 0; i < family.parameters.size(); ++i) {
        if (family.parameters[i].role == role && axisOf(family.parameters[i].key) == axis)
            return ParameterIndex{i};
    }
    return std::nullopt;
}

Role roleOf(const Family &family, std::string_view key)
{
    const auto index = findParameter(family.parameters, key);
    return index ? family.parameters[index->value].role : Role::None;
}

std::string_view gainLetter(Role role)
{
    switch (role) {
    case Role::Proportional: return "P";
    case Role::Integral: return "I";
    case Role::Derivative: return "D";
    case Role::FeedForward: return "F";
    default: return {};
    }
}

} // namespace mb
