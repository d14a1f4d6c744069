// SPDX-License-Identifier: GPL-3.0-or-later
#include "telemetry/telemetry.h"

#include <gtest/gtest.h>

#include <thread>

namespace {

using namespace mb;
using namespace std::chrono_literals;

constexpr std::array<Channel, 3> channels{{
    {"position", "counts", "Position", Quantity::Position},
    {"velocity", "counts/s", "Velocity", Quantity::Velocity},
    {"current", "A", "Current", Quantity::Current},
}};
static_assert(checkChannels(channels));
static_assert(!checkChannels(std::array<Channel, 2>{{{"a", "", "A"}, {"a", "", "B"}}}));
static_assert(!checkChannels(std::array<Channel, 1>{{{"", "", "A"}}}));
static_assert(!checkChannels(std::array<Channel, 1>{{{"a", "", ""}}}));
static_assert(findChannel(channels, "current") == ChannelIndex{2});
static_assert(!findChannel(channels, "speed"));

constexpr ChannelIndex position{0};
constexpr ChannelIndex velocity{1};
constexpr ChannelIndex current{2};

Instant at(std::int64_t millis)
{
    return Instant(std::chrono::milliseconds(millis));
}

} // namespace

TEST(Telemetry, ShowsReadersASampleAfterTheCommit)
{
    Telemetry telemetry(channels);
    EXPECT_EQ(telemetry.find("velocity"), velocity);
    telemetry.append({position, at(1), 7.0});
    EXPECT_EQ(telemetry.size(position), 0U);
    EXPECT_FALSE(telemetry.last(position));
    ASSERT_TRUE(telemetry.latest(position));
    EXPECT_EQ(telemetry.latest(position)->value, 7.0);
    const std::uint64_t revision = telemetry.revision();
    telemetry.commit();
    EXPECT_GT(telemetry.revision(), revision);
    EXPECT_EQ(telemetry.size(position), 1U);
    EXPECT_EQ(telemetry.last(position)->value, 7.0);
    EXPECT_EQ(telemetry.first(position)->time, at(1));
    EXPECT_EQ(telemetry.at(position, at(5))->value, 7.0);
    EXPECT_FALSE(telemetry.last(velocity));
    EXPECT_FALSE(telemetry.latest(velocity));
}

TEST(Telemetry, DoesNotMoveItsRevisionWithoutNews)
{
    Telemetry telemetry(channels);
    telemetry.commit();
    EXPECT_EQ(telemetry.revision(), 0U);
}

TEST(Telemetry, TellsListenersAtOnce)
{
    Telemetry telemetry(channels);
    std::vector<Sample> heard;
    const auto subscription = telemetry.samples().add([&](const Sample &sample) { heard.push_back(sample); });
    telemetry.append({velocity, at(3), -2.5});
    ASSERT_EQ(heard.size(), 1U);
    EXPECT_EQ(heard[0].channel, velocity);
    EXPECT_EQ(heard[0].time, at(3));
    EXPECT_EQ(heard[0].value, -2.5);
}

