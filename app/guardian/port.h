// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/guardian/runner.h"

#include <memory>
#include <optional>
#include <string_view>

namespace mb::guardian {

/// How messages pass a descriptor.
enum class PortForm {
    Packet, ///< one write, one message: CAN sockets
    Stream, ///< terminals, stream sockets
    Spi,    ///< spidev, one transfer a message
};

/// Its word on the guardian's command line.
[[nodiscard]] const char *toString(PortForm form);
/// The same back; nothing for another word.
[[nodiscard]] std::optional<PortForm> portFormFrom(std::string_view word);

/// A port on an inherited descriptor.
[[nodiscard]] std::unique_ptr<Port> makePort(PortForm form, int descriptor);

/// What an error of a write or a transfer says of the device file.
[[nodiscard]] Port::Sent verdictOn(int cause);

} // namespace mb::guardian
