// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for the simulated units of every family.
#include "model/bench.h"
#include "model/registry.h"
#include "support/simulatedsession.h"
#include "transport/backends/virtualcan.h"
#include "transport/backends/virtualserial.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

namespace mb {
namespace {

TEST(SimulatedUnits, AreRefusedOnALinkOfAnotherKind)
{
    VirtualClock clock;
    VirtualCanBus bus(clock, 1'000'000, 1);
    VirtualCanLink can(*LinkAddress::parse("sim:can"), bus);
    VirtualSerialLine line(clock, VirtualSerialLine::Wiring::HalfDuplex, 1);
    VirtualSerialLink serial(*LinkAddress::parse("sim:serial"), line);
    const std::map<std::string_view, std::string> refusals{{"dmc60c", "a DMC60C is simulated on a CAN link"},
        {"abstractdc", "Abstract DC Drives live on CAN links only"},
        {"supermodified", "a Supermodified is simulated on a serial link"},
        {"quadquad2drv", "a QuadQuad2Drv is simulated on the board's end of an SPI link"}};
    for (const Family *const family : families()) {
        Link &other = family->links.front() == LinkKind::Can ? static_cast<Link &>(serial) : static_cast<Link &>(can);
        const auto made = family->simulate(other, clock, *SimulatedUnit::parse(family->bench.front()));
        ASSERT_FALSE(made) << family->key;
        EXPECT_EQ(made.error().text(), refusals.at(family->key));
    }
}

TEST(SimulatedUnits, ThatShowOffTheProgramAreOnTheBench)
{
    int shown = 0;
    for (const Family *const family : families()) {
        if (!family->demo)
            continue;
        std::set<int> addresses{0};
        for (const std::string_view unit : family->bench)
            addresses.insert(SimulatedUnit::parse(unit)->address);
        const DemoUnits &demo = *family->demo;
        for (const int which : {demo.tuned, demo.overshooting, demo.inBootloader, demo.stoppingShort}) {
            EXPECT_TRUE(addresses.contains(which)) << family->key << ' ' << which;
            shown += which == 0 ? 0 : 1;
        }
        EXPECT_EQ(isDemoUnit(*family, 0, &DemoUnits::tuned), false) << "nobody";
        if (demo.tuned != 0) {
            EXPECT_TRUE(isDemoUnit(*family, demo.tuned, &DemoUnits::tuned)) << family->key;
        }
    }
    EXPECT_EQ(shown, 4) << "tuned, overshooting, in its bootloader, stopping short";
}

} // namespace
} // namespace mb
