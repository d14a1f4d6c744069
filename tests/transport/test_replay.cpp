// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/virtualclock.h"
#include "support/heldbackground.h"
#include "support/temporaryfile.h"
#include "transport/backends/replay.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <tuple>
#include <vector>

namespace mb {
namespace {

using namespace std::chrono_literals;

constexpr Duration began = 1436509052s;
const std::string log = "(1436509052.000000) can0 02061405#0040110000000000\n"
                        "(1436509052.250000) can0 02060005#0F00000000000000 T\n"
                        "(1436509052.250000) can1 123#01\n"
                        "(1436509053.000000) can0 20000004#0004000000000000\n"
                        "(1436509062.000000) can0 02061485#01E240FED4000014\n";

struct Replay {
    explicit Replay(const std::string &text = log, const std::string &options = {})
        : path(folder.write("run.log", text))
        , opened(open("replay:" + path + options))
    {
    }
    Result<void> open(const std::string &text)
    {
        auto made = ReplayLink::create(*LinkAddress::parse(text), clock);
        if (!made)
            return fail(made.error());
        link = std::move(*made);
        received = link->received().add([this](const CanFrame &frame) { frames.push_back(frame); });
        traffic = link->traffic().add([this](const Traffic &t) { passed.emplace_back(t.direction, *t.can); });
        end = link->ended().add([this] { ++ends; });
        return link->open();
    }
    bool survey()
    {
        while (true) {
            const auto done = link->survey([](const LoggedFrame &) {});
            if (!done || *done)
                return done.has_value();
        }
    }

