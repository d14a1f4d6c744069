// SPDX-License-Identifier: GPL-3.0-or-later
// The engine's half of recording and replaying, in virtual time.
#include "app/engine/enginecore.h"
#include "async/virtualclock.h"
#include "heard.h"
#include "model/registry.h"
#include "support/fulldisk.h"
#include "support/temporaryfile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

namespace mb {
namespace {

using namespace std::chrono_literals;

struct EngineBench {
    EngineBench()
        : core(clock, families(), false)
        , noticed(core.noticed().add([this](Severity severity, const std::string &, const Message &text) {
            notices.emplace_back(severity, text.english());
        }))
    {
    }
    Result<void> open(const std::string &address) { return ask(orders::OpenLink{*LinkAddress::parse(address)}); }
    /// The answer, which may take a moment.
    template <class O> Result<void> ask(O order)
    {
        const test::Heard<> heard;
        core.send(std::move(order), heard.finished());
        (void)clock.runUntil([&heard] { return heard.has_value(); }, 1s);
        return heard.value_or(fail(Fault::Timeout, say("no answer")));
    }
    LinkView view(const std::string &address)
    {
        const Snapshot shot = core.snapshot();
        const LinkView *found = shot.link(address);
        return found ? *found : LinkView{};
    }
    [[nodiscard]] bool wasTold(const std::string &text) const
    {
        return std::any_of(notices.begin(), notices.end(),
            [&text](const auto &notice) { return notice.second.find(text) != std::string::npos; });
    }

