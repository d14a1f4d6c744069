// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/eventloop.h"
#include "support/pseudoterminal.h"
#include "transport/backends/ptyline.h"
#include "transport/backends/serialport.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace mb;
using namespace mb::test;
namespace fs = std::filesystem;

namespace {

using Bytes = std::vector<std::uint8_t>;

/// A device that answers each byte with the next number.
struct Answerer {
    explicit Answerer(PtyLine &line)
        : link(line.makeEnd())
    {
        EXPECT_TRUE(link->open());
        received = link->received().add([this](std::span<const std::uint8_t> bytes) {
            for (const std::uint8_t byte : bytes)
                EXPECT_TRUE(link->send(Bytes{static_cast<std::uint8_t>(byte + 1)}));
        });
    }
    std::unique_ptr<VirtualSerialLink> link;
    Subscription received;
};

struct PtyLines : public ::testing::Test {
    PtyLines() { fs::create_directories(folder); }
    ~PtyLines() override { fs::remove_all(folder); }
    std::unique_ptr<PtyLine> make(const std::string &options = {})
    {
        auto line = PtyLine::create(LinkAddress::parse("pty:" + path + options).value(), loop.clock());
        EXPECT_TRUE(line);
        return std::move(*line);
    }
    std::unique_ptr<SerialLink> host(int rate)
    {
        auto link = makeSerialPortLink(LinkAddress::parse("serial:" + path).value(), loop.clock());
        EXPECT_TRUE((*link)->open());
        std::unique_ptr<SerialLink> serial(static_cast<SerialLink *>(link->release()));
        EXPECT_TRUE(serial->setBaudrate(rate));
        received = serial->received().add(
            [this](std::span<const std::uint8_t> bytes) { heard.insert(heard.end(), bytes.begin(), bytes.end()); });
        return serial;
    }

    EventLoop loop;
    fs::path folder = fs::path(testing::TempDir()) / ("motorbench-pty-" + std::to_string(::getpid()));
    std::string path = (folder / "tty0").string();
    Bytes heard;
    Subscription received;
};

} // namespace

TEST_F(PtyLines, DevicesAnswerAtTheSpeedOfTheHostAndTakeTheTimeOfItsBytes)
{
    const auto line = make();
    ASSERT_TRUE(line->open());
    const Answerer device(*line);
    for (const int rate : {600, 9600, 119048}) {
        heard.clear();
        const auto link = host(rate);
        const Instant start = loop.clock().now();
        ASSERT_TRUE(link->send(Bytes{0x41}));
        ASSERT_TRUE(loop.runUntil([&] { return !heard.empty(); })) << rate;
        EXPECT_EQ(heard, Bytes{0x42}) << rate;
        EXPECT_GE(loop.clock().now() - start, 2 * link->byteTime()) << rate;
    }
}

TEST_F(PtyLines, WithABaudRateOnlyThatOneIsUnderstood)
{
    const auto line = make("?baud=57600");
    ASSERT_TRUE(line->open());
    const Answerer device(*line);
    {
        const auto wrong = host(9600);
        ASSERT_TRUE(wrong->send(Bytes{0x41}));
        loop.runUntil([] { return false; }, std::chrono::milliseconds(100));
        EXPECT_NE(heard, Bytes{0x42});
        EXPECT_GT(device.link->counters().errors, 0U);
    }
    heard.clear();
    const auto right = host(57600);
    ASSERT_TRUE(right->send(Bytes{0x41}));
    ASSERT_TRUE(loop.runUntil([&] { return !heard.empty(); }));
    EXPECT_EQ(heard, Bytes{0x42});
}

TEST_F(PtyLines, AStaleLinkIsReplacedAndOursIsRemovedAtTheEnd)
{
    fs::create_symlink("/dev/pts/99999", path);
    {
        const auto line = make();
        ASSERT_TRUE(line->open());
        EXPECT_TRUE(fs::is_symlink(path));
        EXPECT_TRUE(fs::exists(path));
    }
    EXPECT_FALSE(fs::is_symlink(path));
}

TEST_F(PtyLines, WhatIsNoLinkToATerminalStays)
{
    std::ofstream(path) << "precious";
    const auto line = make();
    const auto opened = line->open();
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().text(), path + " is there already and no link to a terminal; choose another path");
    EXPECT_EQ(fs::file_size(path), 8U);
    fs::remove(path);
    fs::create_symlink(folder, path);
    EXPECT_FALSE(make()->open());
    EXPECT_TRUE(fs::is_symlink(path));
}

TEST_F(PtyLines, ALinkToATerminalThatAnotherProgramServesStays)
{
    const PseudoTerminal others;
    fs::create_symlink(others.path(), path);
    const auto opened = make()->open();
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().text(),
        path + " leads to a terminal that another program serves; end that one first, or choose another path");
    EXPECT_EQ(fs::read_symlink(path), others.path());
    const std::array<timespec, 2> longAgo{{{1'000'000'000, 0}, {1'000'000'000, 0}}}; // the number is another's by now
    ASSERT_EQ(::utimensat(AT_FDCWD, path.c_str(), longAgo.data(), AT_SYMLINK_NOFOLLOW), 0);
    EXPECT_TRUE(make()->open());
}

TEST_F(PtyLines, APathThatIsServedIsRefusedAndTheOneThatServesItKeepsIt)
{
    const auto first = make();
    ASSERT_TRUE(first->open());
    {
        const auto second = make();
        const auto opened = second->open();
        ASSERT_FALSE(opened);
        EXPECT_EQ(opened.error().fault, Fault::LinkLost);
    }
    EXPECT_TRUE(fs::exists(path));
}

TEST_F(PtyLines, AFolderThatIsNotThereAndOptionsThatItDoesNotHaveAreNamed)
{
    path = (folder / "nowhere" / "tty0").string();
    const auto opened = make()->open();
    ASSERT_FALSE(opened);
    EXPECT_NE(opened.error().text().find("cannot be made"), std::string::npos);
    for (const char *text : {"pty:x?baud=x", "pty:x?baud=5", "pty:x?rs485=1"})
        EXPECT_EQ(PtyLine::create(LinkAddress::parse(text).value(), loop.clock()).error().fault, Fault::OutOfRange)
            << text;
}

TEST_F(PtyLines, AHostMayComeBackAfterItLeft)
{
    const auto line = make();
    ASSERT_TRUE(line->open());
    const Answerer device(*line);
    for (int round = 0; round < 3; ++round) {
        heard.clear();
        const auto link = host(115200);
        ASSERT_TRUE(link->send(Bytes{1}));
        ASSERT_TRUE(loop.runUntil([&] { return !heard.empty(); })) << round;
        link->close();
        loop.runUntil([] { return false; }, std::chrono::milliseconds(60));
    }
}
