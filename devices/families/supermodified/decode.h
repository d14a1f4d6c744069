// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/supermodified/frame.h"
#include "model/family.h"

#include <memory>
#include <optional>
#include <string_view>

namespace mb::supermodified {

/// One frame as named fields, with the names of README.md#frames: AndID and OndID, then the data. Requests and replies are told apart
/// by their length, and so are the dialects. The address is the node's. Nothing for a command that no dialect has, or for
/// data that no dialect sends.
[[nodiscard]] std::optional<DecodedFrame> decodeFrame(const Frame &frame);

/// Finds frames in what passes a line, each direction for itself; what is none comes out as bytes.
[[nodiscard]] std::unique_ptr<ByteDecoder> decodeBytes(std::string_view dialect);

} // namespace mb::supermodified
