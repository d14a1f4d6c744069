// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/trialrecorder.h"

#include "experiment/envelope.h"
#include "experiment/seconds.h"
#include "model/axis.h"
#include "model/family.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mb::tuning {
namespace {

constexpr Duration guardPeriod = std::chrono::milliseconds(5);
constexpr std::size_t fewestStill = 3; ///< positions that tell a standstill
constexpr double stillCounts = 1.0;
constexpr double settledShare = 0.5;                       ///< of the time since the edge, over which it rests
constexpr double besideShare = 0.75;                       ///< the same beside its aim
constexpr Duration besideLeast = std::chrono::seconds(1);  ///< so that the guard of no motion has had its half second
constexpr Duration heldUp = std::chrono::milliseconds(20); ///< what came meanwhile is not read yet

} // namespace

TrialRecorder::TrialRecorder(Device &device, SetPointStream &stream, Mode mode, int axis)
    : m_device(device)
    , m_stream(stream)
    , m_measured(measuredOf(mode))
    , m_isOpen(mode == Mode::Duty)
    , m_timer(device.clock())
{
    const auto channels = device.telemetry()->channels();
    for (std::size_t i = 0; i < channels.size(); ++i) {
        const int of = axisOf(channels[i].key);
        if (of != 0 && of != axis)
            continue;
        const auto key = of == 0 ? channels[i].key : channels[i].key.substr(channels[i].key.find('.') + 1);
        m_recorded.push_back({ChannelIndex{static_cast<std::uint16_t>(i)}, std::string(key), {}});
    }
    m_ordersAreDuty = m_isOpen && !find("duty");
    device.telemetry()->commit();
    device.link().recount();
    m_lostBefore = lostSoFar();
    m_subscription = device.telemetry()->samples().add([this](const Sample &sample) { take(sample); });
}

void TrialRecorder::guard(const GuardPlan &plan)
{
    m_trip.reset();
    m_guards.emplace(plan, m_device.clock().now());
    m_lookedAt = m_device.clock().now();
    m_timer.startIn(guardPeriod, [this] { look(); });
}

void TrialRecorder::unguard()
{
    m_guards.reset();
    m_timer.stop();
}

void TrialRecorder::expect(double target)
{
    m_target = target;
    if (m_guards)
        m_guards->target(target);
}

void TrialRecorder::take(const Sample &sample)
{
    const auto recorded = std::ranges::find(m_recorded, sample.channel, &Recorded::channel);
    if (recorded == m_recorded.end())
        return;
    ++m_samples;
    recorded->points.push_back({sample.time, sample.value});
    if (recorded->key == m_measured)
        m_extremes.add(sample.time, sample.value);
    if (m_guards && m_stream.isRunning())
        ended(show(recorded->key, sample));
    else if (m_guards)
        m_guards->rested(sample.time);
}

std::optional<Trip> TrialRecorder::show(const std::string &key, const Sample &sample)
{
    std::optional<Trip> trip;
    if (key == "position" && m_ordersAreDuty && m_target)
        trip = m_guards->duty(sample.time, *m_target);
    if (trip)
        return trip;
    if (key == "position")
        trip = m_guards->position(sample.time, sample.value);
    else if (key == "velocity")
        trip = m_guards->velocity(sample.time, sample.value);
    else if (key == "current")
        trip = m_guards->current(sample.time, sample.value);
    else if (key == "duty")
        trip = m_guards->duty(sample.time, sample.value);
    else if (key == "temperature" && m_device.telemetry()->channels()[sample.channel.value].unit == "°C")
        trip = m_guards->temperature(sample.time, sample.value);
    else if (key == "bus_voltage")
        trip = m_guards->busVoltage(sample.time, sample.value);
    if (!trip && m_target && !m_isOpen && key == m_measured)
        trip = m_guards->error(sample.time, *m_target - sample.value);
    return trip;
}

void TrialRecorder::look()
{
    m_timer.startIn(guardPeriod, [this] { look(); });
    const Instant before = std::exchange(m_lookedAt, m_device.clock().now());
    const bool isLate = m_lookedAt - before > heldUp;
    const bool wasLate = std::exchange(m_wasLate, isLate);
    if (m_stream.isRunning())
        lookForLimits();
    if (isLate && !wasLate)
        return; // who was held up reads first, and then judges silence
    if (m_guards && m_stream.isRunning())
        ended(m_guards->look(m_device.clock().now(), m_samples, lost()));
}

void TrialRecorder::lookForLimits()
{
    for (const StateRow *const row : conditionsOf(m_device.family().states, m_device.states())) {
        if (row->kind == StateKind::Switch)
            m_limitMet = row;
    }
}

