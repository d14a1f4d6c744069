// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/frequencyresponse.h"

#include "experiment/figures.h"
#include "experiment/motiontimes.h"
#include "model/family.h"
#include "tuning/leastsquares.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace mb::tuning {
namespace {

constexpr int sines = 8;
constexpr double swingsOfOne = 6.0;  ///< of Profile::Sine
constexpr double slowest = 0.3;      ///< Hz: its six swings take 20 s
constexpr double belowCorner = 10.0; ///< times
constexpr double aboveCorner = 10.0;
constexpr double leastSpread = 4.0;     ///< of the highest over the lowest frequency
constexpr double samplesOfSwing = 10.0; ///< and set-points of one: beyond 0.1/Ts nothing is drawn
constexpr double nearlyAll = 0.98;
constexpr double leastCoherence = 0.9;
constexpr double usableShare = 0.75; ///< of a limit of the envelope
constexpr double usualBias = 0.25;   ///< duty
constexpr double leastBias = 0.06;
constexpr double swingShare = 0.4;      ///< of the bias beyond friction: it never comes to rest
constexpr double clearOfFriction = 3.0; ///< times friction that the bias is, at least
constexpr double standsAfter = 5.0;     ///< lags, until it has come to rest from X
constexpr double notMoving
    = 1.6; ///< s of an experiment around its motion: rates, the stop that is seen, late where edges tell a speed
constexpr std::size_t leastPoints = 40;

struct Phasor {
    std::complex<double> value;
    double line = 0.0;      ///< slope, per second
    double coherence = 0.0; ///< share of what is no line that the sine explains
};

/// Line, decay and sine; without a line the slope is held at nought.
std::optional<Phasor> phasorOf(const Trace &trace, double omega, double from, double to, double tau)
{
    LeastSquares<5> fit;
    const Trace part = trace.part(from, to);
    if (part.size() < leastPoints)
        return std::nullopt;
    const double origin = part.y.front();
    const auto rowAt = [=](double t) {
        return LeastSquares<5>::Row{
            1.0, t - from, std::exp(-(t - from) / tau), std::cos(omega * t), std::sin(omega * t)};
    };
    for (std::size_t i = 0; i < part.size(); ++i)
        fit.add(rowAt(part.t[i]), part.y[i] - origin);
    const auto solved = fit.solve();
    if (!solved)
        return std::nullopt;
    const auto &v = solved->values;
    double explained = 0.0;
    double rest = 0.0;
    for (std::size_t i = 0; i < part.size(); ++i) {
        const auto row = rowAt(part.t[i]);
        const double sine = v[3] * row[3] + v[4] * row[4];
        const double left = part.y[i] - origin - v[0] - v[1] * row[1] - v[2] * row[2] - sine;
        explained += sine * sine;
        rest += left * left;
    }
    return Phasor{{v[3], -v[4]}, v[1], explained > 0.0 ? explained / (explained + rest) : 0.0};
}

/// The duty that was told, or that was ordered where the device tells none.
Trace dutyOf(const Trial &trial, const Trace &position)
{
    if (const Signal *const told = trial.signal("duty"); told && told->trace.size() >= leastPoints)
        return told->trace;
    Trace ordered;
    for (const double t : position.t)
        ordered.add(t, trial.stimulus.at(t));
    return ordered;
}

} // namespace

Result<FrequencyPoint> frequencyPoint(const Trial &trial, double tau)
{
    const Stimulus &stimulus = trial.stimulus;
    const Signal *const position = trial.signal("position");
    if (stimulus.profile != Profile::Sine || !position || !(stimulus.period > 0.0))
        return fail(Fault::OutOfRange, say("this trial has no sine and no positions"));
    const double omega = 2.0 * std::numbers::pi / stimulus.period;
    const double from = stimulus.period; // the first swing is the motor's way into it
    const auto counts = phasorOf(position->trace, omega, from, stimulus.time, tau);
    const auto duty = phasorOf(dutyOf(trial, position->trace), omega, from, stimulus.time, tau);
    if (!counts || !duty || std::abs(duty->value) == 0.0)
        return fail(Fault::OutOfRange, say("too few samples for a sine of %1 Hz", 1.0 / stimulus.period));
    if (omega * std::abs(counts->value) >= std::abs(counts->line))
        return fail(Fault::OutOfRange,
            say("the motor reversed during a sine of %1 Hz: friction is in it", 1.0 / stimulus.period),
            say("allow more speed"));
    const std::complex<double> response = std::complex<double>(0.0, omega) * counts->value / duty->value;
    FrequencyPoint point;
    point.hertz = 1.0 / stimulus.period;
    point.magnitude = std::abs(response);
    point.phase = std::arg(response) * 180.0 / std::numbers::pi;
    if (point.phase > 0.0)
        point.phase -= 360.0;
    point.coherence = counts->coherence;
    const double period = samplePeriod(position->trace);
    point.trusted = point.coherence >= leastCoherence && point.hertz * period * samplesOfSwing <= 1.0 + 1e-9;
    return point;
}

