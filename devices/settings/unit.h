// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/device.h"

#include <string>
#include <string_view>

namespace mb::settings {

/// Whose settings something is. Units without a serial number cannot be told apart: there it is the place where one is
/// connected, and another unit may stand there tomorrow.
struct Unit {
    enum class By { Serial, Place };
    std::string key; ///< "dmc60c 2103343A79F2", "place usb-1.2 supermodified:4"; of a simulated one "simulated …"
    By by = By::Serial;

    friend bool operator==(const Unit &, const Unit &) = default;
};

[[nodiscard]] Unit unitOf(const Device &device);
/// For people: empty, or "this place, not this unit".
[[nodiscard]] std::string_view caveatOf(Unit::By by);
[[nodiscard]] Unit::By byOf(std::string_view key);

} // namespace mb::settings