TEST(Telemetry, LosesNothingWhenNobodyCommits)
{
    Telemetry telemetry(channels);
    for (int i = 0; i < 100'000; ++i)
        telemetry.append({ChannelIndex{static_cast<std::uint16_t>(i % 3)}, at(i), static_cast<double>(i)});
    telemetry.commit();
    EXPECT_EQ(telemetry.size(position) + telemetry.size(velocity) + telemetry.size(current), 100'000U);
    int expected = 0;
    bool ordered = true;
    telemetry.forEach(position, at(0), at(100'000), [&](const Point &point) {
        ordered = ordered && point.value == expected;
        expected += 3;
    });
    EXPECT_TRUE(ordered);
    EXPECT_EQ(expected, 100'002);
}

TEST(Telemetry, KeepsSamplesAndLossesInTheirOrder)
{
    Telemetry telemetry(channels);
    telemetry.append({position, at(1), 1.0});
    telemetry.lost(position, 3);
    telemetry.append({position, at(5), 2.0});
    telemetry.append({position, at(6), 3.0});
    telemetry.breakLine(position);
    telemetry.append({position, at(9), 4.0});
    telemetry.append({velocity, at(9), 4.0});
    telemetry.commit();
    EXPECT_EQ(telemetry.lost(position), 3U);
    EXPECT_EQ(telemetry.lost(velocity), 0U);
    const auto gaps = telemetry.gaps(position, at(0), at(20));
    ASSERT_EQ(gaps.size(), 2U);
    EXPECT_EQ(gaps[0].from, at(1));
    EXPECT_EQ(gaps[0].to, at(5));
    EXPECT_EQ(gaps[0].lost, 3U);
    EXPECT_EQ(gaps[1].lost, 0U);
    std::vector<Point> points;
    telemetry.columns(position, at(0), at(20), 1000, points);
    ASSERT_EQ(points.size(), 6U);
    EXPECT_TRUE(points[1].isGap());
    EXPECT_TRUE(points[4].isGap());
    ColumnWindow window;
    telemetry.columns(position, at(0), at(20), 1000, window);
    EXPECT_EQ(window.points().size(), 6U);
    std::size_t visited = 0;
    telemetry.forEach(position, at(5), at(20), [&](const Point &) { ++visited; });
    EXPECT_EQ(visited, 4U); // three samples, and the gap between two of them
}

TEST(Telemetry, CountsWhatIsNotANumberAsLost)
{
    Telemetry telemetry(channels);
    int heard = 0;
    const auto subscription = telemetry.samples().add([&](const Sample &) { ++heard; });
    telemetry.append({current, at(1), std::numeric_limits<double>::quiet_NaN()});
    telemetry.commit();
    EXPECT_EQ(heard, 0);
    EXPECT_EQ(telemetry.size(current), 0U);
    EXPECT_EQ(telemetry.lost(current), 1U);
}

TEST(Telemetry, MeasuresTheRateOfEachChannel)
{
    Telemetry telemetry(channels);
    EXPECT_EQ(telemetry.rate(position, at(0)), 0.0);
    for (int i = 0; i <= 300; ++i) {
        telemetry.append({position, at(i * 10), 0.0});
        if (i % 5 == 0)
            telemetry.append({velocity, at(i * 10), 0.0});
        if (i == 20) {
            EXPECT_NEAR(telemetry.rate(position, at(200)), 100.0, 1e-6); // before a whole second has passed
            EXPECT_NEAR(telemetry.rate(velocity, at(200)), 20.0, 1e-6);
        }
    }
    EXPECT_NEAR(telemetry.rate(position, at(3000)), 100.0, 1e-6);
    EXPECT_NEAR(telemetry.rate(velocity, at(3000)), 20.0, 1e-6);
    EXPECT_EQ(telemetry.rate(current, at(3000)), 0.0);
}

TEST(Telemetry, FollowsAChangeOfRateWithinTwoSeconds)
{
    Telemetry telemetry(channels);
    for (int i = 0; i <= 200; ++i)
        telemetry.append({position, at(i * 10), 0.0});
    for (int i = 1; i <= 2000; ++i)
        telemetry.append({position, at(2000 + i), 0.0});
    EXPECT_NEAR(telemetry.rate(position, at(4000)), 1000.0, 1.0);
}

TEST(Telemetry, SaysZeroForAChannelThatFellSilent)
{
    Telemetry telemetry(channels);
    for (int i = 0; i <= 100; ++i) {
        telemetry.append({position, at(i * 100), 0.0});
        if (i <= 50)
            telemetry.append({velocity, at(i * 100), 0.0});
        if (i % 40 == 0)
            telemetry.append({current, at(i * 100), 0.0});
    }
    EXPECT_EQ(telemetry.rate(velocity, at(10'000)), 0.0);
    EXPECT_NEAR(telemetry.rate(current, at(10'000)), 0.25, 1e-6); // slow is not silent
    EXPECT_NEAR(telemetry.rate(position, at(10'000)), 10.0, 1e-6);
    EXPECT_EQ(telemetry.rate(position, at(13'000)), 0.0) << "nor do others go on";
}

TEST(Telemetry, ForgetsRecordingsButNotTheLatestWhenCleared)
{
    Telemetry telemetry(channels);
    telemetry.append({position, at(1), 1.0});
    telemetry.commit();
    const std::uint64_t revision = telemetry.revision();
    telemetry.clear();
    EXPECT_GT(telemetry.revision(), revision);
    EXPECT_EQ(telemetry.size(position), 0U);
    EXPECT_TRUE(telemetry.latest(position));
    EXPECT_FALSE(telemetry.extremes(position, at(0), at(9)));
}

TEST(Telemetry, ForgetsWhatWasMeasuredInAnotherUnit)
{
    static constexpr std::array<Channel, 3> inMilliamperes{
        {channels[0], channels[1], {"current", "mA", "Current", Quantity::Current}}};
    Telemetry telemetry(channels);
    telemetry.append({position, at(1), 1.0});
    telemetry.append({current, at(1), 2.0});
    const std::uint64_t revision = telemetry.revision();
    telemetry.useTable(inMilliamperes);
    EXPECT_GT(telemetry.revision(), revision);
    EXPECT_EQ(telemetry.channels()[current.value].unit, "mA");
    EXPECT_EQ(telemetry.size(position), 1U);
    EXPECT_TRUE(telemetry.latest(position));
    EXPECT_EQ(telemetry.size(current), 0U) << "what waited, too";
    EXPECT_FALSE(telemetry.latest(current));
}

TEST(Telemetry, TellsItsMemory)
{
    Telemetry telemetry(channels);
    const std::size_t empty = telemetry.memoryUse();
    for (int i = 0; i < 100'000; ++i)
        telemetry.append({position, at(i), 1.0});
    telemetry.commit();
    EXPECT_GT(telemetry.memoryUse() - empty, 1'200'000U);
    EXPECT_LE(telemetry.memoryUse() - empty, 1'600'000U);
}

TEST(Telemetry, ThatKeepsNothingDoesNotGrowAndKnowsWhatIsLatestAndLost)
{
    Telemetry telemetry(channels);
    telemetry.keepIn(nullptr);
    int heard = 0;
    const Subscription hearing = telemetry.samples().add([&heard](const Sample &) { ++heard; });
    const std::size_t empty = telemetry.memoryUse();
    for (int i = 1; i <= 1'000'000; ++i) {
        telemetry.append({position, at(i), static_cast<double>(i)});
        if (i % 1000 == 0)
            telemetry.lost(position, 2);
    }
    telemetry.commit();
    EXPECT_EQ(telemetry.memoryUse(), empty);
    EXPECT_EQ(telemetry.size(position), 0U);
    EXPECT_EQ(telemetry.lost(position), 2000U);
    EXPECT_EQ(telemetry.latest(position)->value, 1'000'000.0);
    EXPECT_NEAR(telemetry.rate(position, at(1'000'000)), 1000.0, 1.0);
    EXPECT_EQ(heard, 1'000'000);
}

/// Also a test of the ThreadSanitizer build: one engine, two readers, a user who clears.
TEST(Telemetry, IsReadWhileItIsWritten)
{
    const auto telemetry = std::make_shared<Telemetry>(channels);
    std::atomic<bool> done{false};
    std::atomic<int> torn{0};
    std::vector<std::thread> readers;
    for (int reader = 0; reader < 2; ++reader) {
        readers.emplace_back([&, telemetry] {
            std::vector<Point> points;
            ColumnWindow window;
            std::uint64_t revision = 0;
            for (int round = 0; !done || round == 0; ++round) {
                const std::uint64_t now = telemetry->revision();
                torn += now < revision ? 1 : 0;
                revision = now;
                telemetry->columns(position, at(0), at(30'000), 200, points);
                telemetry->columns(velocity, at(0), at(30'000), 200, window);
                for (const Point &point : points)
                    torn += !point.isGap() && point.time != at(static_cast<std::int64_t>(point.value)) ? 1 : 0;
                telemetry->forEach(position, at(0), at(30'000), [&](const Point &point) {
                    torn += point.time != at(static_cast<std::int64_t>(point.value)) ? 1 : 0;
                });
                torn += telemetry->gaps(position, at(0), at(30'000)).empty() ? 0 : 1;
            }
        });
    }
    for (int i = 0; i < 30'000; ++i) {
        telemetry->append({position, at(i), static_cast<double>(i)});
        telemetry->append({velocity, at(i), static_cast<double>(i)});
        if (i % 64 == 0)
            telemetry->commit();
        if (i == 15'000)
            telemetry->clear();
    }
    telemetry->commit();
    done = true;
    for (auto &reader : readers)
        reader.join();
    EXPECT_EQ(torn, 0);
    EXPECT_LT(telemetry->size(position), 30'000U);
    EXPECT_EQ(telemetry->last(position)->value, 29'999.0);
}
