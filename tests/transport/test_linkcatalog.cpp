// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/virtualclock.h"
#include "transport/backends/serialports.h"
#include "transport/linkcatalog.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <fcntl.h>
#include <unistd.h>

namespace {

std::string_view forbidden; ///< a path that this user may not use, whoever that is

} // namespace

extern "C" int access(const char *path, int mode) noexcept
{
    if (forbidden.empty() || std::string_view(path) != forbidden)
        return ::faccessat(AT_FDCWD, path, mode, 0);
    errno = EACCES;
    return -1;
}

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
    for (const char *text : {"sim:can", "sim:serial", "sim:spi"}) {
        const auto link = createLink(LinkAddress::parse(text).value(), clock);
        ASSERT_FALSE(link) << text;
        EXPECT_EQ(link.error().fault, Fault::Unsupported) << text;
    }
}

TEST(LinkCatalog, RefusesOptionsAndPathsThatAKindDoesNotHave)
{
    VirtualClock clock;
    for (const char *text :
        {"socketcan:can0?bitrate=5", "qtcan:peakcan", "qtcan::usb0", "qtcan:peakcan:usb0?bitrate=fast",
            "qtcan:peakcan:usb0?speed=5", "serial:/dev/ttyUSB0?speed=5", "pty:./tty0"}) {
        const auto link = createLink(LinkAddress::parse(text).value(), clock);
        ASSERT_FALSE(link) << text;
        EXPECT_EQ(link.error().fault, Fault::OutOfRange) << text;
    }
}

TEST(LinkCatalog, SaysWhatIsWrongWithAnAddress)
{
    VirtualClock clock;
    const auto refusal = [&clock](const LinkAddress &address) {
        const auto link = createLink(address, clock);
        return link ? std::string() : link.error().text();
    };
    const auto parsed = [](const char *text) { return LinkAddress::parse(text).value(); };
    EXPECT_EQ(refusal(parsed("socketcan:can0?bitrate=5")), "socketcan links have no option 'bitrate'");
    EXPECT_EQ(refusal(parsed("unix:./board?pace=1")), "unix links have no option 'pace'");
    EXPECT_EQ(refusal(parsed("unix:./board")), "");
    EXPECT_EQ(refusal(parsed("pty:./tty0")),
        "pty: is where 'simulate' puts its devices; open that terminal as serial:./tty0");
    EXPECT_EQ(refusal(parsed("spidev:/dev/spidev0.0?bitrate=5")),
        "spidev links have no option 'bitrate'; speed, ready and reset are known");
    EXPECT_EQ(refusal(parsed("sim:can")), "simulated links belong to a bench");
    EXPECT_EQ(refusal({"pigeon", "grey", {}}), "pigeon links are not supported yet");
    EXPECT_EQ(createLink(parsed("unix:./board"), clock).value()->kind(), LinkKind::Spi);
    EXPECT_EQ(createLink(parsed("socketcan:can0"), clock).value()->kind(), LinkKind::Can);
}

TEST(LinkCatalog, ASpiBusHasTenKilohertzToTenMegahertz)
{
    VirtualClock clock;
    const auto isTaken = [&clock](const char *speed) {
        return createLink(LinkAddress::parse(std::string("spidev:/dev/spidev0.0?speed=") + speed).value(), clock)
            .has_value();
    };
    for (const char *const good : {"10000", "500000", "10000000"})
        EXPECT_TRUE(isTaken(good)) << good;
    for (const char *const bad : {"9999", "10000001", "0", "-1", "fast"})
        EXPECT_FALSE(isTaken(bad)) << bad;
}

TEST(LinkCatalog, AnInterfaceThatIsNotThereFailsToOpenWithItsCause)
{
    VirtualClock clock;
    auto link = createLink(LinkAddress::parse("socketcan:nosuchcan7").value(), clock);
    ASSERT_TRUE(link);
    const auto opened = (*link)->open();
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().fault, Fault::LinkLost);
    const std::string &detail = opened.error().text();
    EXPECT_TRUE(detail == "there is no CAN interface nosuchcan7" || detail.find("CAN s") != std::string::npos)
        << detail;
    EXPECT_EQ((*link)->state(), LinkState::Closed);
}

