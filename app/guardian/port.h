// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/guardian/runner.h"

#include <memory>
#include <string_view>

namespace mb::guardian {

/// A port on an inherited descriptor, by the word the program gave: "packet" (one write, one message: CAN sockets), "stream"
/// (terminals, stream sockets), "spi" (spidev, one transfer a message). nullptr for another word.
[[nodiscard]] std::unique_ptr<Port> makePort(std::string_view form, int descriptor);

/// What an error of a write or a transfer says of the device file.
[[nodiscard]] Port::Sent verdictOn(int cause);

} // namespace mb::guardian
