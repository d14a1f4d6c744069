// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/steplog.h"

#include "model/axis.h"
#include "widgets/control/gainunits.h"

#include <algorithm>
#include <cmath>

namespace mb {
namespace {

using namespace std::chrono_literals;

constexpr Duration lookBack = 200ms;  ///< for what was there before
constexpr Duration rampPause = 150ms; ///< a set-point that changes again within this is still on its way
constexpr Duration watchTime = 3s;    ///< after the set-point has arrived
constexpr Duration leastTime = 300ms; ///< less than this says nothing
constexpr Duration snapshotTime = 500ms;
constexpr std::size_t mostRecords = 1000;

std::vector<Point> samplesOf(const DeviceView &device, std::string_view key, Instant from, Instant to)
{
    std::vector<Point> samples;
    if (const auto channel = device.telemetry->find(key))
        device.telemetry->forEach(*channel, from, to, [&samples](const Point &point) { samples.push_back(point); });
    return samples;
}

} // namespace

std::string_view measuredChannel(Mode mode)
{
    switch (mode) {
    case Mode::Velocity: return "velocity";
    case Mode::Position: return "position";
    case Mode::Current: return "current";
    default: return {};
    }
}

StepRecord *StepLog::running()
{
    return m_records.empty() || m_records.back().finished ? nullptr : &m_records.back();
}

/// Nothing while it is not kept alive.
const SetPoint *StepLog::told(const DeviceView &device) const
{
    if (m_axis > 0)
        return device.motion.on(m_axis);
    return device.motion.running ? &device.motion.setPoint : nullptr;
}

bool StepLog::follow(const DeviceView &device, Instant now)
{
    m_news = false;
    const auto channel = device.telemetry->find(axisKey(m_axis, "setpoint"));
    if (!channel)
        return false;
    if (m_seen == Instant{})
        m_seen = now - 1us; // what happened before somebody looked is history
    std::vector<Point> fresh;
    device.telemetry->forEach(*channel, m_seen + 1us, now, [&fresh](const Point &point) { fresh.push_back(point); });
    const bool early = !fresh.empty() && !told(device) && !m_target && now - fresh.back().time < snapshotTime;
    if (early)
        return false; // the recording is ahead of the snapshot, which does not know the mode yet
    for (const Point &point : fresh)
        take(device, point);
    if (!fresh.empty())
        m_seen = std::max(m_seen, fresh.back().time);
    StepRecord *record = running();
    if (record && !told(device) && now - m_seen > rampPause)
        finish(device, m_seen, true);
    else if (record && now >= m_changedAt + watchTime)
        finish(device, m_changedAt + watchTime, false);
    if (!told(device) && now - m_seen > rampPause)
        m_target.reset();
    return m_news;
}

void StepLog::take(const DeviceView &device, const Point &setPoint)
{
    if (setPoint.isGap()) {
        if (running())
            finish(device, setPoint.time, true);
        m_target.reset();
        return;
    }
    if (m_target == setPoint.value)
        return;
    StepRecord *record = running();
    const bool onItsWay = record && setPoint.time - m_changedAt < rampPause;
    const bool held = onItsWay && std::abs(record->to - record->from) <= 1.0;
    if (held) { // the first command only held what was there: the step begins now
        record->begin = setPoint.time;
        record->to = setPoint.value;
    } else if (onItsWay) {
        record->to = setPoint.value;
        record->ramp = std::chrono::duration<double>(setPoint.time - record->begin).count();
    } else {
        if (record)
            finish(device, setPoint.time, setPoint.time - m_changedAt < watchTime / 2);
        begin(device, setPoint.time, setPoint.value);
    }
    m_target = setPoint.value;
    m_changedAt = setPoint.time;
}

void StepLog::begin(const DeviceView &device, Instant time, double target)
{
    const SetPoint &command
        = m_axis > 0 && device.motion.on(m_axis) ? *device.motion.on(m_axis) : device.motion.setPoint;
    const Mode mode = command.mode;
    const std::string_view channel = measuredChannel(mode);
    if (channel.empty())
        return;
    const auto before = samplesOf(device, axisKey(m_axis, channel), time - lookBack, time);
    StepRecord record;
    record.number = m_records.empty() ? 1 : m_records.back().number + 1;
    record.begin = time;
    record.mode = mode;
    record.slot = command.slot;
    record.axis = m_axis;
    record.to = target;
    const bool known = !before.empty() && !before.back().isGap();
    record.from = m_target ? *m_target : known ? before.back().value : 0.0;
    const GainSet set = gainSet(*device.family, mode, record.slot, m_axis);
    for (std::size_t i = 0; i < std::min(set.gains.size(), record.gains.size()); ++i)
        record.gains[i] = device.parameters.at(set.gains[i].value).raw;
    if (m_records.size() >= mostRecords)
        m_records.erase(m_records.begin());
    m_records.push_back(record);
    m_news = true;
}

void StepLog::finish(const DeviceView &device, Instant end, bool cut)
{
    StepRecord &record = m_records.back();
    m_news = true;
    record.finished = true;
    record.end = end;
    record.cut = cut;
    const bool still = std::abs(record.to - record.from) < 1e-9;
    if (still || (cut && end - record.begin < leastTime)) { // a start at the present value is no step
        m_records.pop_back();
        return;
    }
    const auto samples = samplesOf(device, axisKey(m_axis, measuredChannel(record.mode)), record.begin - lookBack, end);
    record.metrics = measureStep(samples, record.begin, std::nullopt, record.to);
    if (const auto channel = device.telemetry->find(axisKey(m_axis, measuredChannel(record.mode)))) {
        for (const History::Gap &gap : device.telemetry->gaps(*channel, record.begin, end))
            record.lost += gap.lost;
    }
    for (const Point &point : samplesOf(device, axisKey(m_axis, "current"), record.begin, end)) {
        if (!point.isGap())
            record.peakCurrent = std::max(record.peakCurrent, std::abs(point.value));
    }
}

} // namespace mb
