// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/identity.h"
#include "simulation/simulator.h"

#include <gtest/gtest.h>

namespace mb {
namespace {

TEST(Selector, FindsTheDeviceBehindTheLastSlash)
{
    const auto plain = DeviceSelector::parse("sim:can/dmc60c:5");
    ASSERT_TRUE(plain);
    EXPECT_EQ(plain->link.text(), "sim:can");
    EXPECT_EQ(plain->family, "dmc60c");
    EXPECT_EQ(plain->address, 5);
    EXPECT_FALSE(plain->session);
    const auto serial = DeviceSelector::parse("serial:/dev/ttyUSB0?baud=57600&rs485=1/supermodified:4");
    ASSERT_TRUE(serial);
    EXPECT_EQ(serial->link.path, "/dev/ttyUSB0");
    EXPECT_EQ(serial->link.option("rs485"), "1");
    EXPECT_EQ(serial->address, 4);
}

TEST(Selector, KeepsTheOptionsOfTheLinkAndTheSession)
{
    for (const char *text : {"sim:can?loss=0.1/dmc60c:5", "sim:can/dmc60c:5@1234", "socketcan:vcan0/abstractdc:3",
             "unix:./a/b/quadquad2drv:0"}) {
        const auto selector = DeviceSelector::parse(text);
        ASSERT_TRUE(selector) << text;
        EXPECT_EQ(selector->text(), text);
    }
    EXPECT_EQ(DeviceSelector::parse("sim:can/dmc60c:5@1234")->session, 0x1234);
}

TEST(Selector, RefusesNonsenseWithOneClause)
{
    for (const char *text :
        {"", "/", "dmc60c:5", "sim:can", "sim:can/", "sim:can/dmc60c", "sim:can/dmc60c:", "sim:can/:5",
            "sim:can/dmc60c:x", "sim:can/dmc60c:5x", "sim:can/dmc60c:-1", "sim:can/dmc60c:5@", "sim:can/dmc60c:5@xyz",
            "sim:can/dmc60c:99999999999", "foo:bar/dmc60c:5", "sim:nowhere/dmc60c:5", "sim:can?loss/dmc60c:5"}) {
        const auto selector = DeviceSelector::parse(text);
        ASSERT_FALSE(selector) << text;
        const bool isOfNoKind = std::string_view(text).starts_with("foo:");
        EXPECT_EQ(selector.error().fault, isOfNoKind ? Fault::Usage : Fault::OutOfRange) << text;
        EXPECT_FALSE(selector.error().text().empty());
        EXPECT_EQ(selector.error().text().find('\n'), std::string::npos);
    }
}

TEST(Selector, NamesTheSessionOnlyOfDuplicates)
{
    Identity identity;
    identity.family = "dmc60c";
    identity.address = 5;
    identity.session = 0xBEEF;
    LinkAddress link;
    link.scheme = "sim";
    link.path = "can";
    EXPECT_EQ(selectorOf(link, identity).text(), "sim:can/dmc60c:5");
    identity.state = DeviceState::Duplicate;
    EXPECT_EQ(selectorOf(link, identity).text(), "sim:can/dmc60c:5@beef");
}

TEST(DeviceSelector, OfADeviceThatIsGoneHasItsPartsWithoutBeingChecked)
{
    struct Row {
        std::string_view text, link, device, address, session;
    };
    for (const Row &row :
        {Row{"sim:can/dmc60c:5", "sim:can", "dmc60c:5", "5", ""},
            Row{"serial:/dev/ttyUSB0?baud=57600/supermodified:4", "serial:/dev/ttyUSB0?baud=57600", "supermodified:4",
                "4", ""},
            Row{"elsewhere:x/dmc60c:5@00ef", "elsewhere:x", "dmc60c:5@00ef", "5", "@00ef"},
            Row{"dmc60c:5", "", "dmc60c:5", "5", ""}, Row{"derived", "", "derived", "", ""}, Row{"", "", "", "", ""}}) {
        const SelectorParts parts = partsOf(row.text);
        EXPECT_EQ(parts.link, row.link) << row.text;
        EXPECT_EQ(parts.device, row.device) << row.text;
        EXPECT_EQ(parts.address, row.address) << row.text;
        EXPECT_EQ(parts.session, row.session) << row.text;
    }
}

TEST(SimulatedUnit, ReadsOptionsAndFaults)
{
    const auto unit
        = SimulatedUnit::parse("dmc60c:7,motor=775pro,fault=drop@3,fault=delay@7:50,fault=duplicate,load=2.5");
    ASSERT_TRUE(unit);
    EXPECT_EQ(unit->family, "dmc60c");
    EXPECT_EQ(unit->address, 7);
    EXPECT_EQ(unit->option("motor"), "775pro");
    EXPECT_EQ(unit->option("load"), "2.5");
    EXPECT_FALSE(unit->option("fault"));
    ASSERT_EQ(unit->faults.size(), 3U);
    EXPECT_EQ(unit->faults[0].kind, FaultKind::Drop);
    EXPECT_EQ(unit->faults[0].at, 3.0);
    EXPECT_EQ(unit->faults[1].argument, 50.0);
    EXPECT_EQ(unit->faults[2].kind, FaultKind::Duplicate);
}

TEST(SimulatedUnit, RefusesNonsense)
{
    for (const char *text : {"", "dmc60c", ":5", "dmc60c:", "dmc60c:x", "dmc60c:-1", "dmc60c:1.5", "dmc60c:70000",
             "dmc60c:nan", "dmc60c:inf", "dmc60c:5,", "dmc60c:5,motor", "dmc60c:5,=cim",
             "dmc60c:5,motor=", "dmc60c:5,fault=", "dmc60c:5,fault=melt@1"}) {
        const auto unit = SimulatedUnit::parse(text);
        ASSERT_FALSE(unit) << text;
        EXPECT_EQ(unit.error().fault, Fault::OutOfRange) << text;
    }
}

TEST(SimulatedFault, NeedsTheNumbersOfItsKind)
{
    for (const char *text :
        {"drop@3", "corrupt@1", "delay@7:50", "silent@9", "power@4", "power-page@30", "power-page@0", "reset@1.5",
            "busoff@2", "brownout@1", "stall@1", "encoder-dead@0", "encoder-reversed", "duplicate"})
        EXPECT_TRUE(SimulatedFault::parse(text)) << text;
    for (const char *text : {"", "@3", "drop", "drop@", "drop@x", "drop@-1", "drop@3:4", "delay@7",
             "delay@7:", "delay@:50", "drop@0", "drop@1.5", "corrupt@0", "silent@0", "delay@0:5", "power@0",
             "power@2.5", "power-page@1.5", "duplicate@1", "stall@nan", "stall@inf", "busoff@1e400"})
        EXPECT_FALSE(SimulatedFault::parse(text)) << text;
}

} // namespace
} // namespace mb
