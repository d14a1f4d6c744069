// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/decoded.h"

#include <memory>

namespace mb::quadquad2drv {

/// Family::decodeBytes: packets in both directions with the names of the data sheet, README.md#stream. Motion data and streams
/// read as the masks and configurations say that passed before, or as at start-up; positions as they were asked for. What belongs to no packet (filler) has no frame.
[[nodiscard]] std::unique_ptr<ByteDecoder> decodeBytes(std::string_view dialect);

} // namespace mb::quadquad2drv
