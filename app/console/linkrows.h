// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/console.h"
#include "transport/linkcatalog.h"

#include <QJsonArray>

namespace mb::console {

/// Every link of this machine, the simulated ones last. Opens nothing.
[[nodiscard]] std::vector<LinkListing> allLinks(const Console &console);
/// What became of a link that was opened, and what is wrong with it.
[[nodiscard]] LinkListing listingOf(const Link &link, Instant now);
[[nodiscard]] QJsonArray toJson(const std::vector<LinkListing> &links);
void print(Output &out, const std::vector<LinkListing> &links);

} // namespace mb::console
