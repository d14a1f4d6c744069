// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "transport/link.h"

#include <memory>
#include <string>
#include <vector>

namespace mb {

/// One row of "which links are there". Listing opens nothing: opening a serial port can reset hardware.
struct LinkListing {
    LinkAddress link; ///< without a path where it stands for "none of this kind"
    LinkKind kind = LinkKind::Can;
    std::string state;  ///< "up", "down", "no-permission", "absent", "available"
    std::string detail; ///< what it is, or why it cannot be opened and what helps, in one clause
    bool openable = false;
};

/// CAN interfaces (one row "absent" when there is none, or no CAN in the kernel), serial ports, spidev devices;
/// simulated links are not among them. Any thread; takes some milliseconds.
[[nodiscard]] std::vector<LinkListing> listLinks();

/// Makes the closed link of an address; Link::open() names what is wrong with it. Fails with OutOfRange for an option
/// or path that this kind of link does not have, Unsupported for a kind that cannot be opened. The clock outlives the
/// link.
[[nodiscard]] Result<std::unique_ptr<Link>> createLink(const LinkAddress &address, Clock &clock);

} // namespace mb
