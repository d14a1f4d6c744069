// SPDX-License-Identifier: GPL-3.0-or-later
// What the search for the gain scales does to a board, run for run (quadquad2drv/README.md#gain-scale).
#include "quadquad2drvboard.h"

#include "families/quadquad2drv/codec.h"
#include "families/quadquad2drv/gainfit.h"
#include "wire/bytes.h"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace mb::quadquad2drv {
namespace {

/// What was ordered of the motor, one row for each motion: the gains that it ran with, its target, and how long it lasted.
class OrderLog {
public:
    explicit OrderLog(Link &link)
        : m_heard(link.traffic().add([this](const Traffic &traffic) {
            if (traffic.direction == Direction::Sent && traffic.bytes.size() > 5)
                take(traffic.bytes, traffic.time);
        }))
    {
    }
    struct Row {
        std::string what; ///< "power", or the loop with its gains
        int target = 0;
        double seconds = 0.0;
    };
    std::vector<Row> rows;

private:
    void take(std::span<const std::uint8_t> packet, Instant time)
    {
        const auto u16 = [packet](std::size_t at) { return std::to_string(readU16le(packet, at)); };
        const auto i32 = [packet](std::size_t at) { return static_cast<std::int32_t>(readU32le(packet, at)); };
        switch (static_cast<PacketId>(packet[2])) {
        case PacketId::SetVelocityGains:
        case PacketId::SetPositionGains: m_gains = u16(4) + ' ' + u16(6) + ' ' + u16(8); break;
        case PacketId::SetPower: order("power", static_cast<std::int16_t>(readU16le(packet, 4)), time); break;
        case PacketId::SetVelocityTarget: order("velocity", i32(4), time); break;
        case PacketId::SetPositionTarget: order("position", i32(4), time); break;
        default: break;
        }
    }
    void order(const std::string &what, std::int32_t target, Instant time)
    {
        if (what == m_what && target == m_target)
            return;
        const bool moved = m_target != 0 && time - m_begun > 300ms;
        if (moved)
            rows.push_back({m_what == "power" ? m_what : m_what + ' ' + m_gains, m_target,
                std::chrono::duration<double>(time - m_begun).count()});
        m_what = what;
        m_target = target;
        m_begun = time;
    }

