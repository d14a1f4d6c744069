// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/gainunits.h"

#include "widgets/common/devicetext.h"

#include <QCoreApplication>

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

/// Numbers of a loop that computes in integers: tuning.md 3.8.
struct LoopScale {
    std::string_view family;
    double fullDuty = 0.0;
    double period = 0.0;       ///< of the loop, seconds
    double velocityTime = 0.0; ///< velocities are counts per so many seconds
    const char *velocityError = nullptr;
};
constexpr std::array scales{
    LoopScale{"dmc60c", 32767.0, 500e-6, 0.1, QT_TRANSLATE_NOOP("GainText", "count/100\u00A0ms")}};

const LoopScale *scaleOf(const Family &family)
{
    for (const LoopScale &scale : scales) {
        if (scale.family == family.key)
            return &scale;
    }
    return nullptr;
}

/// Device units per SI unit of the error.
std::optional<double> errorScale(const LoopScale &scale, Mode mode, double countsPerRevolution)
{
    const double countsPerRadian = countsPerRevolution / (2.0 * std::numbers::pi);
    switch (mode) {
    case Mode::Velocity: return countsPerRadian * scale.velocityTime;
    case Mode::Position: return countsPerRadian;
    case Mode::Current: return 1.0;
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

GainSet gainSet(const Family &family, Mode mode, int slot)
{
    const std::array prefixes{
        "slot" + std::to_string(slot) + ".", std::string(toString(mode)) + ".", std::string("gain.")};
    for (const std::string &prefix : prefixes) {
        GainSet set;
        collect(family, prefix, gainNames, set.gains);
        collect(family, prefix, boundNames, set.bounds);
        if (!set.gains.empty())
            return set;
    }
    return {};
}

std::string_view gainName(const Parameter &parameter)
{
    const auto dot = parameter.key.rfind('.');
    return dot == std::string_view::npos ? parameter.key : parameter.key.substr(dot + 1);
}

QString gainUnit(const Family &family, const Parameter &parameter, Mode mode)
{
    const LoopScale *scale = scaleOf(family);
    if (!scale || !isClosedLoop(mode) || parameter.type != WireType::Fixed16x16)
        return tableText(parameter.unit);
    const QString error = mode == Mode::Velocity ? GainText::tr(scale->velocityError)
        : mode == Mode::Position                 ? GainText::tr("count")
                                                 : GainText::tr("A");
    const std::string_view name = gainName(parameter);
    if (name == "i")
        return GainText::tr("throttle per %1 · loop").arg(error);
    if (name == "d")
        return GainText::tr("throttle per %1 / loop").arg(error);
    return GainText::tr("throttle per %1").arg(error);
}

std::optional<SiGain> siGain(
    const Family &family, const Parameter &parameter, Mode mode, double number, double countsPerRevolution)
{
    const LoopScale *scale = scaleOf(family);
    const auto perSi = scale ? errorScale(*scale, mode, countsPerRevolution) : std::nullopt;
    const std::string_view name = gainName(parameter);
    if (!perSi || parameter.type != WireType::Fixed16x16)
        return std::nullopt;
    double value = number * *perSi / scale->fullDuty;
    if (name == "i")
        value /= scale->period;
    else if (name == "d")
        value *= scale->period;
    return SiGain{value, siUnit(name, mode)};
}

} // namespace mb
