// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/verdict.h"

#include "model/unit.h"

#include "experiment/effort.h"
#include "experiment/envelope.h"
#include "experiment/equivalenttime.h"
#include "experiment/seconds.h"
#include "model/device.h"
#include "model/family.h"
#include "model/loopparameters.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mb::tuning {
namespace {

using Spans = std::vector<std::pair<Instant, Instant>>;

constexpr double leastCounts = 5.0;
constexpr double leastLevels = 50.0; ///< of the measured value in a step
constexpr double notable = 0.02;     ///< share of time at the duty limit
constexpr double nearlyAll = 0.98;
constexpr double unlike = 0.25;     ///< rise up and down
constexpr double beforeStep = 0.25; ///< s

/// One response, or those of all repeats together.
struct Reading {
    Response response;
    bool isWhole = false; ///< of one that was not cut short
    std::vector<Metrics> runs;
};

/// What went on when the trial was cut short is of no repeat that was whole, and is read only where there was none.
Reading readSteps(const TrialRecorder &recorder, std::string_view key, const Spans &spans, std::optional<Instant> cut,
    std::optional<double> target, double leastMove)
{
    Reading reading;
    std::vector<Trace> traces;
    for (const auto &[edge, end] : spans) {
        if (end <= edge)
            continue; // it was cut before
        const double seconds = inSeconds(end - edge);
        const Trace trace = recorder.trace(key, edge, {-beforeStep, seconds});
        const Response response = readResponse(trace, target, leastMove);
        const bool whole = !cut || end < *cut;
        reading.runs.push_back((whole ? response : cutShort(response, seconds)).metrics);
        if (whole)
            traces.push_back(trace);
        else if (traces.empty())
            reading.response = cutShort(response, seconds);
    }
    if (traces.empty())
        return reading;
    const auto repeats = static_cast<int>(traces.size());
    reading.isWhole = true;
    reading.response = readResponse(merged(traces), target, leastMove, repeats);
    return reading;
}

/// When a trial ended before its time; nothing where it did not.
std::optional<Instant> cutOf(const Trial &trial, const Spans &holds, const Spans &returns)
{
    Instant last = holds.back().second;
    for (const Spans *spans : {&holds, &returns}) {
        for (const auto &[edge, end] : *spans)
            last = std::max(last, end);
    }
    return trial.has(flag::aborted) ? std::optional(last) : std::nullopt;
}

void averageEffort(Metrics &into, const std::vector<Metrics> &runs)
{
    for (const auto member : {&Metrics::peakCurrent, &Metrics::dutyChatter, &Metrics::saturated}) {
        double sum = 0.0;
        std::size_t count = 0;
        for (const Metrics &run : runs) {
            sum += (run.*member).value_or(0.0);
            count += run.*member ? 1U : 0U;
        }
        if (count > 0)
            into.*member = sum / static_cast<double>(count);
    }
}

bool isRampLimited(const Trial &trial, const Family &family)
{
    return std::ranges::any_of(trial.gains, [&family](const auto &gain) {
        return gain.second.value_or(0.0) > 0.0 && roleOf(family, gain.first) == Role::Ramp;
    });
}

void addFlag(Trial &trial, std::string_view name, bool holds)
{
    if (holds && !trial.has(name))
        trial.flags.emplace_back(name);
}

void addFlags(Trial &trial, const Family &family, const Reading &reading, const Reading &back, const Trace &measured)
{
    const double swing = std::abs(trial.stimulus.to - trial.stimulus.from);
    addFlag(trial, flag::saturated, trial.metrics.saturated.value_or(0.0) > notable);
    addFlag(trial, flag::currentLimit,
        trial.envelope.current && trial.metrics.peakCurrent.value_or(0.0) >= nearlyAll * *trial.envelope.current);
    addFlag(trial, flag::rampLimit, isRampLimited(trial, family));
    addFlag(trial, flag::lostSamples, trial.lost > 0);
    const double resolution = resolutionOf(measured);
    addFlag(
        trial, flag::lowResolution, trial.mode != Mode::Duty && resolution > 0.0 && swing < leastLevels * resolution);
    const auto up = reading.response.metrics.rise;
    const auto down = back.response.metrics.rise;
    addFlag(trial, flag::asymmetric, up && down && std::abs(*up - *down) > unlike * std::max(*up, *down));
    const bool still = reading.isWhole && !reading.response.moved && !measured.isEmpty();
    addFlag(trial, flag::didNotMove, still || trial.reason == EndReason::NoMotion);
}

std::vector<Span> spansOf(const Spans &spans, Instant zero)
{
    std::vector<Span> all;
    for (const auto &[from, to] : spans)
        all.push_back({inSeconds(from - zero), inSeconds(to - zero)});
    return all;
}

} // namespace

double resolutionOf(const Trace &trace)
{
    double least = 0.0;
    for (std::size_t i = 1; i < trace.size(); ++i) {
        const double difference = std::abs(trace.y[i] - trace.y[i - 1]);
        if (difference > 0.0 && (least == 0.0 || difference < least))
            least = difference;
    }
    return least;
}

