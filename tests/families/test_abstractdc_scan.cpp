// SPDX-License-Identifier: GPL-3.0-or-later
#include "abstractdcbench.h"
#include "families/abstractdc/logpoller.h"
#include "families/abstractdc/scan.h"
#include "fuzz/soak.h"
#include "support/fakeunit.h"
#include "support/simulatedsession.h"
#include "support/stallingclock.h"

#include <map>
#include <set>

namespace mb::abstractdc {
namespace {

struct FoundUnit final : ScanSink {
    void found(const Identity &identity) override { rows[identity.address] = identity; }
    void progress(const Message &, int, int) override { }
    void leftOut(const Message &) override { isWhole = false; }
    [[nodiscard]] ScanExtent extent() const override { return howFar; }
    [[nodiscard]] std::vector<Identity> remembered() const override
    {
        Identity identity;
        identity.address = named;
        return named >= 0 ? std::vector{identity} : std::vector<Identity>();
    }
    int named = -1;
    ScanExtent howFar = ScanExtent::Quick;
    bool isWhole = true;
    [[nodiscard]] std::string text() const
    {
        std::string all;
        for (const auto &[offset, identity] : rows)
            all += std::to_string(offset) + ':' + (identity.dialect.empty() ? "?" : identity.dialect)
                + (identity.state == DeviceState::Duplicate ? "x2 " : " ");
        return all;
    }
    std::map<int, Identity> rows;
};

class AbstractDcScan : public Drives {
protected:
    using Drives::Drives;
    std::string scanned(int named = -1, ScanExtent extent = ScanExtent::Quick)
    {
        FoundUnit sink;
        sink.named = named;
        sink.howFar = extent;
        std::vector<std::string> sent;
        const Subscription tap = host.traffic().add([&](const Traffic &traffic) {
            if (traffic.direction == Direction::Sent)
                sent.push_back(toText(*traffic.can));
        });
        const Instant begin = clock.now();
        const auto result = test::run(clock, scan(host, clock, sink));
        EXPECT_TRUE(result) << result.error().text();
        took = clock.now() - begin;
        for (const std::string &frame : sent)
            EXPECT_TRUE((frame[0] == '3' && frame.size() == 6) && (frame.substr(0, 3) >= "320"))
                << frame << " is no log request";
        last = sink.rows;
        isWhole = sink.isWhole;
        return sink.text();
    }
    Duration took{};
    std::map<int, Identity> last;
    bool isWhole = true;
};

TEST_F(AbstractDcScan, NobodyIsFoundOnAnEmptyBus)
{
    EXPECT_EQ(scanned(), "");
    EXPECT_LE(took, 300ms);
}

TEST_F(AbstractDcScan, TellsTheDialectsApart)
{
    for (const char *unit :
        {"abstractdc:3,dialect=F", "abstractdc:4,dialect=L", "abstractdc:5,dialect=D", "abstractdc:9,dialect=LL"})
        add(unit);
    EXPECT_EQ(scanned(), "3:F 4:L 5:D 9:LL ");
    EXPECT_TRUE(isWhole);
    EXPECT_LE(took, 500ms);
    EXPECT_NE(last.at(3).detail.english().find("firmware's codes, not the document's"), std::string::npos);
    for (const auto &[offset, identity] : last)
        EXPECT_EQ(identity.state, DeviceState::Online);
}

class AbstractDcSlowLine : public AbstractDcScan {
protected:
    AbstractDcSlowLine()
        : AbstractDcScan(50'000)
    {
    }
};

TEST_F(AbstractDcSlowLine, OneOfTheOldestIsAskedForWhenItIsNamedThoughTheLineIsTooSlowForAll)
{
    add("abstractdc:9,dialect=LL");
    EXPECT_EQ(scanned(), "");
    EXPECT_FALSE(isWhole) << "and whoever looks is told";
    EXPECT_EQ(scanned(9), "9:LL ");
    EXPECT_EQ(scanned(-1, ScanExtent::Everything), "9:LL ");
    EXPECT_TRUE(isWhole);
}

/// This program's own pollers ask for logs whose answers come where another dialect would answer the scan's questions.
TEST_F(AbstractDcScan, TellsTheDialectsApartWhileEveryDriveIsPolledAsOftenAsTheWireCarries)
{
    for (const char *unit : {"abstractdc:3,dialect=F", "abstractdc:4,dialect=L", "abstractdc:5,dialect=D"})
        add(unit);
    std::vector<std::unique_ptr<LogPoller>> pollers;
    const std::array spoken{&dialectF, &dialectL, &dialectD};
    for (int offset = 3; offset <= 5; ++offset) {
        pollers.push_back(std::make_unique<LogPoller>(
            host, clock, LogPoller::Events{[](Log, std::int32_t, Instant) {}, [] {}, [](Log) {}}));
        pollers.back()->speak(spoken.at(static_cast<std::size_t>(offset) - 3), offset);
        for (const Log log : {Log::Position, Log::Velocity, Log::Current})
            pollers.back()->wish(log, 500.0);
    }
    for (int phase = 0; phase < test::rounds(20); ++phase) {
        clock.advance(1013us * (phase % 17));
        FoundUnit sink;
        const auto result = test::run(clock, scan(host, clock, sink));
        ASSERT_TRUE(result) << result.error().text() << ", scan " << phase;
        ASSERT_EQ(sink.text(), "3:F 4:L 5:D ") << "scan " << phase;
    }
}

/// Without a clock of its own, as on a link to a real bus: whoever is held up for longer than an answer may take sees question and
/// answer at once, and judges by when they passed.
TEST(AbstractDcScanBusy, TellsTheDialectsApartOnAComputerThatIsHeldUp)
{
    test::StallingClock clock(120ms);
    VirtualCanBus bus(clock, 500'000, 1);
    VirtualCanLink host(*LinkAddress::parse("sim:can"), bus);
    ASSERT_TRUE(host.open());
    std::vector<std::unique_ptr<VirtualCanLink>> ends;
    std::vector<std::unique_ptr<Simulator>> drives;
    std::vector<std::unique_ptr<LogPoller>> pollers;
    const std::array spoken{&dialectF, &dialectL, &dialectD};
    for (int offset = 3; offset <= 5; ++offset) {
        const Dialect &dialect = *spoken.at(static_cast<std::size_t>(offset) - 3);
        ends.push_back(std::make_unique<VirtualCanLink>(*LinkAddress::parse("sim:can"), bus));
        ASSERT_TRUE(ends.back()->open());
        const std::string unit = "abstractdc:" + std::to_string(offset) + ",dialect=" + std::string(dialect.key);
        drives.push_back(*simulate(*ends.back(), clock, *SimulatedUnit::parse(unit)));
        pollers.push_back(std::make_unique<LogPoller>(
            host, clock, LogPoller::Events{[](Log, std::int32_t, Instant) {}, [] {}, [](Log) {}}));
        pollers.back()->speak(&dialect, offset);
        for (const Log log : {Log::Position, Log::Velocity, Log::Current})
            pollers.back()->wish(log, 100.0);
    }
    for (int round = 0; round < test::rounds(200); ++round) {
        FoundUnit sink;
        auto scanning = scan(host, clock, sink);
        scanning.start();
        ASSERT_TRUE(clock.runUntil([&] { return scanning.isFinished(); }, 1min));
        // A drive that did not answer in time is missing from one scan; it is never taken for another.
        for (const auto &[offset, identity] : sink.rows) {
            ASSERT_TRUE(offset >= 3 && offset <= 5) << sink.text() << "in scan " << round;
            if (!identity.dialect.empty()) {
                ASSERT_EQ(identity.dialect, spoken.at(static_cast<std::size_t>(offset) - 3)->key) << round;
            }
        }
    }
}

TEST_F(AbstractDcScan, NoMotorMovesAndNoSettingChanges)
{
    Simulator &a = add("abstractdc:3,dialect=F");
    Simulator &b = add("abstractdc:40,dialect=L");
    Simulator &c = add("abstractdc:5,dialect=D");
    events.clear();
    scanned();
    EXPECT_TRUE(events.empty());
    for (Simulator *drive : {&a, &b, &c}) {
        EXPECT_FALSE(drive->isOutputOn());
        EXPECT_EQ(drive->position(), 0.0);
    }
}

/// 1000+k of a legacy drive with k ≥ 24 is 1024+(k−24) of one of today's.
TEST_F(AbstractDcScan, AnAmbiguousIdentifierIsAskedBothWays)
{
    add("abstractdc:30,dialect=L");
    EXPECT_EQ(scanned(), "30:L ");
    add("abstractdc:31,dialect=F");
    EXPECT_EQ(scanned(), "30:L 31:F ");
}

TEST_F(AbstractDcScan, EveryOffsetOfEveryDialectIsFoundAlone)
{
    for (const char *dialect : {"F", "L", "D"}) {
        for (const int offset : {0, 1, 23, 24, 28, 51, 52, 75, 76, 99}) {
            VirtualCanBus own(clock, 1'000'000, 1);
            VirtualCanLink one(*LinkAddress::parse("sim:can"), own);
            VirtualCanLink other(*LinkAddress::parse("sim:can"), own);
            ASSERT_TRUE(one.open());
            ASSERT_TRUE(other.open());
            const auto drive = simulate(
                other, clock, *SimulatedUnit::parse("abstractdc:" + std::to_string(offset) + ",dialect=" + dialect));
            FoundUnit sink;
            ASSERT_TRUE(test::run(clock, scan(one, clock, sink)));
            EXPECT_EQ(sink.text(), std::to_string(offset) + ':' + dialect + ' ');
        }
    }
}

TEST_F(AbstractDcScan, EightDrivesAreFoundInHalfASecond)
{
    for (int offset = 1; offset <= 8; ++offset)
        add("abstractdc:" + std::to_string(offset) + ",dialect=" + (offset % 2 == 0 ? "L" : "F"));
    EXPECT_EQ(scanned(), "1:F 2:L 3:F 4:L 5:F 6:L 7:F 8:L ");
    EXPECT_LE(took, 500ms);
}

TEST_F(AbstractDcScan, TwoDrivesWithOneOffsetAreADuplicate)
{
    add("abstractdc:7,fault=duplicate");
    add("abstractdc:8");
    EXPECT_EQ(scanned(), "7:Fx2 8:F ");
}

TEST_F(AbstractDcScan, TwoDrivesWhoseAnswersDestroyEachOtherAreNoHealthyOne)
{
    bus.setStubborn(true);
    add("abstractdc:7,fault=duplicate");
    add("abstractdc:8");
    EXPECT_EQ(scanned(), "7:?x2 8:F ");
    EXPECT_NE(last[7].detail.english().find("destroyed"), std::string::npos) << last[7].detail.english();
}

TEST_F(AbstractDcScan, ADriveOnALineWithErrorsIsNoDuplicate)
{
    add("abstractdc:7");
    test::FakeUnit first(bus, clock);
    test::FakeUnit second(bus, clock);
    first.answer("387#03", {{"7F0#01"}}); // two others destroy each other's frames meanwhile
    second.answer("387#03", {{"7F0#02"}});
    EXPECT_EQ(scanned(), "7:F ");
}

TEST_F(AbstractDcScan, TwoDrivesWhoseAnswersAreAlikeAreOneOnTheWire)
{
    add("abstractdc:7,dialect=L,fault=duplicate"); // no temperature, and the rest is 0
    EXPECT_EQ(scanned(), "7:L ");
}

TEST_F(AbstractDcScan, LostFramesAreAskedForAgain)
{
    add("abstractdc:3,fault=drop@2");
    add("abstractdc:4,dialect=L,fault=drop@2");
    EXPECT_EQ(scanned(), "3:F 4:L ");
}

class AbstractDcSlowScan : public AbstractDcScan {
protected:
    AbstractDcSlowScan()
        : AbstractDcScan(1250)
    {
    }
};

TEST_F(AbstractDcSlowScan, WorksAtTheBitRateOfTheStockFirmware)
{
    add("abstractdc:3");
    add("abstractdc:4,dialect=L");
    EXPECT_EQ(scanned(), "3:F 4:L ");
    EXPECT_LE(took, 5s);
}

class AbstractDcScanLiteral : public testing::Test {
protected:
    AbstractDcScanLiteral()
        : bus(clock, 500'000, 1)
        , host(*LinkAddress::parse("sim:can"), bus)
        , unit(bus, clock)
    {
        EXPECT_TRUE(host.open());
        clock.advance(1s);
    }
    std::string scanned()
    {
        FoundUnit sink;
        EXPECT_TRUE(test::run(clock, scan(host, clock, sink)));
        return sink.text();
    }
    VirtualClock clock;
    VirtualCanBus bus;
    VirtualCanLink host;
    test::FakeUnit unit;
};

TEST_F(AbstractDcScanLiteral, ThirdAndFourthAnswerProveTheFirmware)
{
    unit.answer("384#01", {{"405#00000000"}});
    unit.answer("389#03", {{"605#00000000"}});
    unit.answer("389#04", {{"680#00000000"}});
    EXPECT_EQ(scanned(), "5:F ");
}

/// Its current and its position, in dialect F, come where dialect D answers the two questions that tell them apart.
TEST_F(AbstractDcScanLiteral, AnswersToSomebodyElsesQuestionsProveNothing)
{
    unit.answer("384#01", {{"405#00000000"}});
    unit.answer("389#03", {{"605#00000000"}}, 2ms);
    unit.answer("389#04", {{"680#00000000"}}, 2ms);
    unit.answer("389#02", {{"505#00000000"}});
    unit.answer("389#00", {{"485#00000000"}});
    Timer timer(clock);
    bool turn = false;
    std::function<void()> poll = [&] {
        turn = !turn;
        EXPECT_TRUE(host.send(canFrameFromText(turn ? "389#02" : "389#00").value()));
        timer.startIn(700us, poll);
    };
    poll();
    EXPECT_EQ(scanned(), "5:F ");
}

TEST_F(AbstractDcScanLiteral, AContradictionIsNoProof)
{
    unit.answer("384#01", {{"405#00000000"}});
    unit.answer("389#03", {{"605#00000000"}});
    unit.answer("389#04", {{"485#00000000"}});
    EXPECT_EQ(scanned().find(":F"), std::string::npos);
    EXPECT_EQ(scanned().find(":D"), std::string::npos);
}

TEST_F(AbstractDcScanLiteral, OneThatKnowsOnlyTheSpeedIsListedWithoutADialect)
{
    unit.answer("384#01", {{"460#00000000"}}); // 1120: today's with 96, or legacy with 120, which there is not
    unit.answer("3E4#01", {{"460#00000000"}});
    EXPECT_EQ(scanned(), "96:? ");
}

/// The position of legacy drive 4 comes where drive 80 answers for its speed.
TEST_F(AbstractDcScanLiteral, ALateAnswerToAPollThatIsOlderThanTheScanIsNoDrive)
{
    unit.answer("388#00", {{"450#00000000"}}, 15ms);
    Timer timer(clock);
    std::function<void()> poll = [&] {
        EXPECT_TRUE(host.send(canFrameFromText("388#00").value()));
        timer.startIn(33ms, poll);
    };
    for (int phase = 0; phase < 33; ++phase) {
        poll();
        clock.advance(1ms * phase);
        ASSERT_EQ(scanned(), "") << phase;
    }
}

TEST_F(AbstractDcScanLiteral, AnAnswerThatOnlyEverybodyWasAskedForIsNoDrive)
{
    unit.answer("384#01", {{"460#00000000"}});
    EXPECT_EQ(scanned(), "");
}

TEST_F(AbstractDcScanLiteral, TheDocumentsCodesAreBelievedOnlyWithTheAnswerThatNoOtherDialectHas)
{
    unit.answer("384#01", {{"405#00000000"}});
    unit.answer("389#03", {{"505#00000000"}});
    unit.answer("389#04", {{"485#00000000"}});
    EXPECT_EQ(scanned().find(":D"), std::string::npos);
    unit.answer("389#05", {{"685#00000000"}});
    EXPECT_EQ(scanned(), "5:D ");
}

TEST_F(AbstractDcScanLiteral, AnUnprovenDriveIsNotHeardByTheAnswersOfAnother)
{
    unit.answer("388#00", {{"450#00000000"}});
    LogPoller phantom(host, clock, LogPoller::Events{[](Log, std::int32_t, Instant) {}, [] {}, [](Log) {}});
    phantom.speak(nullptr, 80);
    LogPoller legacy(host, clock, LogPoller::Events{[](Log, std::int32_t, Instant) {}, [] {}, [](Log) {}});
    legacy.wish(Log::Position, 200.0);
    legacy.speak(&dialectL, 4);
    for (int i = 0; i < 3000; ++i) {
        clock.advance(1ms);
        ASSERT_FALSE(phantom.isHeard()) << i;
    }
    EXPECT_TRUE(legacy.isHeard());
}

/// The current of legacy drive 4 comes where drive 52 answers for its position.
TEST_F(AbstractDcScanLiteral, TheLogOfAnotherDriveIsNotTakenForItsOwn)
{
    unit.answer("388#02", {{"4B4#11111111"}}, 3ms);
    unit.answer("3B8#00", {{"4B4#22222222"}}, 3ms);
    std::set<std::int32_t> currents;
    std::set<std::int32_t> positions;
    const auto into = [](std::set<std::int32_t> &all) {
        return LogPoller::Events{[&all](Log, std::int32_t value, Instant) { all.insert(value); }, [] {}, [](Log) {}};
    };
    LogPoller legacy(host, clock, into(currents));
    LogPoller today(host, clock, into(positions));
    legacy.wish(Log::Current, 100.0);
    legacy.speak(&dialectL, 4);
    today.wish(Log::Position, 100.0);
    today.speak(&dialectF, 52);
    clock.advance(2s);
    EXPECT_EQ(currents, std::set<std::int32_t>{0x11111111});
    EXPECT_EQ(positions, std::set<std::int32_t>{0x22222222});
}

TEST_F(AbstractDcScanLiteral, FramesOfOthersAreNoDrives)
{
    unit.answer("384#01", {{"405#0000", "00000405#00000000", "7E8#00000000", "460#R4"}});
    EXPECT_EQ(scanned(), "");
}

TEST_F(AbstractDcScanLiteral, AnAnswerInAnotherFormProvesNothing)
{
    unit.answer("384#01", {{"405#00000000"}});
    unit.answer("389#03", {{"00000605#00000000", "605#000000", "605#0000000000"}});
    unit.answer("389#04", {{"680#00000000"}});
    EXPECT_EQ(scanned().find("5:F"), std::string::npos);
}

TEST_F(AbstractDcScanLiteral, TheOldestAreFoundByTheirPositionsFromTheirFirstIdentifierToTheirLast)
{
    unit.answer("329#00", {{"00000455#00000000", "455#000000", "44B#00000000", "4B0#00000000"}});
    EXPECT_EQ(scanned(), "");
    unit.answer("383#00", {{"4AF#00000000"}});
    unit.answer("383#01", {{"44B#00000000"}});
    unit.answer("383#02", {{"513#00000000"}});
    EXPECT_EQ(scanned(), "99:LL ");
}

} // namespace
} // namespace mb::abstractdc
