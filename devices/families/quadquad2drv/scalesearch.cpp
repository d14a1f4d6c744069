// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/scalesearch.h"

#include "families/quadquad2drv/calibrations.h"
#include "families/quadquad2drv/experiments.h"

#include <algorithm>
#include <cmath>

namespace mb::quadquad2drv {
namespace {

constexpr int greatestGain = 65535;
constexpr int phases = 6;
constexpr std::array<double, 4> limitLevels{0.4, 0.6, 0.8, 1.0}; ///< of the power limit
constexpr double sameBothWays = 0.2;
constexpr double proportional = 0.05; ///< spread of a P scale (README.md#gain-scale)
constexpr double integral = 0.1;
constexpr double coarsest = 0.03; ///< of the set-point: with less of it left as error nothing can be measured

int times(int gain, double factor)
{
    return std::clamp(static_cast<int>(std::lround(gain * factor)), 1, greatestGain);
}

/// Four digits.
double rounded(double value)
{
    const double inverse = std::pow(10.0, 3.0 - std::floor(std::log10(value)));
    return std::round(value * inverse) / inverse;
}

} // namespace

ScaleSearch::ScaleSearch(
    Controller &board, SetPointStream &stream, const ExperimentOptions &options, Progress &progress)
    : m_board(board)
    , m_progress(progress)
    , m_trial(board, stream, options, progress)
{
}

Task<ExperimentReport> ScaleSearch::run()
{
    co_await m_trial.prepare();
    co_await measureAll();
    co_await m_trial.finish();
    for (const auto &[key, scale] : m_report.found)
        co_await m_board.knowledge().calibrate(key, scale);
    if (m_trial.leavesStartGains())
        m_report.sentence
            = say("%1; the gains of the axis were not known, and are now those that the board starts with",
                m_report.sentence);
    co_return m_report;
}

Task<void> ScaleSearch::measureAll()
{
    int phase = 0;
    const auto step = [&](const Message &what) { m_progress.step(what, phase++, phases); };
    step(say("turning the motor with several powers"));
    co_await measurePlant();
    step(say("looking for velocity P"));
    m_velocityP = co_await findVelocityP();
    found(calibration::velocityP, m_velocityP);
    step(say("looking for velocity I"));
    auto velocityIs = findVelocityI();
    found(calibration::velocityI, co_await std::move(velocityIs));
    step(say("looking for position P"));
    m_positionP = co_await findPositionP();
    found(calibration::positionP, m_positionP);
    step(say("looking for position I"));
    auto positionIs = findPositionI();
    found(calibration::positionI, co_await std::move(positionIs));
    step(say("looking for position D"));
    if (const std::optional<double> scale = co_await findPositionD(); scale)
        found(calibration::positionD, *scale);
    else
        m_progress.log(
            Severity::Caution, say("position D has no effect that could be measured; its scale stays unknown"));
    m_progress.step(say("putting the settings back"), phases, phases);
    co_return {};
}

void ScaleSearch::found(std::string_view key, double scale)
{
    const double value = rounded(scale);
    m_report.found.emplace_back(key, value);
    const Message one = say("%1 %2", key, value);
    m_report.sentence = m_report.sentence.empty() ? one : say("%1, %2", m_report.sentence, one);
    m_progress.log(Severity::Good, say("%1 is %2", key, value));
}

Task<void> ScaleSearch::measurePlant()
{
    std::vector<PowerStep> steps;
    for (const double level : limitLevels) {
        const PowerStep there = co_await m_trial.powerStep(level * m_trial.mostPower());
        const PowerStep back = co_await m_trial.powerStep(level * m_trial.mostPower());
        const double speed = (there.speed + back.speed) / 2.0;
        tell(say("power %1: %2 and %3 counts/s", std::round(level * m_trial.mostPower()), std::round(there.speed),
            std::round(back.speed)));
        if (std::abs(there.speed - back.speed) > sameBothWays * speed)
            co_return fail(Fault::Refused, say("the motor turns differently in both directions"),
                say("the shaft must be free, without load on one side"));
        steps.push_back({level * m_trial.mostPower(), speed, (there.lag + back.lag) / 2.0});
    }
    const auto plant = co_await fitPlant(steps);
    m_trial.setPlant(plant);
    tell(say("the motor gives %1 counts/s per power unit, friction takes %2 units, it follows within %3 ms",
        rounded(m_trial.plant().gain), std::round(m_trial.plant().friction), std::round(m_trial.plant().lag * 1000.0)));
    co_return {};
}

Task<int> ScaleSearch::firstGain(Run run, std::size_t which, double way)
{
    for (int gain = 1;; gain = std::min(2 * gain, greatestGain)) {
        run.gains[which] = gain;
        const Track track = co_await m_trial.drive(run);
        if (track.way() >= way)
            co_return gain;
        if (gain == greatestGain)
            break;
    }
    if (run.loop != Loop::Velocity)
        co_return fail(Fault::Refused, say("no gain of the position loop turns the motor"));
    co_return fail(Fault::Refused, say("no gain of the velocity loop turns the motor"),
        say("the board may want velocity targets times 4096: choose that setting, and try again"));
}

Task<double> ScaleSearch::velocityP(int gain, double aim)
{
    auto driving = m_trial.drive({Loop::Velocity, {gain, 0, 0}, aim, 1.8, 0.0});
    const Track track = co_await std::move(driving);
    const double speed = track.speed(track.end() - 0.6, track.end());
    const double error = aim - speed;
    if (error < coarsest * aim)
        co_return fail(Fault::Refused, say("the gain scale is too coarse to be measured with so little power"));
    co_return (speed / m_trial.plant().gain + m_trial.plant().friction) / (gain * error);
}

/// P alone, at rest in speed: the power is what the friction and the speed take.
Task<double> ScaleSearch::findVelocityP()
{
    const double aim = 0.8 * m_trial.plant().speedAt(m_trial.mostPower());
    auto first = firstGain({Loop::Velocity, {}, aim, 0.8, 0.0}, 0, 0.15 * aim);
    const int gain = co_await std::move(first);
    const double scale = co_await velocityP(gain, aim);
    const double middle = (0.5 * aim / m_trial.plant().gain + m_trial.plant().friction) / (scale * 0.5 * aim);
    std::vector<double> scales;
    int last = 0;
    for (const double factor : {0.7, 1.0, 1.4, 2.0}) {
        const int next = times(1, middle * factor);
        for (const double part : {1.0, 0.7}) {
            if (next == last)
                continue;
            auto measuring = velocityP(next, part * aim);
            scales.push_back(co_await std::move(measuring));
        }
        last = next;
    }
    co_return agreed(scales, proportional);
}

std::vector<double> ScaleSearch::termsOf(const Run &run, const Track &track, std::size_t which) const
{
    std::vector<double> terms;
    const double gain = run.gains[which];
    double sum = 0.0;
    for (std::size_t i = 0; i < track.size(); ++i) {
        const double before = i == 0 ? 0.0 : track.seconds[i - 1];
        const double start = i == 0 ? 0.0 : track.counts[i - 1];
        const double position = track.counts[i];
        sum += (run.aim - (start + position) / 2.0) * (track.seconds[i] - before);
        double term = 0.0;
        if (run.loop == Loop::Velocity)
            term = (run.aim * track.seconds[i] - position) / loopTime;
        else if (which == 0)
            term = run.aim - position;
        else if (which == 1)
            term = sum / loopTime;
        else
            term = -loopTime * track.speed(track.seconds[i] - 0.04, track.seconds[i] + 0.04);
        terms.push_back(gain * term);
    }
    return terms;
}

Task<double> ScaleSearch::scaleAt(Run run, std::size_t which)
{
    const Track track = co_await m_trial.drive(run);
    Drive power{termsOf(run, track, which), {}, m_trial.mostPower()};
    if (which == 2) {
        power.others = termsOf(run, track, 0);
        for (double &other : power.others)
            other *= m_positionP;
    }
    const auto fit = co_await fitScale(m_trial.plant(), track, power);
    co_return fit.scale;
}

/// The I of a loop alone, at the first gain that goes the way, and at more.
Task<double> ScaleSearch::findIntegral(Run run, double way)
{
    const int gain = co_await firstGain(run, 1, way);
    std::vector<double> scales;
    for (const double factor : {1.0, 1.5, 2.0}) {
        run.gains = {0, times(gain, factor), 0};
        auto measuring = scaleAt(run, 1);
        scales.push_back(co_await std::move(measuring));
    }
    co_return agreed(scales, integral);
}

Task<double> ScaleSearch::findVelocityI()
{
    const double aim = 0.8 * m_trial.plant().speedAt(m_trial.mostPower());
    return findIntegral({Loop::Velocity, {}, aim, 1.6, 0.0}, 0.25 * aim);
}

Task<double> ScaleSearch::findPositionP()
{
    const double aim = 0.8 * m_trial.plant().speedAt(m_trial.mostPower());
    Run run{Loop::Position, {}, aim, 1.5, 0.85 * aim};
    auto first = firstGain(run, 0, 0.15 * aim);
    run.gains[0] = co_await std::move(first);
    const double one = co_await scaleAt(run, 0);
    std::vector<double> scales;
    for (const double part : {0.6, 0.8}) { // of the power at the start
        run.gains[0] = times(1, part * m_trial.mostPower() / (one * aim));
        for (int way = 0; way < 2; ++way) {
            auto measuring = scaleAt(run, 0);
            scales.push_back(co_await std::move(measuring));
        }
    }
    co_return agreed(scales, integral);
}

Task<double> ScaleSearch::findPositionI()
{
    const double aim = 1.5 * m_trial.plant().speedAt(m_trial.mostPower());
    return findIntegral({Loop::Position, {}, aim, 2.0, 0.6 * aim}, 0.15 * aim);
}

/// Beside a P that is known: D brakes.
Task<std::optional<double>> ScaleSearch::findPositionD()
{
    const double aim = m_trial.plant().speedAt(m_trial.mostPower());
    const int p = times(1, 0.7 * m_trial.mostPower() / (m_positionP * aim));
    Run run{Loop::Position, {p, 0, 0}, aim, 0.8, 0.0};
    const Track free = co_await m_trial.drive(run);
    for (int gain = 1;; gain = std::min(2 * gain, greatestGain)) {
        run.gains[2] = gain;
        const Track braked = co_await m_trial.drive(run);
        if (braked.way() <= 0.65 * free.way())
            break;
        if (gain == greatestGain)
            co_return std::optional<double>();
    }
    std::vector<double> scales;
    run.seconds = 1.5;
    const int gain = run.gains[2];
    for (const double factor : {1.0, 0.75}) {
        run.gains[2] = times(gain, factor);
        for (int way = 0; way < 2; ++way) {
            auto measuring = scaleAt(run, 2);
            scales.push_back(co_await std::move(measuring));
        }
    }
    const auto mean = co_await agreed(scales, 2.0 * integral);
    co_return std::optional<double>(mean);
}

Task<ExperimentReport> findGainScales(
    Device &device, SetPointStream &stream, ExperimentOptions options, Progress &progress)
{
    if (options.axis < 1 || options.axis > axes || !(options.power > 0.0) || options.power > 1.0)
        co_return fail(Fault::OutOfRange, say("an axis from 1 to 4 and a power limit above 0 are needed"));
    ScaleSearch search(static_cast<Controller &>(device), stream, options, progress);
    const ExperimentReport report = co_await search.run();
    co_return report;
}

} // namespace mb::quadquad2drv
