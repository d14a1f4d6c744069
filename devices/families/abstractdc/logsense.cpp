// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/logsense.h"

#include "families/abstractdc/answertime.h"
#include "families/abstractdc/channels.h"
#include "families/abstractdc/setpoints.h"

#include <algorithm>
#include <cmath>

namespace mb::abstractdc {
namespace {

using namespace std::chrono_literals;

constexpr double positionRate = 20.0; ///< samples per second nobody asked for
constexpr double loopRate = 20.0;
constexpr double slowRate = 5.0;
constexpr double temperatureRate = 1.0;
constexpr double drivenRate = 50.0;                             ///< the loop of the drive is no faster
constexpr Duration twoPasses = 2 * loopPeriod + loopPeriod / 4; ///< each takes its time, too

std::optional<Log> logOf(ChannelIndex channel)
{
    if (channel == channel::position)
        return Log::Position;
    if (channel == channel::velocity)
        return Log::Velocity;
    if (channel == channel::current)
        return Log::Current;
    if (channel == channel::duty)
        return Log::Voltage;
    if (channel == channel::temperature)
        return Log::Temperature;
    return std::nullopt;
}

} // namespace

LogSense::LogSense(
    CanLink &link, Clock &clock, std::shared_ptr<Telemetry> telemetry, const DeviceProfile &profile, Owner owner)
    : m_link(link)
    , m_clock(clock)
    , m_telemetry(std::move(telemetry))
    , m_profile(profile)
    , m_owner(std::move(owner))
    , m_poller(link, clock,
          {[this](Log log, std::int32_t value, Instant time) { take(log, value, time); }, [this] { m_owner.silent(); },
              [this](Log log) {
                  if (log == Log::Position)
                      m_telemetry->lost(channel::position, 1);
              }})
    , m_whereabouts(profile, m_owner.stands)
    , m_look(clock)
{
}

void LogSense::speak(const Dialect *dialect, int offset)
{
    m_dialect = dialect;
    m_poller.speak(dialect, offset);
}

bool LogSense::enter(std::optional<Loop> loop, Instant time)
{
    if (loop == Loop::None) // look closely until it is seen to stand
        m_look.startIn(2s, [this] { plan(); });
    else
        m_look.stop();
    const bool isOther = loop != m_loop;
    m_loop = loop;
    if (isOther) {
        m_enteredAt = time;
        m_velocity.reset();
        m_output.enterLoop();
        for (const ChannelIndex stale : {channel::velocity, channel::duty})
            m_telemetry->breakLine(stale);
    }
    plan();
    return isOther;
}

Result<void> LogSense::isAddressedAlone() const
{
    if (!m_poller.reachesOthers())
        return {};
    return fail(Fault::Unsafe,
        say("what is sent to offset 0 is done by every drive of the bus, and others answer on this one"),
        say("compile an offset of its own, 1 … 99, into its firmware, or leave it alone on the bus"));
}

// How often

Result<void> LogSense::wish(ChannelIndex channel, double hertz)
{
    const auto log = logOf(channel);
    if (!log)
        return fail(Fault::Unsupported, say("the set-point comes from here, not from the device"));
    if (!std::isfinite(hertz) || hertz < 0.0)
        return fail(Fault::OutOfRange, say("a rate is a positive number, or 0 for the usual one"));
    if (hertz > 0.0)
        m_wishes[*log] = hertz;
    else
        m_wishes.erase(*log);
    plan();
    return {};
}

bool LogSense::isFresh(Log log) const
{
    if (log == Log::Velocity)
        return m_loop == Loop::Velocity;
    if (log == Log::Voltage)
        return isDriven();
    return true;
}

/// A set-point may wait for what is on the wire. A duty has no pass to wait for.
bool LogSense::hasPassed(Instant time) const
{
    const Duration passes = m_loop == Loop::Direct ? Duration::zero() : twoPasses;
    return time - m_enteredAt >= passes + roundTrip(m_link);
}

double LogSense::rateOf(Log log) const
{
    if (!isFresh(log))
        return 0.0;
    const auto wished = [this](Log which) {
        const auto found = m_wishes.find(which);
        return found == m_wishes.end() ? 0.0 : found->second;
    };
    const double wish = wished(log);
    switch (log) {
    case Log::Position: // outside its mode velocity is computed from positions
        return std::max({wish, wished(Log::Velocity), isDriven() || m_look.isActive() ? drivenRate : positionRate});
    case Log::Velocity: return std::max(wish, drivenRate);
    case Log::Voltage: return std::max(wish, loopRate);
    case Log::Current: return wish > 0.0 ? wish : slowRate;
    case Log::Temperature: return wish > 0.0 ? wish : temperatureRate;
    }
    return 0.0;
}

void LogSense::plan()
{
    for (std::size_t i = 0; i < logCount; ++i)
        m_poller.wish(static_cast<Log>(i), rateOf(static_cast<Log>(i)));
}

// What they say

void LogSense::take(Log log, std::int32_t value, Instant time)
{
    switch (log) {
    case Log::Position: takePosition(value, time); break;
    case Log::Velocity:
        if (!isFresh(log) || !hasPassed(time))
            break;
        m_velocity = value;
        m_telemetry->append({channel::velocity, time, static_cast<double>(value)});
        break;
    case Log::Current:
        m_telemetry->append({channel::current, time, value * m_profile.calibrated(calibration::amperes, 1.0)});
        break;
    case Log::Temperature:
        m_telemetry->append({channel::temperature, time, value * m_profile.calibrated(calibration::degrees, 1.0)});
        break;
    case Log::Voltage: takeVoltage(value, time); break;
    }
    m_owner.heard();
    if (!m_link.address().isRecording() && !isDriven() && m_motion.standsSince(Instant::min()))
        m_whereabouts.stands();
}

void LogSense::takePosition(std::int32_t value, Instant time)
{
    if (const Restart restart = m_whereabouts.heard(value, m_clock.now()); restart != Restart::No)
        m_owner.restarted(restart);
    const MotionSense::Reading reading = m_motion.add(value, time);
    if (reading == MotionSense::Reading::Glitch) {
        m_telemetry->lost(channel::position, 1);
        return;
    }
    if (reading == MotionSense::Reading::Anew) {
        m_whereabouts.restarted(time);
        m_owner.restarted(Restart::Seen);
    }
    m_whereabouts.located(value, time, m_loop == Loop::Velocity && hasPassed(time));
    m_telemetry->append({channel::position, time, static_cast<double>(value)});
    if (isFresh(Log::Velocity))
        return; // the drive measures it itself
    if (const auto velocity = m_motion.velocity(time))
        m_telemetry->append({channel::velocity, time, *velocity});
}

void LogSense::takeVoltage(std::int32_t value, Instant time)
{
    if (!isFresh(Log::Voltage) || !hasPassed(time))
        return;
    if (m_output.take(value)) {
        m_owner.wrapped();
        return;
    }
    m_owner.output(value, time);
    m_telemetry->append({channel::duty, time, std::clamp(value / double{fullPwm}, -1.0, 1.0)});
}

std::optional<double> LogSense::feedback(Loop loop, double target) const
{
    switch (loop) {
    case Loop::Velocity: {
        const auto computed = m_motion.velocity(m_clock.now());
        if (m_velocity && computed)
            return std::abs(*computed - target) > std::abs(*m_velocity - target) ? computed : m_velocity;
        return m_velocity ? m_velocity : computed;
    }
    case Loop::Position: {
        const auto position = m_motion.position();
        return position ? std::optional<double>(*position) : std::nullopt;
    }
    default: return std::nullopt;
    }
}

void LogSense::forget()
{
    m_whereabouts.silent(m_link.state() == LinkState::Open, m_motion.standsSince(Instant::min()));
    m_motion.forget();
    m_velocity.reset();
}

} // namespace mb::abstractdc
