// SPDX-License-Identifier: GPL-3.0-or-later
// The line: scan, one request in flight, turns, rates near what the wire can carry, acceptance masks.
#include "families/supermodifiedbench.h"

#include <cmath>
#include <cstdio>
#include <map>

namespace mb::supermodified {
namespace {

using namespace std::chrono_literals;
using mb::test::run;
using test::Bench;

TEST(SupermodifiedScan, FindsNodesOfAllDialectsAtTheirRatesWithGetsOnly)
{
    Bench bench;
    bench.add("supermodified:4,dialect=D1,baud=57600");
    bench.add("supermodified:5,dialect=D2,baud=57600");
    bench.add("supermodified:9,dialect=D3,baud=115200");
    bench.add("supermodified:90,dialect=D3,baud=57600");
    bench.add("supermodified:1,dialect=D1,baud=57600"); // the host's own usual id
    std::map<int, std::string> found;
    for (const Identity &row : bench.scanAll())
        found[row.address] = row.dialect + ' ' + row.descriptors.front().second;
    EXPECT_EQ(found,
        (std::map<int, std::string>{
            {1, "D1 57600"}, {4, "D1 57600"}, {5, "D2 57600"}, {9, "D3 115200"}, {90, "D3 57600"}}));
    for (const Frame &frame : bench.framesSent())
        EXPECT_TRUE(isGet(frame.command) && frame.size == 0);
}

TEST(SupermodifiedScan, RowsComeAsTheyAnswerAndTheSecondScanIsFast)
{
    Bench bench;
    bench.add("supermodified:4");
    bench.add("supermodified:5,dialect=D3");
    struct Sink final : ScanSink {
        explicit Sink(Clock &c)
            : clock(c)
        {
        }
        void found(const Identity &) override { times.push_back(clock.now()); }
        void progress(const Message &, int done, int total) override { EXPECT_LE(done, total); }
        Clock &clock;
        std::vector<Instant> times;
    };
    const auto timed = [&](Duration &firstRow) {
        Sink sink(bench.clock);
        const Instant begin = bench.clock.now();
        EXPECT_TRUE(run(bench.clock, scan(bench.host, bench.clock, sink)));
        EXPECT_EQ(sink.times.size(), 2U);
        firstRow = sink.times.empty() ? Duration{} : sink.times.back() - begin;
        return bench.clock.now() - begin;
    };
    Duration rows{};
    const auto keep = Line::of(bench.host, bench.clock); // as open devices do
    const Duration first = timed(rows);
    EXPECT_LT(rows, 500ms) << "both rows, long before the end";
    const Duration second = timed(rows);
    EXPECT_LT(rows, 100ms);
    EXPECT_LT(second, first);
    std::printf("first scan %.1f s, second %.1f s, known rows after %.0f ms\n",
        std::chrono::duration<double>(first).count(), std::chrono::duration<double>(second).count(),
        std::chrono::duration<double>(rows).count() * 1000.0);
}

TEST(SupermodifiedScan, ANodeWhoseFirstAnswerComesTooLateIsAskedAgainInTheSameScan)
{
    Bench bench;
    bench.add("supermodified:4,fault=delay@1:60");
    bench.add("supermodified:5,fault=delay@1:120");
    const auto found = bench.scanAll();
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].address + found[1].address, 9);
}

TEST(SupermodifiedScan, AFixedRateIsTheOnlyOneAsked)
{
    Bench bench("sim:serial?bitrate=9600");
    bench.add("supermodified:4");
    EXPECT_EQ(bench.scanAll().size(), 1U);
    EXPECT_EQ(bench.host.baudrate(), 9600);
}

TEST(SupermodifiedScan, ErrorsInTheQueueAreAskedAgainAndLevelOneIsExplained)
{
    Bench bench;
    Simulator &waiting = bench.add("supermodified:4");
    waiting.disturb("error", 0x43);
    bench.add("supermodified:6,level=1");
    const auto rows = bench.scanAll();
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0].dialect, "D1");
    EXPECT_EQ(rows[1].dialect, "");
    EXPECT_NE(rows[1].detail.english().find("error.level"), std::string::npos) << rows[1].detail;
    const auto device = bench.connect(6);
    EXPECT_EQ(device->mayMove().has_value(), true);
    EXPECT_FALSE(device->command(test::setPoint(Mode::Velocity, 100.0))) << "unknown widths";
    ASSERT_TRUE(run(bench.clock, device->write(Bench::index("error.level"), 0)));
    ASSERT_TRUE(run(bench.clock, device->refresh()));
    EXPECT_EQ(device->identity().dialect, "D1");
}

