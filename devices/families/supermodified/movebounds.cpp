// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/movebounds.h"

#include "families/supermodified/movecommand.h"
#include "model/parameter.h"

#include <algorithm>
#include <cmath>

namespace mb::supermodified {
namespace {

constexpr double unreachable
    = 2147483648.0; ///< D1, D2: 32-bit arithmetic of the loop overflows at this P·e (README.md#overflow)
constexpr double fastestProfile = 46340.0; ///< D1, D2: its square must fit 32 bits
constexpr double surestProfile
    = 2500.0; ///< D1, D2: beyond it the knee of the profile may be missed (README.md#passed-target)
constexpr double leastOverrun = 100.0; ///< ticks that a loop may swing past its target
constexpr double widest = 4294967295.0;
constexpr double narrowest = 65535.0;
constexpr double stallTime = 2.0; ///< D1, D2: seconds until a node whose motor does not follow switches its output off

double farthestWith(std::int64_t p)
{
    return std::floor(unreachable / static_cast<double>(p)) - 1.0;
}

Message overflows(double error)
{
    return say("the motor may be %1 counts from where its loop holds it, and with this P that overflows", error);
}

} // namespace

Result<void> checkNumber(const MessageArgument &name, double value, double low, double high, std::string_view unit)
{
    if (std::isfinite(value) && value >= low && value <= high)
        return {};
    return fail(Fault::OutOfRange, say("%1 %2 is outside %3 … %4 %5", name, value, low, high, unit));
}

Result<void> MoveBounds::checkProfile(const SetPoint &setPoint) const
{
    const double fastest = isNarrow() ? fastestProfile : widest;
    const double steepest = m_node.dialect == Dialect::D1 ? narrowest : widest;
    const auto legal = [](std::string_view name, double value, double most, std::string_view unit) {
        return value == 0.0 ? Result<void>() : checkNumber(name, value, 1.0, most, unit); // 0 leaves what it has
    };
    MB_TRY_VOID(legal("--velocity", setPoint.velocity, fastest, "counts/s"));
    MB_TRY_VOID(legal("--acceleration", setPoint.acceleration, steepest, "counts/s²"));
    if (setPoint.mode != Mode::RampPosition || !isNarrow())
        return {};
    if (velocity(setPoint) && acceleration(setPoint)) {
        auto kept = legal("profile.velocity", *velocity(setPoint), fastest, "counts/s");
        if (!kept)
            kept.error().remedy = say("give --velocity, or write a lower profile.velocity");
        return kept;
    }
    return fail(Fault::Unsafe, say("its profile is not known, so a move that passes its target could not be told"),
        say("read profile.velocity and profile.acceleration"));
}

Result<void> MoveBounds::checkReach(const SetPoint &setPoint, std::optional<MotionCount::Step> step) const
{
    if (!isNarrow() || isHold(setPoint) || m_known.gainP == 0)
        return {};
    const auto error = farthest(setPoint, step);
    if (m_known.gainP && !error && setPoint.relative)
        return fail(Fault::Unsafe,
            say("after a move with a velocity or a profile it is not known from where this distance counts"),
            say("halt it first, or give a position"));
    if (!m_known.gainP || !error)
        return fail(Fault::Unsafe,
            say("its P or its position is not known, so whether this step overflows its loop is not either"),
            say("read gain.p"));
    const double most = farthestWith(*m_known.gainP);
    if (std::abs(*error) <= most)
        return {};
    if (setPoint.mode != Mode::Position)
        return fail(
            Fault::OutOfRange, overflows(*error), say("at most %1 counts/s with its P", std::floor(most / stallTime)));
    return fail(Fault::OutOfRange, say("a step of %1 counts overflows the loop of this firmware", *error),
        say("at most %1 with its P: use a profiled mode or several moves", most));
}

Result<void> MoveBounds::checkGain(
    std::int64_t p, const SetPoint &applied, std::optional<MotionCount::Step> error) const
{
    const auto reached = farthest(applied, error);
    if (!isNarrow() || !reached || p == 0 || std::abs(*reached) <= farthestWith(p))
        return {};
    return fail(Fault::OutOfRange, overflows(*reached), say("stop it first"));
}

/// What an order can make the error of the loop; nothing where the step is not known that makes it.
std::optional<double> MoveBounds::farthest(const SetPoint &setPoint, std::optional<MotionCount::Step> step) const
{
    switch (isHold(setPoint) ? Mode::Position : setPoint.mode) {
    case Mode::Velocity:
    case Mode::RampVelocity: return std::abs(setPoint.target) * stallTime;
    case Mode::RampPosition: return velocity(setPoint).value_or(fastestProfile) * stallTime;
    default: return step ? std::optional(step->farther()) : std::nullopt;
    }
}

std::optional<double> MoveBounds::velocity(const SetPoint &setPoint) const
{
    if (setPoint.velocity > 0.0)
        return setPoint.velocity;
    return m_known.profileVelocity ? std::optional(static_cast<double>(*m_known.profileVelocity)) : std::nullopt;
}

std::optional<double> MoveBounds::acceleration(const SetPoint &setPoint) const
{
    if (setPoint.acceleration > 0.0)
        return setPoint.acceleration;
    return m_known.profileAcceleration ? std::optional(static_cast<double>(*m_known.profileAcceleration))
                                       : std::nullopt;
}

Message MoveBounds::caution(const SetPoint &setPoint) const
{
    if (!isProfiled(setPoint.mode) || !m_node.dialect)
        return {};
    Message all;
    const auto changes = [&all](std::string_view key, double wanted, std::optional<std::int64_t> stands) {
        if (wanted <= 0.0 || stands == std::llround(wanted))
            return;
        all = joined(all,
            stands ? say("%1 becomes %2, it was %3: the device stores it", key, std::round(wanted), *stands)
                   : say("%1 becomes %2: the device stores it", key, std::round(wanted)));
    };
    changes("profile.velocity", setPoint.velocity, m_known.profileVelocity);
    changes("profile.acceleration", setPoint.acceleration, m_known.profileAcceleration);
    if (isNarrow() && setPoint.mode == Mode::RampPosition && velocity(setPoint).value_or(0.0) > surestProfile)
        all = joined(
            all, say("this firmware may pass the target of a profiled move above 2500 counts/s; it is stopped then"));
    return all;
}

/// A short move never gets as fast as it may.
std::optional<double> MoveBounds::overrun(const SetPoint &setPoint, double distance) const
{
    const auto speed = velocity(setPoint);
    const auto slope = acceleration(setPoint);
    if (setPoint.mode != Mode::RampPosition || !isNarrow() || !speed || !slope)
        return std::nullopt;
    const double stopping = *speed * *speed / (2.0 * std::max(*slope, 1.0));
    return std::max(std::min(stopping, std::abs(distance) / 2.0), leastOverrun);
}

} // namespace mb::supermodified
