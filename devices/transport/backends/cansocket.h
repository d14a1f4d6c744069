// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "transport/backends/caninterface.h"
#include "transport/linkdoctor.h"

#include <cstdint>
#include <optional>
#include <string>

struct can_frame;

namespace mb {

// The system calls that make and feed a CAN socket, apart from the link that lives on it.

struct OpenedCan {
    int descriptor = -1;
    int receiveBuffer = 0; ///< bytes
    CanInterface interface;
};

/// A raw socket bound to the interface, prepared before it is bound: no frame comes unstamped. Fails with LinkLost.
[[nodiscard]] Result<OpenedCan> openCanSocket(const std::string &name);

/// Nothing when the kernel has CAN sockets, else why not and what helps.
[[nodiscard]] std::optional<Diagnosis> whyNoCan();

/// Stamps, drop counter, error frames, and the largest receive buffer the kernel gives; yields its size in bytes.
/// Works on other sockets too, with what they have of this.
int prepareCanSocket(int descriptor);

/// Hands one frame to the kernel without waiting: 0 or errno. An urgent one goes to the first band of pfifo_fast.
[[nodiscard]] int writeFrame(int descriptor, const CanFrame &frame, Priority priority);

/// Frames the kernel dropped for this socket since it was opened; nothing when it does not say.
[[nodiscard]] std::optional<std::uint32_t> droppedFrames(int descriptor);

/// What an errno of the socket says about the interface, in one clause.
[[nodiscard]] Error socketFailure(const std::string &name, int cause);

[[nodiscard]] CanFrame frameOf(const can_frame &raw, Instant time);

} // namespace mb