void TrialRecorder::ended(std::optional<Trip> trip)
{
    if (!trip)
        return;
    m_stream.stop();
    m_stoppedAt = m_device.clock().now();
    m_trip = std::move(trip);
}

const TrialRecorder::Recorded *TrialRecorder::find(std::string_view key) const
{
    const auto found = std::ranges::find(m_recorded, key, &Recorded::key);
    return found == m_recorded.end() ? nullptr : &*found;
}

std::optional<double> TrialRecorder::latest(std::string_view key) const
{
    const Recorded *recorded = find(key);
    if (!recorded || recorded->points.empty())
        return std::nullopt;
    return recorded->points.back().value;
}

Trace TrialRecorder::trace(std::string_view key, Instant zero, const Span &within) const
{
    Trace trace;
    const Recorded *recorded = find(key);
    if (!recorded)
        return trace;
    const auto timeOf = [zero](const Point &point) { return inSeconds(point.time - zero); };
    const std::vector<Point> &points = recorded->points;
    auto point = std::partition_point(
        points.begin(), points.end(), [&](const Point &each) { return timeOf(each) < within.from; });
    for (; point != points.end() && timeOf(*point) <= within.to; ++point)
        trace.add(timeOf(*point), point->value);
    return trace;
}

std::vector<Signal> TrialRecorder::signals(Instant zero, const Span &within) const
{
    std::vector<Signal> signals;
    for (const Recorded &recorded : m_recorded) {
        const Channel &channel = m_device.telemetry()->channels()[recorded.channel.value];
        if (!recorded.points.empty())
            signals.push_back({std::string(channel.key), std::string(channel.unit), trace(recorded.key, zero, within)});
    }
    return signals;
}

std::uint64_t TrialRecorder::lostSoFar() const
{
    std::uint64_t lost = m_device.link().counters().lost;
    for (const Recorded &recorded : m_recorded)
        lost += m_device.telemetry()->lost(recorded.channel);
    return lost;
}

std::uint64_t TrialRecorder::lost() const
{
    m_device.telemetry()->commit();
    m_device.link().recount();
    const std::uint64_t now = lostSoFar();
    return now > m_lostBefore ? now - m_lostBefore : 0;
}

double TrialRecorder::positionPeriod() const
{
    constexpr std::size_t recent = 12;
    const Recorded *recorded = find("position");
    if (!recorded || recorded->points.size() < recent)
        return 0.0;
    std::vector<double> gaps;
    for (auto point = recorded->points.end() - recent + 1; point != recorded->points.end(); ++point)
        gaps.push_back(inSeconds(point->time - std::prev(point)->time));
    return median(std::move(gaps));
}

double TrialRecorder::stopsAt(double lag) const
{
    const Recorded *recorded = find("position");
    if (!recorded || recorded->points.size() < fewestStill)
        return 0.0;
    const Point &last = recorded->points.back();
    const Point &before = *(recorded->points.end() - fewestStill);
    const double span = inSeconds(last.time - before.time);
    return last.value + (span > 0.0 ? (last.value - before.value) / span * lag : 0.0);
}

bool TrialRecorder::isSettled(Instant from, Duration least, double share, double width) const
{
    const Instant now = m_device.clock().now();
    if (now - from < least)
        return false;
    const auto spread = m_extremes.spread(now - std::chrono::duration_cast<Duration>((now - from) * share));
    return spread && *spread <= width;
}

bool TrialRecorder::hasSettled(Instant from, Duration least, const std::optional<Way> &way, double width) const
{
    if (!isSettled(from, least, settledShare, width))
        return false;
    const auto now = latest(m_measured);
    if (!way || (now && std::abs(*now - way->aim) <= width / 2.0))
        return true;
    const bool hasLeft = now && std::abs(*now - way->start) > width / 2.0;
    return hasLeft && isSettled(from, besideLeast, besideShare, width);
}

bool TrialRecorder::isStill(Instant from, Duration span) const
{
    const Recorded *recorded = find("position");
    const Instant since = m_device.clock().now() - span;
    if (!recorded || recorded->points.empty() || since < from)
        return false;
    const double last = recorded->points.back().value;
    std::size_t seen = 0;
    for (auto point = recorded->points.rbegin(); point != recorded->points.rend() && point->time >= since; ++point) {
        if (std::abs(point->value - last) > stillCounts)
            return false;
        ++seen;
    }
    return seen >= fewestStill;
}

} // namespace mb::tuning
