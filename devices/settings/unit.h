// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/device.h"

#include <string>
#include <string_view>

namespace mb::settings {

/// Whose settings something is. Units without a serial number cannot be told apart: there it is the place where one is
/// connected, and another unit may stand there tomorrow, unless its user gave it a tag (SettingsBook::setTag).
struct Unit {
    enum class By { Serial, Tag, Place };
    std::string
        key; ///< "dmc60c 2103343A79F2", "tag supermodified left arm", "place usb-1.2 supermodified:4"; "simulated …"
    By by = By::Serial;

    friend bool operator==(const Unit &, const Unit &) = default;
};

[[nodiscard]] Unit unitOf(const Device &device);
[[nodiscard]] Unit unitOf(const Identity &identity, const LinkAddress &link);
/// For people: empty, or "this place, not this unit".
[[nodiscard]] std::string_view caveatOf(Unit::By by);
[[nodiscard]] Unit::By byOf(std::string_view key);
/// The key of the unit that is called so and stands at this place, given by its key.
[[nodiscard]] std::string taggedKey(std::string_view placeKey, std::string_view tag);
/// The tag in such a key; empty in others.
[[nodiscard]] std::string_view tagIn(std::string_view key);

} // namespace mb::settings
