// SPDX-License-Identifier: GPL-3.0-or-later
// What OpenOCD is asked for, and what it means by what it says.
#include "families/abstractdc/openocd.h"

#include <gtest/gtest.h>

namespace mb::abstractdc {
namespace {

TEST(AbstractDcOpenOcd, AsksForWhatTheRepositoryConfigures)
{
    const auto text = [](const openocd::Job &job) {
        std::string all;
        for (const std::string &argument : openocd::commandOf(job).arguments)
            all += argument + '|';
        return all;
    };
    auto f1 = *openocd::jobOf("openocd:stlink", "f1");
    f1.file = "a.hex";
    EXPECT_EQ(text(f1),
        "-f|interface/stlink.cfg|-c|transport select hla_swd|-f|target/stm32f1x.cfg|-c|reset_config none separate|-c|"
        "program {a.hex} verify reset exit|");
    auto f4 = *openocd::jobOf("openocd:cmsis-dap", "f4");
    f4.file = "a.hex";
    f4.eraseSettings = true;
    EXPECT_EQ(text(f4),
        "-f|interface/cmsis-dap.cfg|-c|transport select swd|-f|target/stm32f4x.cfg|-c|adapter speed "
        "2000|-c|reset_config "
        "srst_only srst_nogate|-c|init|-c|reset halt|-c|echo {** Erasing Settings **}|-c|flash erase_address pad "
        "0x0800C800 0xC00|-c|program {a.hex} verify reset exit|");
}

TEST(AbstractDcOpenOcd, EachProbeHasItsOwnWordForSwd)
{
    const auto transport = [](const std::string &probe) {
        const auto arguments = openocd::commandOf(*openocd::jobOf("openocd:" + probe, "f1")).arguments;
        return arguments.at(3);
    };
    EXPECT_EQ(transport("stlink"), "transport select hla_swd");
    EXPECT_EQ(transport("stlink-v2-1"), "transport select hla_swd");
    EXPECT_EQ(transport("stlink-dap"), "transport select dapdirect_swd");
    EXPECT_EQ(transport("nulink"), "transport select hla_swd");
    EXPECT_EQ(transport("ti-icdi"), "transport select hla_swd");
    EXPECT_EQ(transport("jlink"), "transport select swd");
}

TEST(AbstractDcOpenOcd, RefusesWhatIsNoWayIn)
{
    for (const char *via : {"", "avrdude:x", "openocd", "openocd:", "openocd:../x", "openocd:a b", "openocd:a;b"}) {
        const auto job = openocd::jobOf(via, "f1");
        ASSERT_FALSE(job) << via;
        EXPECT_EQ(job.error().fault, Fault::OutOfRange);
    }
    for (const char *target : {"", "f2", "F1"})
        EXPECT_FALSE(openocd::jobOf("openocd:stlink", target)) << target;
}

TEST(AbstractDcOpenOcd, EveryKnownFailureIsOneLineWithARemedy)
{
    struct Case {
        const char *line;
        Fault fault;
        const char *says;
    };
    for (const Case &c : {Case{"Error: open failed", Fault::LinkLost, "no debug probe"},
             Case{"Error: unable to find a matching CMSIS-DAP device", Fault::LinkLost, "no debug probe"},
             Case{"Error: No J-Link device found", Fault::LinkLost, "no debug probe"},
             Case{"Error: libusb_open() failed with LIBUSB_ERROR_ACCESS", Fault::LinkLost, "udev"},
             Case{"embedded:startup.tcl:28: Error: Can't find interface/x.cfg", Fault::OutOfRange,
                 "no interface of this name"},
             Case{"Error: init mode failed (unable to connect to the target)", Fault::Timeout, "SWDIO"},
             Case{"Error: Error connecting DP: cannot read IDR", Fault::Timeout, "SWDIO"},
             Case{"Warn : UNEXPECTED idcode: 0x2ba01477", Fault::Refused, "--target"},
             Case{"** Programming Failed **", Fault::Refused, "protected"},
             Case{"** Verify Failed **", Fault::BadCheck, "does not hold"},
             Case{"Error: something new", Fault::BadReply, "something new"}, Case{"", Fault::BadReply, "by hand"}}) {
        openocd::Reading reading;
        reading.take(c.line);
        const Error error = reading.failure({"stlink", "f1", "a.hex", false});
        EXPECT_EQ(error.fault, c.fault) << c.line;
        EXPECT_NE(error.text().find(c.says), std::string::npos) << error.text();
        EXPECT_NE(error.text().find("; "), std::string::npos) << "a remedy: " << error.text();
    }
}

} // namespace
} // namespace mb::abstractdc