Result<SweepPlan> planSweep(const PlantModel &plant, const Envelope &inForce, double beat)
{
    const double corner = 1.0 / (2.0 * std::numbers::pi * plant.tau);
    const double high = std::min(aboveCorner * corner, nearlyAll / (samplesOfSwing * beat));
    const double low = std::min(std::max(corner / belowCorner, slowest), high / leastSpread);
    SweepPlan plan;
    const double most = usableShare * inForce.duty.value_or(1.0);
    double bias = std::min(usualBias, most / (1.0 + swingShare));
    const auto speedAt = [&plant](double duty) { return plant.gain * std::max(duty - plant.friction, 0.0); };
    if (inForce.speed)
        bias = std::min(bias, (usableShare * *inForce.speed / plant.gain + plant.friction) / (1.0 + swingShare));
    const double lag = plant.tau + plant.delay;
    const auto aroundOne
        = [lag](double swings) { return secondsBefore(lag) + secondsAfter(lag, swings) + standsAfter * lag; };
    const double slow = swingsOfOne / low;
    const double longest = slow + aroundOne(slow);
    if (inForce.travel)
        bias = std::min(bias, usableShare * *inForce.travel / (plant.gain * longest) + plant.friction);
    if (bias < std::max(leastBias, clearOfFriction * plant.friction))
        return fail(Fault::OutOfRange,
            say("there is not enough room for a frequency response: its limits leave a speed of %1 counts/s for %2 s",
                std::round(speedAt(bias)), std::round(longest)),
            say("allow more travel or speed"));
    plan.bias = bias;
    plan.swing = swingShare * (bias - plant.friction);
    for (int i = 0; i < sines; ++i) {
        plan.hertz.push_back(low * std::pow(high / low, static_cast<double>(i) / (sines - 1)));
        const double swings = swingsOfOne / plan.hertz.back();
        plan.seconds += swings + aroundOne(swings) + notMoving;
    }
    plan.speed = speedAt(plan.bias + plan.swing);
    plan.travel = speedAt(plan.bias) * slow + speedAt(plan.bias - plan.swing) * aroundOne(slow);
    return plan;
}

Message announcementOf(const SweepPlan &plan)
{
    const auto whole = [](double number) { return numberText(std::round(number)); };
    return say("duty %1 ± %2 %, at most %3 counts/s, %4 counts one way, %5 s", whole(100.0 * plan.bias),
        whole(100.0 * plan.swing), whole(plan.speed), whole(plan.travel), whole(plan.seconds));
}

double FrequencyResponse::trustedUpTo() const
{
    double up = 0.0;
    for (const FrequencyPoint &point : points) {
        if (!point.trusted)
            break;
        up = point.hertz;
    }
    return up;
}

Task<FrequencyResponse> measureFrequencyResponse(
    Device &device, SetPointStream &stream, SweepPlan plan, PlantModel plant, ExperimentSurroundings surroundings)
{
    std::optional<double> start;
    surroundings.start = &start;
    FrequencyResponse response;
    response.simulated = device.link().address().isSimulated();
    double sign = 1.0;
    int number = 0;
    for (const double hertz : plan.hertz) {
        ExperimentPlan sine;
        sine.mode = Mode::Duty;
        sine.axis = plan.axis;
        sine.slot = plan.slot;
        sine.profile = Profile::Sine;
        sine.from = sign * (plan.bias - plan.swing);
        sine.to = sign * (plan.bias + plan.swing);
        sine.seconds = swingsOfOne / hertz;
        sine.limits = plan.limits;
        if (surroundings.note)
            surroundings.note(say("sine %1 of %2, %3 Hz: %4", ++number, plan.hertz.size(),
                std::round(100.0 * hertz) / 100.0, announcementOf(plan)));
        const Result<Trial> trial = co_await runExperiment(device, stream, sine, surroundings).attempt();
        if (!trial && response.trials.empty())
            co_return fail(trial.error());
        if (!trial) {
            response.stopReason = EndReason::Refused;
            response.evidence = trial.error().message();
            co_return response;
        }
        if (trial->number)
            response.trials.push_back(*trial->number);
        response.stopped = trial->stopped || device.isSeenStopped();
        if (trial->reason != EndReason::Done || !response.stopped) {
            const bool isNamed = trial->reason != EndReason::None && trial->reason != EndReason::Done;
            response.stopReason = isNamed ? trial->reason : EndReason::Refused;
            response.evidence = trial->reason != EndReason::Done
                ? trial->detail
                : say("the stop was not confirmed by %1", device.selector());
            co_return response;
        }
        const auto point = frequencyPoint(*trial, plant.tau);
        response.points.push_back(point.value_or(FrequencyPoint{hertz})); // nothing above it is to be trusted
        if (!point)
            response.evidence = point.error().message();
        sign = -sign; // back, less far
    }
    if (response.evidence.empty())
        response.evidence = say("to be trusted up to %1 Hz, as far as ten samples a swing and a coherence of 0.9",
            std::round(100.0 * response.trustedUpTo()) / 100.0);
    co_return response;
}

} // namespace mb::tuning
