// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "transport/link.h"
#include "transport/linkdoctor.h"

#include <memory>
#include <string_view>
#include <vector>

namespace mb {

struct CanInterface;

/// What a row of the listing says of its link at a glance.
enum class ListingState { Up, Down, BusOff, NoPermission, Absent, Available, Open, Lost };

/// Its word in JSON and tables.
[[nodiscard]] std::string_view toString(ListingState state);

/// One row of "which links are there". Listing opens nothing: opening a serial port can reset hardware.
struct LinkListing {
    LinkAddress link; ///< without a path where it stands for "none of this kind"
    LinkKind kind = LinkKind::Can;
    ListingState state = ListingState::Absent;
    Message detail; ///< what it is, or why it cannot be opened and what helps, in one clause
    bool openable = false;
    Diagnosis diagnosis{};   ///< of one that is not openable; `detail` is its text
    bool listenable = false; ///< a CAN controller that can listen without disturbing the bus
};

/// CAN interfaces (one row "absent" when there is none, or no CAN in the kernel), serial ports, spidev devices;
/// simulated links are not among them. Any thread; takes some milliseconds.
[[nodiscard]] std::vector<LinkListing> listLinks();
/// The row of one CAN interface.
[[nodiscard]] LinkListing listed(const CanInterface &interface);
/// Adapters behind plugins of QtSerialBus, and one row "absent" with the cause for each plugin that has none. Loads vendors'
/// libraries: GUI thread or console, and not often.
[[nodiscard]] std::vector<LinkListing> listPluginLinks();
/// What is wrong with a link in use, with what `listings` say of its interface.
[[nodiscard]] Diagnosis diagnose(const LinkSymptoms &link, Instant now, const std::vector<LinkListing> &listings);

/// Makes the closed link of an address; Link::open() names what is wrong with it. Fails with OutOfRange for an option
/// or path that this kind of link does not have, Unsupported for a kind that cannot be opened. The clock outlives the
/// link.
[[nodiscard]] Result<std::unique_ptr<Link>> createLink(const LinkAddress &address, Clock &clock);

} // namespace mb
