// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/device.h"

#include <string>
#include <string_view>

namespace mb {

/// How a unit is known. Units without a serial number cannot be told apart: there it is the place where one is connected, and
/// another unit may stand there tomorrow, unless its user gave it a tag (SettingsBook::setTag).
enum class UnitBy { Serial, Tag, Place };

/// Whose settings, trials, debts and visits something is, whatever its link is called today: "dmc60c 2103343A79F2", "place usb-1.2
/// supermodified:4"; of simulated ones "simulated …". With a tag, which the notebook knows, "tag supermodified left arm".
[[nodiscard]] std::string unitKeyOf(const Device &device);
[[nodiscard]] std::string unitKeyOf(const Identity &identity, const LinkAddress &link);
/// `line` is the linkIdentity() of the link, which takes a look at the computer's hardware.
[[nodiscard]] std::string unitKeyOf(const Identity &identity, std::string_view line, bool simulated);
[[nodiscard]] bool isSimulatedUnit(std::string_view key);
/// For people: empty, or "this place, not this unit".
[[nodiscard]] std::string_view unitCaveatOf(UnitBy by);
[[nodiscard]] UnitBy unitByOf(std::string_view key);
/// The serial number in such a key; empty in others.
[[nodiscard]] std::string_view unitSerialIn(std::string_view key);
/// The key of such a place with another number on the same line.
[[nodiscard]] std::string renumberedPlaceKey(std::string_view placeKey, int number);
/// The key of the unit that is called so and stands at this place, given by its key.
[[nodiscard]] std::string taggedUnitKey(std::string_view placeKey, std::string_view tag);
/// The tag in such a key; empty in others.
[[nodiscard]] std::string_view unitTagIn(std::string_view key);

} // namespace mb
