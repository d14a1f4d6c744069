// SPDX-License-Identifier: GPL-3.0-or-later
// Controller: set-points and the stop.
#include "families/quadquad2drv/controller.h"

#include "async/sleep.h"
#include "families/quadquad2drv/channels.h"

#include <algorithm>
#include <cmath>

namespace mb::quadquad2drv {
namespace {

using namespace std::chrono_literals;

constexpr int stopTries = 20;

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

bool isWithin(double value, double low, double high)
{
    return std::isfinite(value) && value >= low && value <= high;
}

} // namespace

Result<void> Controller::doCheck(const SetPoint &setPoint) const
{
    if (setPoint.axis < 1 || setPoint.axis > axes)
        return fail(Fault::OutOfRange, "the board has axes 1 to 4");
    if (setPoint.slot != 0)
        return fail(Fault::Unsupported, "the board has one set of gains per axis");
    const double target = setPoint.target;
    switch (setPoint.mode) {
    case Mode::Off: return {};
    case Mode::Duty:
        if (!isWithin(target, -1.0, 1.0))
            return fail(Fault::OutOfRange, "duty is a fraction from −1 to 1");
        return {};
    case Mode::Velocity:
    case Mode::RampVelocity:
        if (!isWithin(target, -1.0 * fastest, fastest))
            return fail(Fault::OutOfRange, "velocity is −100000 to 100000 counts/s");
        break;
    case Mode::Position:
    case Mode::RampPosition:
        if (!isWithin(target, lowestCounts, highestCounts))
            return fail(Fault::OutOfRange, "position has 32 bits");
        break;
    default: return fail(Fault::Unsupported, "the board has no such mode");
    }
    if (!isWithin(setPoint.velocity, 0.0, fastest) || !isWithin(setPoint.acceleration, 0.0, steepest))
        return fail(Fault::OutOfRange, "a profile has up to 100000 counts/s and 1000000 counts/s²");
    return {};
}

Result<void> Controller::doCommand(const SetPoint &setPoint)
{
    const int axis = setPoint.axis - 1;
    if (setPoint.mode == Mode::Off) {
        m_drives[static_cast<std::size_t>(axis)] = {};
        noteSetPoint(axis, std::nullopt);
        post(setControlMode(maskOf(axis), ControlMode::Off));
        updateLiveness();
        return {};
    }
    const ControlMode mode = modeFor(setPoint.mode);
    if (mode == ControlMode::Position && !m_tracked[static_cast<std::size_t>(axis)].position)
        return fail(Fault::Unsafe, "the position is not known yet, so nothing would keep the motor from jumping");
    if (m_drives[static_cast<std::size_t>(axis)].mode != mode)
        enter(axis, mode);
    aim(axis, setPoint);
    noteSetPoint(axis, setPoint.target);
    updateLiveness();
    return {};
}

/// Committed with the motion data that come all the time.
void Controller::noteSetPoint(int axis, std::optional<double> target)
{
    const ChannelIndex channel = channelOf(axis, AxisChannel::SetPoint);
    if (target)
        telemetry()->append({channel, clock().now(), *target});
    else if (telemetry()->latest(channel))
        telemetry()->breakLine(channel);
}

/// Trap 14: the target is where the motor is, before and after the mode is taken.
void Controller::enter(int axis, ControlMode mode)
{
    limitFirstMotion(axis);
    Bytes rest = setPower(maskOf(axis), 0);
    if (mode == ControlMode::Velocity)
        rest = setVelocityTarget(maskOf(axis), 0.0, readings());
    else if (mode == ControlMode::Position)
        rest = setPositionTarget(
            maskOf(axis), static_cast<std::int32_t>(*m_tracked[static_cast<std::size_t>(axis)].position));
    post(rest);
    post(setControlMode(maskOf(axis), mode));
    post(rest);
    m_drives[static_cast<std::size_t>(axis)] = {mode, readings().velocityTargetShifted, std::nullopt};
}

void Controller::limitFirstMotion(int axis)
{
    const ParameterIndex index = indexOf(axis, AxisParameter::LimitPower);
    if (parameters().entry(index).raw)
        return;
    post(setPowerLimit(maskOf(axis), static_cast<std::uint16_t>(firstPowerLimit)));
    parameters().setWritten(index, firstPowerLimit);
}

void Controller::aim(int axis, const SetPoint &setPoint)
{
    Drive &drive = m_drives[static_cast<std::size_t>(axis)];
    const auto whole = [&setPoint] { return static_cast<std::int32_t>(std::lround(setPoint.target)); };
    const bool profiled = setPoint.mode == Mode::RampPosition || setPoint.mode == Mode::RampVelocity;
    if (profiled && drive.profile == setPoint)
        return; // sending it again would begin it again
    drive.profile = profiled ? std::optional(setPoint) : std::nullopt;
    const std::uint8_t mask = maskOf(axis);
    switch (setPoint.mode) {
    case Mode::Duty: post(setPower(mask, static_cast<std::int16_t>(std::lround(setPoint.target * fullPower)))); break;
    case Mode::Velocity:
        post(setVelocityTarget(mask, setPoint.target, {.velocityTargetShifted = drive.shifted}));
        break;
    case Mode::Position: post(setPositionTarget(mask, whole())); break;
    case Mode::RampPosition: post(rampPosition(mask, whole(), setPoint.velocity, setPoint.acceleration)); break;
    case Mode::RampVelocity: post(rampVelocity(mask, whole(), setPoint.acceleration)); break;
    default: break;
    }
}

/// A newer target of the same kind for the same axis takes the place of one that has not left yet.
void Controller::post(Bytes request)
{
    if (m_orders.size() > 1 && m_orders.back().size() == request.size()
        && std::equal(m_orders.back().begin(), m_orders.back().begin() + 4, request.begin()))
        m_orders.back() = std::move(request);
    else
        m_orders.push_back(std::move(request));
    m_changed = true;
    if (m_working)
        return;
    m_working = true;
    m_scope.spawn<void>(work(), [this](const Result<void> &) {
        m_working = false;
        if (!m_orders.empty())
            m_orders.clear(); // what failed ends the motion, see work()
    });
}

Task<void> Controller::work()
{
    if (m_port.masks()[0] != datamask::everything) {
        auto telling = tellEverything();
        co_await std::move(telling);
    }
    while (!m_orders.empty()) {
        Bytes next = std::move(m_orders.front());
        m_orders.pop_front();
        auto asking = m_port.request(std::move(next));
        const Result<Packet> reply = co_await std::move(asking).attempt();
        if (!reply) {
            stop();
            co_return fail(reply.error());
        }
    }
    co_return {};
}

void Controller::doStop()
{
    m_orders.clear();
    for (int axis = 0; axis < axes; ++axis) {
        if (m_drives[static_cast<std::size_t>(axis)].mode != ControlMode::Off)
            noteSetPoint(axis, std::nullopt);
    }
    m_drives = {};
    m_stopConfirmed = false;
    (void)m_port.urgent(setControlMode(allAxes, ControlMode::Off));
    m_scope.spawn<void>(confirmStop());
    updateLiveness();
}

Task<void> Controller::confirmStop()
{
    for (int i = 0; i < stopTries && !m_stopConfirmed; ++i) {
        auto asking = m_port.request(setControlMode(allAxes, ControlMode::Off), 1);
        const Result<Packet> reply = co_await std::move(asking).attempt();
        if (reply)
            break;
        if (reply.error().fault == Fault::LinkLost)
            co_return fail(reply.error());
        co_await Sleep(clock(), 10ms);
    }
    co_return {};
}

/// Trap 13: the board has no watchdog. A transfer may come in the middle of another one, so it is sent three times.
StopScript Controller::doStopScript() const
{
    StopStep off;
    off.bytes = setControlMode(allAxes, ControlMode::Off);
    off.wait = 10ms;
    off.attempts = 3;
    return {{off}};
}

bool Controller::doIsSeenStopped() const
{
    return m_stopConfirmed && m_heard && m_motionAt && *m_motionAt > stoppedAt();
}

} // namespace mb::quadquad2drv
