// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"

namespace mb::abstractdc {

/// Family::decodeCan: any frame, both directions, read as this dialect; F when it is empty. What asks or stops is read whatever the
/// dialect, because a scan and a stop speak all of them. A voltage log, which
/// has one identifier for all drives, has the address -1.
[[nodiscard]] std::optional<DecodedFrame> decodeCan(const CanFrame &frame, std::string_view dialect);
/// Family::followCan: a voltage log is that of the drive that was asked for it, where there was one.
[[nodiscard]] CanDecoder followCan(std::string_view dialect);

} // namespace mb::abstractdc