    test::TemporaryFolder folder;
    VirtualClock clock;
    std::string path;
    std::unique_ptr<ReplayLink> link;
    std::vector<CanFrame> frames;
    std::vector<std::pair<Direction, CanFrame>> passed;
    int ends = 0;
    Subscription received;
    Subscription traffic;
    Subscription end;
    Result<void> opened;
};

TEST(Replay, PlaysFramesAtTheirTimesAndStandsAtTheEnd)
{
    Replay replay;
    ASSERT_TRUE(replay.opened);
    replay.clock.advance(1h);
    EXPECT_TRUE(replay.passed.empty()) << "it stands until it is let play";
    replay.link->play();
    replay.clock.advance(0ns);
    ASSERT_EQ(replay.frames.size(), 1U);
    EXPECT_EQ(replay.frames[0].time, Instant(began));
    replay.clock.advance(1s);
    EXPECT_EQ(replay.frames.size(), 2U);
    EXPECT_EQ(replay.passed.size(), 4U);
    EXPECT_EQ(replay.passed[1].first, Direction::Sent) << "what the recorder sent is seen, not received";
    EXPECT_EQ(replay.link->counters().rx, 3U);
    EXPECT_EQ(replay.link->counters().tx, 1U);
    EXPECT_EQ(replay.link->counters().errors, 1U);
    EXPECT_EQ(replay.ends, 0);
    replay.clock.advance(20s);
    EXPECT_EQ(replay.ends, 1);
    EXPECT_EQ(replay.frames.size(), 3U);
    EXPECT_TRUE(replay.link->replay().ended);
    EXPECT_FALSE(replay.link->replay().running);
    EXPECT_EQ(replay.link->replay().position, 10s);
    EXPECT_EQ(replay.link->timeLine().now(), Instant(began + 10s));
    EXPECT_EQ(replay.clock.armed(), 0U);
}

TEST(Replay, HasItsSpeedFromTheAddress)
{
    for (const auto &[option, seconds] : {std::pair{"?speed=2", 5.0}, {"?speed=0.5", 20.0}, {"?speed=max", 0.0}}) {
        Replay replay(log, option);
        ASSERT_TRUE(replay.opened);
        replay.link->play();
        ASSERT_TRUE(replay.clock.runUntil([&] { return replay.ends == 1; })) << option;
        EXPECT_EQ(std::chrono::duration<double>(replay.clock.now().time_since_epoch()).count(), seconds) << option;
        EXPECT_EQ(replay.frames.back().time, Instant(began + 10s));
    }
}

TEST(Replay, ItsPaceIsChangedWhileItRunsAndWhileItStands)
{
    Replay replay;
    ASSERT_TRUE(replay.opened);
    ASSERT_TRUE(replay.link->setPace(4.0));
    EXPECT_EQ(replay.link->replay().pace, 4.0);
    replay.clock.advance(10s);
    EXPECT_FALSE(replay.link->replay().running) << "another pace lets nothing play";
    EXPECT_EQ(replay.link->replay().position, 0s);
    replay.link->play();
    replay.clock.advance(125ms);
    EXPECT_EQ(replay.link->replay().position, 500ms);
    ASSERT_TRUE(replay.link->setPace(0.5));
    replay.clock.advance(1s - 1ns);
    EXPECT_EQ(replay.passed.size(), 3U);
    replay.clock.advance(1ns);
    EXPECT_EQ(replay.passed.size(), 4U);
    EXPECT_EQ(replay.link->replay().position, 1s);
    for (const double good : {0.01, 1000.0, 0.0})
        EXPECT_TRUE(replay.link->setPace(good)) << good;
    replay.clock.advance(1ns);
    EXPECT_EQ(replay.ends, 1) << "as fast as possible";
    for (const auto &[bad, text] : {std::pair{0.0099, "0.009900"}, {1000.1, "1000.100000"}, {-1.0, "-1.000000"}}) {
        const auto refused = replay.link->setPace(bad);
        ASSERT_FALSE(refused) << text;
        EXPECT_EQ(refused.error().fault, Fault::OutOfRange);
        EXPECT_EQ(refused.error().text(), "speed=" + std::string(text) + " is no speed; legal is 0.01 … 1000, or max");
    }
    EXPECT_EQ(replay.link->replay().pace, 0.0);
}

TEST(Replay, OneThatIsClosedTellsNothingAndLeavesNoTimer)
{
    std::string text = "(1436509052.000000) can1 123#01\n";
    while (text.size() < 600'000)
        text += "(1436509053.000000) can0 02061405#0040110000000000\n";
    Replay replay(text, "?interface=can1");
    ASSERT_TRUE(replay.opened);
    replay.link->play();
    replay.clock.step();
    EXPECT_TRUE(replay.link->replay().running) << "the next piece is read";
    replay.link->close();
    EXPECT_EQ(replay.clock.armed(), 0U);
    EXPECT_EQ(replay.link->replay(), ReplayState{});
    EXPECT_TRUE(replay.link->remark().empty());
    EXPECT_EQ(replay.link->seek(0s).error().text(), "run.log is not open");
    EXPECT_EQ(replay.link->survey([](const LoggedFrame &) {}).error().text(), "run.log is not open");
    replay.link->play();
    replay.clock.advance(1h);
    EXPECT_EQ(replay.frames.size(), 1U);
    ASSERT_TRUE(replay.link->open());
    EXPECT_FALSE(replay.link->replay().running) << "it stands, whatever was under way";
    replay.link->play();
    replay.clock.advance(1h);
    EXPECT_EQ(replay.frames.size(), 2U);
    EXPECT_EQ(replay.ends, 1) << "nothing more of can1, to the last piece";
    EXPECT_TRUE(replay.link->replay().ended);
}

TEST(Replay, IsOpenedInTheBackgroundAndNotWaitedForWhenItsDiskHangs)
{
    const Replay replay;
    VirtualClock clock;
    test::HeldBackground background;
    const auto made = [&](const std::string &name) {
        auto link = ReplayLink::create(*LinkAddress::parse("replay:" + replay.folder.path(name)), clock).value();
        link->settings().background = &background;
        return link;
    };
    const auto begin = [&](ReplayLink &link) {
        Task<void> opening = link.openSoon();
        opening.start();
        clock.advance(Link::openLimit - 1ns);
        EXPECT_FALSE(opening.isFinished());
        EXPECT_EQ(background.waiting(), 1U);
        EXPECT_EQ(background.lane(), link.address().path);
        return opening;
    };
    const auto good = made("run.log");
    Task<void> opening = begin(*good);
    background.release();
    clock.advance(0ns);
    EXPECT_TRUE(opening.isFinished());
    EXPECT_EQ(good->state(), LinkState::Open);
    EXPECT_EQ(good->replay().start, began);
    const auto missing = made("none.log");
    opening = begin(*missing);
    background.release();
    clock.advance(0ns);
    ASSERT_TRUE(opening.isFinished());
    EXPECT_EQ(opening.result().error().text(), replay.folder.path("none.log") + ": no such file; check the path");
    const auto late = made("run.log");
    opening = begin(*late);
    clock.advance(1ns);
    ASSERT_TRUE(opening.isFinished());
    EXPECT_EQ(opening.result().error().fault, Fault::LinkLost);
    EXPECT_EQ(
        opening.result().error().text(), "the disk of run.log does not answer; copy the recording to another one");
    background.release();
    EXPECT_EQ(late->state(), LinkState::Closed);
}

TEST(Replay, SeeksToTheFirstFrameAtOrAfterAPosition)
{
    Replay replay;
    ASSERT_TRUE(replay.opened);
    ASSERT_TRUE(replay.survey());
    EXPECT_EQ(replay.link->replay().length, 10s);
    EXPECT_EQ(replay.link->replay().surveyed, 1.0);
    replay.link->play();
    replay.clock.advance(20s);
    ASSERT_TRUE(replay.link->seek(250ms));
    EXPECT_EQ(replay.link->replay().position, 250ms);
    EXPECT_FALSE(replay.link->replay().ended);
    EXPECT_FALSE(replay.link->replay().running) << "it stood before";
    replay.passed.clear();
    replay.link->play();
    replay.clock.advance(0ns);
    ASSERT_EQ(replay.passed.size(), 2U);
    EXPECT_EQ(replay.passed[0].second.id, 0x02060005U);
    ASSERT_TRUE(replay.link->seek(251ms));
    EXPECT_TRUE(replay.link->replay().running);
    replay.passed.clear();
    replay.clock.advance(748ms);
    EXPECT_TRUE(replay.passed.empty());
    replay.clock.advance(1ms);
    EXPECT_EQ(replay.passed.size(), 1U);
    ASSERT_TRUE(replay.link->seek(99h));
    EXPECT_EQ(replay.link->replay().position, 10s);
    ASSERT_TRUE(replay.link->seek(-1h));
    EXPECT_EQ(replay.link->replay().position, 0s);
}

TEST(Replay, IsReadInPiecesWhereTheWantedInterfaceIsSilentToo)
{
    std::string text = "(1436509052.000000) can1 123#01\n";
    while (text.size() < 2'000'000)
        text += "(1436509053.000000) can0 02061405#0040110000000000\n";
    Replay replay(text + "(1436509054.000000) can1 123#02\n", "?interface=can1");
    ASSERT_TRUE(replay.opened);
    const auto first = replay.link->survey([](const LoggedFrame &) {});
    ASSERT_TRUE(first);
    EXPECT_FALSE(*first);
    EXPECT_LT(replay.link->replay().surveyed, 0.3);
    ASSERT_TRUE(replay.survey());
    EXPECT_EQ(replay.link->replay().length, 2s);
}

TEST(Replay, StandsWhileItIsReadOnInPiecesWhereTheWantedInterfaceFellSilent)
{
    std::string text = "(1436509052.000000) can1 123#01\n";
    while (text.size() < 2'000'000)
        text += "(1436509053.000000) can0 02061405#0040110000000000\n";
    Replay replay(text + "(1436509054.000000) can1 123#02\n", "?interface=can1&speed=max");
    ASSERT_TRUE(replay.opened);
    replay.link->play();
    replay.clock.step();
    ASSERT_EQ(replay.frames.size(), 1U);
    int turns = 0; // of everybody else in between
    for (; replay.frames.size() < 2 && turns < 100; ++turns) {
        EXPECT_TRUE(replay.link->replay().running);
        EXPECT_FALSE(replay.link->replay().ended);
        EXPECT_EQ(replay.link->timeLine().now(), Instant(began)) << "nobody times out meanwhile";
        replay.clock.step();
    }
    EXPECT_GE(turns, 7);
    EXPECT_EQ(replay.ends, 1);
    ASSERT_TRUE(replay.link->seek(0s));
    replay.link->play();
    replay.clock.step();
    replay.link->pause();
    replay.clock.advance(10s);
    EXPECT_EQ(replay.frames.size(), 3U) << "it was told to stand while it was read on";
    EXPECT_FALSE(replay.link->replay().running);
    replay.link->play();
    replay.clock.advance(10s);
    EXPECT_EQ(replay.frames.size(), 4U);
    EXPECT_EQ(replay.ends, 2);
    ASSERT_TRUE(replay.link->seek(0s));
    replay.link->play();
    replay.clock.step();
    ASSERT_TRUE(replay.link->seek(0s));
    replay.clock.advance(10s);
    EXPECT_EQ(replay.frames.size(), 7U) << "no frame is passed over by what it was about to read";
}

TEST(Replay, KnowsNothingOfTheBusOfALaterPartOnceItHasJumpedBack)
{
    std::string busy;
    for (int i = 0; i < 2000; ++i)
        busy += "(1436509052.00" + std::to_string(1000 + i) + ") can0 02061405#0040110000000000\n";
    Replay replay(busy + "(1436509062.000000) can0 20000004#0004000000000000\n(1436509063.500000) can0 123#01\n");
    ASSERT_TRUE(replay.opened);
    replay.link->play();
    replay.clock.advance(11s);
    ASSERT_TRUE(replay.link->health().lastReceived);
    ASSERT_TRUE(replay.link->seek(0s));
    EXPECT_FALSE(replay.link->health().lastReceived);
    EXPECT_FALSE(replay.link->health().lastError);
    replay.link->play();
    replay.clock.advance(1500ms);
    EXPECT_GT(replay.link->load(replay.link->timeLine().now()), 0.1);
}

TEST(Replay, PlaysOneInterfaceWhenAsked)
{
    Replay replay(log, "?interface=can1&speed=max");
    ASSERT_TRUE(replay.opened);
    replay.link->play();
    replay.clock.advance(1s);
    ASSERT_EQ(replay.passed.size(), 1U);
    EXPECT_EQ(replay.passed[0].second.id, 0x123U);
    Replay none(log, "?interface=can7");
    ASSERT_FALSE(none.opened);
    EXPECT_EQ(none.opened.error().fault, Fault::OutOfRange);
    EXPECT_NE(none.opened.error().text().find("no frame of can7"), std::string::npos);
}

TEST(Replay, RefusesToSend)
{
    Replay replay;
    replay.link->play();
    const auto sent = replay.link->send(extendedFrame(0x240, {}), Priority::Urgent);
    ASSERT_FALSE(sent);
    EXPECT_EQ(sent.error().fault, Fault::Unsupported);
    EXPECT_NE(sent.error().text().find("run.log is a recording"), std::string::npos);
    EXPECT_EQ(replay.link->counters().tx, 0U);
    EXPECT_TRUE(replay.passed.empty());
}

TEST(Replay, ReadsAscLogsWithRelativeTimesAndSeeksInThem)
{
    std::string text = "date Sat Sep 30 15:06:13.191 2017\nbase hex timestamps relative\n";
    for (int i = 0; i < 100'000; ++i)
        text += "0.001000 1 " + std::string(i % 2 == 0 ? "123" : "2061405x") + " Rx d 2 AB CD\n";
    Replay replay(text, "?speed=max");
    ASSERT_TRUE(replay.opened) << replay.opened.error().text();
    ASSERT_TRUE(replay.survey());
    EXPECT_EQ(replay.link->replay().length, 99'999ms);
    ASSERT_TRUE(replay.link->seek(77'777ms));
    replay.link->play();
    ASSERT_TRUE(replay.clock.runUntil([&] { return replay.ends == 1; }));
    EXPECT_EQ(replay.frames.size(), 100'000U - 77'777U);
    EXPECT_EQ(replay.frames.front().time, Instant(1506783973s + 192ms + 77'777ms));
}

TEST(Replay, NeverLetsTimeGoBack)
{
    Replay replay("(10.000000) can0 001#\n(9.000000) can0 002#\n(11.000000) can0 003#\n", "?speed=max");
    replay.link->play();
    replay.clock.advance(1s);
    ASSERT_EQ(replay.frames.size(), 3U);
    EXPECT_EQ(replay.frames[1].time, Instant(10s));
    EXPECT_EQ(replay.frames[2].time, Instant(11s));
}

TEST(Replay, SaysWhyAFileCannotBePlayed)
{
    Replay replay;
    const auto refusal = [&](const std::string &address) {
        const auto opened = replay.open(address);
        return opened ? Error{} : opened.error();
    };
    const std::string here = "replay:" + replay.folder.path();
    EXPECT_EQ(refusal(here + "/none.log").fault, Fault::LinkLost);
    EXPECT_NE(refusal(here + "/none.log").text().find("no such file; "), std::string::npos);
    EXPECT_EQ(refusal(here).fault, Fault::OutOfRange);
    std::filesystem::create_symlink("round.log", replay.folder.path("round.log"));
    EXPECT_EQ(refusal(here + "/round.log").text(),
        replay.folder.path() + "/round.log: cannot be read (system error 40); check the disk");
    EXPECT_EQ(refusal(here + "/run.log/x").ailment, Ailment::NotThere);
    replay.folder.write("empty.log", "");
    EXPECT_NE(refusal(here + "/empty.log").text().find("has no frame in it; "), std::string::npos);
    replay.folder.write("text.log", "Dear diary\n");
    EXPECT_NE(refusal(here + "/text.log").text().find("line 1 is neither"), std::string::npos);
    replay.folder.write("zeros.log", std::string(1 << 20, '\0'));
    EXPECT_NE(refusal(here + "/zeros.log").text().find("line 1 is neither"), std::string::npos);
    for (const char *option : {"?speed=-1", "?speed=0", "?speed=fast", "?speed=0.001", "?speed=1e9", "?pace=1"})
        EXPECT_EQ(refusal("replay:" + replay.path + option).fault, Fault::OutOfRange) << option;
    if (::geteuid() != 0) {
        std::filesystem::permissions(replay.path, std::filesystem::perms::none);
        EXPECT_NE(refusal("replay:" + replay.path).text().find("no permission"), std::string::npos);
    }
}

TEST(Replay, NamesADamagedLineAndEndsThere)
{
    Replay replay("(1.000000) can0 001#\n(2.000000) can0 002#\n(3.0000", "?speed=max");
    EXPECT_TRUE(replay.survey()) << "a last line that was cut off is the end of the recording";
    EXPECT_EQ(replay.link->remark().english(), "the last line is cut off, and left out");
    EXPECT_EQ(replay.link->replay().length, 1s);

    Replay whole("(1.000000) can0 001#\n(2.000000) can0 002#", "?speed=max");
    EXPECT_TRUE(whole.survey());
    EXPECT_EQ(whole.link->replay().length, 1s) << "a last line without its end is a line";
    EXPECT_EQ(whole.link->remark().english(), "the last line has no end, so its frame may be cut short");
    whole.folder.write("one.log", "(1.0000");
    const auto one = whole.open("replay:" + whole.folder.path() + "/one.log");
    ASSERT_FALSE(one) << "a first line that is cut could be anything";
    EXPECT_NE(one.error().text().find("line 1 is not a line of candump -L"), std::string::npos) << one.error().text();

    Replay damaged("(1.000000) can0 001#\n(2.000000) ca\xFF\n(3.000000) can0 003#\n", "?speed=max");
    ASSERT_TRUE(damaged.opened);
    const auto surveyed = damaged.link->survey([](const LoggedFrame &) {});
    ASSERT_FALSE(surveyed);
    EXPECT_EQ(surveyed.error().fault, Fault::OutOfRange);
    EXPECT_NE(surveyed.error().text().find("run.log: line 2 is not a line of candump -L"), std::string::npos);
    damaged.link->play();
    damaged.clock.advance(1s);
    EXPECT_EQ(damaged.frames.size(), 1U);
    EXPECT_EQ(damaged.ends, 1);
}

TEST(Replay, PassesCanFdFramesOverAndSaysHowMany)
{
    Replay replay("(1.000000) can0 001#\n(1.500000) can0 123##311223344\n(2.000000) can0 002#\n", "?speed=max");
    ASSERT_TRUE(replay.opened);
    EXPECT_TRUE(replay.survey());
    EXPECT_EQ(replay.link->replay().length, 1s);
    EXPECT_EQ(replay.link->remark().english(), "1 CAN FD frame is left out, because only classic CAN is read");
}

TEST(Replay, IsReadInPieces)
{
    std::string text;
    for (int i = 0; i < 200'000; ++i)
        text += "(" + std::to_string(i) + ".000000) can0 123#0011223344556677\n";
    Replay replay(text, "?speed=max");
    int pieces = 1;
    std::uint64_t frames = 0;
    for (auto done = replay.link->survey([&](const LoggedFrame &) { ++frames; }); done && !*done; ++pieces)
        done = replay.link->survey([&](const LoggedFrame &) { ++frames; });
    EXPECT_EQ(frames, 200'000U);
    EXPECT_GE(pieces, static_cast<int>(text.size() / (300 * 1024)));
    for (const int second : {0, 1, 77'777, 199'999}) {
        ASSERT_TRUE(replay.link->seek(std::chrono::seconds(second)));
        replay.frames.clear();
        replay.link->play();
        replay.clock.step();
        ASSERT_FALSE(replay.frames.empty());
        EXPECT_EQ(replay.frames.front().time, Instant(std::chrono::seconds(second)));
    }
}

TEST(Replay, SeeksToTheFirstOfManyFramesOfOneTime)
{
    constexpr int many = 30'000; // of one time: several pieces of the file
    std::string text = "(1.000000) can0 700#\n";
    for (int i = 0; i < many; ++i)
        text += std::string("(2.000000) can0 ") + (i == 0 ? "701" : "123") + "#0102030405060708\n";
    text += "(3.000000) can0 702#\n";
    Replay replay(text, "?speed=max");
    ASSERT_TRUE(replay.survey());
    for (const auto &[position, first, count] :
        {std::tuple{1ms, 0x701U, many + 1}, {1000ms, 0x701U, many + 1}, {1001ms, 0x702U, 1}, {0ms, 0x700U, many + 2}}) {
        ASSERT_TRUE(replay.link->seek(position));
        replay.frames.clear();
        replay.link->play();
        replay.clock.advance(1s);
        ASSERT_EQ(replay.frames.size(), static_cast<std::size_t>(count)) << position.count();
        EXPECT_EQ(replay.frames.front().id, first) << position.count();
    }
}

TEST(Replay, IsLostWhenItsFileIsCutWhileItIsPlayed)
{
    std::string text;
    for (int i = 0; text.size() < 3 * 256 * 1024; ++i)
        text += "(" + std::to_string(1000 + i) + ".000000) can0 123#0102030405060708\n";
    Replay replay(text);
    ASSERT_TRUE(replay.survey());
    std::filesystem::resize_file(replay.path, text.size() / 2);
    replay.link->play();
    replay.clock.advance(30h);
    EXPECT_EQ(replay.link->state(), LinkState::Lost);
    EXPECT_EQ(replay.link->loss().message(), "run.log was changed while it was played; open it again");
    EXPECT_EQ(replay.ends, 0);
    EXPECT_GT(replay.frames.size(), 5000U);
    Replay deleted(text);
    ASSERT_TRUE(deleted.survey());
    std::filesystem::remove(deleted.path);
    deleted.link->play();
    deleted.clock.advance(30h);
    EXPECT_EQ(deleted.ends, 1) << "what is open stays readable";
    EXPECT_EQ(deleted.link->state(), LinkState::Open);
}

} // namespace
} // namespace mb
