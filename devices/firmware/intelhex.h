// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "firmware/firmwareimage.h"

namespace mb {

/// The image as Intel HEX: 16 data bytes a line, an extended linear address where the upper half of the address changes, LF at
/// the end of a line. FirmwareImage::fromIntelHex() reads it back byte for byte.
[[nodiscard]] std::string toIntelHex(const FirmwareImage &image);

} // namespace mb