TEST(SupermodifiedScan, DoesNotChangeTheRateWhileAMotorIsDriven)
{
    Bench bench;
    Simulator &node = bench.add("supermodified:4");
    const auto device = bench.connect(4);
    ASSERT_TRUE(device->command(test::setPoint(Mode::Velocity, 1000.0)));
    bench.clock.advance(300ms);
    Bench::Found sink;
    auto task = scan(bench.host, bench.clock, sink);
    task.start();
    while (!task.isFinished()) {
        ASSERT_TRUE(bench.clock.step());
        ASSERT_EQ(bench.host.baudrate(), 57600);
    }
    EXPECT_TRUE(node.isOutputOn());
    EXPECT_TRUE(device->liveness().heard);
    device->stop();
    bench.clock.advance(50ms);
    EXPECT_FALSE(node.isOutputOn());
}

TEST(SupermodifiedLine, KeepsItsRateWhileAMotorIsDriven)
{
    Bench bench;
    Simulator &driven = bench.add("supermodified:4,baud=57600");
    Simulator &other = bench.add("supermodified:5,baud=9600");
    const auto four = bench.connect(4);
    const auto five = bench.connect(5);
    bench.clock.advance(1s);
    EXPECT_TRUE(four->liveness().heard);
    EXPECT_TRUE(five->liveness().heard);
    ASSERT_TRUE(four->command(test::setPoint(Mode::Velocity, 1000.0)));
    bench.clock.advance(500ms);
    EXPECT_TRUE(driven.isOutputOn());
    bench.clock.advance(2s);
    EXPECT_EQ(bench.host.baudrate(), 57600);
    EXPECT_FALSE(five->liveness().heard) << "nobody asks it meanwhile, and nobody pretends to know";
    (void)five->command(test::setPoint(Mode::Velocity, 1000.0));
    bench.clock.advance(500ms);
    EXPECT_FALSE(other.isOutputOn());
    EXPECT_EQ(five->command(test::setPoint(Mode::Velocity, 900.0)).error().fault, Fault::Unsafe);
    four->stop();
    five->stop();
    bench.clock.advance(2s);
    EXPECT_FALSE(driven.isOutputOn());
    EXPECT_TRUE(five->liveness().heard);
}

TEST(SupermodifiedLine, TheHostLeavesTheGroupOfAMaskAndSaysWhoFollows)
{
    Bench bench;
    Simulator &follower = bench.add("supermodified:4,mask=240");
    bench.add("supermodified:5");
    const auto rows = bench.scanAll();
    const auto keep = Line::of(bench.host, bench.clock);
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_NE(rows[1].detail.english().find("node 4"), std::string::npos) << rows[1].detail;
    EXPECT_TRUE(rows[0].detail.empty()) << rows[0].detail;
    const auto four = bench.connect(4);
    const auto five = bench.connect(5);
    bench.heard.clear();
    bench.clock.advance(500ms);
    for (const Frame &frame : test::framesIn(bench.heard))
        EXPECT_NE(frame.to & 0xF0, 0) << "answers would be acted upon by node 4 (supermodified/README.md#masks)";
    EXPECT_FALSE(follower.isOutputOn());
}

TEST(SupermodifiedLine, NeverHasTwoRequestsInFlight)
{
    Bench bench;
    bench.add("supermodified:4");
    bench.add("supermodified:5,dialect=D3");
    const auto four = bench.connect(4);
    const auto five = bench.connect(5);
    bool waiting = false;
    int pairs = 0;
    const Subscription tap = bench.host.traffic().add([&](const Traffic &traffic) {
        if (traffic.direction == Direction::Sent) {
            EXPECT_FALSE(waiting);
            waiting = true;
        } else if (!test::framesIn({traffic.bytes.begin(), traffic.bytes.end()}).empty()) {
            waiting = false;
            ++pairs;
        }
    });
    for (int i = 0; i < 30; ++i)
        ASSERT_TRUE(run(bench.clock, five->read(Bench::index("gain.p"))));
    bench.clock.advance(2s);
    EXPECT_GT(pairs, 100);
    EXPECT_EQ(bench.host.counters().errors, 0U) << "no collision";
}

