// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/guards.h"

#include "experiment/seconds.h"
#include "model/parameter.h"

#include <cmath>

namespace mb::tuning {
namespace {

using namespace std::chrono_literals;

constexpr Duration handling = 25ms; ///< from a sample to the bridge being off, besides the periods
constexpr Duration overloadTime = 100ms;
constexpr double peakMargin = 1.5;
constexpr double heatBudget = 10.0; ///< s at the current limit
constexpr double heatMargin = 5.0;  ///< K
constexpr double dutyMargin = 0.02;
constexpr int wrongSamples = 5;
constexpr Duration stuckTime = 500ms;
constexpr int growingPeaks = 6;
constexpr int lastingPeaks = 25;
constexpr int sustainedPeaks = 10; ///< of broad ones that do not become smaller
constexpr int mostFlips = 20;      ///< a second
constexpr double planMargin = 1.5;
constexpr int silentPeriods = 5;
constexpr double surelyReal = 5.0;     ///< σ of the noise
constexpr double fullPush = 1.0 / 3.0; ///< breakaway for which a push of 1 surely moves it

double rounded(double value)
{
    return std::round(value * 100.0) / 100.0;
}

MessageNumber milliseconds(Duration time)
{
    return {rounded(inSeconds(time) * 1e3), -1, "ms"};
}

} // namespace

Guards::Guards(const GuardPlan &plan, Instant start)
    : m_plan(plan)
    , m_start(start)
    , m_heardAt(start)
    , m_positionAt(start)
{
}

std::optional<Trip> Guards::trip(EndReason guard, Instant at, Message detail)
{
    if (m_tripped)
        return std::nullopt;
    m_tripped = true;
    return Trip{guard, std::move(detail), at};
}

void Guards::rested(Instant time)
{
    heard(time);
    m_positionAt = std::max(m_positionAt, time);
    m_overload.pause();
}

/// What happens, and what drives the motor meanwhile.
Message Guards::underPush(const Message &what) const
{
    return m_plan.dutyKnown ? say("%1 at %2 % duty", what, rounded(m_motion.pushed() * 100.0))
        : m_plan.isVelocity ? say("%1, told to run at more than half a step", what)
                            : say("%1, more than half a step from its target", what);
}

/// Where no duty is told: full for more than half a step.
double Guards::pushOf(double error) const
{
    return std::abs(error) > m_plan.swing / 2.0 ? std::copysign(1.0, error) : 0.0;
}

std::optional<Trip> Guards::position(Instant time, double counts)
{
    heard(time);
    m_positionAt = std::max(m_positionAt, time);
    m_speed = m_slope.add(time, counts);
    if (!m_plan.dutyKnown && m_plan.isVelocity) // what it calls its velocity comes too late
        m_motion.duty(time, pushOf(m_target), fullPush);
    m_motion.position(time, counts);
    if (m_motion.wrong() >= wrongSamples)
        return trip(EndReason::WrongDirection, time,
            underPush(m_motion.pushed() > 0.0 ? say("the sensor is reversed: it counts down")
                                              : say("the sensor is reversed: it counts up")));
    if (m_motion.stuck() >= stuckTime + m_plan.late)
        return trip(EndReason::NoMotion, time,
            underPush(
                say("stalled, or the encoder is dead: less than 3 counts in %1", milliseconds(m_motion.stuck()))));
    const auto &limit = m_plan.envelope.travel;
    const double latency = inSeconds(m_plan.telemetry + m_plan.command + handling);
    const double stops = counts + m_speed * (latency + m_plan.lag);
    const double farthest = std::max(std::abs(stops - m_plan.origin), std::abs(counts - m_plan.origin));
    if (limit && farthest > *limit)
        return trip(EndReason::Travel, time,
            say("it would stop %1 counts from the start, %2 are allowed", rounded(farthest), rounded(*limit)));
    return std::nullopt;
}

std::optional<Trip> Guards::velocity(Instant time, double perSecond)
{
    heard(time);
    const auto &planned = m_plan.envelope.speed;
    if (planned && std::abs(perSecond) > speedMargin * *planned)
        return trip(EndReason::Speed, time,
            say("speed %1 counts/s is above 1.2 × %2 counts/s", rounded(std::abs(perSecond)), rounded(*planned)));
    return std::nullopt;
}

std::optional<Trip> Guards::current(Instant time, double amperes)
{
    heard(time);
    const auto &limit = m_plan.envelope.current;
    if (!limit)
        return std::nullopt;
    m_overload.add(time, amperes, *limit);
    if (std::abs(amperes) > peakMargin * *limit)
        return trip(EndReason::Current, time,
            say("current %1 A is above 1.5 × %2 A", rounded(std::abs(amperes)), rounded(*limit)));
    if (m_overload.above() >= overloadTime)
        return trip(EndReason::Current, time,
            say("current was above %1 A for %2", rounded(*limit), milliseconds(m_overload.above())));
    if (m_overload.heat() > heatBudget)
        return trip(EndReason::Energy, time,
            say("the motor took the heat of %1 s at %2 A, 10 s are allowed; let it cool", rounded(m_overload.heat()),
                rounded(*limit)));
    return std::nullopt;
}

std::optional<Trip> Guards::duty(Instant time, double fraction)
{
    heard(time);
    m_motion.duty(time, fraction, m_plan.breakaway);
    const double limit = m_plan.envelope.duty.value_or(1.0);
    m_oscillation.duty(time, fraction, limit);
    if (std::abs(fraction) > limit + dutyMargin)
        return trip(EndReason::Duty, time,
            say("duty %1 % is above %2 %", rounded(std::abs(fraction) * 100.0), rounded(limit * 100.0)));
    if (m_oscillation.flips() > mostFlips)
        return trip(EndReason::Oscillation, time,
            say("the duty changed its direction %1 times in a second", m_oscillation.flips()));
    return std::nullopt;
}

std::optional<Trip> Guards::temperature(Instant time, double celsius)
{
    heard(time);
    if (celsius <= m_plan.hottest - heatMargin)
        return std::nullopt;
    return trip(EndReason::Temperature, time,
        say("temperature %1 °C is within 5 K of %2 °C", rounded(celsius), rounded(m_plan.hottest)));
}

std::optional<Trip> Guards::busVoltage(Instant time, double volts)
{
    heard(time);
    if (volts >= m_plan.lowestBus && volts <= m_plan.highestBus)
        return std::nullopt;
    return trip(EndReason::BusVoltage, time,
        say("supply %1 V is outside %2 … %3 V", rounded(volts), rounded(m_plan.lowestBus), rounded(m_plan.highestBus)));
}

std::optional<Trip> Guards::error(Instant time, double error)
{
    m_oscillation.error(error, m_plan.swing, surelyReal * m_plan.noise);
    if (!m_plan.dutyKnown && !m_plan.isVelocity)
        m_motion.duty(time, pushOf(error), fullPush);
    const bool isBlind = !m_plan.dutyKnown && !m_plan.isVelocity; // no duty shows how hard it works
    const bool swings = m_oscillation.lasting() >= lastingPeaks || m_oscillation.sustained() >= sustainedPeaks;
    if (isBlind && swings)
        return trip(
            EndReason::Oscillation, time, say("the loop does not come to rest: %1 swings", m_oscillation.lasting()));
    if (m_oscillation.growing() < growingPeaks)
        return std::nullopt;
    return trip(EndReason::Oscillation, time,
        say("the loop swings itself up: %1 swings, each larger than the last or with full duty",
            m_oscillation.growing()));
}

std::optional<Trip> Guards::judgeSilence(Instant now)
{
    const Duration patience = std::max<Duration>(m_plan.silence, silentPeriods * m_plan.telemetry);
    if (now - m_heardAt > patience)
        return trip(EndReason::Link, m_heardAt + patience, say("no sample for %1", milliseconds(now - m_heardAt)));
    if (now - m_positionAt > patience)
        return trip(
            EndReason::Link, m_positionAt + patience, say("no position for %1", milliseconds(now - m_positionAt)));
    return std::nullopt;
}

std::optional<Trip> Guards::look(Instant now, std::uint64_t samples, std::uint64_t lost)
{
    if (auto silent = judgeSilence(now))
        return silent;
    m_loss.add(now, samples, lost);
    if (m_loss.share() > m_plan.mostLost)
        return trip(
            EndReason::Link, now, say("%1 % of the samples were lost in a second", rounded(m_loss.share() * 100.0)));
    const auto longest = std::chrono::duration_cast<Duration>(m_plan.longest * planMargin);
    if (now - m_start > longest)
        return trip(EndReason::Time, m_start + longest,
            say("it took longer than 1.5 × %1 s", rounded(inSeconds(m_plan.longest))));
    return std::nullopt;
}

} // namespace mb::tuning
