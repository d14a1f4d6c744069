// SPDX-License-Identifier: GPL-3.0-or-later
// Lines and parabolas through samples: curve where the samples are those of one.
#include "experiment/localfit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mb::tuning {
namespace {

constexpr double curveA = 3.0;
constexpr double curveB = -2.0;
constexpr double curveC = 0.7;

/// Of a parabola around t = 5, one sample each 0.1 s from 0 to 10 s.
Trace sampledCurve()
{
    Trace trace;
    for (int i = 0; i <= 100; ++i) {
        const double x = 0.1 * i - 5.0;
        trace.add(0.1 * i, curveA + curveB * x + curveC * x * x);
    }
    return trace;
}

TEST(LocalFit, ALineIsExactAndLevelWhereAllIsAtOnePlace)
{
    const Line line = fitLine({1.0, 2.0, 4.0}, {5.0, 3.0, -1.0});
    EXPECT_NEAR(line.slope, -2.0, 1e-12);
    EXPECT_NEAR(line.offset, 7.0, 1e-12);
    EXPECT_NEAR(line.at(10.0), -13.0, 1e-12);
    const Line scattered = fitLine({0.0, 1.0, 2.0}, {0.0, 3.0, 3.0}); // Σ(x−1)(y−2)/Σ(x−1)² = 3/2
    EXPECT_NEAR(scattered.slope, 1.5, 1e-12);
    EXPECT_NEAR(scattered.offset, 0.5, 1e-12);
    const Line level = fitLine({2.0, 2.0, 2.0}, {1.0, 2.0, 6.0});
    EXPECT_EQ(level.slope, 0.0);
    EXPECT_NEAR(level.offset, 3.0, 1e-12);
    EXPECT_EQ(fitLine({}, {}).offset, 0.0);
}

TEST(LocalFit, AParabolaIsExactOfOneWhateverItsWidth)
{
    for (const double half : {0.15, 0.5, 3.0}) {
        for (const double shift : {0.0, 1.0, -2.03}) {
            const auto fit = fitParabola(sampledCurve(), 5.0 + shift, half, 0);
            ASSERT_TRUE(fit);
            EXPECT_NEAR(fit->a, curveA + curveB * shift + curveC * shift * shift, 1e-9);
            EXPECT_NEAR(fit->b, curveB + 2.0 * curveC * shift, 1e-8);
            EXPECT_NEAR(fit->c, curveC, 1e-7);
        }
    }
}

TEST(LocalFit, AParabolaIsTheLeastSquaresOne)
{
    // five samples that are level but for the middle: a = 17/35, c = −1/7 of it, by the polynomials orthogonal on −2…2
    Trace trace;
    for (int i = -2; i <= 2; ++i)
        trace.add(i, i == 0 ? 1.0 : 0.0);
    const auto fit = fitParabola(trace, 0.0, 2.0, 0);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->a, 17.0 / 35.0, 1e-12);
    EXPECT_NEAR(fit->b, 0.0, 1e-12);
    EXPECT_NEAR(fit->c, -1.0 / 7.0, 1e-12);
    trace.y = {0.0, 0.0, 0.0, 1.0, 0.0}; // b = 1/10
    EXPECT_NEAR(fitParabola(trace, 0.0, 2.0, 0)->b, 0.1, 1e-12);
    EXPECT_NEAR(fitParabola(trace, 0.0, 2.0, 0)->a, 12.0 / 35.0, 1e-12);
    EXPECT_NEAR(fitParabola(trace, 0.0, 2.0, 0)->c, -1.0 / 14.0, 1e-12);
}

TEST(LocalFit, AParabolaWantsThreeSamplesAtPlacesOfTheirOwn)
{
    Trace trace;
    trace.add(0.0, 1.0);
    trace.add(1.0, 2.0);
    EXPECT_FALSE(fitParabola(trace, 0.5, 1.0, 0));
    trace.add(1.0, 4.0);
    EXPECT_FALSE(fitParabola(trace, 0.5, 1.0, 0));
    trace.add(1.5, 4.0);
    EXPECT_TRUE(fitParabola(trace, 0.5, 1.0, 0)) << "the last is within its half width";
    EXPECT_FALSE(fitParabola(trace, 0.5, 0.99, 0));
    EXPECT_FALSE(fitParabola(trace, 0.5, 1.0, 1)) << "the first does not count";
}