TEST(SupermodifiedLine, PollsPositionsAtNinetyPercentOfTheWire)
{
    struct Row {
        int baud;
        std::string_view dialect;
        double limit; ///< of the wire
    };
    for (const Row &row :
        {Row{9600, "D1", 53.0}, Row{57600, "D1", 320.0}, Row{115200, "D1", 640.0}, Row{115200, "D3", 524.0}}) {
        Bench bench("sim:serial?bitrate=" + std::to_string(row.baud));
        bench.add("supermodified:4,dialect=" + std::string(row.dialect));
        const auto device = bench.connect(4);
        const auto position = *device->telemetry()->find("position");
        ASSERT_TRUE(run(bench.clock, device->setRate(position, 10000.0)));
        bench.clock.advance(1s);
        int samples = 0;
        const Subscription tap = device->telemetry()->samples().add(
            [&](const Sample &sample) { samples += sample.channel == position ? 1 : 0; });
        bench.clock.advance(10s);
        const double rate = samples / 10.0;
        std::printf("position %s at %d baud: %.1f samples/s, wire limit %.0f (%.1f %%), besides all slow channels\n",
            std::string(row.dialect).c_str(), row.baud, rate, row.limit, 100.0 * rate / row.limit);
        if (row.baud == 115200) {
            EXPECT_GE(rate, 0.9 * row.limit);
        }
    }
}

TEST(SupermodifiedLine, SharesItselfOutFairlyBetweenNodesAndChannels)
{
    Bench bench("sim:serial?bitrate=19200");
    std::vector<std::unique_ptr<Device>> devices;
    for (int id = 4; id <= 7; ++id) {
        bench.add("supermodified:" + std::to_string(id));
        devices.push_back(bench.connect(id));
    }
    for (const auto &device : devices) {
        ASSERT_TRUE(run(bench.clock, device->setRate(*device->telemetry()->find("position"), 1000.0)));
        ASSERT_TRUE(run(bench.clock, device->setRate(*device->telemetry()->find("current"), 1000.0)));
    }
    bench.clock.advance(2s);
    std::vector<double> rates;
    for (const auto &device : devices) {
        for (const std::string_view key : {"position", "current"})
            rates.push_back(device->telemetry()->rate(*device->telemetry()->find(key), device->clock().now()));
        EXPECT_GT(device->telemetry()->rate(*device->telemetry()->find("analog1"), device->clock().now()), 1.5)
            << "who wants little gets it";
    }
    const auto [least, most] = std::minmax_element(rates.begin(), rates.end());
    EXPECT_GT(*least, 5.0);
    EXPECT_LT(*most, 1.2 * *least);
}

TEST(SupermodifiedLine, ASilentNodeCostsTheOthersLittle)
{
    Bench bench;
    Simulator &dead = bench.add("supermodified:4");
    bench.add("supermodified:5");
    const auto four = bench.connect(4);
    const auto five = bench.connect(5);
    const auto position = *five->telemetry()->find("position");
    ASSERT_TRUE(run(bench.clock, five->setRate(position, 10000.0)));
    bench.clock.advance(3s);
    const double before = five->telemetry()->rate(position, five->clock().now());
    dead.setPowered(false);
    bench.clock.advance(5s);
    EXPECT_FALSE(four->liveness().heard);
    EXPECT_GT(five->telemetry()->rate(position, five->clock().now()), 0.85 * before);
    dead.setPowered(true);
    bench.clock.advance(2s);
    EXPECT_TRUE(four->liveness().heard);
}

