// SPDX-License-Identifier: GPL-3.0-or-later
// Boards that keep nothing, as the engine's half sees them: resets, writing again, experiments, bootloaders. Virtual time.
#include "app/engine/enginecore.h"
#include "async/virtualclock.h"
#include "heard.h"
#include "model/registry.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <algorithm>

namespace mb {
namespace {

using namespace std::chrono_literals;

class BoardCore : public testing::Test {
protected:
    explicit BoardCore(const std::string &options = {})
        : unit("quadquad2drv:0" + options)
    {
        family = *findFamily(families(), "quadquad2drv");
        family.bench = units;
        core.send(orders::OpenLink{*LinkAddress::parse("sim:spi")});
        clock.advance(1s);
    }
    [[nodiscard]] Device *device()
    {
        return core.session().devices().empty() ? nullptr : core.session().devices().front();
    }
    [[nodiscard]] DeviceId id() { return core.session().idOf(*device()); }
    [[nodiscard]] Simulator &board()
    {
        return *core.session().bench(*core.session().links().front())->simulators().front();
    }
    void write()
    {
        test::Heard<> written;
        const auto gain = *findParameter(family.parameters, "ch1.velocity.p");
        const auto limit = *findParameter(family.parameters, "ch2.limit.power");
        core.send(orders::WriteParameters{id(), {{gain, 120}, {limit, 4000}}}, written.finished());
        ASSERT_TRUE(clock.runUntil([&written] { return written.has_value(); }, 10s));
        ASSERT_TRUE(*written);
    }
    void reset()
    {
        board().setPowered(false);
        board().setPowered(true);
        clock.advance(4s);
    }
    [[nodiscard]] std::size_t lost() { return core.snapshot().devices.front().profile->lost.size(); }
    [[nodiscard]] bool said(const std::string &part) const
    {
        return std::any_of(
            lines.begin(), lines.end(), [&part](const std::string &l) { return l.find(part) != std::string::npos; });
    }

    std::string unit;
    std::array<std::string_view, 1> units{unit};
    Family family;
    std::array<const Family *, 1> only{&family};
    VirtualClock clock;
    EngineCore core{clock, only, false};
    std::vector<std::string> lines;
    Subscription listening = core.noticed().add(
        [this](Severity, const std::string &, const Message &text) { lines.push_back(text.english()); });
};

TEST_F(BoardCore, AnswersAnOrderWhoseLinkIsClosedMeanwhile)
{
    test::Heard<> written;
    const auto gain = *findParameter(family.parameters, "ch1.velocity.p");
    core.send(orders::WriteParameters{id(), {{gain, 120}}}, written.finished());
    EXPECT_FALSE(written) << "it is under way";
    core.send(orders::CloseLink{"sim:spi"});
    ASSERT_TRUE(written);
    ASSERT_FALSE(*written);
    EXPECT_EQ(written->error().fault, Fault::LinkLost);
}

TEST_F(BoardCore, ShowsWhatAResetTookAndWritesItAgain)
{
    write();
    EXPECT_EQ(lost(), 0U);
    reset();
    EXPECT_TRUE(said("the unit restarted"));
    EXPECT_EQ(lost(), 2U);
    test::Heard<> again;
    core.send(orders::RewriteSettings{id()}, again.finished());
    EXPECT_EQ(core.snapshot().operations.back().status.kind, OperationKind::RewriteSettings);
    ASSERT_TRUE(clock.runUntil([&again] { return again.has_value(); }, 10s));
    EXPECT_TRUE(*again);
    EXPECT_EQ(lost(), 0U);
    EXPECT_TRUE(said("are written again"));
}

TEST_F(BoardCore, AnOrderForADeviceThatIsGoneIsAnswered)
{
    const DeviceId gone = id();
    core.send(orders::CloseLink{"sim:spi"});
    test::Heard<> first;
    test::Heard<> second;
    core.send(orders::RewriteSettings{gone}, first.finished());
    core.send(orders::RunExperiment{gone, "gain-scales", {}}, second.finished());
    ASSERT_TRUE(first && second);
    EXPECT_FALSE(*first);
    EXPECT_FALSE(*second);
}

TEST_F(BoardCore, AnExperimentThatIsNotKnownOrComesInMotionIsRefused)
{
    test::Heard<> unknown;
    core.send(orders::RunExperiment{id(), "no-such", {}}, unknown.finished());
    ASSERT_TRUE(unknown);
    EXPECT_EQ(unknown->error().fault, Fault::Unsupported);
    SetPoint setPoint;
    setPoint.mode = Mode::Duty;
    setPoint.target = 0.1;
    core.send(orders::StartMotion{id(), setPoint, 10s});
    test::Heard<> moving;
    core.send(orders::RunExperiment{id(), "gain-scales", {}}, moving.finished());
    ASSERT_TRUE(moving);
    EXPECT_EQ(moving->error().fault, Fault::Unsafe);
}

TEST_F(BoardCore, StopEndsAnExperimentWhereverItIs)
{
    for (const Duration moment : {0ms, 1ms, 5ms, 20ms, 100ms, 500ms}) {
        test::Heard<> end;
        ExperimentOptions options;
        options.power = 0.25;
        core.send(orders::RunExperiment{id(), "gain-scales", options}, end.finished());
        clock.advance(moment);
        ASSERT_FALSE(end) << "it runs: " << (*end ? "" : end->error().text()) << ' ' << moment.count();
        core.stopAll(StopCause::User);
        clock.advance(5ms);
        ASSERT_TRUE(end) << moment.count();
        EXPECT_EQ(end->error().fault, Fault::Cancelled);
        clock.advance(3s);
        EXPECT_FALSE(core.session().stream(*device()).isRunning());
        EXPECT_FALSE(board().isOutputOn());
    }
}

TEST_F(BoardCore, AnExperimentTellsInItsLogWhatItFound)
{
    test::Heard<> end;
    core.send(orders::RunExperiment{id(), "input-reading", {}}, end.finished());
    EXPECT_EQ(core.snapshot().operations.back().status.kind, OperationKind::FamilyExperiment);
    ASSERT_TRUE(clock.runUntil([&end] { return end.has_value(); }, 10s));
    ASSERT_TRUE(*end);
    const OperationView operation = core.snapshot().operations.back();
    ASSERT_FALSE(operation.status.log.empty());
    EXPECT_EQ(operation.status.log.back().text, "polarity 0 is active high: the board follows the maker's library");
}

class SilentBoard : public BoardCore {
protected:
    SilentBoard()
        : BoardCore(",state=bootloader,boot=pty:" + QTemporaryDirPath())
    {
    }
    static std::string QTemporaryDirPath()
    {
        static const QTemporaryDir folder;
        return folder.filePath(QStringLiteral("boot")).toStdString();
    }
};

TEST_F(SilentBoard, ABoardThatWaitsInItsBootloaderIsInTheListThoughItIsSilent)
{
    clock.advance(2s);
    ASSERT_NE(device(), nullptr);
    EXPECT_EQ(device()->identity().state, DeviceState::Bootloader);
    EXPECT_NE(device()->identity().detail.english().find("bootloader"), std::string::npos);
    EXPECT_FALSE(device()->mayMove());
}

class MuteUnits : public testing::Test {
protected:
    void find(int number, const test::Heard<DeviceId> &found)
    {
        core.send(orders::FindMute{"sim:serial", "supermodified", number}, found.finished());
    }
    [[nodiscard]] Result<DeviceId> find(int number)
    {
        const test::Heard<DeviceId> found;
        find(number, found);
        EXPECT_TRUE(clock.runUntil([&found] { return found.has_value(); }, 2min));
        return found.value_or(fail(Fault::Cancelled));
    }
    void open() { core.send(orders::OpenLink{*LinkAddress::parse("sim:serial")}); }
    void power(bool on)
    {
        for (Simulator *const node : core.session().bench(*core.session().links().front())->simulators())
            node->setPowered(on);
    }

