// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/supermodified/frame.h"
#include "model/family.h"

#include <functional>
#include <optional>
#include <string_view>

namespace mb::supermodified {

/// One frame as named fields, with the names of section 2: AndID and OndID, then the data. Requests and replies are told apart
/// by their length, and so are the dialects. The address is the node's. Nothing for a command that no dialect has, or for
/// data that no dialect sends.
[[nodiscard]] std::optional<DecodedFrame> decodeFrame(const Frame &frame);

} // namespace mb::supermodified
