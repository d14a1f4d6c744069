// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/snapshot.h"

#include <QString>

#include <compare>
#include <vector>

class QByteArray;
class QMimeData;

namespace mb {

/// One channel of one device, as long as the program runs.
struct Signal {
    DeviceId device;
    ChannelIndex channel;
    friend auto operator<=>(const Signal &, const Signal &) = default;
};

/// What dragged signals travel as.
inline constexpr const char *signalMimeType = "application/x-motorbench-signal";
[[nodiscard]] QByteArray toMime(const std::vector<Signal> &carried);
/// Nothing when it is not ours.
[[nodiscard]] std::vector<Signal> signalsFromMime(const QByteArray &data);
/// What a view's model hands to a drag; nullptr for nothing.
[[nodiscard]] QMimeData *carry(const std::vector<Signal> &carried);

/// "#5 velocity", "#0 ch2 velocity"
[[nodiscard]] QString signalName(const DeviceView &device, ChannelIndex channel);
/// The same with family and link, "DMC60C #5 velocity", "#5 velocity (can0)", as far as another one of these has its number.
[[nodiscard]] QString signalName(
    const DeviceView &device, ChannelIndex channel, const std::vector<DeviceView> &devices);
/// "velocity" as it stands in the middle of a line.
[[nodiscard]] QString channelName(const Channel &channel);
/// What one looks at first: of an axis, or of the device as a whole (0), which is the position of every axis where it has several.
[[nodiscard]] std::vector<Signal> usualSignals(const DeviceView &device, int axis);

} // namespace mb
