// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/derivedsignal.h"
#include "signals.h"

#include <gtest/gtest.h>

namespace mb {
namespace {

using namespace test;

const std::vector<std::string> names{"a", "b", "d5_velocity"};

double once(const char *text, std::vector<double> values)
{
    auto expression = Expression::parse(text, names);
    EXPECT_TRUE(expression) << text << (expression ? "" : expression.error().text());
    return expression ? expression->evaluate(0.0, values) : 0.0;
}

TEST(Expression, KnowsArithmeticAndFunctions)
{
    EXPECT_DOUBLE_EQ(once("a + 2*b", {3, 4}), 11);
    EXPECT_DOUBLE_EQ(once("sqrt(a^2 + b^2)", {3, 4}), 5);
    EXPECT_DOUBLE_EQ(once("d5_velocity * 60 / 4096", {4096}), 60);
    EXPECT_DOUBLE_EQ(once("abs(a) > 2 ? 1 : 0", {-3}), 1);
}

TEST(Expression, UsesOnlyWhatItNames)
{
    const auto expression = Expression::parse("d5_velocity - a + a", names);
    ASSERT_TRUE(expression);
    EXPECT_EQ(expression->used(), (std::vector<std::size_t>{0, 2}));
}

TEST(Expression, DerivativeIsTheChangeASecond)
{
    auto expression = Expression::parse("2 * derivative(a)", names);
    ASSERT_TRUE(expression);
    const auto feed = [&](double time, double value) { return expression->evaluate(time, std::vector{value}); };
    EXPECT_TRUE(std::isnan(feed(0.0, 1)));
    EXPECT_DOUBLE_EQ(feed(0.5, 2), 4);
    EXPECT_DOUBLE_EQ(feed(1.0, 2), 0);
    expression->restart(); // a gap
    EXPECT_TRUE(std::isnan(feed(5.0, 100)));
    EXPECT_DOUBLE_EQ(feed(6.0, 101), 2);
}

TEST(Expression, AverageForgetsWhatIsOlderThanItsTime)
{
    auto expression = Expression::parse("average(a, 0.3)", names);
    ASSERT_TRUE(expression);
    double last = 0.0;
    for (int i = 0; i < 20'000; ++i)
        last = expression->evaluate(i * 0.1, std::vector{i % 3 == 0 ? 3e9 : 0.0});
    EXPECT_NEAR(last, 1e9, 1e-3);
}

TEST(Expression, ValuesThatAreNotFiniteAreAGapForWhatRemembers)
{
    auto expression = Expression::parse("average(1 / a, 0.3)", names);
    ASSERT_TRUE(expression);
    EXPECT_DOUBLE_EQ(expression->evaluate(0.0, std::vector{0.5}), 2.0);
    EXPECT_TRUE(std::isnan(expression->evaluate(0.1, std::vector{0.0})));
    EXPECT_DOUBLE_EQ(expression->evaluate(0.2, std::vector{0.25}), 4.0);
}

TEST(Expression, IntegralAddsTrapezoids)
{
    auto expression = Expression::parse("integral(a)", names);
    ASSERT_TRUE(expression);
    double last = 0.0;
    for (int i = 0; i <= 100; ++i)
        last = expression->evaluate(i * 0.01, std::vector{i * 0.01});
    EXPECT_NEAR(last, 0.5, 1e-12);
}

TEST(Expression, CallsCanStandInsideEachOther)
{
    auto expression = Expression::parse("average(derivative(a * 2), 10) + derivative (b)", names);
    ASSERT_TRUE(expression) << expression.error().text();
    (void)expression->evaluate(0.0, std::vector{0.0, 0.0});
    EXPECT_DOUBLE_EQ(expression->evaluate(1.0, std::vector{1.0, 5.0}), 7.0);
    EXPECT_DOUBLE_EQ(expression->evaluate(2.0, std::vector{3.0, 5.0}), 3.0);
}

TEST(Expression, NothingComesOfAMissingValueOrADivisionByZero)
{
    EXPECT_TRUE(std::isnan(once("1 / a", {0})));
    EXPECT_TRUE(std::isnan(once("a + b", {1, std::nan("")})));
    EXPECT_TRUE(std::isnan(once("ln(a)", {-1})));
}

TEST(Expression, SaysWhatIsWrong)
{
    for (const char *wrong :
        {"", "a +", "a b", "speed", "derivative(a", "derivative(a, 1)", "average(a)", "average(a, 0)", "average(a, b)",
            "average(a, 1, 2)", "average(a, 99999)", "1 + 2", "step__0", "a = 1", "derivative()", "((a)"}) {
        const auto expression = Expression::parse(wrong, names);
        ASSERT_FALSE(expression) << wrong;
        EXPECT_EQ(expression.error().fault, Fault::OutOfRange);
        EXPECT_FALSE(expression.error().text().empty()) << wrong;
    }
    std::string deep = "a";
    for (int i = 0; i < 100; ++i)
        deep = "derivative(" + deep + ")";
    EXPECT_FALSE(Expression::parse(deep, names));
    EXPECT_FALSE(Expression::parse(std::string(10'000, 'a'), names));
}

struct Derived {
    std::shared_ptr<Telemetry> left = telemetry();
    std::shared_ptr<Telemetry> right = telemetry();
    std::unique_ptr<DerivedSignal> signal;

    explicit Derived(const char *text)
    {
        const std::vector<std::string> both{"left", "right"};
        auto expression = Expression::parse(text, both);
        EXPECT_TRUE(expression);
        std::vector<DerivedSignal::Input> inputs;
        for (const std::size_t i : expression->used())
            inputs.push_back({i == 0 ? left : right, velocity});
        signal = std::make_unique<DerivedSignal>("difference", "counts/s", std::move(*expression), inputs);
    }
    std::vector<Point> points()
    {
        (void)signal->advance(1'000'000);
        std::vector<Point> found;
        signal->telemetry()->forEach({0}, ms(0), ms(1'000'000), [&](const Point &point) { found.push_back(point); });
        return found;
    }
};

TEST(DerivedSignal, TakesTheLastValueOfTheOtherAndWaitsUntilItIsKnown)
{
    Derived derived("left - right");
    put(*derived.left, velocity, 10, 100);
    put(*derived.left, velocity, 20, 200);
    EXPECT_TRUE(derived.points().empty()); // the right one may still come
    put(*derived.right, velocity, 5, 1);
    put(*derived.right, velocity, 15, 2);
    ASSERT_EQ(derived.points().size(), 1U);
    put(*derived.right, velocity, 25, 3);
    const auto points = derived.points();
    ASSERT_EQ(points.size(), 2U);
    EXPECT_EQ(points[0].value, 99.0);
    EXPECT_EQ(points[1].value, 198.0);
    EXPECT_EQ(points[1].time, ms(20));
}

TEST(DerivedSignal, AGapOfAnInputIsAGapOfTheResult)
{
    Derived derived("left - right");
    for (int i = 0; i < 10; ++i)
        put(*derived.left, velocity, i * 10, i);
    for (int i = 0; i < 30; ++i) {
        if (i == 10)
            derived.right->lost(velocity, 3);
        if (i < 10 || i >= 20)
            put(*derived.right, velocity, i * 3, 0);
    }
    std::vector<std::int64_t> times;
    int gaps = 0;
    for (const Point &point : derived.points()) {
        gaps += point.isGap() ? 1 : 0;
        if (!point.isGap())
            times.push_back(point.time.time_since_epoch() / 1ms);
    }
    EXPECT_EQ(gaps, 1);
    EXPECT_EQ(times, (std::vector<std::int64_t>{0, 10, 20, 60, 70, 80})); // 27 … 60 is unknown
}

TEST(DerivedSignal, WorksInPiecesAsWellAsAtOnce)
{
    Derived derived("derivative(left)");
    for (int i = 0; i < 1000; ++i)
        put(*derived.left, velocity, i * 10, i * i);
    std::size_t done = 0;
    while (const std::size_t some = derived.signal->advance(37))
        done += some;
    EXPECT_EQ(done, 1000U);
    const auto points = derived.points();
    ASSERT_EQ(points.size(), 999U);
    EXPECT_NEAR(points.back().value, 100.0 * (999 * 999 - 998 * 998), 1e-6);
    EXPECT_EQ(derived.signal->label(), "difference");
}

} // namespace
} // namespace mb
