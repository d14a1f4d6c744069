// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transport/linkaddress.h"

#include <string>
#include <string_view>

namespace mb {

/// What is behind an address, whatever it is called today (place/place.h): `can0` may be another adapter tomorrow. Where no
/// hardware is known, scheme and name, as in `unix:board`.
[[nodiscard]] std::string linkIdentity(const LinkAddress &address);
/// Whether an identity tells of hardware.
[[nodiscard]] inline bool isPlace(std::string_view identity)
{
    return identity.starts_with('/');
}

} // namespace mb
