// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/axisdrives.h"

#include "families/quadquad2drv/channels.h"

#include <cmath>

namespace mb::quadquad2drv {
namespace {

constexpr double lowestCounts = -2147483648.0;
constexpr double highestCounts = 2147483647.0;

ControlMode modeFor(Mode mode)
{
    switch (mode) {
    case Mode::Duty: return ControlMode::Power;
    case Mode::Velocity:
    case Mode::RampVelocity: return ControlMode::Velocity;
    case Mode::Position:
    case Mode::RampPosition: return ControlMode::Position;
    default: return ControlMode::Off;
    }
}

bool isProfiled(const SetPoint &setPoint)
{
    return setPoint.mode == Mode::RampPosition || setPoint.mode == Mode::RampVelocity;
}

bool isWithin(double value, double low, double high)
{
    return std::isfinite(value) && value >= low && value <= high;
}

} // namespace

Result<void> checkSetPoint(const SetPoint &setPoint)
{
    if (setPoint.axis < 1 || setPoint.axis > axes)
        return fail(Fault::OutOfRange, say("the board has axes 1 to 4"));
    if (setPoint.slot != 0)
        return fail(Fault::Unsupported, say("the board has one set of gains per axis"));
    const double target = setPoint.target;
    switch (setPoint.mode) {
    case Mode::Off: return {};
    case Mode::Duty:
        if (!isWithin(target, -1.0, 1.0))
            return fail(Fault::OutOfRange, say("duty is a fraction from −1 to 1"));
        return {};
    case Mode::Velocity:
    case Mode::RampVelocity:
        if (!isWithin(target, -1.0 * fastest, fastest))
            return fail(Fault::OutOfRange, say("velocity is −100000 to 100000 counts/s"));
        break;
    case Mode::Position:
    case Mode::RampPosition:
        if (!isWithin(target, lowestCounts, highestCounts))
            return fail(Fault::OutOfRange, say("position has 32 bits"));
        break;
    default: return fail(Fault::Unsupported, say("the board has no such mode"));
    }
    if (!isWithin(setPoint.velocity, 0.0, fastest) || !isWithin(setPoint.acceleration, 0.0, steepest))
        return fail(Fault::OutOfRange, say("a profile has up to 100000 counts/s and 1000000 counts/s²"));
    if (setPoint.mode == Mode::RampPosition && setPoint.velocity < 1.0 / limitOne) // 0 means nothing there
        return fail(Fault::OutOfRange,
            say("%1 %2 is outside %3 … %4 %5", "--velocity", setPoint.velocity, 1.0 / limitOne, 1.0 * fastest,
                "counts/s"));
    return {};
}

Message cautionOf(const SetPoint &setPoint, const ParameterStore &known)
{
    const auto limit = [&](AxisParameter which) { return known.entry(indexOf(setPoint.axis - 1, which)).raw; };
    const double size = std::abs(setPoint.target);
    const auto power = static_cast<double>(limit(AxisParameter::LimitPower).value_or(SettingRequests::firstPowerLimit));
    if (setPoint.mode == Mode::Duty && std::round(size * fullPower) > power)
        return say("the power limit of axis %1 is %2: its motor gets no more", setPoint.axis,
            MessageNumber{100.0 * power / fullPower, 0, "%"});
    const bool isVelocity = setPoint.mode == Mode::Velocity || setPoint.mode == Mode::RampVelocity;
    const double wished = isVelocity ? size : setPoint.mode == Mode::RampPosition ? setPoint.velocity : 0.0;
    const auto velocity = limit(AxisParameter::LimitVelocity); // what a board starts with is not documented
    if (velocity && wished * limitOne > static_cast<double>(*velocity))
        return say("the velocity limit of axis %1 is %2: its motor goes no faster", setPoint.axis,
            MessageNumber{static_cast<double>(*velocity) / limitOne, -1, "counts/s"});
    return {};
}

Result<void> AxisDrives::command(const SetPoint &setPoint)
{
    const int axis = setPoint.axis - 1;
    if (setPoint.mode == Mode::Off) {
        Drive &drive = m_drives[static_cast<std::size_t>(axis)];
        drive.isLeaving = true; // and driven until the board has taken it
        record(axis, std::nullopt);
        m_orders.enter(axis, {{setControlMode(maskOf(axis), ControlMode::Off), [&drive] {
                                   if (drive.isLeaving) // and has not been told something else since
                                       drive = {};
                               }}});
        return {};
    }
    if (const auto failure = m_orders.takeFailure())
        return fail(*failure);
    const ControlMode mode = modeFor(setPoint.mode);
    if (controlMode(axis) != mode || m_drives[static_cast<std::size_t>(axis)].isLeaving) {
        if (mode == ControlMode::Position && !m_sense.place(axis)) {
            m_orders.learn();
            return fail(Fault::Unsafe,
                say("the position is not known yet, so nothing would keep the motor from jumping"),
                say("the board is told to tell its whole counters; look at the position, and run it again"));
        }
        enter(axis, mode, isProfiled(setPoint));
    }
    sendTarget(axis, setPoint);
    record(axis, setPoint.target);
    return {};
}

/// Committed with the motion data that come all the time.
void AxisDrives::record(int axis, std::optional<double> target)
{
    const ChannelIndex channel = channelOf(axis, AxisChannel::SetPoint);
    if (target)
        m_telemetry.append({channel, m_clock.now(), *target});
    else if (m_telemetry.latest(channel))
        m_telemetry.breakLine(channel);
}

/// README.md#position-mode: the target is where the motor is, before and after the mode is taken.
void AxisDrives::enter(int axis, ControlMode mode, bool profiled)
{
    std::vector<OrderQueue::Order> orders;
    if (auto limit = m_settings.firstLimit(axis))
        orders.push_back(
            {std::move(*limit), [this, axis] { m_settings.accepted(indexOf(axis, AxisParameter::LimitPower)); }});
    OrderQueue::Order rest{setPower(maskOf(axis), 0)};
    if (mode == ControlMode::Velocity)
        rest.request = setVelocityTarget(maskOf(axis), 0.0, m_settings.readings());
    else if (mode == ControlMode::Position) // it may go on turning for as long as a stop before this is being proven
        rest.late = [this, axis, before = *m_sense.place(axis)] {
            return setPositionTarget(maskOf(axis), m_sense.place(axis).value_or(before));
        };
    orders.push_back(rest);
    orders.push_back({setControlMode(maskOf(axis), mode)});
    if (profiled) // any other target follows at once
        orders.push_back(rest);
    m_orders.enter(axis, std::move(orders));
    m_drives[static_cast<std::size_t>(axis)] = {mode, m_settings.readings().velocityTargetShifted};
}

void AxisDrives::sendTarget(int axis, const SetPoint &setPoint)
{
    Drive &drive = m_drives[static_cast<std::size_t>(axis)];
    const auto whole = [&setPoint] { return static_cast<std::int32_t>(std::lround(setPoint.target)); };
    const bool profiled = isProfiled(setPoint);
    if (profiled && drive.profile == setPoint)
        return; // sending it again would begin it again
    drive.profile = profiled ? std::optional(setPoint) : std::nullopt;
    const std::uint8_t mask = maskOf(axis);
    switch (setPoint.mode) {
    case Mode::Duty:
        m_orders.setTarget(axis, setPower(mask, static_cast<std::int16_t>(std::lround(setPoint.target * fullPower))));
        break;
    case Mode::Velocity:
        m_orders.setTarget(axis, setVelocityTarget(mask, setPoint.target, {.velocityTargetShifted = drive.shifted}));
        break;
    case Mode::Position: m_orders.setTarget(axis, setPositionTarget(mask, whole())); break;
    case Mode::RampPosition:
        m_orders.setTarget(axis, rampPosition(mask, whole(), setPoint.velocity, setPoint.acceleration));
        break;
    case Mode::RampVelocity: m_orders.setTarget(axis, rampVelocity(mask, whole(), setPoint.acceleration)); break;
    default: break;
    }
}

void AxisDrives::stop()
{
    for (int axis = 0; axis < axes; ++axis) {
        if (isDriven(axis))
            record(axis, std::nullopt);
    }
    m_drives = {};
}

Mode AxisDrives::mode(int axis) const
{
    const Drive &drive = m_drives[static_cast<std::size_t>(axis)];
    switch (drive.mode) {
    case ControlMode::Off: break;
    case ControlMode::Power: return Mode::Duty;
    case ControlMode::Position: return drive.profile ? Mode::RampPosition : Mode::Position;
    case ControlMode::Velocity: return drive.profile ? Mode::RampVelocity : Mode::Velocity;
    }
    return Mode::Off;
}

} // namespace mb::quadquad2drv
