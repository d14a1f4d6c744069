// SPDX-License-Identifier: GPL-3.0-or-later
// Controller: what is asked for, and what the bus tells.
#include "families/abstractdc/channels.h"
#include "families/abstractdc/codec.h"
#include "families/abstractdc/controller.h"
#include "families/abstractdc/parameters.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace mb::abstractdc {
namespace {

using namespace std::chrono_literals;

constexpr Duration foreignMemory = 2s;
constexpr double positionRate = 20.0; ///< samples per second nobody asked for
constexpr double loopRate = 20.0;
constexpr double slowRate = 5.0;
constexpr double temperatureRate = 1.0;
constexpr std::int64_t turnedByHand = 100; ///< counts, between switching on and the first question
constexpr double drivenRate = 50.0;        ///< the loop of the drive is no faster

} // namespace

// Polling

/// Logs that stand still in this mode are not asked for (README.md#stale-logs).
bool Controller::isFresh(Log log) const
{
    if (log == Log::Velocity)
        return m_loop == Loop::Velocity;
    if (log == Log::Voltage)
        return isDriven();
    return true;
}

double Controller::rateOf(Log log) const
{
    if (!isFresh(log))
        return 0.0;
    const auto wished = m_wishes.find(log);
    const double wish = wished == m_wishes.end() ? 0.0 : wished->second;
    switch (log) {
    case Log::Position: return std::max(wish, isDriven() || m_look.isActive() ? drivenRate : positionRate);
    case Log::Velocity: return std::max(wish, drivenRate);
    case Log::Voltage: return std::max(wish, loopRate);
    case Log::Current: return wish > 0.0 ? wish : slowRate;
    case Log::Temperature: return wish > 0.0 ? wish : temperatureRate;
    }
    return 0.0;
}

void Controller::planPolling()
{
    for (std::size_t i = 0; i < logCount; ++i)
        m_poller.wish(static_cast<Log>(i), rateOf(static_cast<Log>(i)));
}

void Controller::enter(std::optional<Loop> loop)
{
    if (loop == Loop::None) // look closely until it is seen to stand
        m_look.startIn(2s, [this] { planPolling(); });
    else
        m_look.stop();
    if (loop == m_loop) {
        planPolling();
        return;
    }
    m_loop = loop;
    m_velocity.reset();
    m_saturated = false;
    for (const ChannelIndex stale : {channel::velocity, channel::duty})
        telemetry()->breakLine(stale);
    planPolling();
    updateLiveness();
}

// What the bus tells

/// Set-points and settings of other masters; `ours`: of a recording, those of its recorder.
void Controller::onFrame(const CanFrame &frame, bool ours)
{
    if (!m_dialect || frame.extended)
        return;
    if (const auto loop = decodeSetPoint(*m_dialect, identity().address, frame)) {
        const bool driven = *loop != Loop::None;
        m_ours = ours && driven;
        m_foreignAt = driven && !ours ? std::optional<Instant>(frame.time) : std::nullopt;
        m_wrapped = m_wrapped && (driven || !ours);
        enter(*loop);
        updateLiveness();
    } else if (const auto settings = decodeSettings(*m_dialect, identity().address, frame)) {
        if (const auto index = parameterOf(settings->loop, settings->field))
            assume(*index, settings->value);
    }
}

void Controller::onLog(Log log, std::int32_t value, Instant time)
{
    switch (log) {
    case Log::Position: onPosition(value, time); break;
    case Log::Velocity:
        if (!isFresh(log))
            break;
        m_velocity = value;
        telemetry()->append({channel::velocity, time, static_cast<double>(value)});
        break;
    case Log::Current:
        telemetry()->append({channel::current, time, value * profile().calibrated(calibration::amperes, 1.0)});
        break;
    case Log::Temperature:
        telemetry()->append({channel::temperature, time, value * profile().calibrated(calibration::degrees, 1.0)});
        break;
    case Log::Voltage: onVoltage(value, time); break;
    }
    updateLiveness();
}

/// Without power it has lost its position. One that is heard again where it was, had only lost its cable.
void Controller::judgeSilence(std::int32_t position)
{
    const bool startsAnew = std::abs(std::int64_t{position}) <= turnedByHand;
    const bool unmoved = m_positionBefore && *m_positionBefore == position && position != 0;
    if (std::exchange(m_wasSilent, false) && needsPowerCycle() && startsAnew && !unmoved)
        setCounter(std::string(counter::powerCycle), 0);
    m_positionBefore.reset();
}

void Controller::onPosition(std::int32_t value, Instant time)
{
    if (m_wasSilent)
        judgeSilence(value);
    const MotionSense::Verdict verdict = m_sense.add(value, time);
    if (verdict.glitch) {
        telemetry()->lost(channel::position, 1);
        return;
    }
    if (verdict.mended)
        telemetry()->breakLine(channel::position);
    telemetry()->append({channel::position, time, static_cast<double>(value)});
    if (isFresh(Log::Velocity))
        return; // the drive measures it itself
    if (const auto velocity = m_sense.velocity(time))
        telemetry()->append({channel::velocity, time, *velocity});
}

void Controller::onVoltage(std::int32_t value, Instant time)
{
    if (!isFresh(Log::Voltage))
        return;
    const bool saturated = std::abs(std::int64_t{value}) > fullPwm;
    m_saturations += saturated && !m_saturated ? 1 : 0;
    m_saturated = saturated;
    if (std::abs(std::int64_t{value}) >= outputWraps && !m_wrapped) {
        m_wrapped = true; // the next command is refused, which ends the stream
        ++m_wraps;
        if (m_ours) {
            doStop();
            m_wrapped = true;
        }
        updateLiveness();
        return;
    }
    const double duty = std::clamp(value / double{fullPwm}, -1.0, 1.0);
    telemetry()->append({channel::duty, time, duty});
}

void Controller::onSilence()
{
    m_wasSilent = m_wasSilent || m_can.state() == LinkState::Open;
    if (const auto position = m_sense.position())
        m_positionBefore = *position;
    m_sense.forget();
    m_velocity.reset();
    enter(std::nullopt);
    for (std::uint16_t i = 0; i < telemetry()->channels().size(); ++i)
        telemetry()->breakLine({i});
    updateLiveness();
}

void Controller::updateLiveness()
{
    if (m_foreignAt && clock().now() - *m_foreignAt > foreignMemory && !m_sense.isMoving(clock().now()))
        m_foreignAt.reset();
    Liveness now;
    now.heard = m_poller.isHeard();
    now.moving = m_sense.isMoving(clock().now()) || (isDriven() && m_ours);
    if (m_loop)
        now.mode = modeOf(*m_loop);
    now.foreignMaster = m_foreignAt.has_value();
    if (m_saturated)
        now.faults.emplace_back("output_saturated");
    if (m_wrapped)
        now.faults.emplace_back("output_wrapped");
    setLiveness(now);
}

} // namespace mb::abstractdc
