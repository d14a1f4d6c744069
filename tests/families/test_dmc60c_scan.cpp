// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/virtualclock.h"
#include "families/dmc60c/scan.h"
#include "support/fakeunit.h"

#include <gtest/gtest.h>

namespace mb::dmc60c {
namespace {

using namespace std::chrono_literals;
using test::FakeUnit;

const std::string request = "00000240#";
const std::string firstOf5 = "0206F005#341203012060";      // E2
const std::string secondOf5 = "0206F005#3412000017010901"; // application 1.23, bootloader 1.9
const FakeUnit::Frames pairOf5{firstOf5, secondOf5};
const std::string getDescriptors = "0206FC05#3412600000000000"; // V5
const FakeUnit::Frames descriptors{                             // V6, V7a–e
    "0206FCC5#00002700", "0206FC85#0106444D43363043", "0206FC85#030F446967696C65", "0206FC85#6E7420444D433630",
    "0206FC85#43060C3231303333", "0206FC85#34334137394632"};

class Dmc60cScan : public testing::Test, protected ScanSink {
protected:
    Dmc60cScan()
        : bus(clock, 1'000'000, 1)
        , host(*LinkAddress::parse("sim:can"), bus)
    {
        EXPECT_TRUE(host.open());
    }
    void found(const Identity &identity) override
    {
        reports.push_back({clock.now(), identity});
        for (Identity &known : list) {
            if (known.address == identity.address && known.session == identity.session) {
                known = identity;
                return;
            }
        }
        list.push_back(identity);
    }
    void progress(const Message &, int, int) override { }

    Result<void> scanNow()
    {
        auto task = scan(host, clock, *this);
        task.start();
        EXPECT_TRUE(clock.runUntil([&] { return task.isFinished(); }, 10s));
        return task.isFinished() ? task.result() : fail(Fault::Timeout, say("the scan hangs"));
    }

