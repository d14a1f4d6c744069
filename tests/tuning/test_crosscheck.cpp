// SPDX-License-Identifier: GPL-3.0-or-later
// The second opinion on a lag: of a motor whose position is known exactly, it is exact.
#include "tuning/crosscheck.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mb::tuning {
namespace {

constexpr double crossGain = 120'000.0; ///< counts/s per duty
constexpr double crossFriction = 0.05;

/// A push of a motor with this lag, from standstill, sampled each `spacing` until `end`.
PushRecord crossPush(double duty, double tau, double delay, double growth, double spacing, double end)
{
    PushRecord record;
    record.duty = duty;
    record.growth = growth;
    const double speed = crossGain * (duty - std::copysign(crossFriction, duty));
    for (int i = 0; i * spacing <= end + 1e-9; ++i) {
        const double t = std::max(i * spacing - delay - growth, 0.0);
        record.position.add(i * spacing, speed * (t - tau * (1.0 - std::exp(-t / tau))));
    }
    return record;
}

PushFit crossFit(const std::vector<PushRecord> &records, double tau, double delay)
{
    PushFit fit;
    fit.tau = tau;
    fit.delay = delay;
    for (const PushRecord &record : records)
        fit.speeds.push_back(crossGain * (record.duty - std::copysign(crossFriction, record.duty)));
    return fit;
}

std::optional<double> crossLag(double tau, double spacing, double guessed, double end)
{
    const std::vector records{crossPush(0.4, tau, 0.01, 0.02, spacing, end),
        crossPush(-0.25, tau, 0.01, 0.04, spacing, end), crossPush(0.08, tau, 0.01, 0.0, spacing, end)};
    return lagByRegression(records, crossFit(records, guessed, 0.01));
}

TEST(CrossCheck, IsExactOfAnExactLagWhateverLagWasThought)
{
    // mean speeds over equal times follow each other by e^(-window/lag) exactly, whatever the window is
    EXPECT_NEAR(crossLag(0.2, 0.001, 0.2, 1.0).value_or(0.0), 0.2, 2e-5);
    EXPECT_NEAR(crossLag(0.2, 0.001, 0.4, 1.0).value_or(0.0), 0.2, 2e-5);
    EXPECT_NEAR(crossLag(0.08, 0.001, 0.08, 0.6).value_or(0.0), 0.08, 2e-5);
}

TEST(CrossCheck, SaysNothingBelowThreeAndAHalfOfItsWindows)
{
    // 20 ms at least, or a sample, or a quarter of the lag
    EXPECT_TRUE(crossLag(0.071, 0.001, 0.071, 0.6));
    EXPECT_FALSE(crossLag(0.069, 0.001, 0.069, 0.6));
    EXPECT_TRUE(crossLag(0.176, 0.05, 0.176, 1.2));
    EXPECT_FALSE(crossLag(0.174, 0.05, 0.174, 1.2));
}

TEST(CrossCheck, SaysNothingWhereAMeanSpeedIsOfFewerThanFiftyCounts)
{
    std::vector records{crossPush(0.4, 0.2, 0.01, 0.0, 0.001, 2.0)};
    records.push_back(crossPush(-0.3, 0.2, 0.01, 0.0, 0.001, 2.0));
    records.push_back(crossPush(0.25, 0.2, 0.01, 0.0, 0.001, 2.0));
    PushFit fit = crossFit(records, 0.2, 0.01); // a window of 50 ms
    fit.speeds.back() = 1001.0;
    EXPECT_TRUE(lagByRegression(records, fit));
    fit.speeds.back() = 999.0;
    EXPECT_FALSE(lagByRegression(records, fit));
    fit.speeds.back() = 3000.0;
    records.back().position = {};
    EXPECT_FALSE(lagByRegression(records, fit));
    fit.speeds.pop_back(); // not of these records
    EXPECT_FALSE(lagByRegression(records, fit));
    EXPECT_FALSE(lagByRegression({}, {}));
}

TEST(CrossCheck, AsksForTwelvePairsOfMeanSpeeds)
{
    // windows of 50 ms from 10 ms on: five of them make four pairs
    const auto lagOf = [](double last) {
        const std::vector records{crossPush(0.4, 0.2, 0.01, 0.0, 0.001, 0.27),
            crossPush(-0.25, 0.2, 0.01, 0.0, 0.001, 0.27), crossPush(0.08, 0.2, 0.01, 0.0, 0.001, last)};
        return lagByRegression(records, crossFit(records, 0.2, 0.01));
    };
    EXPECT_TRUE(lagOf(0.27));
    EXPECT_FALSE(lagOf(0.25));
}

TEST(CrossCheck, SaysNothingOfAMotorThatRunsAwayOrSwings)
{
    const auto lagOf = [](double factor) {
        std::vector<PushRecord> records;
        for (const double duty : {0.4, -0.25, 0.08}) {
            PushRecord record;
            record.duty = duty;
            double place = 0.0;
            double speed = crossGain * duty;
            for (int i = 0; i < 9; ++i) {
                record.position.add(0.05 * i, place);
                place += 0.05 * (speed + std::copysign(1000.0, duty));
                speed *= factor;
            }
            records.push_back(record);
        }
        return lagByRegression(records, crossFit(records, 0.2, 0.0));
    };
    EXPECT_NEAR(lagOf(0.5).value_or(0.0), 0.05 / std::log(2.0), 1e-9);
    EXPECT_FALSE(lagOf(1.1));
    EXPECT_FALSE(lagOf(-0.5));
}

} // namespace
} // namespace mb::tuning
