// SPDX-License-Identifier: GPL-3.0-or-later
// What a drive hears and says, and its loop.
#include "families/abstractdc/simulatorunit.h"
#include "wire/bytes.h"

#include <algorithm>
#include <cmath>

namespace mb::abstractdc::simulation {
namespace {

using namespace std::chrono_literals;

constexpr Duration answerTime = 15us; ///< replies are sent from the receive interrupt
constexpr std::size_t mailboxes = 3;  ///< 1.3: further replies are dropped
constexpr int temperatureCycles = 2;
constexpr double glitchWindow = 20e-6; ///< how long after a wrap a reading may be wrong

template <std::size_t N> int placeOf(const std::array<int, N> &codes, int code)
{
    const auto found = std::find(codes.begin(), codes.end(), code);
    return found == codes.end() ? absent : static_cast<int>(found - codes.begin());
}

std::int32_t valueAt(const CanFrame &frame, std::size_t place)
{
    return signExtend(readU32le(frame.data, place), 32);
}

int toAdc(double counts)
{
    return std::clamp(static_cast<int>(std::lround(counts)), 0, adcMost);
}

} // namespace

void Unit::hear(const CanFrame &frame)
{
    if (!m_powered || frame.extended || frame.remote || frame.error)
        return;
    ++m_heard;
    for (const SimulatedFault &fault : m_options.faults) {
        if (fault.kind == "power" && static_cast<double>(m_heard) == fault.at) {
            losePower();
            return;
        }
    }
    advance();
    dispatch(frame);
}

/// In this order: settings, set-point, log (README.md#voltage-log).
void Unit::dispatch(const CanFrame &frame)
{
    const auto own = [&](std::uint32_t base) {
        return frame.id == base || frame.id == base + static_cast<std::uint32_t>(m_options.offset);
    };
    if (own(id::settings))
        onSettings(frame);
    else if (own(id::setPoint))
        onSetPoint(frame);
    else if (m_dialect.request == id::logRequest
            ? own(id::logRequest)
            : frame.id == id::logRequestOld + static_cast<std::uint32_t>(m_options.offset))
        onLogRequest(frame);
}

void Unit::onSettings(const CanFrame &frame)
{
    const bool save = frame.size == 1;
    if (!save && frame.size != (m_dialect.wide ? 8 : 6))
        return;
    const int type = m_dialect.wide && !save ? frame.data[0] & 0xF : frame.data[0];
    const int loop = placeOf(m_dialect.type, type);
    if (loop < static_cast<int>(Loop::Velocity) || loop > static_cast<int>(Loop::Position))
        return;
    Record &gains = gainsOf(static_cast<Loop>(loop));
    if (save) {
        m_flash.save(loop - 1, gains);
        m_notify(m_clock.now(), "settings-saved", loop);
        return;
    }
    const std::int32_t value = valueAt(frame, m_dialect.wide ? 4 : 2);
    switch (placeOf(m_dialect.field, m_dialect.wide ? frame.data[0] >> 4 : frame.data[1])) {
    case 0: gains.p = value; break;
    case 1: gains.i = value; break;
    case 2: gains.d = value; break;
    case 3: gains.divisor = value; break;
    case 4:
        if (loop == static_cast<int>(Loop::Current))
            gains.averaging = value & 0xFFFF;
        break;
    default: break;
    }
}

void Unit::onSetPoint(const CanFrame &frame)
{
    if (frame.size != (m_dialect.wide ? 8 : 5))
        return;
    const int loop = placeOf(m_dialect.type, frame.data[0]);
    if (loop != absent)
        enter(static_cast<Loop>(loop), valueAt(frame, m_dialect.wide ? 4 : 1));
}

void Unit::enter(Loop mode, std::int32_t value)
{
    const bool changed = mode != m_mode;
    m_mode = mode;
    m_target = value;
    if (mode == Loop::None) {
        drive(0);
    } else if (mode == Loop::Direct) {
        m_output = value;
        drive(pwmOf(value));
    } else if (changed) {
        m_pids.at(static_cast<std::size_t>(mode) - 1).restart(gainsOf(mode), milliseconds());
    }
}

void Unit::onLogRequest(const CanFrame &frame)
{
    if (frame.size != 1)
        return;
    const int log = placeOf(m_dialect.log, frame.data[0]);
    if (log == absent)
        return;
    switch (static_cast<Log>(log)) {
    case Log::Position: reply(Log::Position, positionLog()); break;
    case Log::Velocity: reply(Log::Velocity, m_velocity); break;
    case Log::Current: reply(Log::Current, m_current.mean(gainsOf(Loop::Current).averaging)); break;
    case Log::Temperature: reply(Log::Temperature, m_temperature); break;
    case Log::Voltage: reply(Log::Voltage, static_cast<std::int32_t>(m_output)); break;
    }
}

/// README.md#position: the reading is not atomic with the interrupt of a wrap.
std::int32_t Unit::positionLog()
{
    ++m_positionLogs;
    const std::int64_t counts = m_motor.counts() - m_origin;
    const auto low = static_cast<double>(counts & 0xFFFF);
    const double passed = m_motor.countSpeed() * glitchWindow;
    const bool justWrapped
        = (passed > 0.0 && low < passed && counts > 65535) || (passed < 0.0 && 65536.0 - low < -passed);
    const bool wanted = m_glitchNext || (m_options.glitches > 0 && m_positionLogs % m_options.glitches == 0);
    m_glitchNext = false;
    if (!justWrapped && !wanted)
        return encoder();
    return encoder() + (m_motor.countSpeed() >= 0.0 ? -wrapLoss : wrapLoss);
}

void Unit::reply(Log log, std::int32_t value)
{
    if (m_pending >= mailboxes)
        return;
    std::array<std::uint8_t, 4> data{};
    writeU32le(data, 0, static_cast<std::uint32_t>(value));
    const int base = m_dialect.reply.at(static_cast<std::size_t>(log));
    const bool shifted = log != Log::Voltage || m_dialect.voltageOffset;
    const CanFrame frame = standardFrame(static_cast<std::uint32_t>(base + (shifted ? m_options.offset : 0)), data);
    ++m_pending;
    m_replies.emplace_back(m_clock);
    m_replies.back().startIn(answerTime, [this, frame, self = &m_replies.back()] {
        --m_pending;
        transmit(frame);
        m_replies.remove_if([self](const Timer &timer) { return &timer == self; });
    });
}

const SimulatedFault *Unit::strikes(std::string_view kind) const
{
    for (const SimulatedFault &fault : m_options.faults) {
        const auto number = static_cast<double>(m_sent);
        if (fault.kind == kind && (number == fault.at || (kind == "silent" && number > fault.at)))
            return &fault;
    }
    return nullptr;
}

void Unit::transmit(CanFrame frame)
{
    ++m_sent;
    if (strikes("silent") != nullptr || strikes("drop") != nullptr)
        return;
    if (strikes("corrupt") != nullptr)
        frame.data[m_sent % frame.size] ^= 0x55U;
    if (const SimulatedFault *late = strikes("delay")) {
        at(late->argument / 1000.0, [this, frame] { (void)m_link.send(frame); });
        return;
    }
    (void)m_link.send(frame); // a lost link is noticed by its state
}

void Unit::cycle()
{
    m_cycle.startIn(loopPeriod, [this] { cycle(); });
    advance();
    const std::int64_t now = milliseconds();
    m_current.add(toAdc(std::abs(m_motor.current()) * countsPerAmpere), gainsOf(Loop::Current).averaging);
    if (m_current.hasOverrun() && !m_overrunTold) {
        m_overrunTold = true;
        m_notify(m_clock.now(), "memory-overrun", 0.0);
    }
    if ((m_clock.now() - m_startedAt) / loopPeriod % temperatureCycles == 0)
        m_temperature = toAdc(m_motor.housingTemperature() * countsPerDegree);
    if (m_mode != Loop::None && m_mode != Loop::Direct)
        regulate(now);
}

void Unit::regulate(std::int64_t now)
{
    std::int64_t feedback = 0;
    if (m_mode == Loop::Velocity) { // README.md#stale-logs: since it was used last, however long ago
        const std::int32_t position = encoder();
        const std::int64_t elapsed = std::max<std::int64_t>(now - m_velocityTime, 1);
        m_velocity = static_cast<std::int32_t>((std::int64_t{position} - m_velocityFrom) * 1000 / elapsed);
        m_velocityFrom = position;
        m_velocityTime = now;
        feedback = m_velocity;
    } else if (m_mode == Loop::Current) {
        feedback = m_current.mean(gainsOf(Loop::Current).averaging);
    } else {
        feedback = encoder();
    }
    m_output = m_pids.at(static_cast<std::size_t>(m_mode) - 1).step(gainsOf(m_mode), m_target - feedback, now);
    drive(pwmOf(m_output));
}

} // namespace mb::abstractdc::simulation
