// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/axistext.h"

#include "model/axis.h"
#include "widgets/common/livetext.h"
#include "widgets/common/numberformat.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace mb {
namespace {

struct AxisText {
    Q_DECLARE_TR_FUNCTIONS(AxisText)
};

constexpr std::array colours{
    TraceRole::Position, TraceRole::Velocity, TraceRole::Current, TraceRole::Duty, TraceRole::Temperature};

const AxisLiveness *livenessOf(const DeviceView &device, int axis)
{
    const auto place = static_cast<std::size_t>(axis - 1);
    return axis > 0 && place < device.liveness.axes.size() ? &device.liveness.axes[place] : nullptr;
}

bool hasFault(const DeviceView &device, int axis)
{
    const auto &faults = device.liveness.faults;
    return std::ranges::any_of(faults, [axis](const std::string &fault) { return axisOf(fault) == axis; });
}

} // namespace

bool turnsAxis(const DeviceView &device, int axis)
{
    const AxisLiveness *live = livenessOf(device, axis);
    const Mode mode = live ? live->mode.value_or(Mode::Off) : Mode::Off;
    return mode == Mode::Duty || mode == Mode::Velocity || mode == Mode::RampVelocity;
}

std::string channelOfAxis(const DeviceView &device, int axis)
{
    return std::string(axisKey(axis, turnsAxis(device, axis) ? "velocity" : "position"));
}

QString motorTitle(const DeviceView &device, int axis)
{
    const QString title = titleOf(device);
    return axis > 0 && hasAxes(*device.family) ? AxisText::tr("%1 · %2").arg(title, axisTitle(axis)) : title;
}

QString axisTitle(int axis)
{
    return AxisText::tr("Axis %1").arg(axis);
}

GlyphState glyphOfAxis(const DeviceView &device, int axis)
{
    const GlyphState whole = glyphOf(device);
    if (whole != GlyphState::Fault && whole != GlyphState::Moving && whole != GlyphState::Online)
        return whole;
    if (hasFault(device, axis))
        return GlyphState::Fault;
    const AxisLiveness *live = livenessOf(device, axis);
    return live && live->moving ? GlyphState::Moving : GlyphState::Online;
}

QString commandOfAxis(const DeviceView &device, int axis)
{
    if (const SetPoint *told = device.motion.on(axis)) {
        const bool duty = told->mode == Mode::Duty;
        return AxisText::tr("%1 %2", "mode and target")
            .arg(modeText(told->mode),
                duty ? formatValue(told->target * 100.0, 0, AxisText::tr("%")) : formatNumber(told->target));
    }
    const AxisLiveness *live = livenessOf(device, axis);
    return live && live->mode ? modeText(*live->mode) : QString(UnknownMark);
}

QString numberOfAxis(const DeviceView &device, int axis, Instant now)
{
    return liveText(device, channelOfAxis(device, axis), now).number;
}

QString valueOfAxis(const DeviceView &device, int axis, Instant now)
{
    return liveText(device, channelOfAxis(device, axis), now).whole();
}

TraceRole axisColour(int axis)
{
    return colours.at(static_cast<std::size_t>(std::max(axis - 1, 0)) % colours.size());
}

} // namespace mb