    VirtualClock clock;
    EngineCore core{clock, families(), false};
};

TEST_F(MuteUnits, AreInTheListForTheirFirmwareWhereNoOtherOfTheirFamilyAnswers)
{
    EXPECT_EQ(find(9).error().fault, Fault::LinkLost);
    open();
    clock.advance(10s);
    EXPECT_EQ(find(9).error().fault, Fault::Timeout) << "the programmer may hang on another";
    power(false);
    const auto mute = find(9);
    ASSERT_TRUE(mute) << mute.error().text();
    const Snapshot shot = core.snapshot();
    ASSERT_NE(shot.device(*mute), nullptr);
    EXPECT_EQ(shot.device(*mute)->identity->address, 9);
    EXPECT_EQ(shot.device(*mute)->identity->state, DeviceState::Bootloader);
    EXPECT_FALSE(shot.links.front().scanning);
    test::Heard<> begun;
    core.send(orders::UpdateFirmware{*mute, std::make_shared<FirmwareImage>(), {}}, begun.finished());
    ASSERT_TRUE(clock.runUntil([&begun] { return begun.has_value(); }, 2min));
    EXPECT_EQ(core.snapshot().operations.back().device, *mute) << "it was taken, with an image that holds nothing";
}

TEST_F(MuteUnits, AreAskedWhoTheyAreWhereTheirApplicationIsHeard)
{
    open();
    clock.advance(10s);
    power(false);
    clock.advance(5s);
    const auto mute = find(4);
    ASSERT_TRUE(mute) << mute.error().text();
    const Device &node = *core.session().find(*mute);
    ASSERT_EQ(node.identity().state, DeviceState::Bootloader);
    power(true);
    EXPECT_TRUE(clock.runUntil([&node] { return node.identity().state == DeviceState::Online; }, 20s));
    EXPECT_TRUE(node.mayStop());
    EXPECT_FALSE(node.identity().dialect.empty());
}

TEST_F(MuteUnits, AreSearchedForBesideALookAndNotBesideAnotherSearch)
{
    open();
    ASSERT_TRUE(clock.runUntil(
        [this] { return !core.snapshot().links.empty() && core.snapshot().links.front().scanning; }, 10s));
    const test::Heard<DeviceId> found;
    find(4, found);
    const test::Heard<DeviceId> another;
    find(4, another);
    ASSERT_TRUE(clock.runUntil([&] { return found.has_value() && another.has_value(); }, 2min));
    EXPECT_EQ(another->error().fault, Fault::Unsafe);
    const auto isListed = [this] {
        const auto all = core.session().devices();
        return std::ranges::any_of(all, [](const Device *device) { return device->identity().address == 5; });
    };
    EXPECT_TRUE(clock.runUntil(isListed, 2min)) << "the look is made again";
}

} // namespace
} // namespace mb