    VirtualClock clock;
    VirtualCanBus bus;
    VirtualCanLink host;
    std::vector<std::pair<Instant, Identity>> reports;
    std::vector<Identity> list;
};

TEST_F(Dmc60cScan, ReportsARowWhenItsPairIsCompleteAndAgainWithDescriptors)
{
    FakeUnit unit(bus, clock);
    unit.answer(request, {pairOf5}, 5ms);
    unit.answer(getDescriptors, {descriptors});
    ASSERT_TRUE(scanNow());
    ASSERT_EQ(reports.size(), 2U);
    EXPECT_LT(reports[0].first - Instant{}, 6ms);
    EXPECT_EQ(reports[0].second.name, "");
    EXPECT_LT(reports[1].first - Instant{}, 150ms) << "in the quiet part of the first window";
    const Identity &identity = list.at(0);
    EXPECT_EQ(identity.family, "dmc60c");
    EXPECT_EQ(identity.address, 5);
    EXPECT_EQ(identity.session, 0x1234);
    EXPECT_EQ(identity.state, DeviceState::Online);
    EXPECT_EQ(identity.firmware, "1.23");
    EXPECT_EQ(identity.bootloader, "1.9");
    EXPECT_EQ(identity.name, "DMC60C");
    EXPECT_EQ(identity.serial, "2103343A79F2");
    EXPECT_EQ(identity.detail, "");
    const std::vector<std::pair<std::string, std::string>> expected{{"name", "DMC60C"}, {"product", "Digilent DMC60C"},
        {"serial", "2103343A79F2"}, {"application_version", "1.23 (0x0117)"}, {"bootloader_version", "1.9 (0x0109)"},
        {"product_id", "0x60200103"}};
    EXPECT_EQ(identity.descriptors, expected);
}

TEST_F(Dmc60cScan, SendsNothingButThreeEnumerationsAndGets)
{
    FakeUnit unit(bus, clock);
    unit.answer(request, {pairOf5}, 5ms);
    unit.answer(getDescriptors, {descriptors});
    ASSERT_TRUE(scanNow());
    EXPECT_EQ(unit.heard(), (FakeUnit::Frames{request, getDescriptors, request, request}));
    EXPECT_GE(clock.now() - Instant{}, 450ms);
    EXPECT_LE(clock.now() - Instant{}, 500ms);
}

TEST_F(Dmc60cScan, FindsNothingOnAnEmptyBus)
{
    ASSERT_TRUE(scanNow());
    EXPECT_TRUE(list.empty());
    EXPECT_LE(clock.now() - Instant{}, 500ms);
}

TEST_F(Dmc60cScan, IsCompleteWithEightUnitsInHalfASecond)
{
    std::vector<std::unique_ptr<FakeUnit>> units;
    for (int n = 1; n <= 8; ++n) {
        const auto text = [n](std::string frame) {
            frame[frame.find('?')] = static_cast<char>('0' + n);
            return frame;
        };
        auto &unit = *units.emplace_back(std::make_unique<FakeUnit>(bus, clock));
        unit.answer(request, {{text("0206F00?#341203012060"), text("0206F00?#3412000017010901")}},
            std::chrono::milliseconds(n));
        unit.answer(
            text("0206FC0?#3412600000000000"), {{text("0206FCC?#00000800"), text("0206FC8?#0106444D43363043")}});
    }
    ASSERT_TRUE(scanNow());
    EXPECT_LE(clock.now() - Instant{}, 500ms);
    ASSERT_EQ(list.size(), 8U);
    for (const Identity &identity : list)
        EXPECT_EQ(identity.name, "DMC60C") << identity.address;
}

TEST_F(Dmc60cScan, ShowsBothUnitsOfADuplicateNumberAndReadsEachBySession)
{
    FakeUnit one(bus, clock);
    FakeUnit two(bus, clock);
    one.answer(request, {pairOf5}, 5ms);
    two.answer(request, {{"0206F005#CDAB03012060", "0206F005#CDAB000017010901"}}, 8ms);
    one.answer(getDescriptors, {descriptors});
    two.answer("0206FC05#CDAB600000000000", {{"0206FCC5#00000400", "0206FC85#01024142"}});
    ASSERT_TRUE(scanNow());
    ASSERT_EQ(list.size(), 2U);
    for (const Identity &identity : list) {
        EXPECT_EQ(identity.state, DeviceState::Duplicate);
        EXPECT_NE(identity.detail.english().find("2 units"), std::string::npos) << identity.detail;
    }
    EXPECT_EQ(list[0].name, "DMC60C");
    EXPECT_EQ(list[1].session, 0xABCD);
    EXPECT_EQ(list[1].name, "AB");
}

TEST_F(Dmc60cScan, TellsUnassignedFromWaitingInTheBootloader)
{
    FakeUnit unassigned(bus, clock);
    FakeUnit waiting(bus, clock);
    FakeUnit staying(bus, clock);
    unassigned.answer(request, {{"0206F000#EFBE03012060", "0206F000#EFBE0100FFFF0901"}}); // E4
    waiting.answer(request, {{"0206F009#010003012060", "0206F009#01000000FFFF0901"}}, 9ms);
    staying.answer(request, {{"0206F00A#020003012060", "0206F00A#0200010017010901"}}, 10ms);
    ASSERT_TRUE(scanNow());
    ASSERT_EQ(list.size(), 3U);
    EXPECT_EQ(list[0].state, DeviceState::Unassigned);
    EXPECT_EQ(list[0].firmware, "");
    EXPECT_NE(list[0].detail.english().find("number"), std::string::npos);
    EXPECT_EQ(list[1].state, DeviceState::Bootloader) << "no application";
    EXPECT_NE(list[1].detail.english().find("update its firmware"), std::string::npos);
    EXPECT_EQ(list[2].state, DeviceState::Bootloader) << "the bootloader runs although there is an application";
    EXPECT_EQ(list[2].firmware, "1.23");
}

TEST_F(Dmc60cScan, JoinsHalvesOfDifferentRounds)
{
    FakeUnit unit(bus, clock);
    unit.answer(request, {{firstOf5}, {secondOf5}, {}}, 5ms);
    ASSERT_TRUE(scanNow());
    ASSERT_EQ(list.size(), 1U);
    EXPECT_GT(reports[0].first - Instant{}, 150ms);
}

TEST_F(Dmc60cScan, AsksThreeMoreTimesForAMissingHalfAndThenLeavesTheRowOut)
{
    FakeUnit unit(bus, clock);
    unit.answer(request, {{firstOf5}}, 5ms);
    ASSERT_TRUE(scanNow());
    EXPECT_TRUE(list.empty());
    EXPECT_EQ(unit.count(request), 6);
}

TEST_F(Dmc60cScan, CountsHalfAnAnswerAsASecondUserOfTheNumber)
{
    FakeUnit one(bus, clock);
    FakeUnit two(bus, clock);
    one.answer(request, {pairOf5}, 5ms);
    two.answer(request, {{"0206F005#CDAB03012060"}}, 8ms);
    ASSERT_TRUE(scanNow());
    ASSERT_EQ(list.size(), 1U);
    EXPECT_EQ(list[0].state, DeviceState::Duplicate);
}

TEST_F(Dmc60cScan, WarnsOfAnotherProduct)
{
    FakeUnit unit(bus, clock);
    unit.answer(request, {{"0206F005#341203011060", secondOf5}}, 5ms);
    ASSERT_TRUE(scanNow());
    EXPECT_NE(list.at(0).detail.english().find("0x60100103"), std::string::npos);
}

TEST_F(Dmc60cScan, ListsAUnitWhoseDescriptorsDoNotCome)
{
    FakeUnit unit(bus, clock);
    unit.answer(request, {pairOf5}, 5ms);
    unit.answer(getDescriptors, {{"0206FCC5#00002700", "0206FC85#0106444D43363043"}}); // then silence
    ASSERT_TRUE(scanNow());
    ASSERT_EQ(list.size(), 1U);
    EXPECT_EQ(list[0].name, "");
    EXPECT_LE(unit.count(getDescriptors), 4);
}

TEST_F(Dmc60cScan, RepeatsDescriptorsWhenAFrameWasLost)
{
    FakeUnit unit(bus, clock);
    unit.answer(request, {pairOf5}, 5ms);
    FakeUnit::Frames gap = descriptors;
    gap.erase(gap.begin() + 2);
    unit.answer(getDescriptors, {gap, {}, descriptors});
    ASSERT_TRUE(scanNow());
    EXPECT_EQ(list.at(0).serial, "2103343A79F2");
    EXPECT_LE(clock.now() - Instant{}, 500ms);
}

TEST_F(Dmc60cScan, EndsWithLinkLostWhenTheLinkGoes)
{
    FakeUnit unit(bus, clock);
    unit.answer(request, {pairOf5}, 5ms);
    clock.arm(clock.now() + 20ms, [this] { bus.forceBusOff(host); });
    const auto result = scanNow();
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().fault, Fault::LinkLost);
}

TEST_F(Dmc60cScan, LeavesNoTimerAndNoListenerWhenCancelledAnywhere)
{
    FakeUnit unit(bus, clock);
    unit.answer(request, {pairOf5}, 5ms);
    unit.answer(getDescriptors, {descriptors});
    for (int steps = 0; steps < 40; ++steps) {
        {
            auto task = scan(host, clock, *this);
            task.start();
            for (int i = 0; i < steps && !task.isFinished(); ++i)
                clock.step();
        }
        EXPECT_EQ(host.received().size(), 0U) << steps;
        clock.advance(1s);
        EXPECT_EQ(clock.armed(), 0U) << steps;
    }
}

} // namespace
} // namespace mb::dmc60c
