// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/unit.h"

#include "transport/linkidentity.h"

namespace mb::settings {
namespace {

constexpr std::string_view simulatedMark = "simulated ";
constexpr std::string_view placeMark = "place ";

} // namespace

Unit unitOf(const Device &device)
{
    const Identity &identity = device.identity();
    const LinkAddress &link = device.link().address();
    const std::string simulated(link.isSimulated() ? simulatedMark : "");
    if (!identity.serial.empty())
        return {simulated + identity.family + ' ' + identity.serial, Unit::By::Serial};
    return {simulated + std::string(placeMark) + linkIdentity(link) + ' ' + identity.family + ':'
            + std::to_string(identity.address),
        Unit::By::Place};
}

std::string_view caveatOf(Unit::By by)
{
    return by == Unit::By::Place ? "this place, not this unit" : "";
}

Unit::By byOf(std::string_view key)
{
    if (key.starts_with(simulatedMark))
        key.remove_prefix(simulatedMark.size());
    return key.starts_with(placeMark) ? Unit::By::Place : Unit::By::Serial;
}

} // namespace mb::settings
