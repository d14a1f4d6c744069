// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/framedecoder.h"

#include <QString>

#include <cstdint>
#include <vector>

namespace mb {

/// Which bits of a frame make each of its fields: bit n of the mask is bit n % 8 of byte n / 8. Found by turning every bit
/// and decoding again, so it holds for any family. A bit that only scales a field belongs to the field that it is.
[[nodiscard]] std::vector<std::uint64_t> fieldBits(const CanFrame &frame, const FrameDecoder &decoder);

/// "0–1" for whole bytes, "2.0–3" for bits of one, "4.3–5.1" across; empty for none.
[[nodiscard]] QString bitsText(std::uint64_t mask);

} // namespace mb
