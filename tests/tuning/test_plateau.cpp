// SPDX-License-Identifier: GPL-3.0-or-later
// A loop that should rest and does not, where its own velocity hardly shows it.
#include "tests/tuning/matrix/matrixrow.h"
#include "tuning/plateau.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace mb::test {
namespace {

using namespace tuning;

constexpr double step = 2000.0;
constexpr double seconds = 2.0;

/// A response that is there after 0.1 s, with an edge of its count now and then, and a swing of 36 Hz of this amplitude that grows.
Trace response(double swing)
{
    Trace trace;
    for (int i = 0; i < 200; ++i) {
        const double t = i * 0.01;
        const double count = (i % 3 == 0 ? 0.02 : -0.01) * step;
        const double swings = swing * step * std::min(t, 1.0) * std::sin(2.0 * std::numbers::pi * 36.0 * t);
        trace.add(t, t < 0.1 ? step * t / 0.1 : step + count + swings);
    }
    return trace;
}

Trial trialOf(Trace measured)
{
    Trial trial;
    trial.mode = Mode::Velocity;
    trial.stimulus.to = step;
    trial.holds.push_back({0.0, seconds});
    trial.signals.push_back({"velocity", "counts/s", std::move(measured)});
    return trial;
}

Prediction predictedBy(Trace measured, double edges)
{
    Prediction predicted;
    predicted.measured = std::move(measured);
    predicted.shape.windowCounts = edges;
    return predicted;
}

TEST(Plateau, ASwingBesideTheCountsIsNamed)
{
    const Prediction predicted = predictedBy(response(0.0), 32.0);
    EXPECT_NEAR(swingOf(predicted, step), 0.014, 0.001);
    EXPECT_TRUE(judgeRest(swingOf(trialOf(response(0.0))), predicted, step).empty());
    EXPECT_TRUE(judgeRest(swingOf(trialOf(response(0.01))), predicted, step).empty());
    const Message wrong = judgeRest(swingOf(trialOf(response(0.05))), predicted, step);
    EXPECT_NE(wrong.english().find("goes on swinging"), std::string::npos) << wrong;
    const Prediction averaged = predictedBy(response(0.0), 0.0); // 100 ms of it hide no edges, but noise is more there
    EXPECT_TRUE(judgeRest(swingOf(trialOf(response(0.03))), averaged, step).empty());
    EXPECT_FALSE(judgeRest(swingOf(trialOf(response(0.08))), averaged, step).empty());
}

/// Friction has kept it waiting for its integral.
TEST(Plateau, AMotorThatSetsOutLateSwingsNoMoreThanOneThatDoesNot)
{
    Trace late;
    for (int i = 0; i < 200; ++i) {
        const double t = i * 0.01;
        late.add(t, step * std::clamp((t - 0.9) / 0.4, 0.0, 1.0));
    }
    EXPECT_LT(swingOf(predictedBy(late, 124.0), step), 0.015);
    EXPECT_LT(swingOf(trialOf(late)), 0.015);
    for (std::size_t i = 0; i < late.size(); ++i)
        late.y[i] += late.t[i] < 1.3 ? 0.0 : 0.2 * step * std::sin(60.0 * late.t[i]);
    EXPECT_GT(swingOf(trialOf(late)), 0.1) << "what goes on swinging does not settle";
}

TEST(Plateau, SettlesInABandThatIsWiderThanACount)
{
    EXPECT_NEAR(settledWidely(response(0.0), step).value_or(0.0), 0.095, 0.01);
    EXPECT_NEAR(settledWidely(std::vector{trialOf(response(0.0))}).value_or(0.0), 0.095, 0.01);
    EXPECT_GT(settledWidely(response(0.2), step).value_or(seconds), 1.9);
    Trace rising;
    rising.add(0.0, 0.0);
    rising.add(1.0, 0.9 * step);
    EXPECT_FALSE(settledWidely(rising, step));
}

/// A CIM whose sensor stands on the other side of a play of 11° than its load: it swings at its shaft by 15 % and more of the step,
/// for as long as it is driven, with gains that would be good without the play.
TEST(Plateau, AMotorThatSwingsInItsPlayIsNotLeftSwinging)
{
    for (const double rate : {0.0, 50.0}) {
        const MatrixRow row = tuneCell(cellOf("quadquad2drv", "cim", Mode::Velocity, 4, rate), Compare::Kept);
        std::printf("  %s, %s\n", row.result.c_str(), row.reason.c_str());
        EXPECT_TRUE(row.stopped);
        if (row.result != "kept") {
            EXPECT_NE(row.reason.find("swinging"), std::string::npos) << row.reason;
            continue;
        }
        ASSERT_TRUE(row.kept);
        EXPECT_TRUE(row.kept->isStable) << textOf(row);
        EXPECT_LE(row.kept->overshoot, 0.075) << textOf(row);
    }
}

TEST(Plateau, APositionThatSwingsBetweenItsSamplesDoesNotSettle)
{
    Trial trial = trialOf(Trace());
    trial.mode = Mode::Position;
    trial.signals = {{"position", "counts", {}}};
    Trace &place = trial.signals.front().trace;
    for (int i = 0; i < 200; ++i)
        place.add(i * 0.01, step + (i % 2));
    EXPECT_TRUE(judgePlace(trial, 2.0).empty());
    for (std::size_t i = 0; i < place.size(); ++i)
        place.y[i] = step + 13.0 * std::sin(2.0 * static_cast<double>(i));
    EXPECT_FALSE(judgePlace(trial, 2.0).empty());
}

/// The rotor of a 775pro swings in a play of four counts before its load, every 5 ms: its steps do not come to rest, and heat it.
TEST(Plateau, ARotorThatSwingsBeforeItsLoadIsTriedWithLessD)
{
    const MatrixRow row = tuneCell(cellOf("supermodified", "775pro", Mode::Position, 4, 0.0, "D1"), Compare::Kept);
    std::printf("  %s, %s\n", row.result.c_str(), row.reason.c_str());
    ASSERT_EQ(row.result, "kept");
    ASSERT_TRUE(row.kept);
    EXPECT_LE(row.kept->overshoot, 0.075) << textOf(row);
    EXPECT_LE(row.kept->itae, 0.001) << textOf(row);
}

TEST(Plateau, AMotorThatRestsKeepsTheGainsThatWereAskedFor)
{
    for (const char *const motor : {"rs775", "25d", "n20"}) {
        const MatrixRow row = tuneCell(cellOf("quadquad2drv", motor, Mode::Velocity, 1, 0.0), Compare::Nothing);
        EXPECT_EQ(row.result, "kept") << textOf(row);
        EXPECT_EQ(row.reason.find("did not"), std::string::npos) << row.reason;
    }
}

} // namespace
} // namespace mb::test