TEST(LocalFit, SmoothingTakesNoiseOutAndLooksAtNothingBeforeItsBeginning)
{
    Trace trace = sampledCurve();
    for (int i = 0; i < 50; ++i)
        trace.y[static_cast<std::size_t>(i)] = -1000.0; // before a step
    const std::vector<double> kept = smoothed(trace, 50, 0.5);
    const Trace curve = sampledCurve();
    for (std::size_t i = 0; i < 101; ++i)
        EXPECT_NEAR(kept[i], i < 50 ? -1000.0 : curve.y[i], 1e-9) << i;
    Trace noisy;
    for (int i = 0; i < 41; ++i)
        noisy.add(0.1 * i, i % 2 == 0 ? 1.0 : -1.0);
    EXPECT_LT(std::abs(smoothed(noisy, 0, 1.0).at(20)), 0.15);
}

TEST(LocalFit, TheTopOfACurveLiesBetweenItsSamples)
{
    Trace trace;
    for (int i = 0; i < 21; ++i) {
        const double x = 0.1 * i - 1.03;
        trace.add(0.1 * i, 5.0 - 2.0 * x * x);
    }
    EXPECT_NEAR(vertexNear(trace, 10, 0, 0.25).value_or(0.0), 5.0, 1e-9);
    EXPECT_FALSE(vertexNear(trace, 4, 0, 0.25)) << "it is not within reach";
    for (double &y : trace.y)
        y = -y;
    EXPECT_FALSE(vertexNear(trace, 10, 0, 0.25)) << "a valley";
}

TEST(LocalFit, ATopNoFartherAboveItsSamplesThanTheyLieApartIsOne)
{
    // samples of several runs upon each other: a curve through them goes anywhere
    Trace trace;
    trace.add(1.0, 0.0);
    trace.add(1.001, 1.0);
    trace.add(1.1, 0.9);
    trace.add(1.1001, 0.0);
    EXPECT_FALSE(vertexNear(trace, 1, 0, 0.2));
    Trace flat;
    flat.add(-1.0, 0.0);
    flat.add(0.0, 1.0);
    flat.add(1.0, 0.99);
    // through (−1, 0), (0, 1), (1, 0.99): c = −0.505, b = 0.495: top 1 + b²/4/0.505
    EXPECT_NEAR(vertexNear(flat, 1, 0, 1.0).value_or(0.0), 1.0 + 0.495 * 0.495 / (4.0 * 0.505), 1e-9);
    flat.add(1.1, 50.0); // beyond its reach
    EXPECT_TRUE(vertexNear(flat, 1, 0, 1.0));
}

/// Of a slow and noisy response, which is smoothed over a share of its length.
Trace longHold(std::size_t samples)
{
    Trace trace;
    for (std::size_t i = 0; i < samples; ++i) {
        const double time = 1e-3 * static_cast<double>(i);
        trace.add(time, 1.0 - std::exp(-3.0 * time) + 0.05 * std::sin(static_cast<double>(i * i % 97)));
    }
    return trace;
}

TEST(LocalFit, AMovingParabolaLooksAtASampleOfALongHoldAFewTimesHoweverWideItIs)
{
    for (const std::size_t samples : {4'000U, 40'000U}) {
        const Trace hold = longHold(samples);
        MovingParabola moving(hold, 0.3 * hold.t.back(), 0);
        for (const double time : hold.t)
            (void)moving.fit(time);
        EXPECT_LE(moving.looks(), 4 * samples);
    }
}

TEST(LocalFit, AMovingParabolaIsTheOneThatIsFittedAlone)
{
    const Trace hold = longHold(5'000);
    for (const double half : {0.05, 0.2, 1.4}) {
        MovingParabola moving(hold, half, 100);
        for (std::size_t i = 100; i < hold.size(); i += i % 7 == 0 ? 13 : 1) {
            const auto moved = moving.fit(hold.t[i]);
            const auto alone = fitParabola(hold, hold.t[i], half, 100);
            ASSERT_TRUE(moved && alone);
            ASSERT_NEAR(moved->a, alone->a, 1e-9);
            ASSERT_NEAR(moved->b, alone->b, 1e-7);
            ASSERT_NEAR(moved->c, alone->c, 1e-6);
        }
    }
}

} // namespace
} // namespace mb::tuning
