// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/linkaddress.h"

#include <gtest/gtest.h>

using namespace mb;

namespace {

struct Row {
    const char *text;
    const char *scheme;
    const char *path;
    const char *shortName;
};

} // namespace

TEST(LinkAddress, ReadsEveryKindAndWritesItBack)
{
    const Row rows[] = {
        {"sim:", "sim", "", "sim:"},
        {"sim:can", "sim", "can", "sim:can"},
        {"sim:serial?seed=7", "sim", "serial", "sim:serial"},
        {"sim:spi", "sim", "spi", "sim:spi"},
        {"sim:can?loss=0.1&fault=drop@3&fault=silent@9", "sim", "can", "sim:can"},
        {"socketcan:can0", "socketcan", "can0", "can0"},
        {"qtcan:peakcan:usb0", "qtcan", "peakcan:usb0", "peakcan:usb0"},
        {"serial:/dev/ttyUSB0?baud=57600&rs485=1", "serial", "/dev/ttyUSB0", "ttyUSB0"},
        {"spidev:/dev/spidev0.0?speed=500000&ready=gpiochip0:25", "spidev", "/dev/spidev0.0", "spidev0.0"},
        {"unix:./bench", "unix", "./bench", "bench"},
        {"replay:run.log", "replay", "run.log", "run.log"},
    };
    for (const Row &row : rows) {
        const auto address = LinkAddress::parse(row.text);
        ASSERT_TRUE(address) << row.text;
        EXPECT_EQ(address->scheme, row.scheme);
        EXPECT_EQ(address->path, row.path);
        EXPECT_EQ(address->shortName(), row.shortName);
        EXPECT_EQ(address->text(), row.text);
        EXPECT_EQ(LinkAddress::parse(address->text()).value(), *address);
    }
}

TEST(LinkAddress, KeepsRepeatedOptionsInOrderAndFindsTheFirst)
{
    const auto address = LinkAddress::parse("sim:can?fault=drop@3&loss=0.1&fault=silent@9");
    ASSERT_TRUE(address);
    ASSERT_EQ(address->options.size(), 3U);
    EXPECT_EQ(address->options[2].second, "silent@9");
    EXPECT_EQ(address->option("fault"), "drop@3");
    EXPECT_EQ(address->option("loss"), "0.1");
    EXPECT_FALSE(address->option("seed").has_value());
}

TEST(LinkAddress, RefusesWhatIsNoLinkAndQuotesIt)
{
    for (const char *text : {"", ":", "can0", "usb:can0", "SIM:can", "socketcan:", "serial:?baud=9600", "sim:usb",
             "sim:can?loss", "sim:can?=1", "sim:can?loss=", "sim:can?a=1&&b=2", "sim:can?seed=1&seed=2",
             "serial:/dev/ttyUSB0?baud=9600&rs485=1&baud=57600"}) {
        const auto address = LinkAddress::parse(text);
        ASSERT_FALSE(address) << text;
        const std::string_view link(text);
        const bool isOfNoKind = link.find(':') == std::string_view::npos || link == ":" || link.starts_with("usb:")
            || link.starts_with("SIM:");
        EXPECT_EQ(address.error().fault, isOfNoKind ? Fault::Usage : Fault::OutOfRange) << text;
        EXPECT_FALSE(address.error().text().empty()) << text;
    }
    EXPECT_NE(LinkAddress::parse("usb:can0").error().text().find("'usb'"), std::string::npos);
}

TEST(LinkAddress, OptionsMakeADifferentLink)
{
    EXPECT_NE(LinkAddress::parse("sim:can").value(), LinkAddress::parse("sim:can?seed=2").value());
}
