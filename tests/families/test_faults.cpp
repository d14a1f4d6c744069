// SPDX-License-Identifier: GPL-3.0-or-later
// Faults on demand: a unit has those that it can have, and refuses the others; a link gives each unit its own.
#include "families/abstractdcbench.h"
#include "families/quadquad2drvbytes.h"
#include "families/quadquad2drvupdatebench.h"
#include "model/bench.h"

namespace mb {
namespace {

using namespace std::chrono_literals;

Fault refusalOf(const std::string &text)
{
    VirtualClock clock;
    const auto unit = SimulatedUnit::parse(text);
    if (!unit)
        return unit.error().fault;
    const Family &family = *findFamily(families(), unit->family);
    const LinkAddress address = *LinkAddress::parse("sim:" + std::string(toString(family.links.front())));
    const auto bus = makeSimulatedBus(family.links.front(), clock, 0, 1);
    const auto end = (*bus)->makeEnd(address);
    const auto made = family.simulate(*end, clock, *unit);
    return made ? Fault::Cancelled : made.error().fault;
}

TEST(SimulatedFaults, AUnitRefusesThoseThatItCannotHave)
{
    for (const char *text :
        {"abstractdc:3,fault=power-page@1", "supermodified:4,fault=busoff@1", "supermodified:4,fault=power-page@1",
            "quadquad2drv:0,fault=busoff@1", "quadquad2drv:0,fault=duplicate", "quadquad2drv:0,fault=power-page@1"})
        EXPECT_EQ(refusalOf(text), Fault::Unsupported) << text;
    EXPECT_EQ(refusalOf("dmc60c:5,fault=power-page@31"), Fault::OutOfRange) << "there are 31 pages from 0";
    for (const char *text : {"dmc60c:5,fault=power-page@30", "abstractdc:3,fault=busoff@1",
             "quadquad2drv:0,fault=delay@1:20", "quadquad2drv:0,fault=brownout@1"})
        EXPECT_EQ(refusalOf(text), Fault::Cancelled) << text << " is taken";
}

TEST(SimulatedFaults, ALinkGivesEachUnitWhatItCanHaveAndRefusesWhatNoneCan)
{
    VirtualClock clock;
    const auto open
        = [&clock](const char *link) { return Bench::create(*LinkAddress::parse(link), clock, families()); };
    EXPECT_TRUE(open("sim:can?fault=power-page@3"));
    EXPECT_TRUE(open("sim:serial?fault=brownout@3"));
    for (const char *link : {"sim:serial?fault=power-page@3", "sim:spi?fault=duplicate"}) {
        const auto refused = open(link);
        ASSERT_FALSE(refused) << link;
        EXPECT_EQ(refused.error().fault, Fault::OutOfRange) << link;
    }
}

class AbstractDcBusOff : public abstractdc::Drives { };

TEST_F(AbstractDcBusOff, IsDeafAndMuteFor100Milliseconds)
{
    add("abstractdc:0,fault=busoff@1");
    clock.advance(990ms);
    EXPECT_EQ(ask("384#01").size(), 1U);
    clock.advance(10ms);
    EXPECT_EQ(ask("384#01").size(), 0U);
    clock.advance(100ms);
    EXPECT_EQ(ask("384#01").size(), 1U);
}

TEST(QuadQuad2DrvFaults, ADelayedPacketComesLaterAndABrownoutTakesSixSeconds)
{
    quadquad2drv::QuadQuad2DrvUpdateBench bench(",fault=delay@40:20,fault=brownout@20");
    bench.device.reset();
    bench.spi.close();
    const auto time = [&bench] {
        const std::vector<std::uint8_t> version = test::bytesOf("02 04 01 F9");
        std::vector<std::uint8_t> miso(version.size());
        bench.board->transfer(version, miso);
        const Instant begin = bench.clock.now();
        bench.clock.runUntil([&bench] { return bench.board->isReady(); }, 100ms);
        const Duration taken = bench.board->isReady() ? bench.clock.now() - begin : Duration(-1);
        std::vector<std::uint8_t> bytes(8);
        if (bench.board->isReady())
            bench.board->transfer(std::vector<std::uint8_t>(8), bytes);
        return taken;
    };
    Duration longest{};
    for (int i = 0; i < 40; ++i)
        longest = std::max(longest, time());
    EXPECT_GE(longest, 20ms);
    EXPECT_LE(longest, 21ms);
    bench.clock.advance(21s);
    EXPECT_LT(time(), Duration(0)) << "no supply";
    bench.clock.advance(6s);
    EXPECT_GT(time(), Duration(0));
}

} // namespace
} // namespace mb
