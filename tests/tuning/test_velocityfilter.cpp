// SPDX-License-Identifier: GPL-3.0-or-later
// A velocity that was made of positions in a known way is recognised.
#include "tuning/velocityfilter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mb::tuning {
namespace {

struct MadeVelocity {
    double window = 0.05;
    double late = 0.0;
    double hold = 0.0; ///< s; 0: with each sample
    double period = 0.01;
    int samples = 150;
};

/// A shaft that swings twice a second around 20 000 counts/s, 8000 of it each way.
double swungPlace(double t)
{
    constexpr double omega = 4.0 * 3.14159265358979;
    return 20'000.0 * t - 8000.0 / omega * std::cos(omega * t);
}

std::optional<VelocityFilter> filterOf(const MadeVelocity &made)
{
    Trace position;
    Trace velocity;
    for (int i = 0; i < made.samples; ++i) {
        const double t = i * made.period;
        const double at = (made.hold > 0.0 ? std::floor(t / made.hold + 1e-9) * made.hold : t) - made.late;
        position.add(t, swungPlace(t));
        velocity.add(t, (swungPlace(at) - swungPlace(at - made.window)) / made.window);
    }
    return fingerprint(position, velocity);
}

TEST(VelocityFilter, FindsWindowAndLatenessOfWhatWasMadeOfThePositions)
{
    for (const MadeVelocity &made : {MadeVelocity{0.05, 0.0}, MadeVelocity{0.08, 0.03}, MadeVelocity{0.12, 0.1},
             MadeVelocity{0.3, 0.0, 0.0, 0.01, 200}}) {
        const auto filter = filterOf(made);
        ASSERT_TRUE(filter);
        EXPECT_NEAR(filter->window, made.window, 0.0026) << made.window;
        EXPECT_NEAR(filter->delay, made.window / 2.0 + made.late, 0.0014) << made.window;
        EXPECT_NEAR(filter->hold, made.period, 1e-9);
        EXPECT_EQ(filter->kind, VelocityFilter::Kind::Rolling);
    }
}

TEST(VelocityFilter, LooksForWindowsOfThreeTenthsOfASecondAndATenthOfLatenessAtMost)
{
    EXPECT_NEAR(filterOf({0.34, 0.0, 0.0, 0.01, 200}).value().window, 0.3, 1e-6);
    const VelocityFilter late = filterOf({0.05, 0.14, 0.0, 0.01, 200}).value();
    EXPECT_NEAR(late.delay - late.window / 2.0, 0.1, 1e-6);
}

TEST(VelocityFilter, AWindowOfTwoSamplesOrTenMillisecondsIsNone)
{
    const auto kindOf = [](double window, double spacing, int samples) {
        const auto filter = filterOf({window, 0.0, 0.0, spacing, samples});
        return filter ? filter->kind : VelocityFilter::Kind::Block;
    };
    EXPECT_EQ(kindOf(0.005, 0.001, 600), VelocityFilter::Kind::None);
    EXPECT_EQ(kindOf(0.01, 0.001, 600), VelocityFilter::Kind::None);
    EXPECT_EQ(kindOf(0.0125, 0.001, 600), VelocityFilter::Kind::Rolling);
    EXPECT_EQ(kindOf(0.02, 0.01, 150), VelocityFilter::Kind::None);
    EXPECT_EQ(kindOf(0.03, 0.01, 150), VelocityFilter::Kind::Rolling);
}

TEST(VelocityFilter, WhatIsHeldForThreeFifthsOfItsWindowIsABlock)
{
    const auto kindOf = [](double held) { return filterOf({0.1, 0.0, held}).value().kind; };
    // which it is seen over a little longer for being held
    EXPECT_EQ(kindOf(0.1), VelocityFilter::Kind::Block);
    EXPECT_EQ(kindOf(0.08), VelocityFilter::Kind::Block);
    EXPECT_EQ(kindOf(0.05), VelocityFilter::Kind::Rolling);
    EXPECT_NEAR(filterOf({0.1, 0.0, 0.08}).value().hold, 0.08, 1e-9);
    EXPECT_EQ(filterOf({0.1, 0.0, 0.08, 0.04, 60}).value().kind, VelocityFilter::Kind::Block);
    // told with every sample, it is not held
    EXPECT_EQ(filterOf({0.05, 0.0, 0.0, 0.04, 60}).value().kind, VelocityFilter::Kind::None);
}

TEST(VelocityFilter, AsksForFortySamplesOfEach)
{
    EXPECT_TRUE(filterOf({0.05, 0.0, 0.0, 0.01, 40}));
    EXPECT_FALSE(filterOf({0.05, 0.0, 0.0, 0.01, 39}));
    Trace position;
    Trace velocity;
    for (int i = 0; i < 60; ++i) {
        position.add(i * 0.01, swungPlace(i * 0.01));
        velocity.add(i * 0.01, 20'000.0 + 8000.0 * std::sin(0.1256 * i));
    }
    EXPECT_TRUE(fingerprint(position, velocity));
    EXPECT_FALSE(fingerprint(position.part(0.0, 0.385), velocity));
    EXPECT_FALSE(fingerprint(position, velocity.part(0.0, 0.385)));
    EXPECT_FALSE(fingerprint({}, velocity));
}

TEST(VelocityFilter, SaysNothingOfSpeedsWithinATenthOfEachOther)
{
    const auto tells = [](double low, double high, int first, int last) {
        Trace position;
        Trace velocity;
        double place = 0.0;
        for (int i = 0; i < 100; ++i) {
            const double speed = i < first ? low : i >= 100 - last ? high : 0.5 * (low + high);
            position.add(0.01 * i, place);
            velocity.add(0.01 * i, speed);
            place += 0.01 * speed;
        }
        return fingerprint(position, velocity).has_value();
    };
    EXPECT_TRUE(tells(1000.0, 1120.0, 30, 30));
    EXPECT_FALSE(tells(1000.0, 1110.0, 30, 30));
    EXPECT_TRUE(tells(-1120.0, -1000.0, 30, 30));
    EXPECT_FALSE(tells(-1110.0, -1000.0, 30, 30));
    EXPECT_TRUE(tells(-500.0, 500.0, 30, 30));
    // the slowest and the fastest tenth do not count
    EXPECT_TRUE(tells(100.0, 1000.0, 11, 11));
    EXPECT_FALSE(tells(1.0, 10'000.0, 10, 10));
}

TEST(VelocityFilter, SaysNothingWhereTheTwoWereNeverTakenTogether)
{
    Trace position;
    Trace velocity;
    for (int i = 0; i < 100; ++i) {
        position.add(0.01 * i, swungPlace(0.01 * i));
        velocity.add(10.0 + 0.01 * i, 100.0 * i);
    }
    EXPECT_FALSE(fingerprint(position, velocity));
}

TEST(VelocityFilter, ItsKindsHaveTheNamesOfTheFile)
{
    EXPECT_EQ(toString(VelocityFilter::Kind::None), "none");
    EXPECT_EQ(toString(VelocityFilter::Kind::Rolling), "rolling");
    EXPECT_EQ(toString(VelocityFilter::Kind::Block), "block");
}

} // namespace
} // namespace mb::tuning
