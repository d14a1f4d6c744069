// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"

namespace mb::dmc60c {

/// Every message of README.md#identifiers, in both directions, with the names of the maker's guide; nothing for anything else. Values are
/// in the wire's unit after scale flags, fixed-point ones as engineering values; there are no dialects.
[[nodiscard]] std::optional<DecodedFrame> decodeCan(const CanFrame &frame, std::string_view dialect);

} // namespace mb::dmc60c
