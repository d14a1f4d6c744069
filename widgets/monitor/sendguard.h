// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/control/arming.h"
#include "widgets/monitor/framedecoder.h"

#include <QString>

namespace mb {

/// What a typed frame is: one or the other.
struct TypedFrame {
    std::optional<CanFrame> frame;
    QString problem; ///< what is wrong and what would be right
};
/// Reads identifier (hexadecimal, `0x` allowed) and bytes ("81 25 11", blanks as you like). A whole line of candump in the
/// first field, `02061405#8125`, is understood too; its digits then tell the format.
[[nodiscard]] TypedFrame readTypedFrame(const QString &id, bool extended, const QString &data);

/// What becomes of a frame that a person sends.
struct SendVerdict {
    bool control = false; ///< makes a motor move: never sent by a click
    QString meaning;      ///< what the frame says, for people
    QString refusal;      ///< why it is not sent now, and the remedy; empty when it may be
    DeviceId device;      ///< whose motor, of a control frame that may be sent
};
/// A control frame needs an armed device on this link that STOP can reach, that nobody else drives, and that stops by itself
/// when nothing follows. Everything else needs an open link.
[[nodiscard]] SendVerdict judgeFrame(
    const CanFrame &frame, const std::string &link, const Snapshot &shot, const Arming &arming);

} // namespace mb
