// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/linkidentity.h"

#include "place/place.h"

#include <filesystem>

namespace mb {

std::string linkIdentity(const LinkAddress &address)
{
    std::string place;
    if (address.scheme == "socketcan")
        place = placeOf(PlaceKind::CanInterface, address.path);
    else if (address.scheme == "serial")
        place = placeOf(PlaceKind::SerialPort, address.path);
    else if (address.scheme == "spidev")
        place = placeOf(PlaceKind::SpiDevice, address.path);
    if (!place.empty())
        return place;
    std::error_code failed;
    const bool isFile = address.scheme == "serial" || address.scheme == "spidev" || address.scheme == "unix";
    const auto name = isFile ? std::filesystem::absolute(address.path, failed) : std::filesystem::path(address.path);
    return address.scheme + ':' + name.string();
}

} // namespace mb
