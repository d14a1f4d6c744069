// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/setpoints.h"

#include "families/abstractdc/parameters.h"

#include <QtGlobal>

#include <algorithm>
#include <cmath>

namespace mb::abstractdc {
namespace {

constexpr double farthest = 2147483647.0;
constexpr double safeOutput = 32000.0; ///< of 32767
constexpr double firstPass = 1.0;      ///< ms, at least: from the set-point that entered the loop
constexpr double laterPass = 20.0;

struct Scale {
    Loop loop = Loop::None;
    double low = 0.0;
    double high = 0.0;
    double one = 1.0; ///< wire value of 1.0
};

Result<Scale> scaleOf(Mode mode, const DeviceProfile &profile)
{
    const double perCount = profile.calibrated(calibration::amperes, 1.0);
    switch (mode) {
    case Mode::Off: return Scale{};
    case Mode::Duty: return Scale{Loop::Direct, -1.0, 1.0, fullPwm}; // README.md#wraps: never more
    case Mode::Velocity: return Scale{Loop::Velocity, -farthest, farthest};
    case Mode::Position: return Scale{Loop::Position, -farthest, farthest};
    case Mode::Current: return Scale{Loop::Current, 0.0, adcMost * perCount, 1.0 / perCount};
    default: break;
    }
    return fail(Fault::Unsupported, say("an Abstract DC Drive has no mode '%1'", toString(mode)));
}

/// Output per unit of error in a pass of so many milliseconds, in which the error may turn from one end to the other; nothing where it is
/// not known. With the changes.
std::optional<double> strengthOf(
    const ParameterStore &known, Loop loop, double milliseconds, std::span<const ParameterChange> changes = {})
{
    const auto number = [&](Field field) -> std::optional<double> {
        const auto index = parameterOf(loop, field);
        const auto last = std::ranges::find(changes.rbegin(), changes.rend(), index, &ParameterChange::index);
        if (last != changes.rend())
            return static_cast<double>(last->raw);
        const auto raw = index ? known.entry(*index).raw : std::nullopt;
        return raw ? std::optional<double>(static_cast<double>(*raw)) : std::nullopt;
    };
    const auto p = number(Field::P);
    const auto d = number(Field::D);
    const auto divisor = number(Field::Divisor);
    if (!p || !d || !divisor || *divisor == 0.0)
        return std::nullopt;
    return (std::abs(*p) + 2.0 * std::abs(*d) / milliseconds) / std::abs(*divisor);
}

} // namespace

Result<Command> commandOf(const SetPoint &setPoint, const DeviceProfile &profile)
{
    MB_TRY(const auto scale, scaleOf(setPoint.mode, profile));
    if (!std::isfinite(setPoint.target))
        return fail(Fault::OutOfRange, say("%1 needs a number", toString(setPoint.mode)));
    if (!std::isfinite(setPoint.ramp) || setPoint.ramp < 0.0)
        return fail(Fault::OutOfRange, say("the ramp must be 0 or a positive number of duty per second"));
    if (setPoint.target < scale.low || setPoint.target > scale.high)
        return fail(Fault::OutOfRange,
            say("%1 %2 is outside %3 … %4", toString(setPoint.mode), setPoint.target, scale.low, scale.high));
    return Command{scale.loop, static_cast<std::int32_t>(std::lround(setPoint.target * scale.one))};
}

Mode modeOf(Loop loop)
{
    switch (loop) {
    case Loop::None: return Mode::Off;
    case Loop::Velocity: return Mode::Velocity;
    case Loop::Current: return Mode::Current;
    case Loop::Position: return Mode::Position;
    case Loop::Direct: return Mode::Duty;
    }
    return Mode::Off;
}

bool knowsGains(const ParameterStore &known, Loop loop)
{
    return strengthOf(known, loop, laterPass).has_value();
}

double greatestError(
    const ParameterStore &known, Loop loop, bool hasPassed, double unknown, std::span<const ParameterChange> changes)
{
    const auto with = [&](std::span<const ParameterChange> sent) {
        const auto strength = strengthOf(known, loop, hasPassed ? laterPass : firstPass, sent);
        if (!strength)
            return unknown;
        return *strength > 0.0 ? std::floor(safeOutput / *strength) : farthest;
    };
    return changes.empty() ? with({}) : std::min(with(changes), with(changes.first(changes.size() - 1)));
}

Result<void> mayChange(
    const ParameterStore &known, std::span<const ParameterChange> changes, double error, double unknown)
{
    const Loop loop = loopOf(known.parameter(changes.back().index));
    const double most = greatestError(known, loop, true, unknown, changes);
    if (std::max(error, 1.0) <= most
        || most >= greatestError(known, loop, true, unknown, changes.first(changes.size() - 1)))
        return {};
    return fail(Fault::Unsafe,
        say("the motor is so far from its target that with this value the output would turn to full reverse"),
        say("stop it first"));
}

Result<void> mayEnterVelocity(const Whereabouts::SpeedRange &entry, const ParameterStore &known, double unknown)
{
    if (entry.halfWidth() <= greatestError(known, Loop::Velocity, false, unknown))
        return {};
    return fail(Fault::Unsafe,
        say("its velocity loop begins with the mean speed since it ran last: from %1 to %2 counts/s, with the speed of "
            "now, is so much that with its gains the output would turn to full reverse",
            std::lround(entry.low), std::lround(entry.high)),
        knowsGains(known, Loop::Velocity)
            ? say("stop the motor and let it stand for a while, or lower p")
            : say("stop the motor and let it stand for a while, or write p, d and divisor of the loop once"));
}

std::int32_t TargetLead::next(
    const Command &command, double ramp, std::optional<double> feedback, double greatestError, Instant now)
{
    const bool fresh = !m_value || command.loop != m_loop;
    const double seconds = fresh ? 0.02 : std::chrono::duration<double>(now - m_at).count();
    m_at = now;
    m_loop = command.loop;
    double value = command.target;
    if (command.loop == Loop::Direct) {
        const double step = std::max(1.0, (ramp > 0.0 ? ramp : usualRamp) * fullPwm * seconds);
        const double before = fresh ? 0.0 : *m_value;
        value = std::clamp(value, before - step, before + step);
    } else {
        const bool isFromNothing = fresh || command.loop == Loop::Current; // its converter reads no less
        const double unknown = isFromNothing ? 0.0 : *m_value;
        const double from = feedback.value_or(unknown);
        value = std::clamp(value, from - greatestError, from + greatestError);
    }
    m_value = value;
    return static_cast<std::int32_t>(std::lround(std::clamp(value, -farthest, farthest)));
}

} // namespace mb::abstractdc
