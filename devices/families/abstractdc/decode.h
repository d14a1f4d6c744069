// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"

namespace mb::abstractdc {

/// Family::decodeCan: any frame, both directions, read as this dialect; F when it is empty.
[[nodiscard]] std::optional<DecodedFrame> decodeCan(const CanFrame &frame, std::string_view dialect);

} // namespace mb::abstractdc
