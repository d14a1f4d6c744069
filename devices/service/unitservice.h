// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/setpointstream.h"
#include "service/preflight.h"
#include "service/servicesurroundings.h"

namespace mb::service {

/// One unit by the recipe, in the order of Step, each written to the journal before it begins and when it has ended; the last
/// entry is the verdict. `visit` is open in the journal; one that was cut off goes on, and does nothing twice. The stream is of
/// the device, idle, and its lease (experimentLease) is the caller's to renew. Yields what the journal has. Fails only where
/// the journal could not be written (the cause), or with Cancelled: then the visit is open still.
[[nodiscard]] Task<Visit> serveUnit(
    Device &device, SetPointStream &stream, Visit visit, ServiceSurroundings surroundings, Progress &progress);

} // namespace mb::service
