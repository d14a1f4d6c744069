// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/snapshot.h"

#include <QStringList>

namespace mb {

/// What a snapshot says of motion, beyond the one device that is armed.

/// "#5"; empty where it is gone.
[[nodiscard]] QString addressIn(const Snapshot &shot, DeviceId device);
/// "DMC60C #5"; empty where it is gone.
[[nodiscard]] QString titleIn(const Snapshot &shot, DeviceId device);
/// The mode; of boards the number of axes.
[[nodiscard]] QString whatMoves(const DeviceView *view, Mode mode);
/// An experiment has this device, whether it moves it now or puts back what it has changed.
[[nodiscard]] bool isTried(const Snapshot &shot, DeviceId device);
/// A device that an experiment moves, whoever has begun it.
[[nodiscard]] const DeviceView *experimentedWith(const Snapshot &shot);
/// Devices that were told to stop, were not seen to, and have nothing that stops them: "#3, #5"; empty for none.
[[nodiscard]] QString namesThatMayTurn(const Snapshot &shot);
/// Of them, those that are in no list any more.
[[nodiscard]] QStringList namesOwed(const Snapshot &shot);
/// Whom STOP leaves out, because it could do harm there: "#3, #5", or with the reasons "#3 (bootloader), …".
[[nodiscard]] QString namesLeftOut(const Snapshot &shot, bool why = false);
/// A STOP is under way to something that moves.
[[nodiscard]] bool isStopping(const Snapshot &shot);

} // namespace mb