TEST(SupermodifiedLine, AStopDoesNotWaitForSomebodySilent)
{
    Bench bench;
    Simulator &moving = bench.add("supermodified:5");
    Simulator &dead = bench.add("supermodified:4");
    const auto four = bench.connect(4);
    const auto five = bench.connect(5);
    ASSERT_TRUE(five->command(test::setPoint(Mode::Velocity, 1000.0)));
    bench.clock.advance(300ms);
    dead.setPowered(false);
    bench.sent.clear();
    ASSERT_TRUE(bench.clock.runUntil(
        [&] {
            const auto frames = bench.framesSent();
            return !frames.empty() && frames.back().to == 4;
        },
        1s));
    bench.clock.advance(1ms);
    five->stop();
    bench.clock.advance(13ms);
    EXPECT_FALSE(moving.isOutputOn());
}

TEST(SupermodifiedLine, APollThatIsLostIsCounted)
{
    Bench bench;
    bench.add("supermodified:4,fault=drop@60,fault=corrupt@70");
    const auto device = bench.connect(4);
    bench.clock.advance(5s);
    std::uint64_t lost = 0;
    device->telemetry()->commit();
    for (std::uint16_t i = 0; i < Bench::family().channels.size(); ++i)
        lost += device->telemetry()->lost(ChannelIndex{i});
    EXPECT_GE(lost, 2U);
    EXPECT_TRUE(device->liveness().heard);
}

TEST(SupermodifiedLine, APollThatIsRefusedIsAskedAgainAndNothingIsLost)
{
    Bench bench;
    Simulator &node = bench.add("supermodified:4");
    const auto device = bench.connect(4);
    bench.clock.advance(1s);
    for (int i = 0; i < 20; ++i) {
        node.disturb("error", 0x43);
        bench.clock.advance(100ms);
    }
    device->telemetry()->commit();
    for (std::uint16_t i = 0; i < Bench::family().channels.size(); ++i)
        EXPECT_EQ(device->telemetry()->lost(ChannelIndex{i}), 0U);
    EXPECT_GT(device->telemetry()->rate(*device->telemetry()->find("position"), device->clock().now()), 18.0);
    EXPECT_EQ(run(bench.clock, device->readFaults())->size(), codeNames().size());
}

TEST(SupermodifiedLine, ASearchAtOtherRatesLosesNoSampleOfWhatIsFound)
{
    mb::test::SimulatedSession bench("sim:serial");
    bench.scan();
    bench.clock.advance(2s);
    int nodes = 0;
    for (Device *device : bench.session.devices()) {
        if (device->family().key != "supermodified")
            continue;
        ++nodes;
        device->telemetry()->commit();
        for (std::uint16_t i = 0; i < device->family().channels.size(); ++i)
            EXPECT_EQ(device->telemetry()->lost(ChannelIndex{i}), 0U)
                << device->selector() << ' ' << device->family().channels[i].key;
    }
    EXPECT_EQ(nodes, 2);
}

TEST(SupermodifiedLine, AnswersAreMeasured)
{
    Bench bench;
    bench.add("supermodified:4");
    const auto device = bench.connect(4);
    bench.clock.advance(1s);
    ASSERT_TRUE(bench.host.roundTrip());
    EXPECT_LT(*bench.host.roundTrip(), 500us);
}

TEST(PollSchedule, GivesTurnsInOrderAndDoesNotMakeUpForMissedOnes)
{
    PollSchedule schedule;
    Instant now{};
    const auto slow = schedule.add(100ms, now);
    const auto fast = schedule.add(10ms, now);
    std::map<PollSchedule::Key, int> turns;
    for (; now < Instant{} + 1s; now += 5ms) {
        while (schedule.nextDue() && *schedule.nextDue() <= now)
            ++turns[schedule.take(now)];
    }
    EXPECT_EQ(turns[slow], 10);
    EXPECT_EQ(turns[fast], 100);
    now += 10s;
    turns.clear();
    while (schedule.nextDue() && *schedule.nextDue() < now)
        ++turns[schedule.take(now)];
    EXPECT_LE(turns[fast], 1);
    schedule.setPeriod(slow, Duration::zero(), now);
    schedule.setPeriod(fast, Duration::zero(), now);
    EXPECT_FALSE(schedule.nextDue());
}

} // namespace
} // namespace mb::supermodified
