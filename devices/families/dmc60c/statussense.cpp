// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/statussense.h"

#include "families/dmc60c/channels.h"
#include "families/dmc60c/setpoints.h"
#include "families/dmc60c/states.h"

#include <algorithm>
#include <cstdlib>

namespace mb::dmc60c {
namespace {

using namespace std::chrono_literals;

constexpr int idleFramesNeeded = 2; ///< one may be a zero crossing of a closed loop
constexpr Duration turningMemory = 500ms;
constexpr int flicker = 1; ///< counts in 100 ms, of a shaft that stands on an edge of its encoder

} // namespace

StatusSense::StatusSense(const std::shared_ptr<Telemetry> &telemetry)
    : m_general(telemetry, {channel::duty, channel::error}, defaultGeneralPeriod)
    , m_encoder(telemetry, {channel::position, channel::velocity}, defaultEncoderPeriod)
    , m_analog(telemetry, {channel::analog1, channel::current, channel::temperature, channel::busVoltage},
          defaultAnalogPeriod)
{
}

void StatusSense::take(const StatusGeneral &status, Instant time, Instant stoppedAt)
{
    m_general.add(time,
        {std::clamp(status.duty / static_cast<double>(fullDuty), -1.0, 1.0),
            status.mode == ControlMode::Voltage        ? errorOf(status) / fullDuty
                : status.mode == ControlMode::Velocity ? errorOf(status) * velocityPerSecond
                                                       : errorOf(status)});
    m_idleFrames = status.duty == 0 && time > stoppedAt ? m_idleFrames + 1 : 0;
    m_lastGeneral = status;
    takeStates(m_told, status);
    m_toldAt = time;
}

void StatusSense::take(const StatusEncoder &status, Instant time, bool heard)
{
    m_encoder.add(
        time, {static_cast<double>(status.position), static_cast<double>(status.velocity) * velocityPerSecond});
    if (heard) {
        takeStates(m_told, status);
        m_toldAt = time;
    }
    m_turning = std::abs(status.velocity) > flicker;
    m_turningAt = time;
}

void StatusSense::take(const StatusAnalog &status, Instant time)
{
    m_analog.add(time, {status.analogIn, status.current, status.temperature, status.busVoltage});
}

void StatusSense::interrupt()
{
    m_turning = false;
    m_told = {};
    for (StatusStream *stream : {&m_general, &m_encoder, &m_analog})
        stream->interrupt();
}

void StatusSense::restart()
{
    for (StatusStream *stream : {&m_general, &m_encoder, &m_analog})
        stream->restart();
}

StatusStream *StatusSense::streamOf(std::uint8_t periodParameter)
{
    switch (periodParameter) {
    case param::generalPeriod: return &m_general;
    case param::encoderPeriod: return &m_encoder;
    case param::analogPeriod: return &m_analog;
    default: return nullptr;
    }
}

bool StatusSense::isTurning(Instant now) const
{
    return m_turning && now - m_turningAt < std::max<Duration>(turningMemory, 3 * m_encoder.period());
}

bool StatusSense::isIdle() const
{
    return m_lastGeneral.duty == 0 && (m_lastGeneral.mode == ControlMode::NoDrive || m_idleFrames >= idleFramesNeeded);
}

} // namespace mb::dmc60c