    test::TemporaryFolder folder;
    VirtualClock clock;
    EngineCore core;
    std::vector<std::pair<Severity, std::string>> notices;
    Subscription noticed;
};

/// Records five seconds of the simulated bench.
std::string recorded(EngineBench &bench)
{
    const std::string path = bench.folder.path("run.log");
    EXPECT_TRUE(bench.open("sim:can"));
    bench.clock.advance(2s);
    EXPECT_TRUE(bench.ask(orders::StartRecording{"sim:can", path}));
    bench.clock.advance(5s);
    EXPECT_GT(bench.view("sim:can").recording->frames, 500U);
    bench.core.send(orders::StopRecording{"sim:can"});
    while (!bench.view("sim:can").recording->finished)
        std::this_thread::yield();
    bench.clock.advance(1s);
    EXPECT_TRUE(bench.wasTold("recorded, none is missing"));
    return "replay:" + path;
}

TEST(EngineRecordings, AreMadeAndPlayedOnceTheirDevicesAreKnown)
{
    EngineBench bench;
    const std::string address = recorded(bench);
    const test::Heard<> opened;
    bench.core.send(orders::OpenLink{*LinkAddress::parse(address)}, opened.finished());
    int waited = 0; // looks at which it is there and does not play
    std::size_t known = 0;
    ASSERT_TRUE(bench.clock.runUntil(
        [&] {
            const Snapshot shot = bench.core.snapshot();
            const LinkView *link = shot.link(address);
            known = static_cast<std::size_t>(std::count_if(shot.devices.begin(), shot.devices.end(),
                [&address](const DeviceView &device) { return device.link == address; }));
            waited += link && !link->replay->running ? 1 : 0;
            return link && link->replay->running;
        },
        1s));
    EXPECT_GT(waited, 0);
    EXPECT_EQ(known, 6U) << "it does not play before";
    bench.clock.advance(1s);
    ASSERT_TRUE(opened && *opened);
    const LinkView view = bench.view(address);
    EXPECT_TRUE(view.replay->running);
    EXPECT_EQ(view.replay->surveyed, 1.0);
    EXPECT_GT(view.counters.rx, 100U);
    const Snapshot shot = bench.core.snapshot();
    const auto onReplay = [&](const DeviceView &device) { return device.link == address; };
    std::vector<std::string> found;
    for (const DeviceView &device : shot.devices) {
        if (onReplay(device))
            found.push_back(device.selector.substr(address.size() + 1) + ' ' + device.identity->dialect);
    }
    EXPECT_EQ(found,
        (std::vector<std::string>{
            "abstractdc:3 F", "abstractdc:4 L", "abstractdc:5 D", "dmc60c:5 ", "dmc60c:7 ", "dmc60c:9 "}));
    for (const DeviceView &device : shot.devices)
        EXPECT_EQ(device.mayNotMove.english().find("is a recording") != std::string::npos, onReplay(device))
            << device.selector;
    const auto played = std::ranges::find_if(shot.devices, onReplay);
    const auto update = bench.ask(orders::UpdateFirmware{played->id, std::make_shared<FirmwareImage>(), {}});
    EXPECT_EQ(update.error().fault, Fault::Unsupported) << update.error().text();
    const auto again = bench.ask(orders::StartRecording{"sim:can", bench.folder.path("run.log")});
    EXPECT_NE(again.error().text().find("run.log: it is being recorded or replayed"), std::string::npos);
    bench.clock.advance(10s);
    EXPECT_TRUE(bench.view(address).replay->ended);
}

TEST(EngineRecordings, ArePausedSoughtAndPaced)
{
    EngineBench bench;
    const std::string address = recorded(bench);
    ASSERT_TRUE(bench.open(address));
    bench.clock.advance(1s);
    bench.core.send(orders::SteerReplay{address, {std::nullopt, std::nullopt, false}});
    const Duration stood = bench.view(address).replay->position;
    bench.clock.advance(10s);
    EXPECT_EQ(bench.view(address).replay->position, stood);
    const auto devices = bench.core.snapshot().devices.size();
    bench.core.send(orders::SteerReplay{address, {2.0, 1s, true}});
    EXPECT_EQ(bench.view(address).replay->position, 1s);
    bench.clock.advance(1s);
    EXPECT_EQ(bench.view(address).replay->position, 3s);
    EXPECT_EQ(bench.core.snapshot().devices.size(), devices);
    bench.core.send(orders::SteerReplay{address, {-1.0, std::nullopt, std::nullopt}});
    EXPECT_TRUE(bench.wasTold("is no speed")) << "a wrong order is told";
    bench.core.send(orders::SteerReplay{"sim:can", {std::nullopt, 1s, true}});
    bench.core.send(orders::CloseLink{address});
    bench.clock.advance(1s);
    EXPECT_TRUE(bench.view(address).address.empty());
}

TEST(EngineRecordings, SayOnceWhyTheyFail)
{
    EngineBench bench;
    ASSERT_TRUE(bench.open("sim:can"));
    Result<void> started = bench.ask(orders::StartRecording{"socketcan:can7", bench.folder.path("a.log")});
    EXPECT_EQ(started.error().fault, Fault::LinkLost);
    started = bench.ask(orders::StartRecording{"sim:can", bench.folder.path("none/a.log")});
    EXPECT_NE(started.error().text().find("there is no such folder; "), std::string::npos);
    started = bench.ask(orders::StartRecording{"sim:can", bench.folder.path("a.log")});
    ASSERT_TRUE(started);
    started = bench.ask(orders::StartRecording{"sim:can", bench.folder.path("b.log")});
    EXPECT_NE(started.error().text().find("is being recorded already"), std::string::npos);
    const auto damaged = bench.folder.write("damaged.log", "(1.000000) can0 02061405#0040110000000000\nrubbish\n(2.0");
    ASSERT_TRUE(bench.open("replay:" + damaged));
    bench.clock.advance(1min);
    const auto told = std::count_if(bench.notices.begin(), bench.notices.end(),
        [](const auto &notice) { return notice.second.find("damaged.log: line 2") != std::string::npos; });
    EXPECT_EQ(told, 1);
}

TEST(EngineRecordings, TellWhatOfOneIsLeftOut)
{
    EngineBench bench;
    const auto cut = bench.folder.write(
        "cut.log", "(1.000000) can0 02061405#0040110000000000\n(1.500000) can0 123##311223344\n(2.0");
    ASSERT_TRUE(bench.open("replay:" + cut));
    EXPECT_TRUE(bench.wasTold("1 CAN FD frame is left out, because only classic CAN is read"));
    EXPECT_TRUE(bench.wasTold("the last line is cut off, and left out"));
}

TEST(EngineRecordings, EndOnceWhenTheDiskIsFull)
{
    EngineBench bench;
    ASSERT_TRUE(bench.open("sim:can"));
    bench.clock.advance(2s);
    Result<void> started = bench.ask(orders::StartRecording{"sim:can", "/dev/full"});
    if (!started)
        GTEST_SKIP() << "there is no /dev/full here";
    while (!bench.view("sim:can").recording->finished) {
        bench.clock.advance(200ms);
        std::this_thread::yield();
    }
    bench.clock.advance(1s);
    const RecordingState end = *bench.view("sim:can").recording;
    EXPECT_EQ(end.lost, end.frames);
    const auto told = std::count_if(bench.notices.begin(), bench.notices.end(),
        [](const auto &notice) { return notice.second.find("the disk is full") != std::string::npos; });
    EXPECT_EQ(told, 1);
    started = bench.ask(orders::StartRecording{"sim:can", bench.folder.path("b.log")});
    EXPECT_TRUE(started) << "another recording may begin";
}

TEST(EngineRecordings, WhatADiskTookBeforeItWasFullIsPlayed)
{
    EngineBench bench;
    const std::string path = bench.folder.path("run.log");
    ASSERT_TRUE(bench.open("sim:can"));
    bench.clock.advance(2s);
    {
        const test::FullDisk full(20'000);
        bench.core.send(orders::StartRecording{"sim:can", path});
        bench.clock.advance(5s);
        while (!bench.view("sim:can").recording->finished) {
            bench.clock.advance(200ms);
            std::this_thread::yield();
        }
        bench.clock.advance(1s);
    }
    const RecordingState end = *bench.view("sim:can").recording;
    EXPECT_NE(end.problem.english().find("greatest size"), std::string::npos) << end.problem;
    EXPECT_GT(end.frames, end.lost) << "the first frames are in the file";
    EXPECT_FALSE(bench.wasTold("none is missing"));
    ASSERT_TRUE(bench.open("replay:" + path));
    bench.clock.advance(1s);
    EXPECT_FALSE(bench.wasTold("run.log: line")) << "no half of one is there";
    EXPECT_GT(bench.view("replay:" + path).counters.rx, 100U);
}

} // namespace
} // namespace mb
