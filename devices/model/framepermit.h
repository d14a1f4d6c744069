// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/framedecoder.h"

#include <functional>

namespace mb {

/// What becomes of a frame that a person sends.
struct FramePermit {
    bool control = false;                ///< makes a motor move: never sent by a click
    std::optional<FrameMeaning> meaning; ///< nothing where no family knows it
    std::optional<Error> refusal;        ///< why it is not sent now, and the remedy
    DeviceId device;                     ///< whose motor, of a control frame that may be sent
};
/// A control frame needs an armed device on this link that STOP can reach, that nobody else drives, and that stops by itself
/// when nothing follows. Everything else needs an open link.
[[nodiscard]] FramePermit permitFor(const CanFrame &frame, const std::string &link, const Snapshot &shot,
    std::span<const Family *const> families, const std::function<bool(DeviceId)> &isArmed);

} // namespace mb
