// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"

namespace mb::tinker {

/// Family::routes: by hand, with a handle to turn first.
[[nodiscard]] std::span<const UpdateRoute> routes();
/// Family::inspect.
[[nodiscard]] Result<ImageSummary> inspect(const FirmwareImage &image);
/// Family::update. `options.via` is `handle:`: somebody has turned it.
[[nodiscard]] Task<UpdateReport> update(
    Device &device, const FirmwareImage &image, UpdateOptions options, Progress &progress);

} // namespace mb::tinker
