// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/unit.h"

#include "transport/linkidentity.h"

namespace mb {
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

std::string unitKeyOf(const Device &device)
{
    return unitKeyOf(device.identity(), device.link().line(), device.link().address().isSimulated());
}

std::string unitKeyOf(const Identity &identity, const LinkAddress &link)
{
    return unitKeyOf(identity, identity.serial.empty() ? linkIdentity(link) : std::string(), link.isSimulated());
}

std::string unitKeyOf(const Identity &identity, std::string_view line, bool simulated)
{
    std::string key(simulated ? simulatedMark : "");
    if (!identity.serial.empty())
        return key + identity.family + ' ' + identity.serial;
    return key.append(placeMark).append(line) + ' ' + identity.family + ':' + std::to_string(identity.address);
}

bool isSimulatedUnit(std::string_view key)
{
    return key.starts_with(simulatedMark);
}

std::string_view unitCaveatOf(UnitBy by)
{
    return by == UnitBy::Place ? "this place, not this unit" : "";
}

UnitBy unitByOf(std::string_view key)
{
    const std::string_view name = withoutMark(key);
    if (name.starts_with(placeMark))
        return UnitBy::Place;
    return name.starts_with(tagMark) ? UnitBy::Tag : UnitBy::Serial;
}

std::string_view unitSerialIn(std::string_view key)
{
    const std::string_view name = withoutMark(key);
    return unitByOf(key) == UnitBy::Serial ? name.substr(name.find(' ') + 1) : std::string_view();
}

std::string renumberedPlaceKey(std::string_view placeKey, int number)
{
    return std::string(placeKey.substr(0, placeKey.rfind(':') + 1)) + std::to_string(number);
}

std::string taggedUnitKey(std::string_view placeKey, std::string_view tag)
{
    const std::string_view name = withoutMark(placeKey);
    const std::size_t device = name.rfind(' ') + 1;
    const std::string family(name.substr(device, name.rfind(':') - device));
    return std::string(placeKey.substr(0, placeKey.size() - name.size())) + std::string(tagMark) + family + ' '
        + std::string(tag);
}

std::string_view unitTagIn(std::string_view key)
{
    if (unitByOf(key) != UnitBy::Tag)
        return {};
    const std::string_view name = withoutMark(key).substr(tagMark.size());
    return name.substr(name.find(' ') + 1);
}

} // namespace mb
