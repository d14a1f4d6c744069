// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/devicetext.h"
#include "widgets/common/theme.h"

#include <QString>

#include <string>

namespace mb {

/// The one place where the state of an axis becomes text and shape. Axes count from 1.

/// "QuadQuad2Drv #0 · Axis 2"; of a device with one motor, or as a whole (0), only the device.
[[nodiscard]] QString motorTitle(const DeviceView &device, int axis);
/// "Axis 2"
[[nodiscard]] QString axisTitle(int axis);
[[nodiscard]] GlyphState glyphOfAxis(const DeviceView &device, int axis);
/// What it is told, with its target: "velocity 2 000", "off"; "–" while nobody knows.
[[nodiscard]] QString commandOfAxis(const DeviceView &device, int axis);
/// The one live value that says most in its mode: what is controlled, or else the position.
[[nodiscard]] QString numberOfAxis(const DeviceView &device, int axis, Instant now);
/// The same, where there is room for the unit.
[[nodiscard]] QString valueOfAxis(const DeviceView &device, int axis, Instant now);
/// Whether its mode is about velocity, and the channel of the value that says most then.
[[nodiscard]] bool turnsAxis(const DeviceView &device, int axis);
[[nodiscard]] std::string channelOfAxis(const DeviceView &device, int axis);
/// Colour of everything of an axis where several are in one plot.
[[nodiscard]] TraceRole axisColour(int axis);

} // namespace mb
