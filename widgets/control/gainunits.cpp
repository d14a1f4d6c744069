// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/gainunits.h"

#include "model/axis.h"
#include "model/loopparameters.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"
#include "widgets/parameters/valuetext.h"

#include <QCoreApplication>

#include <algorithm>
#include <numbers>

namespace mb {
namespace {

struct GainText {
    Q_DECLARE_TR_FUNCTIONS(GainText)
};

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

QString siUnit(Role gain, Mode mode)
{
    const bool velocity = mode == Mode::Velocity;
    if (mode == Mode::Current)
        return gain == Role::Integral  ? GainText::tr("duty/(A·s)")
            : gain == Role::Derivative ? GainText::tr("duty·s/A")
                                       : GainText::tr("duty/A");
    if (gain == Role::Integral)
        return velocity ? GainText::tr("duty/rad") : GainText::tr("duty/(rad·s)");
    if (gain == Role::Derivative)
        return velocity ? GainText::tr("duty/(rad/s²)") : GainText::tr("duty/(rad/s)");
    return velocity ? GainText::tr("duty/(rad/s)") : GainText::tr("duty/rad");
}

/// The family's loop of a mode. Where all its loops have the same gains, those of the first: they act in every mode.
const LoopGains *shownLoopOf(const Family &family, Mode mode)
{
    if (const LoopGains *const loop = loopOf(family, mode))
        return loop;
    const std::span<const LoopGains> loops = family.trials ? family.trials->loops : std::span<const LoopGains>();
    const bool shared = !loops.empty()
        && std::ranges::all_of(loops, [&](const LoopGains &loop) { return loop.prefix == loops.front().prefix; });
    return shared ? &loops.front() : nullptr;
}

} // namespace

bool isClosedLoop(Mode mode)
{
    return mode == Mode::Velocity || mode == Mode::Position || mode == Mode::Current || mode == Mode::RampPosition
        || mode == Mode::RampVelocity;
}

GainSet gainSet(const Family &family, Mode mode, int slot, int axis)
{
    const Mode closed = mode == Mode::RampPosition ? Mode::Position
        : mode == Mode::RampVelocity               ? Mode::Velocity
                                                   : mode;
    GainSet set;
    if (const LoopGains *const loop = shownLoopOf(family, closed)) {
        for (const ParameterIndex index : loopParameters(family, *loop, axis, slot))
            (isGain(family.parameters[index.value]) ? set.gains : set.bounds).push_back(index);
    }
    for (std::uint16_t i = 0; axis > 0 && i < family.parameters.size(); ++i) { // they act whatever the loop does
        if (isLimit(family.parameters[i]) && axisOf(family.parameters[i].key) == axis)
            set.bounds.push_back({i});
    }
    return set;
}

QString shortName(const Parameter &parameter)
{
    return isGain(parameter) ? qt(gainLetter(parameter.role)) : tableText(parameter.label);
}

QString shortNumber(const Parameter &parameter, double value)
{
    if (parameter.one == 1.0)
        return formatNumber(value);
    const auto raw = toRaw(parameter, value);
    return raw ? valueText(parameter, *raw) : formatSignificant(value, 4);
}

QString gainUnit(const Family &family, const Parameter &parameter, Mode mode)
{
    const LoopScale *scale = family.loop && !family.loop->calibrated ? family.loop : nullptr;
    if (!scale || !isClosedLoop(mode) || !isGain(parameter))
        return tableText(parameter.unit);
    const QString error = mode == Mode::Velocity ? tableText(scale->velocityError)
        : mode == Mode::Position                 ? GainText::tr("count")
                                                 : tableText(scale->currentError);
    const QString per = scale->divided ? GainText::tr("throttle × divisor per %1") : GainText::tr("throttle per %1");
    if (parameter.role == Role::Integral)
        return per.arg(GainText::tr("%1 · %2").arg(error, tableText(scale->time)));
    if (parameter.role == Role::Derivative)
        return per.arg(GainText::tr("%1 / %2").arg(error, tableText(scale->time)));
    return per.arg(error);
}

std::optional<SiGain> siGain(const Family &family, const Parameter &parameter, Mode mode, double number,
    double countsPerRevolution, double divisor)
{
    const LoopScale *scale = family.loop && !family.loop->calibrated ? family.loop : nullptr;
    const auto perSi = scale ? errorScale(*scale, mode, countsPerRevolution) : std::nullopt;
    if (!perSi || !isGain(parameter) || divisor == 0.0)
        return std::nullopt;
    double value = number * *perSi / (scale->fullDuty * divisor);
    if (parameter.role == Role::Integral)
        value /= scale->period;
    else if (parameter.role == Role::Derivative)
        value *= scale->derivativeInverted ? -scale->period : scale->period;
    return SiGain{value, siUnit(parameter.role, mode)};
}

SiGain siGain(Role gain, Mode mode, double number, double countsPerRevolution)
{
    const double perSi = mode == Mode::Current ? 1.0 : countsPerRevolution / (2.0 * std::numbers::pi);
    return {number * perSi, siUnit(gain, mode)};
}

/// One digit of an exponent is enough.
QString SiGain::text() const
{
    return formatSignificant(value, 3).replace(QStringLiteral("e−0"), QStringLiteral("e−")) + QLatin1Char(' ') + unit;
}

} // namespace mb