    std::string m_what;
    std::string m_gains;
    std::int32_t m_target = 0;
    Instant m_begun{};
    Subscription m_heard;
};

/// The numbers of each step that a search goes through.
struct Steps final : Progress {
    void step(const Message &, int done, int total) override { all.emplace_back(done, total); }
    void part(int, PartState) override { }
    void log(Severity, const Message &) override { }
    void mayInterrupt(bool) override { }
    std::vector<std::pair<int, int>> all;
};

/// Four levels of the limit of 2048 both ways; then one gain alone, doubled until it turns the motor by the way that is wanted, and
/// its scale at several gains around what was found. Velocities are 0.8 of what the limit gives, in counts/s.
struct ExpectedRun {
    const char *what;
    int target;
    double seconds;
};
constexpr std::array<ExpectedRun, 69> expectedRuns{{
    {"power", -819, 1.60},
    {"power", 819, 1.20},
    {"power", -1229, 1.60},
    {"power", 1229, 1.60},
    {"power", -1638, 1.60},
    {"power", 1638, 1.60},
    {"power", -2048, 1.60},
    {"power", 2048, 1.60},
    {"velocity 1 0 0", -1202, 0.80},
    {"velocity 2 0 0", 1202, 0.80},
    {"velocity 4 0 0", -1202, 0.80},
    {"velocity 8 0 0", 1202, 0.80},
    {"velocity 16 0 0", -1202, 0.80},
    {"velocity 32 0 0", 1202, 0.80},
    {"velocity 64 0 0", -1202, 0.80},
    {"velocity 128 0 0", 1202, 0.80},
    {"velocity 128 0 0", -1202, 1.80},
    {"velocity 139 0 0", 1202, 1.80},
    {"velocity 139 0 0", -841, 1.80},
    {"velocity 198 0 0", 1202, 1.80},
    {"velocity 198 0 0", -841, 1.80},
    {"velocity 278 0 0", 1202, 1.80},
    {"velocity 278 0 0", -841, 1.80},
    {"velocity 397 0 0", 1202, 1.80},
    {"velocity 397 0 0", -841, 1.80},
    {"velocity 0 1 0", 1202, 1.60},
    {"velocity 0 2 0", -1202, 1.60},
    {"velocity 0 4 0", 1202, 1.60},
    {"velocity 0 8 0", -1202, 1.60},
    {"velocity 0 16 0", 1202, 1.60},
    {"velocity 0 32 0", -1202, 1.60},
    {"velocity 0 64 0", 1202, 1.60},
    {"velocity 0 64 0", -1202, 1.60},
    {"velocity 0 96 0", 1202, 1.60},
    {"velocity 0 128 0", -1202, 1.60},
    {"position 1 0 0", 2094, 1.50},
    {"position 2 0 0", -310, 1.50},
    {"position 4 0 0", 2094, 1.50},
    {"position 8 0 0", -310, 1.50},
    {"position 16 0 0", 2094, 1.50},
    {"position 16 0 0", -4, 1.50},
    {"position 21 0 0", 2094, 1.50},
    {"position 21 0 0", 192, 1.50},
    {"position 27 0 0", 2094, 1.50},
    {"position 27 0 0", 358, 1.50},
    {"position 0 1 0", 3145, 2.00},
    {"position 0 2 0", -1361, 2.00},
    {"position 0 4 0", 3145, 2.00},
    {"position 0 8 0", -1294, 2.00},
    {"position 0 8 0", 2519, 2.00},
    {"position 0 12 0", -1296, 2.00},
    {"position 0 16 0", 1846, 1.77},
    {"position 19 0 0", -498, 0.80},
    {"position 19 0 1", 2049, 0.80},
    {"position 19 0 2", -498, 0.80},
    {"position 19 0 4", 2049, 0.80},
    {"position 19 0 8", -498, 0.80},
    {"position 19 0 16", 2049, 0.80},
    {"position 19 0 32", -496, 0.80},
    {"position 19 0 64", 2047, 0.80},
    {"position 19 0 128", -499, 0.80},
    {"position 19 0 256", 2055, 0.80},
    {"position 19 0 512", -515, 0.80},
    {"position 19 0 1024", 2084, 0.80},
    {"position 19 0 2048", -560, 0.80},
    {"position 19 0 2048", 2150, 1.50},
    {"position 19 0 2048", -384, 1.50},
    {"position 19 0 1536", 2150, 1.50},
    {"position 19 0 1536", -346, 1.50},
}};

TEST(QuadQuad2DrvScaleRuns, AreTheseAndNoOthers)
{
    Board bench("quadquad2drv:0");
    Operation operation(bench.clock, say("scales"));
    OrderLog log(*bench.link);
    const auto report = bench.find(withPower(0.25), operation);
    ASSERT_TRUE(report) << report.error().text();
    ASSERT_EQ(log.rows.size(), expectedRuns.size());
    for (std::size_t i = 0; i < expectedRuns.size(); ++i) {
        EXPECT_EQ(log.rows[i].what, expectedRuns[i].what) << i;
        EXPECT_NEAR(log.rows[i].target, expectedRuns[i].target, 3) << i;
        EXPECT_NEAR(log.rows[i].seconds, expectedRuns[i].seconds, 0.011) << i;
    }
}

TEST(QuadQuad2DrvScaleRuns, GoThroughSixStepsAndTellWhatTheyFound)
{
    Board bench("quadquad2drv:0");
    bench.renew();
    Steps steps;
    const auto report = run(bench.clock, findGainScales(*bench.device, bench.stream(), withPower(0.25), steps), 20min);
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_EQ(steps.all, (std::vector<std::pair<int, int>>{{0, 6}, {1, 6}, {2, 6}, {3, 6}, {4, 6}, {5, 6}, {6, 6}}));
    const std::map<std::string, double> expected{{"velocity.p.scale", 0.009971}, {"velocity.i.scale", 3.551e-05},
        {"position.p.scale", 0.04921}, {"position.i.scale", 9.854e-05}, {"position.d.scale", 0.1959}};
    ASSERT_EQ(report->found.size(), expected.size());
    for (const auto &[key, scale] : report->found)
        EXPECT_NEAR(scale, expected.at(key), 0.0003 * expected.at(key)) << key;
}

// The arithmetic behind them

TEST(QuadQuad2DrvGainFit, StepsMayLieOffTheirLineByATenthOfTheFastest)
{
    const auto withMiddle = [](double off) { // of which two thirds stay behind a line through three points
        return fitPlant({{1000.0, 500.0, 0.1}, {1500.0, 750.0 + off, 0.1}, {2000.0, 1000.0, 0.1}});
    };
    for (const double sign : {1.0, -1.0}) {
        EXPECT_TRUE(withMiddle(sign * 149.0));
        EXPECT_FALSE(withMiddle(sign * 151.0));
    }
}

TEST(QuadQuad2DrvGainFit, StepsThatDidNotMoveAndLinesThatFallTellNothing)
{
    const auto plant = fitPlant({{500.0, 0.0, 9.0}, {600.0, -1.0, 9.0}, {1000.0, 600.0, 0.1}, {2000.0, 1600.0, 0.3}});
    ASSERT_TRUE(plant);
    EXPECT_NEAR(plant->lag, 0.2, 1e-12) << "the mean of those that moved";
    EXPECT_NEAR(plant->gain, 1.0, 1e-12);
    EXPECT_NEAR(plant->speedAt(1400.0), 1000.0, 1e-9);
    EXPECT_FALSE(fitPlant({{1000.0, 600.0, 0.1}, {2000.0, 600.0, 0.1}})) << "more power, the same speed";
    EXPECT_FALSE(fitPlant({{1000.0, 600.0, 0.1}, {1000.0, 700.0, 0.1}})) << "one power";
    EXPECT_EQ(fitPlant({{1000.0, 600.0, -0.1}, {2000.0, 1600.0, -0.3}})->lag, 0.0) << "no motor is ahead of itself";
}

/// A steady motion of a plant without lag: every sample is as good as another.
Track steadyTrack(double speed, int samples)
{
    Track track;
    for (int i = 0; i < samples; ++i) {
        track.seconds.push_back(i / 100.0);
        track.counts.push_back(speed * i / 100.0);
    }
    return track;
}

TEST(QuadQuad2DrvGainFit, TwelveSamplesOfAMotionBelowTheLimitAreNeeded)
{
    const Plant plant{2.0, 300.0, 0.0};
    const auto fit = [&plant](int samples, double speed, double most) {
        const Track track = steadyTrack(speed, samples);
        return fitScale(plant, track, {std::vector<double>(track.size(), 100.0), {}, most});
    };
    ASSERT_TRUE(fit(12, 2000.0, 8191.0));
    EXPECT_EQ(fit(12, 2000.0, 8191.0)->samples, 12);
    EXPECT_NEAR(fit(12, 2000.0, 8191.0)->scale, 13.0, 1e-9) << "1000 for the speed and 300 for the friction";
    EXPECT_FALSE(fit(11, 2000.0, 8191.0));
    EXPECT_TRUE(fit(30, 2000.0, 1300.0 / 0.919)) << "92 % of the limit";
    EXPECT_FALSE(fit(30, 2000.0, 1300.0 / 0.921)) << "the board may have cut the power";
    constexpr double fastest = 2.0 * (8191.0 - 300.0);
    EXPECT_TRUE(fit(30, 0.081 * fastest, 8191.0));
    EXPECT_FALSE(fit(30, 0.079 * fastest, 8191.0)) << "so slowly it may stick";
}

/// Turns from sample to sample of each pair, and stands otherwise.
Track brokenTrack(const std::vector<std::pair<int, int>> &turning, int samples)
{
    Track track;
    double counts = 0.0;
    for (int i = 0; i < samples; ++i) {
        track.seconds.push_back(i / 100.0);
        track.counts.push_back(counts);
        for (const auto &[from, to] : turning)
            counts += i >= from && i < to ? 20.0 : 0.0;
    }
    return track;
}

TEST(QuadQuad2DrvGainFit, TheLongestGoodStretchCountsWhereverItIs)
{
    const Plant plant{2.0, 300.0, 0.0};
    for (const auto &turning : {std::vector<std::pair<int, int>>{{0, 30}, {50, 100}}, {{15, 45}, {60, 110}},
             {{15, 65}, {80, 110}}, {{0, 15}, {30, 80}, {95, 110}}}) {
        const Track track = brokenTrack(turning, 120);
        const auto fit = fitScale(plant, track, {std::vector<double>(track.size(), 100.0), {}, 8191.0});
        ASSERT_TRUE(fit) << fit.error().text();
        EXPECT_NEAR(fit->samples, 50, 6) << turning.front().first << " to " << turning.front().second;
        EXPECT_NEAR(fit->scale, 13.0, 0.4) << "1000 for the speed and 300 for the friction";
        EXPECT_FALSE(fitScale(plant, track, {std::vector<double>(track.size(), 0.0), {}, 8191.0}))
            << "nothing to act on";
    }
}

TEST(QuadQuad2DrvGainFit, ScalesAgreeWithinTheirToleranceAndTheirMeanIsTheResult)
{
    EXPECT_EQ(*agreed({0.75, 1.25}, 0.25), 1.0);
    EXPECT_FALSE(agreed({0.75, 1.25}, 0.2499));
    EXPECT_EQ(*agreed({2.0}, 0.0), 2.0);
    EXPECT_FALSE(agreed({0.0}, 1.0)) << "a gain without effect";
}

} // namespace
} // namespace mb::quadquad2drv
