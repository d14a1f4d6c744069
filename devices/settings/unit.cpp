// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/unit.h"

#include "transport/linkidentity.h"

namespace mb::settings {
namespace {

constexpr std::string_view simulatedMark = "simulated ";
constexpr std::string_view tagMark = "tag ";
constexpr std::string_view placeMark = "place ";

std::string_view withoutMark(std::string_view key)
{
    if (key.starts_with(simulatedMark))
        key.remove_prefix(simulatedMark.size());
    return key;
}

} // namespace

Unit unitOf(const Device &device)
{
    return unitOf(device.identity(), device.link().address());
}

Unit unitOf(const Identity &identity, const LinkAddress &link)
{
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
    const std::string_view name = withoutMark(key);
    if (name.starts_with(placeMark))
        return Unit::By::Place;
    return name.starts_with(tagMark) ? Unit::By::Tag : Unit::By::Serial;
}

std::string taggedKey(std::string_view placeKey, std::string_view tag)
{
    const std::string_view name = withoutMark(placeKey);
    const std::size_t device = name.rfind(' ') + 1;
    const std::string family(name.substr(device, name.rfind(':') - device));
    return std::string(placeKey.substr(0, placeKey.size() - name.size())) + std::string(tagMark) + family + ' '
        + std::string(tag);
}

std::string_view tagIn(std::string_view key)
{
    if (byOf(key) != Unit::By::Tag)
        return {};
    const std::string_view name = withoutMark(key).substr(tagMark.size());
    return name.substr(name.find(' ') + 1);
}

} // namespace mb::settings
