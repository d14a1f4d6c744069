// SPDX-License-Identifier: GPL-3.0-or-later
// What a proof must do so that its gains stay (docs/tuning-method.md#proof), every limit from both sides.
#include "tuning/proof.h"

#include <gtest/gtest.h>

namespace mb::tuning {
namespace {

Metrics responseOf(double overshoot, std::optional<double> settle, double error = 0.0, double noise = 0.0)
{
    Metrics metrics;
    metrics.rise = 0.05;
    metrics.overshoot = overshoot;
    metrics.settle = settle;
    metrics.sse = error;
    metrics.noise = noise;
    return metrics;
}

bool isKept(const Metrics &measured, const Metrics &predicted, double resting = 0.0)
{
    return judgeProof(measured, predicted, 1000.0, resting).empty();
}

TEST(Proof, OvershootsByFivePointsMoreThanPredictedAtMost)
{
    const Metrics predicted = responseOf(0.01, 0.2);
    EXPECT_TRUE(isKept(responseOf(0.059, 0.2), predicted));
    EXPECT_FALSE(isKept(responseOf(0.061, 0.2), predicted));
    const Metrics lively = responseOf(0.2, 0.2);
    EXPECT_TRUE(isKept(responseOf(0.074, 0.2), lively));
    EXPECT_FALSE(isKept(responseOf(0.076, 0.2), lively)) << "never by more than 7.5 %";
}

TEST(Proof, NoiseMayLookLikeFivePointsOfOvershootAtMost)
{
    const Metrics predicted = responseOf(0.01, 0.2);
    EXPECT_TRUE(isKept(responseOf(0.079, 0.2, 0.0, 0.01), predicted)) << "twice its noise";
    EXPECT_FALSE(isKept(responseOf(0.081, 0.2, 0.0, 0.01), predicted));
    EXPECT_TRUE(isKept(responseOf(0.109, 0.2, 0.0, 0.2), predicted));
    EXPECT_FALSE(isKept(responseOf(0.111, 0.2, 0.0, 0.2), predicted));
}

TEST(Proof, SettlesWithinTwiceThePredictedTimeAndALittleMore)
{
    const Metrics predicted = responseOf(0.01, 0.2);
    EXPECT_TRUE(isKept(responseOf(0.01, 0.549), predicted));
    EXPECT_FALSE(isKept(responseOf(0.01, 0.551), predicted));
    EXPECT_FALSE(isKept(responseOf(0.01, std::nullopt), predicted)) << "it did not settle";
    EXPECT_TRUE(isKept(responseOf(0.01, std::nullopt, 0.0, 0.01), predicted)) << "noise alone leaves the band";
    const Metrics unpredicted = responseOf(0.01, std::nullopt);
    EXPECT_TRUE(isKept(responseOf(0.01, 0.54), unpredicted)) << "eight times its rise";
    EXPECT_FALSE(isKept(responseOf(0.01, 0.56), unpredicted));
}

TEST(Proof, RestsWhereItsLoopCanBringIt)
{
    const Metrics predicted = responseOf(0.01, 0.2);
    for (const double sign : {1.0, -1.0}) {
        EXPECT_TRUE(isKept(responseOf(0.01, 0.2, 0.019 * sign), predicted));
        EXPECT_FALSE(isKept(responseOf(0.01, 0.2, 0.021 * sign), predicted)) << "2 % of the step";
        EXPECT_TRUE(isKept(responseOf(0.01, 0.2, 0.119 * sign), predicted, 100.0));
        EXPECT_FALSE(isKept(responseOf(0.01, 0.2, 0.121 * sign), predicted, 100.0))
            << "friction may hold it 100 counts away";
    }
    EXPECT_EQ(proofLimits(predicted, -1000.0, 100.0).error, 0.12) << "the other way too";
}

TEST(Proof, AResponseThatCouldNotBeMeasuredProvesNothing)
{
    const Metrics predicted = responseOf(0.01, 0.2);
    Metrics measured = predicted;
    measured.rise.reset();
    EXPECT_FALSE(isKept(measured, predicted));
    measured = predicted;
    measured.overshoot.reset();
    EXPECT_FALSE(isKept(measured, predicted));
}

TEST(Proof, AStepStaysWithinTheLimits)
{
    const PlantModel plant{50'000.0, 0.1, 0.0, 0.05};
    Envelope envelope;
    envelope.speed = 100'000.0;
    EXPECT_NEAR(proofStep(Mode::Velocity, plant, {}, envelope), 0.3 * 47'500.0, 1.0) << "of its free speed";
    envelope.duty = 0.25;
    EXPECT_NEAR(proofStep(Mode::Velocity, plant, {}, envelope), 0.3 * 10'000.0, 1.0);
    envelope.speed = 1000.0;
    EXPECT_LE(proofStep(Mode::Velocity, plant, {}, envelope), 700.0) << "room for its overshoot";
    ContinuousGains gains;
    gains.p = 1e-4;
    envelope.travel = 1e6;
    EXPECT_GE(proofStep(Mode::Position, plant, gains, envelope), 400.0) << "or a count would be much of it";
    envelope.travel = 300.0;
    EXPECT_LE(proofStep(Mode::Position, plant, gains, envelope), 210.0);
}

TEST(Proof, AVelocityStepIsClearOfFrictionAsFarAsItsDutyLeavesRoom)
{
    Envelope envelope;
    envelope.duty = 0.25;
    const auto stepOf = [&envelope](double friction) {
        return proofStep(Mode::Velocity, PlantModel{10'000.0, 0.1, 0.0, friction}, {}, envelope);
    };
    EXPECT_NEAR(stepOf(0.05), 0.3 * 2000.0, 1.0);
    EXPECT_NEAR(stepOf(0.1), 0.6 * 1000.0, 1.0) << "its integral would be late";
    EXPECT_NEAR(stepOf(0.15), 0.5 * 1000.0, 1.0) << "or it could not speed up";
    EXPECT_EQ(stepOf(0.3), 0.0);
}

TEST(Proof, AStepThatIsNotThereWhenItsHoldEndsIsNamed)
{
    const Metrics predicted = responseOf(0.01, 0.2);
    Metrics measured;
    measured.sse = 0.38;
    const std::string said = judgeProof(measured, predicted, 1000.0, 0.0).english();
    EXPECT_EQ(said, "it came to 62 % of its step while that was held");
    measured.sse = 0.02;
    EXPECT_EQ(judgeProof(measured, predicted, 1000.0, 0.0).english(), "the response could not be measured");
}

TEST(Proof, ALimitThatNobodyKnowsTakesNothingOfAStep)
{
    const PlantModel plant{50'000.0, 0.1, 0.0, 0.05};
    EXPECT_NEAR(proofStep(Mode::Velocity, plant, {}, {}), 0.3 * 47'500.0, 1.0);
    EXPECT_DOUBLE_EQ(proofStep(Mode::Position, plant, {0.0002}, {}), 0.5 / 0.0002);
}

} // namespace
} // namespace mb::tuning
