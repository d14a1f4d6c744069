// SPDX-License-Identifier: GPL-3.0-or-later
// Controller: set-points and the stop.
#include "families/quadquad2drv/controller.h"

#include "async/sleep.h"
#include "families/quadquad2drv/channels.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mb::quadquad2drv {
namespace {

using namespace std::chrono_literals;

constexpr int stopTries = 20;
constexpr int triesBeforeReset = 2; ///< each of 100 ms, and as long again for a question that waits in between
constexpr int orderTries = 3;

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
    if (m_orderFailure)
        return fail(*std::exchange(m_orderFailure, std::nullopt));
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

/// README.md#position-mode: the target is where the motor is, before and after the mode is taken.
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
    if (!m_working)
        workOff();
}

void Controller::workOff()
{
    m_working = true;
    m_scope.spawn<void>(work(), [this](const Result<void> &) {
        m_working = false;
        if (!m_orders.empty()) // of a motion that began since a stop
            workOff();
    });
}

/// An order that the board does not take ends the motion. A stop ends what is under way: nothing that was ordered before it is
/// sent after it, not even again.
Task<void> Controller::work()
{
    while (!m_orders.empty()) {
        const std::uint64_t stops = m_stops;
        Bytes next = std::move(m_orders.front());
        m_orders.pop_front();
        auto obeying = obey(std::move(next));
        const Result<void> obeyed = co_await std::move(obeying).attempt();
        if (obeyed || stops != m_stops)
            continue;
        stop();
        m_orderFailure = obeyed.error();
        co_return fail(obeyed.error());
    }
    co_return {};
}

Task<void> Controller::obey(Bytes order)
{
    PacketPort::Gate gate = [this, stops = m_stops] { return stops == m_stops; };
    if (m_port.masks()[0] != datamask::everything) {
        auto telling = tellEverything();
        co_await std::move(telling);
    }
    auto asking = m_port.request(std::move(order), orderTries, std::move(gate));
    co_await std::move(asking);
    co_return {};
}

void Controller::doStop()
{
    m_orders.clear();
    ++m_stops;
    m_orderFailure.reset();
    for (int axis = 0; axis < axes; ++axis) {
        if (m_drives[static_cast<std::size_t>(axis)].mode != ControlMode::Off)
            noteSetPoint(axis, std::nullopt);
    }
    m_drives = {};
    if (m_stopConfirmed)
        m_lastResort = {};
    m_stopConfirmed = false;
    (void)m_port.urgent(setControlMode(allAxes, ControlMode::Off));
    m_scope.spawn<void>(confirmStop());
    updateLiveness();
}

/// Answered twice in a row: the first may be the late answer to an order from before the stop. A stop that is repeated does
/// not put off the last resort.
Task<void> Controller::confirmStop()
{
    const std::uint64_t stops = m_stops;
    for (int i = 0, answered = 0; i < stopTries && stops == m_stops; ++i) {
        if (m_lastResort.unanswered >= triesBeforeReset && !m_lastResort.tried)
            resetAsLastResort();
        auto asking = m_port.request(setControlMode(allAxes, ControlMode::Off), 1);
        const Result<Packet> reply = co_await std::move(asking).attempt();
        answered = reply ? answered + 1 : 0;
        m_lastResort.unanswered = reply ? 0 : m_lastResort.unanswered + 1;
        if (answered == 2) {
            m_stopConfirmed = stops == m_stops;
            break;
        }
        if (!reply && reply.error().fault == Fault::LinkLost)
            co_return fail(reply.error());
        if (!reply)
            co_await Sleep(clock(), 10ms);
    }
    co_return {};
}

/// A reset takes the modes of all axes, and the settings too. Not while its firmware is written: the bootloader would begin anew.
void Controller::resetAsLastResort()
{
    m_lastResort.tried = true;
    if (busy().empty() && m_spi.pulseReset())
        forgetBoard();
}

/// README.md#stopping: the board has no watchdog. A transfer may come in the middle of another one, so it is sent three times.
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
