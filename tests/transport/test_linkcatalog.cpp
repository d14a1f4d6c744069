// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/virtualclock.h"
#include "transport/linkcatalog.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace mb;

TEST(LinkCatalog, SaysSomethingAboutCanOnEveryMachine)
{
    const auto rows = listLinks();
    EXPECT_TRUE(
        std::any_of(rows.begin(), rows.end(), [](const LinkListing &row) { return row.kind == LinkKind::Can; }));
}

TEST(LinkCatalog, NamesTheCauseForWhatCannotBeOpenedAndAnAddressForWhatCan)
{
    for (const LinkListing &row : listLinks()) {
        EXPECT_TRUE(row.openable || !row.detail.empty()) << row.link.text();
        EXPECT_TRUE(!row.openable || LinkAddress::parse(row.link.text()) == row.link) << row.link.text();
    }
}

TEST(LinkCatalog, RefusesKindsThatAreNotSupported)
{
    VirtualClock clock;
    for (const char *text :
        {"serial:/dev/ttyUSB0", "spidev:/dev/spidev0.0", "unix:./bench", "replay:run.log", "sim:can"}) {
        const auto link = createLink(LinkAddress::parse(text).value(), clock);
        ASSERT_FALSE(link) << text;
        EXPECT_EQ(link.error().fault, Fault::Unsupported) << text;
    }
}

TEST(LinkCatalog, RefusesOptionsAndPathsThatAKindDoesNotHave)
{
    VirtualClock clock;
    for (const char *text : {"socketcan:can0?bitrate=5", "qtcan:peakcan", "qtcan::usb0",
             "qtcan:peakcan:usb0?bitrate=fast", "qtcan:peakcan:usb0?speed=5"}) {
        const auto link = createLink(LinkAddress::parse(text).value(), clock);
        ASSERT_FALSE(link) << text;
        EXPECT_EQ(link.error().fault, Fault::OutOfRange) << text;
    }
}

TEST(LinkCatalog, AnInterfaceThatIsNotThereFailsToOpenWithItsCause)
{
    VirtualClock clock;
    auto link = createLink(LinkAddress::parse("socketcan:nosuchcan7").value(), clock);
    ASSERT_TRUE(link);
    const auto opened = (*link)->open();
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().fault, Fault::LinkLost);
    const std::string &detail = opened.error().detail;
    EXPECT_TRUE(detail == "there is no CAN interface nosuchcan7" || detail.find("CAN s") != std::string::npos)
        << detail;
    EXPECT_EQ((*link)->state(), LinkState::Closed);
}
