// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engine/enginecore.h"
#include "async/virtualclock.h"
#include "heard.h"
#include "support/eventloop.h"
#include "support/pseudoterminal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>

namespace mb {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

int scans = 0;

Task<void> countScan(Link &, Clock &, ScanSink &)
{
    ++scans;
    co_return {};
}

constexpr std::array serialKinds{LinkKind::Serial};

Family makeCounted()
{
    Family family{};
    family.key = "counted";
    family.links = serialKinds;
    family.scan = countScan;
    return family;
}

/// The engine with a serial port that comes and goes.
class SerialLinks : public testing::Test {
protected:
    SerialLinks()
    {
        scans = 0;
        fs::create_directories(folder);
    }
    ~SerialLinks() override { fs::remove_all(folder); }
    void plug()
    {
        terminal = std::make_unique<test::PseudoTerminal>();
        fs::remove(path);
        fs::create_symlink(terminal->path(), path);
    }
    void unplug()
    {
        fs::remove(path);
        terminal->pull();
    }
    void open(const std::string &options = {})
    {
        core.send(orders::OpenLink{*LinkAddress::parse("serial:" + path.string() + options)}, opened.finished());
        clock.advance(1ms);
    }
    [[nodiscard]] bool said(const std::string &part) const
    {
        return std::any_of(
            lines.begin(), lines.end(), [&part](const std::string &l) { return l.find(part) != std::string::npos; });
    }
    [[nodiscard]] bool isOpen()
    {
        const Snapshot shot = core.snapshot();
        return shot.links.size() == 1 && shot.links[0].state == LinkState::Open;
    }

    test::EventLoop loop;
    VirtualClock clock;
    const Family family = makeCounted();
    std::array<const Family *, 1> families{&family};
    EngineCore core{clock, families, true};
    fs::path folder = fs::path(testing::TempDir()) / ("motorbench-serial-" + std::to_string(::getpid()));
    fs::path path = folder / "ttyUSB0";
    std::unique_ptr<test::PseudoTerminal> terminal;
    test::Heard<> opened;
    std::vector<std::string> lines;
    Subscription listening = core.noticed().add(
        [this](Severity, const std::string &, const Message &text) { lines.push_back(text.english()); });
};

} // namespace

TEST_F(SerialLinks, APortThatIsNotPluggedInFailsWithItsCauseAndIsOpenedOnceItIsThere)
{
    open();
    ASSERT_TRUE(opened);
    ASSERT_FALSE(*opened);
    EXPECT_TRUE(said("there is no")) << opened->error().text();
    clock.advance(5s);
    EXPECT_EQ(lines.size(), 1U) << "told again and again";
    plug();
    clock.advance(2s);
    EXPECT_TRUE(isOpen());
    EXPECT_TRUE(said("is there"));
    EXPECT_EQ(scans, 1);
}

TEST_F(SerialLinks, APulledAdapterIsLostAndComesBackByItself)
{
    plug();
    open();
    ASSERT_TRUE(opened && *opened);
    unplug();
    ASSERT_TRUE(loop.runUntil([this] { return core.snapshot().links[0].state == LinkState::Lost; }));
    EXPECT_TRUE(said("hung up; start it again"));
    clock.advance(5s);
    EXPECT_FALSE(isOpen());
    plug();
    clock.advance(2s);
    EXPECT_TRUE(isOpen());
    EXPECT_TRUE(said("is back"));
}

TEST_F(SerialLinks, AnotherAdapterUnderItsNameIsAnotherLinkWhoseDevicesAreLookedFor)
{
    std::string adapter = "/usb1";
    core.session().linkBook().setIdentify([&adapter](const LinkAddress &) { return adapter; });
    plug();
    open();
    ASSERT_TRUE(isOpen());
    unplug();
    ASSERT_TRUE(loop.runUntil([this] { return core.snapshot().links[0].state == LinkState::Lost; }));
    adapter = "/usb2";
    plug();
    clock.advance(2s);
    EXPECT_TRUE(isOpen());
    EXPECT_TRUE(said("another adapter has this name now"));
    EXPECT_FALSE(said("is back"));
    EXPECT_EQ(scans, 2);
    EXPECT_EQ(core.session().links().front()->line(), "/usb2");
}

TEST_F(SerialLinks, ALostOneWhoseAdapterIsOpenUnderAnotherNameLeavesTheList)
{
    core.session().linkBook().setIdentify([](const LinkAddress &) { return "/usb1"; });
    plug();
    open();
    unplug();
    ASSERT_TRUE(loop.runUntil([this] { return core.snapshot().links[0].state == LinkState::Lost; }));
    path = folder / "ttyUSB1";
    plug();
    open();
    clock.advance(2s);
    EXPECT_TRUE(isOpen());
    EXPECT_EQ(core.session().links().front()->address().path, path.string());
    EXPECT_TRUE(said("its adapter has another name now"));
}

TEST_F(SerialLinks, ALineIsScannedWhenItOpensAndWhenAskedAndNeverByItself)
{
    plug();
    open();
    clock.advance(60s);
    EXPECT_EQ(scans, 1);
    core.send(orders::ScanLinks{});
    clock.advance(1s);
    EXPECT_EQ(scans, 2);
}

TEST_F(SerialLinks, AClosedOneIsNotOpenedAgain)
{
    open();
    core.send(orders::CloseLink{"serial:" + path.string()});
    plug();
    clock.advance(5s);
    EXPECT_TRUE(core.snapshot().links.empty());
}

TEST_F(SerialLinks, WhatTheUserShouldKnowOfAPortIsSaid)
{
    plug();
    open("?rs485=1");
    ASSERT_TRUE(opened && *opened);
    EXPECT_TRUE(said("cannot switch the direction of an RS-485 line"));
}

} // namespace mb
