// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/movebounds.h"

#include "model/parameter.h"

#include <algorithm>
#include <cmath>

namespace mb::supermodified {
namespace {

constexpr double unreachable = 2147483648.0; ///< D1, D2: 32-bit arithmetic of the loop overflows at this P·e (4)
constexpr double fastestProfile = 46340.0;   ///< D1, D2: its square must fit 32 bits (4)
constexpr double surestProfile
    = 2500.0; ///< D1, D2: beyond it the knee of the profile may be missed (README.md#passed-target)
constexpr double leastOverrun = 100.0; ///< ticks that a loop may swing past its target
constexpr double widest = 4294967295.0;
constexpr double narrowest = 65535.0;

} // namespace

bool isPosition(Mode mode)
{
    return mode == Mode::Position || mode == Mode::RampPosition;
}
bool isProfiled(Mode mode)
{
    return mode == Mode::RampPosition || mode == Mode::RampVelocity;
}

Result<void> checkNumber(std::string_view name, double value, double low, double high, std::string_view unit)
{
    if (std::isfinite(value) && value >= low && value <= high)
        return {};
    return fail(Fault::OutOfRange,
        std::string(name) + ' ' + numberText(value) + " is outside " + numberText(low) + " … " + numberText(high) + ' '
            + std::string(unit));
}

Result<void> MoveBounds::checkProfile(const SetPoint &setPoint) const
{
    const double fastest = isNarrow() ? fastestProfile : widest;
    const double steepest = m_node.dialect == Dialect::D1 ? narrowest : widest;
    if (auto good = checkNumber("--velocity", setPoint.velocity, 0.0, fastest, "counts/s"); !good)
        return good;
    if (auto good = checkNumber("--acceleration", setPoint.acceleration, 0.0, steepest, "counts/s²"); !good)
        return good;
    if (setPoint.mode != Mode::RampPosition || !isNarrow() || (velocity(setPoint) && acceleration(setPoint)))
        return {};
    return fail(Fault::Unsafe,
        "its profile is not known, so a move that passes its target could not be told; read profile.velocity and "
        "profile.acceleration");
}

Result<void> MoveBounds::checkReach(const SetPoint &setPoint, std::optional<std::int64_t> position) const
{
    if (setPoint.mode != Mode::Position || !isNarrow())
        return {};
    if (!m_known.gainP || (!position && !setPoint.relative))
        return fail(Fault::Unsafe,
            "its P or its position is not known, so whether this step overflows its loop is not either; read gain.p");
    if (*m_known.gainP == 0)
        return {};
    const double distance
        = setPoint.relative ? setPoint.target : setPoint.target - static_cast<double>(position.value_or(0));
    const double farthest = std::floor(unreachable / static_cast<double>(*m_known.gainP)) - 1.0;
    if (std::abs(distance) <= farthest)
        return {};
    return fail(Fault::OutOfRange,
        "a step of " + numberText(distance) + " counts overflows the loop of this firmware; at most "
            + numberText(farthest) + " with its P: use a profiled mode or several moves");
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

std::string MoveBounds::caution(const SetPoint &setPoint) const
{
    if (!isProfiled(setPoint.mode) || !m_node.dialect)
        return {};
    std::string text;
    const auto changes = [&text](std::string_view key, double wanted, std::optional<std::int64_t> stands) {
        if (wanted <= 0.0 || stands == std::llround(wanted))
            return;
        text += (text.empty() ? "" : "; ") + std::string(key) + " becomes " + numberText(std::round(wanted))
            + (stands ? ", it was " + std::to_string(*stands) : std::string()) + ": the device stores it";
    };
    changes("profile.velocity", setPoint.velocity, m_known.profileVelocity);
    changes("profile.acceleration", setPoint.acceleration, m_known.profileAcceleration);
    if (isNarrow() && setPoint.mode == Mode::RampPosition && velocity(setPoint).value_or(0.0) > surestProfile)
        text += (text.empty() ? "" : "; ")
            + std::string(
                "this firmware may pass the target of a profiled move above 2500 counts/s; it is stopped then");
    return text;
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