void describe(Trial &trial, const Device &device)
{
    trial.device = device.selector();
    trial.simulated = device.link().address().isSimulated();
    trial.firmware = device.identity().firmware;
    trial.unit = unitKeyOf(device);
}

namespace {

EndReason reasonOf(SetPointStream::End end)
{
    using End = SetPointStream::End;
    switch (end) {
    case End::Late: return EndReason::Late;
    case End::Slept: return EndReason::Slept;
    case End::DeviceRestarted: return EndReason::DeviceRestarted;
    case End::ForeignMaster: return EndReason::ForeignMaster;
    case End::Unguarded: return EndReason::Unguarded;
    default: return EndReason::Refused;
    }
}

} // namespace

void nameEnding(Trial &trial, const Ending &ending)
{
    using End = SetPointStream::End;
    const bool lost = !ending.linkOpen || ending.stream == End::LinkLost || ending.stream == End::DeviceSilent
        || (ending.error && ending.error->fault == Fault::LinkLost);
    if (ending.completed) {
        trial.reason = EndReason::Done;
    } else if (ending.trip) {
        trial.reason = ending.trip->guard;
        trial.detail = ending.trip->detail;
    } else if (lost) {
        trial.reason = EndReason::Link;
        trial.detail = ending.error ? ending.error->detail : ending.streamReason;
    } else if (ending.interrupted) {
        trial.reason = EndReason::Interrupted;
        trial.detail = say("the user stopped it");
    } else if (ending.stream == End::LeaseExpired) {
        trial.reason = EndReason::User;
        trial.detail = ending.streamReason;
    } else if (ending.stream != End::Stopped && ending.stream != End::None) {
        trial.reason = reasonOf(ending.stream);
        trial.detail = ending.streamReason;
    } else if (ending.error && ending.error->fault != Fault::Cancelled) {
        trial.detail = ending.error->detail;
    } else { // somebody has stopped the motor, and not by the interruption
        trial.reason = EndReason::Interrupted;
        trial.detail = ending.streamReason;
    }
    addFlag(trial, flag::aborted, trial.reason != EndReason::Done);
}

std::string_view flagLabel(std::string_view flag)
{
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 10> labels{{
        {flag::saturated, MB_LABEL("saturated")},
        {flag::currentLimit, MB_LABEL("current limit")},
        {flag::rampLimit, MB_LABEL("ramp")},
        {flag::limitSwitch, MB_LABEL("limit switch")},
        {flag::lostSamples, MB_LABEL("samples lost")},
        {flag::aborted, MB_LABEL("stopped")},
        {flag::lowResolution, MB_LABEL("coarse")},
        {flag::asymmetric, MB_LABEL("not symmetric")},
        {flag::didNotMove, MB_LABEL("did not move")},
        {flag::restartNeeded, MB_LABEL("restart needed")},
    }};
    const auto row = std::ranges::find_if(labels, [&](const auto &entry) { return entry.first == flag; });
    return row == labels.end() ? flag : row->second;
}

void measure(Trial &trial, const Family &family, const TrialRecorder &recorder, const Spans &holds,
    const Spans &returns, const Span &within)
{
    if (holds.empty())
        return;
    const std::string_view key = measuredOf(trial.mode);
    const bool open = trial.mode == Mode::Duty;
    const bool steps = !trial.stimulus.edges().empty();
    const auto target = [open](double value) { return open ? std::nullopt : std::optional(value); };
    const double leastMove = trial.mode == Mode::Current ? 0.0 : leastCounts;
    Reading reading;
    Reading back;
    if (steps) { // in what never steps there is no response, and to look for one takes seconds
        const auto cut = cutOf(trial, holds, returns);
        reading = readSteps(recorder, key, holds, cut, target(trial.stimulus.to), leastMove);
        back = readSteps(recorder, key, returns, cut, target(trial.stimulus.from), leastMove);
    }
    reading.runs.resize(holds.size());
    const double limit = trial.envelope.duty.value_or(1.0);
    for (std::size_t i = 0; i < holds.size(); ++i) {
        const double hold = inSeconds(holds[i].second - holds[i].first);
        readEffort(reading.runs[i], recorder.trace("current", holds[i].first, {0.0, hold}),
            recorder.trace("duty", holds[i].first, {0.0, hold}), hold, limit);
        if (trial.envelope.current == std::nullopt)
            reading.runs[i].peakCurrent.reset(); // its channel has no scale
    }
    Metrics metrics = reading.response.metrics;
    averageEffort(metrics, reading.runs);
    if (steps && trial.stimulus.profile == Profile::Step)
        metrics.undershoot = back.response.metrics.overshoot;
    trial.metrics = metrics;
    if (steps && trial.repeat > 1)
        trial.errors = errorsOf(reading.runs);
    const Instant zero = holds.front().first;
    trial.holds = spansOf(holds, zero);
    trial.returns = spansOf(returns, zero);
    trial.signals = recorder.signals(zero, within);
    addFlags(trial, family, reading, back, recorder.trace(key, zero, within));
}

} // namespace mb::tuning
