// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/looppass.h"

#include "model/family.h"

#include <algorithm>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr double mostOfRise = 0.9; ///< of the step: what rests tells the same again and again
constexpr std::size_t leastGaps = 10;
constexpr std::size_t shareOfShort = 4; ///< that are taken for one pass
constexpr double halfAGap = 0.5;        ///< either side of the usual
constexpr double tolerance = 0.15;
constexpr double finest = 0.6; ///< of a pass, that samples may be apart

/// Times between changes of the velocity from an edge on until most of its way is done.
void addGaps(const Trace &velocity, double target, std::vector<double> &gaps)
{
    if (velocity.isEmpty())
        return;
    const double way = target - velocity.y.front();
    std::optional<double> last;
    for (std::size_t i = 1; i < velocity.size(); ++i) {
        if (velocity.y[i] == velocity.y[i - 1])
            continue;
        if (last)
            gaps.push_back(velocity.t[i] - *last);
        last = velocity.t[i];
        if (std::abs(velocity.y[i] - velocity.y.front()) > mostOfRise * std::abs(way))
            break;
    }
}

double inTenths(double seconds)
{
    return std::round(seconds * 1e4) / 10.0;
}

} // namespace

std::optional<double> passOf(const Trial &trial)
{
    const Signal *const velocity = trial.signal("velocity");
    std::vector<double> gaps;
    for (const Span &hold : trial.holds) {
        if (velocity)
            addGaps(velocity->trace.part(hold.from, hold.to), trial.stimulus.to, gaps);
    }
    for (const Span &back : trial.returns) {
        if (velocity)
            addGaps(velocity->trace.part(back.from, back.to), trial.stimulus.from, gaps);
    }
    if (gaps.size() < leastGaps)
        return std::nullopt;
    std::ranges::sort(gaps);
    const double usual = gaps[gaps.size() / shareOfShort]; // half of all may be longer ones
    double sum = 0.0;
    std::size_t count = 0;
    for (const double gap : gaps) { // a sample that was lost, or a pass that told the same, makes a longer one
        if (std::abs(gap - usual) <= halfAGap * usual * (1.0 + 1e-6)) {
            sum += gap;
            ++count;
        }
    }
    return count >= leastGaps ? std::optional(sum / static_cast<double>(count)) : std::nullopt;
}

std::optional<Gate> passGate(const Family &family, const Trial &trial)
{
    if (trial.mode != Mode::Velocity || !family.loop || family.loop->velocityWindow <= 0.0
        || family.loop->velocityWindow != family.loop->cycle)
        return std::nullopt;
    const double expected = family.loop->cycle;
    const Signal *const velocity = trial.signal("velocity");
    if (!velocity || samplePeriod(velocity->trace) > finest * expected)
        return std::nullopt; // samples come no more often than the passes
    const auto pass = passOf(trial);
    if (!pass)
        return std::nullopt;
    return Gate{"period",
        say("its loop takes its velocity every %1 ms, every %2 ms was expected", inTenths(*pass), inTenths(expected)),
        std::abs(*pass - expected) <= tolerance * expected, say("see which firmware it runs")};
}

} // namespace mb::tuning
