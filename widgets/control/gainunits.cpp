// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/gainunits.h"

#include "model/axis.h"
#include "widgets/common/devicetext.h"
#include "widgets/parameters/leap.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <numbers>
#include <string>

namespace mb {
namespace {

struct GainText {
    Q_DECLARE_TR_FUNCTIONS(GainText)
};

constexpr std::array<std::string_view, 4> gainNames{"p", "i", "d", "f"};
constexpr std::array<std::string_view, 9> boundNames{"i_zone", "allowable_error", "ramp", "max_forward", "max_reverse",
    "nominal_forward", "nominal_reverse", "divisor", "windup"};
constexpr std::array<std::string_view, 3> limitNames{"power", "velocity", "acceleration"};

/// Device units per SI unit of the error.
std::optional<double> errorScale(const LoopScale &scale, Mode mode, double countsPerRevolution)
{
    const double countsPerRadian = countsPerRevolution / (2.0 * std::numbers::pi);
    switch (mode) {
    case Mode::Velocity: return countsPerRadian * scale.velocityTime;
    case Mode::Position: return countsPerRadian;
    case Mode::Current: return scale.currentError == "A" ? std::optional<double>(1.0) : std::nullopt;
    default: return std::nullopt;
    }
}

QString siUnit(std::string_view gain, Mode mode)
{
    const bool velocity = mode == Mode::Velocity;
    if (mode == Mode::Current)
        return gain == "i" ? GainText::tr("duty/(A·s)")
            : gain == "d"  ? GainText::tr("duty·s/A")
                           : GainText::tr("duty/A");
    if (gain == "i")
        return velocity ? GainText::tr("duty/rad") : GainText::tr("duty/(rad·s)");
    if (gain == "d")
        return velocity ? GainText::tr("duty/(rad/s²)") : GainText::tr("duty/(rad/s)");
    return velocity ? GainText::tr("duty/(rad/s)") : GainText::tr("duty/rad");
}

void collect(const Family &family, const std::string &prefix, std::span<const std::string_view> names,
    std::vector<ParameterIndex> &out)
{
    for (const std::string_view name : names) {
        if (const auto index = findParameter(family.parameters, prefix + std::string(name)))
            out.push_back(*index);
    }
}

} // namespace

bool isClosedLoop(Mode mode)
{
    return mode == Mode::Velocity || mode == Mode::Position || mode == Mode::Current || mode == Mode::RampPosition
        || mode == Mode::RampVelocity;
}

GainSet gainSet(const Family &family, Mode mode, int slot, int axis)
{
    const Mode loop = mode == Mode::RampPosition ? Mode::Position : mode == Mode::RampVelocity ? Mode::Velocity : mode;
    const std::array prefixes{
        "slot" + std::to_string(slot) + ".", std::string(toString(loop)) + ".", std::string("gain.")};
    GainSet set;
    for (const std::string &prefix : prefixes) {
        const std::string whole = axisKey(axis, prefix);
        collect(family, whole, gainNames, set.gains);
        if (set.gains.empty())
            continue;
        collect(family, whole, boundNames, set.bounds);
        break;
    }
    if (axis > 0) // they act whatever the loop does
        collect(family, axisKey(axis, "limit."), limitNames, set.bounds);
    return set;
}

QString shortName(const Parameter &parameter)
{
    const std::string_view name = gainName(parameter);
    return isGain(parameter) ? qt(name).toUpper() : tableText(parameter.label);
}

std::string_view gainName(const Parameter &parameter)
{
    const auto dot = parameter.key.rfind('.');
    return dot == std::string_view::npos ? parameter.key : parameter.key.substr(dot + 1);
}

QString gainUnit(const Family &family, const Parameter &parameter, Mode mode)
{
    const LoopScale *scale = family.loop && !family.loop->calibrated ? family.loop : nullptr;
    const std::string_view name = gainName(parameter);
    if (!scale || !isClosedLoop(mode) || !isGain(parameter))
        return tableText(parameter.unit);
    const QString error = mode == Mode::Velocity ? tableText(scale->velocityError)
        : mode == Mode::Position                 ? GainText::tr("count")
                                                 : tableText(scale->currentError);
    const QString per = scale->divided ? GainText::tr("throttle × divisor per %1") : GainText::tr("throttle per %1");
    if (name == "i")
        return per.arg(GainText::tr("%1 · %2").arg(error, tableText(scale->time)));
    if (name == "d")
        return per.arg(GainText::tr("%1 / %2").arg(error, tableText(scale->time)));
    return per.arg(error);
}

std::optional<SiGain> siGain(const Family &family, const Parameter &parameter, Mode mode, double number,
    double countsPerRevolution, double divisor)
{
    const LoopScale *scale = family.loop && !family.loop->calibrated ? family.loop : nullptr;
    const auto perSi = scale ? errorScale(*scale, mode, countsPerRevolution) : std::nullopt;
    const std::string_view name = gainName(parameter);
    if (!perSi || !isGain(parameter) || divisor == 0.0)
        return std::nullopt;
    double value = number * *perSi / (scale->fullDuty * divisor);
    if (name == "i")
        value /= scale->period;
    else if (name == "d")
        value *= scale->derivativeInverted ? -scale->period : scale->period;
    return SiGain{value, siUnit(name, mode)};
}

} // namespace mb