TEST(SerialPorts, OneThatIsNotThereOrNotOursIsNamedWithTheRemedy)
{
    EXPECT_EQ(whyUnusable("null", "/dev/null"), std::nullopt);
    EXPECT_EQ(whyUnusable("mine", "/dev/mbnone"),
        (Diagnosis{
            Ailment::NotThere, say("there is no %1", "mine"), say("plug in the adapter, or name another port"), {}}));
    EXPECT_EQ(whyUnusable("letters", "/etc/passwd"),
        (Diagnosis{Ailment::Failed, say("%1 is no serial port", "letters"), say("name one such as /dev/ttyUSB0"), {}}));
    forbidden = "/dev/null";
    const auto theirs = whyUnusable("null", "/dev/null");
    forbidden = {};
    EXPECT_EQ(theirs,
        (Diagnosis{Ailment::NoPermission, say("no permission to use %1", "null"), say("become a member of its group"),
            "sudo usermod -aG dialout $USER"}))
        << "the group of root is none to become a member of";
}

TEST(SerialPorts, AreThoseWithHardwareBehindThemAndDescribedByTheirUsbDevice)
{
    namespace fs = std::filesystem;
    const fs::path root = fs::path(testing::TempDir()) / ("motorbench-tty-" + std::to_string(::getpid()));
    const fs::path usb = root / "devices" / "usb1" / "1-1";
    const fs::path tty = root / "tty";
    const auto write = [](const fs::path &file, const char *text) { std::ofstream(file) << text << '\n'; };
    fs::create_directories(usb / "1-1:1.0" / "ttyUSB0");
    write(usb / "product", "FT232R USB UART");
    write(usb / "manufacturer", "FTDI");
    write(usb / "serial", "A50285BI");
    write(usb / "idVendor", "0403");
    write(usb / "idProduct", "6001");
    fs::create_directories(root / "devices" / "uart");
    for (const char *name : {"ttyUSB0", "ttyS0", "ttyS1", "tty0"})
        fs::create_directories(tty / name);
    fs::create_directory_symlink(usb / "1-1:1.0" / "ttyUSB0", tty / "ttyUSB0" / "device");
    fs::create_directory_symlink(root / "devices" / "uart", tty / "ttyS0" / "device");
    fs::create_directory_symlink(root / "devices" / "uart", tty / "ttyS1" / "device");
    write(tty / "ttyS0" / "type", "4");
    write(tty / "ttyS1" / "type", "0");
    const auto ports = serialPorts(tty);
    fs::remove(usb / "manufacturer");
    fs::remove(usb / "serial");
    const auto withoutMaker = serialPorts(tty);
    write(usb / "manufacturer", "FTDI");
    fs::remove(usb / "product");
    fs::remove(usb / "idProduct");
    const auto withoutProduct = serialPorts(tty);
    fs::remove(usb / "manufacturer");
    fs::remove(usb / "idVendor");
    const auto withoutTexts = serialPorts(tty);
    fs::remove_all(root);
    EXPECT_EQ(withoutMaker.at(1).description, "FT232R USB UART, 0403:6001");
    EXPECT_EQ(withoutProduct.at(1).description, "FTDI, 0403:");
    EXPECT_EQ(withoutTexts.at(1).description, "");
    ASSERT_EQ(ports.size(), 2U);
    EXPECT_EQ(ports[0].path, "/dev/ttyS0");
    EXPECT_EQ(ports[0].description, "");
    EXPECT_EQ(ports[1].path, "/dev/ttyUSB0");
    EXPECT_EQ(ports[1].description, "FTDI FT232R USB UART, serial number A50285BI, 0403:6001");
    EXPECT_TRUE(serialPorts(root / "nothing").empty());
}

TEST(LinkCatalog, MakesARecording)
{
    VirtualClock clock;
    const auto link = createLink(*LinkAddress::parse("replay:run.log"), clock);
    ASSERT_TRUE(link);
    EXPECT_EQ((*link)->kind(), LinkKind::Can);
    EXPECT_FALSE(createLink(*LinkAddress::parse("replay:run.log?x=1"), clock));
}
