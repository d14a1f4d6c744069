// SPDX-License-Identifier: GPL-3.0-or-later
// The place of hardware, by which a guardian finds its line again whatever that is called by then.
#include "folder.h"
#include "place/place.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace mb {
namespace {

using guardian::test::Folder;

TEST(Place, IsThatOfTheHardwareWhateverItIsCalledToday)
{
    const Folder folder;
    const std::string usb = folder.path("sys/devices/usb1/1-2");
    std::filesystem::create_directories(usb + "/1-2:1.0/ttyUSB3");
    std::filesystem::create_directories(folder.path("sys/class/tty/ttyUSB3"));
    std::filesystem::create_directories(folder.path("dev"));
    std::ofstream(usb + "/idVendor") << "0403\n";
    std::ofstream(usb + "/serial") << "A10K\n";
    std::ofstream(folder.path("dev/ttyUSB3")) << "";
    std::filesystem::create_symlink(usb + "/1-2:1.0/ttyUSB3", folder.path("sys/class/tty/ttyUSB3/device"));
    const std::string root = folder.path();
    const std::string place = placeOf(PlaceKind::SerialPort, "/dev/ttyUSB3", root);
    EXPECT_EQ(place, "/sys/devices/usb1/1-2/1-2:1.0#A10K");
    EXPECT_EQ(nameAt(PlaceKind::SerialPort, place, root), "/dev/ttyUSB3");
    EXPECT_EQ(nameAt(PlaceKind::SerialPort, "/sys/devices/usb1/1-2/1-2:1.0#OTHER", root), "")
        << "another adapter there";
    EXPECT_EQ(placeOf(PlaceKind::SerialPort, "/dev/ttyUSB4", root), "");
}

TEST(Place, TellsTheChannelsOfOneAdapterApart)
{
    const Folder folder;
    for (const char *channel : {"0", "1"}) {
        const std::string row = folder.path("sys/class/net/can") + channel;
        std::filesystem::create_directories(row);
        std::filesystem::create_directories(folder.path("sys/devices/pci0/0000:02"));
        std::filesystem::create_symlink(folder.path("sys/devices/pci0/0000:02"), row + "/device");
        std::ofstream(row + "/dev_port") << channel << '\n';
    }
    const std::string root = folder.path();
    EXPECT_NE(placeOf(PlaceKind::CanInterface, "can0", root), placeOf(PlaceKind::CanInterface, "can1", root));
    EXPECT_EQ(nameAt(PlaceKind::CanInterface, placeOf(PlaceKind::CanInterface, "can1", root), root), "can1");
}

TEST(Place, TellsThePortsOfOneUsbInterfaceApart)
{
    const Folder folder;
    const std::string interface = folder.path("sys/devices/usb1/1-1/1-1:1.0");
    std::filesystem::create_directories(folder.path("dev"));
    for (const std::string number : {"0", "1"}) {
        const std::string name = "ttyUSB" + number;
        std::filesystem::create_directories(interface + '/' + name);
        std::filesystem::create_directories(folder.path("sys/class/tty/") + name);
        std::ofstream(folder.path("dev/") + name) << "";
        std::ofstream(interface + '/' + name + "/port_number") << number << '\n';
        std::filesystem::create_symlink(interface + '/' + name, folder.path("sys/class/tty/") + name + "/device");
    }
    const std::string root = folder.path();
    EXPECT_EQ(placeOf(PlaceKind::SerialPort, "ttyUSB0", root), "/sys/devices/usb1/1-1/1-1:1.0")
        << "files are kept by it";
    for (const char *name : {"/dev/ttyUSB0", "/dev/ttyUSB1"})
        EXPECT_EQ(nameAt(PlaceKind::SerialPort, placeOf(PlaceKind::SerialPort, name, root), root), name);
}

TEST(Place, TellsThePortsOfOneCardApart)
{
    const Folder folder;
    std::filesystem::create_directories(folder.path("dev"));
    for (const std::string number : {"4", "5", "6"}) {
        const std::string device = folder.path("sys/devices/pci0/0000:0") + (number == "6" ? "3" : "2");
        const std::string row = folder.path("sys/class/tty/ttyS") + number;
        std::filesystem::create_directories(row);
        std::filesystem::create_directories(device);
        std::ofstream(folder.path("dev/ttyS") + number) << "";
        std::ofstream(row + "/port") << (number == "6" ? "0xE000" : "0x0") << '\n';
        std::ofstream(row + "/iomem_base") << "0xF000" << number << "00\n";
        std::filesystem::create_symlink(device, row + "/device");
    }
    const std::string root = folder.path();
    EXPECT_EQ(placeOf(PlaceKind::SerialPort, "ttyS6", root), "/sys/devices/pci0/0000:03") << "files are kept by it";
    for (const char *name : {"/dev/ttyS4", "/dev/ttyS5", "/dev/ttyS6"})
        EXPECT_EQ(nameAt(PlaceKind::SerialPort, placeOf(PlaceKind::SerialPort, name, root), root), name);
}

} // namespace
} // namespace mb
