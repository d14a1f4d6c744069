// SPDX-License-Identifier: GPL-3.0-or-later
// Scans that remember an earlier run, and those that leave nothing out.
#include "families/supermodifiedbench.h"

#include <cstdio>

namespace mb::supermodified {
namespace {

using namespace std::chrono_literals;
using mb::test::run;
using test::Bench;

/// A bench of a new run of the program: nothing is known but what `known` tells.
struct ProgramRun {
    explicit ProgramRun(std::initializer_list<const char *> units)
    {
        for (const char *unit : units)
            bench.add(unit);
    }
    std::vector<Identity> scan(std::vector<Identity> known, ScanExtent extent = ScanExtent::Quick)
    {
        const Instant begin = bench.clock.now();
        auto rows = bench.scanAll(std::move(known), extent);
        took = bench.clock.now() - begin;
        return rows;
    }
    [[nodiscard]] double seconds() const { return std::chrono::duration<double>(took).count(); }

    Bench bench;
    Duration took{};
};

std::vector<int> idsOf(const std::vector<Identity> &rows)
{
    std::vector<int> ids;
    for (const Identity &row : rows)
        ids.push_back(row.address);
    return ids;
}

TEST(SupermodifiedMemory, TheFirstScanOfANewRunIsFarShorterWithIt)
{
    for (const std::string rate : {"57600", "38400", "9600"}) {
        const std::string one = "supermodified:4,baud=" + rate;
        const std::string other = "supermodified:90,dialect=D3,baud=" + rate;
        ProgramRun first{one.c_str(), other.c_str()};
        const auto known = first.scan({});
        ASSERT_EQ(idsOf(known), (std::vector<int>{4, 90}));
        ProgramRun second{one.c_str(), other.c_str()};
        EXPECT_EQ(idsOf(second.scan(known)), (std::vector<int>{4, 90}));
        EXPECT_LT(second.took, first.took / 5);
        std::printf("nodes at %s bit/s: first scan %.2f s, after a restart of the program %.2f s\n", rate.c_str(),
            first.seconds(), second.seconds());
    }
}

TEST(SupermodifiedMemory, WhoWentIsNotFoundAndWhoCameIs)
{
    ProgramRun first{"supermodified:4", "supermodified:5"};
    const auto known = first.scan({});
    ProgramRun second{"supermodified:5", "supermodified:6", "supermodified:77"};
    EXPECT_EQ(idsOf(second.scan(known)), (std::vector<int>{5, 6, 77}));
    EXPECT_FALSE(second.bench.host.kept<Roster>().nodes().contains(4));
    ProgramRun moved{"supermodified:4,baud=115200"};
    const auto rows = moved.scan(known);
    ASSERT_EQ(idsOf(rows), (std::vector<int>{4})) << "at another rate now";
    EXPECT_EQ(rows.front().descriptors.front().second, "115200");
}

TEST(SupermodifiedMemory, WhoCannotBeAskedAtAFixedRateIsForgotten)
{
    const auto known = ProgramRun{"supermodified:4,mask=240"}.scan({});
    ASSERT_EQ(idsOf(known), (std::vector<int>{4}));
    Bench fixed("sim:serial?bitrate=9600");
    fixed.add("supermodified:77");
    EXPECT_EQ(idsOf(fixed.scanAll(known)), (std::vector<int>{77}));
    EXPECT_FALSE(fixed.host.kept<Roster>().nodes().contains(4)) << "its group is nothing to keep out of";
}

TEST(SupermodifiedMemory, AnUnusualNewcomerIsFoundOnceSomebodyAsks)
{
    ProgramRun first{"supermodified:4"};
    const auto known = first.scan({});
    ProgramRun second{"supermodified:4", "supermodified:9", "supermodified:77"};
    EXPECT_EQ(idsOf(second.scan(known)), (std::vector<int>{4, 9})) << "all who are known answered";
    EXPECT_EQ(idsOf(second.scan(known, ScanExtent::Usual)), (std::vector<int>{4, 9, 77}));
}

TEST(SupermodifiedMemory, OneNodeIsReachedAtOnceAtItsRate)
{
    ProgramRun first{"supermodified:4,baud=38400"};
    const auto known = first.scan({});
    ProgramRun second{"supermodified:4,baud=38400"};
    Bench::Found sink;
    sink.known = known;
    const Instant begin = second.bench.clock.now();
    ASSERT_TRUE(run(second.bench.clock, probe(second.bench.host, second.bench.clock, 4, sink)));
    EXPECT_EQ(idsOf(sink.rows), (std::vector<int>{4}));
    EXPECT_LT(second.bench.clock.now() - begin, 600ms) << "with what eleven usual others leave unanswered three times";
}

TEST(SupermodifiedMemory, TheHostKeepsOutOfARememberedGroupFromTheFirstFrameOn)
{
    ProgramRun first{"supermodified:4,mask=240"};
    const auto known = first.scan({});
    ASSERT_EQ(idsOf(known), (std::vector<int>{4}));
    ProgramRun second{"supermodified:4,mask=240"};
    (void)second.scan(known);
    for (const Frame &frame : second.bench.framesSent())
        EXPECT_NE(frame.from & 0xF0, 0x00) << "supermodified/README.md#masks";
}

TEST(SupermodifiedMemory, TheFirstAndTheLastNodeAreRememberedAtTheirRates)
{
    ProgramRun first{"supermodified:1,baud=600", "supermodified:127,baud=115200"};
    const auto known = first.scan({}, ScanExtent::Everything);
    ASSERT_EQ(known.size(), 2U);
    ProgramRun again{"supermodified:1,baud=600", "supermodified:127,baud=115200"};
    EXPECT_EQ(again.scan(known).size(), 2U) << "a quick scan looks there first";
}

TEST(SupermodifiedMemory, NonsenseCostsTimeOnly)
{
    std::vector<Identity> known(4);
    known[0].address = 0;
    known[1].address = 300;
    known[2].address = 7;
    known[2].descriptors = {{"baud", "-3"}, {"mask", "x"}};
    known[3].address = 8;
    known[3].descriptors = {{"baud", "123456789"}};
    ProgramRun again{"supermodified:4"};
    EXPECT_EQ(idsOf(again.scan(known)), (std::vector<int>{4}));
}

TEST(SupermodifiedSearch, EverythingFindsIdsAndRatesThatAQuickScanLeavesOut)
{
    const std::initializer_list<const char *> units{
        "supermodified:4", "supermodified:100,baud=9600", "supermodified:33,baud=2400"};
    ProgramRun quick(units);
    EXPECT_EQ(idsOf(quick.scan({})), (std::vector<int>{4}));
    ProgramRun whole(units);
    EXPECT_EQ(idsOf(whole.scan({}, ScanExtent::Everything)), (std::vector<int>{4, 100, 33}));
    for (const Frame &frame : whole.bench.framesSent())
        EXPECT_TRUE(isGet(frame.command) && frame.size == 0);
    std::printf("quick scan %.1f s, everything %.1f s\n", quick.seconds(), whole.seconds());
}

TEST(SupermodifiedSearch, TellsHowFarItIsAndCanBeCut)
{
    ProgramRun again{"supermodified:4", "supermodified:100,baud=9600"};
    Bench::Found sink;
    sink.wanted = ScanExtent::Everything;
    {
        auto task = scan(again.bench.host, again.bench.clock, sink);
        task.start();
        ASSERT_TRUE(again.bench.clock.runUntil([&] { return sink.rows.size() == 2; }, 5min));
        EXPECT_FALSE(task.isFinished());
        EXPECT_GT(sink.steps, 100);
    }
    const auto sent = again.bench.sent.size();
    again.bench.clock.advance(1s);
    EXPECT_LE(again.bench.sent.size(), sent + 7) << "nobody goes on asking";
}

TEST(SupermodifiedSearch, ARateThatItDoesNotLookAtIsWrittenToNoNode)
{
    Bench bench;
    bench.add("supermodified:4");
    const auto device = bench.connect(4);
    const auto rate = Bench::index("uart.baud");
    bench.sent.clear();
    const auto refused = mb::test::run(bench.clock, device->write(rate, 5760));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, Fault::OutOfRange);
    EXPECT_EQ(refused.error().detail.english(),
        "uart.baud: legal is 57600, 115200, 9600, 19200, 38400, 4800, 2400, 1200, 600");
    EXPECT_EQ(bench.count(Command::Baudrate), 0);
    for (const int legal : {600, 1200, 2400, 4800, 9600, 19200, 38400, 57600, 115200})
        EXPECT_TRUE(mb::test::run(bench.clock, device->write(rate, legal))) << legal;
    EXPECT_EQ(bench.count(Command::Baudrate), 9);
}

TEST(SupermodifiedSearch, AFixedRateStaysTheOnlyOne)
{
    Bench bench("sim:serial?bitrate=9600");
    bench.add("supermodified:4");
    bench.add("supermodified:120");
    EXPECT_EQ(idsOf(bench.scanAll({}, ScanExtent::Everything)), (std::vector<int>{4, 120}));
    EXPECT_EQ(bench.host.baudrate(), 9600);
}

TEST(SupermodifiedSearch, TheFirstAndTheLastIdAreAskedFor)
{
    Bench bench("sim:serial?bitrate=57600");
    bench.add("supermodified:1");
    bench.add("supermodified:127");
    EXPECT_EQ(bench.connect(1)->identity().address, 1);
    EXPECT_EQ(bench.connect(127)->identity().address, 127);
}

TEST(SupermodifiedSearch, AProbeForgetsWhoDoesNotAnswerAndKeepsWhoWasNotAsked)
{
    Bench bench("sim:serial?bitrate=57600");
    Simulator &leaving = bench.add("supermodified:4");
    bench.add("supermodified:6");
    const auto known = bench.scanAll();
    ASSERT_EQ(known.size(), 2U);
    Bench later("sim:serial?bitrate=57600"); // another run of the program
    later.add("supermodified:6");
    leaving.setPowered(false);
    Bench::Found sink;
    sink.known = known;
    ASSERT_TRUE(mb::test::run(later.clock, probe(later.host, later.clock, 4, sink)));
    const auto &nodes = Line::of(later.host, later.clock)->roster().nodes();
    EXPECT_FALSE(nodes.contains(4)) << "it does not answer";
    EXPECT_TRUE(nodes.contains(6)) << "it was there, and nobody looked for it now";
}

} // namespace
} // namespace mb::supermodified
