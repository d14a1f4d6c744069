// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/snapshot.h"

#include <cstdint>
#include <string_view>

namespace mb {

/// Lost means, everywhere in the window: samples known to be missing. Frames that a link dropped show as samples that the
/// devices on it miss; the Bus page has the frames themselves.
struct SampleCount {
    std::uint64_t kept = 0;
    std::uint64_t lost = 0;
};

[[nodiscard]] SampleCount samplesOf(const DeviceView &device);
/// Of all devices on a link; of all links for an empty address.
[[nodiscard]] SampleCount samplesOn(const Snapshot &shot, std::string_view link = {});

} // namespace mb
