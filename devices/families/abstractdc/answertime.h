// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transport/canlink.h"

namespace mb::abstractdc {

/// Longest time of a request and its answer on the wire.
[[nodiscard]] Duration roundTrip(const CanLink &link);
/// How long to wait for an answer (README.md#byte-order).
[[nodiscard]] Duration answerTime(const CanLink &link);

} // namespace mb::abstractdc
