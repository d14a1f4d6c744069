// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/devicebook.h"
#include "transport/linkaddress.h"
#include "wire/canframe.h"

#include <optional>
#include <string>

/// Orders to links. Links are named by their address, as LinkView::address has it.
namespace mb::orders {

/// Opens a link, and looks for devices on it. A serial port that is not plugged in is opened once it is; until then this has
/// failed. LinkLost with the cause; Cancelled when it is closed meanwhile; OutOfRange for options that do not parse.
struct OpenLink {
    LinkAddress address;
};

/// Closes a link, or forgets one that could not be opened; what its devices were doing fails. No errors: one that is not there
/// is closed.
struct CloseLink {
    std::string link;
};

/// Looks for devices on every open link; each as soon as it answers is in the snapshot. Answered when the scans have begun.
struct ScanLinks { };

/// Every rate and every address of this link, however long it takes; a scan that runs is ended for it. LinkLost when it is not
/// open. Answered when it has begun.
struct ScanEverything {
    std::string link;
};

/// Ends a scan; what it has found stays. No errors.
struct CancelScan {
    std::string link;
};

/// A unit that nothing is heard of, because an update was cut, is in the snapshot as one that waits in its bootloader; one that does
/// answer as it is. LinkLost when the link is not open, Unsafe while it is needed for itself or searched for somebody; Cancelled
/// when the search is; Timeout as Session::connect() has it.
struct FindMute {
    using Answer = DeviceId;
    std::string link;
    std::string family;
    int address = 0;
};

/// Sends one frame by hand on a CAN link. LinkLost, Unsupported (a replay), OutOfRange (no such frame on this link); Unsafe where it makes
/// a motor move that may not (model/framepermit.h).
struct SendFrame {
    std::string link;
    CanFrame frame;
    std::optional<DeviceId> armed{}; ///< at the hand that sends it
};

} // namespace mb::orders
