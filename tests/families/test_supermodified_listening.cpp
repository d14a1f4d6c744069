// SPDX-License-Identifier: GPL-3.0-or-later
// How the line listens before it talks, and how long it waits on a machine that is busy.
#include "families/supermodified/linepolls.h"
#include "families/supermodified/linetiming.h"
#include "families/supermodifiedbench.h"

namespace mb::supermodified {
namespace {

using namespace std::chrono_literals;
using namespace std::string_view_literals;
using mb::test::run;
using test::Bench;
using test::bytesOf;
using test::setPoint;

/// A port whose other end is the test.
class Port final : public SerialLink {
public:
    explicit Port(Clock &clock)
        : SerialLink(*LinkAddress::parse("serial:/dev/ttyTEST?baud=57600"), clock)
    {
        EXPECT_TRUE(open());
    }
    void say(std::string_view hex)
    {
        const auto bytes = bytesOf(hex);
        deliver(clock().now(), bytes);
        endBatch();
    }
    [[nodiscard]] int count(Command command) const
    {
        const auto frames = test::framesIn(sent);
        return static_cast<int>(
            std::count_if(frames.begin(), frames.end(), [command](const Frame &f) { return f.is(command); }));
    }
    std::vector<std::uint8_t> sent;

private:
    Result<void> doOpen() override { return {}; }
    void doClose() override { }
    Result<void> doSend(std::span<const std::uint8_t> bytes, Priority) override
    {
        sent.insert(sent.end(), bytes.begin(), bytes.end());
        return {};
    }
    [[nodiscard]] std::size_t doBacklog() const override { return 0; }
    Result<void> doSetBaudrate(int) override { return {}; }
};

struct SupermodifiedPort : testing::Test {
    Line::Ticket ask(Command command, Line::Rank rank = Line::Rank::Task)
    {
        Line::Request request = asking(Node{4, 57600, Dialect::D1}, command);
        request.rank = rank;
        return line->submit(std::move(request), [this](Result<Frame> answer) { reply = std::move(answer); });
    }
    [[nodiscard]] bool isGood() const { return reply && reply->has_value(); }

    static constexpr std::string_view position = "55 AA 77 04 6F 04 33 16 00 00 4E";
    static constexpr std::string_view stopped = "55 AA 77 04 1B 00 1B";
    VirtualClock clock;
    Port port{clock};
    std::shared_ptr<Line> line = Line::of(port, clock);
    std::optional<Result<Frame>> reply;
};

TEST_F(SupermodifiedPort, NothingIsAskedBeforeAnOpenedLineWasSilent)
{
    const auto ticket = ask(Command::GetPosition);
    clock.advance(20ms);
    EXPECT_TRUE(port.sent.empty());
    port.say("55 AA 01 04 6F"); // an answer to whoever had the port before
    clock.advance(9ms);
    port.say("04 33 16");
    clock.advance(2ms);
    EXPECT_TRUE(port.sent.empty()) << "it goes on";
    port.say("00 00 4E");
    clock.advance(10ms);
    EXPECT_EQ(port.count(Command::GetPosition), 1);
    port.say(position);
    EXPECT_TRUE(isGood());
}

TEST_F(SupermodifiedPort, AStopDoesNotWaitForSilenceAndGoesAgainAfterIt)
{
    clock.advance(5ms);
    const auto ticket = ask(Command::Stop, Line::Rank::Stop);
    EXPECT_EQ(port.count(Command::Stop), 1);
    clock.advance(3ms);
    port.say(stopped);
    EXPECT_TRUE(isGood());
    clock.advance(50ms);
    EXPECT_EQ(port.count(Command::Stop), 2);
    port.say(stopped);
    clock.advance(1s);
    EXPECT_EQ(port.count(Command::Stop), 2);
}

TEST_F(SupermodifiedPort, ALineThatIsNeverSilentIsTalkedOnInTheEnd)
{
    const auto ticket = ask(Command::GetPosition);
    for (int i = 0; i < 400 && port.sent.empty(); ++i) {
        clock.advance(1ms);
        port.say("00");
    }
    EXPECT_EQ(port.count(Command::GetPosition), 1);
}

TEST_F(SupermodifiedPort, AnAnswerThatTheMachineHadNoTimeToReadIsNotMissed)
{
    clock.advance(100ms);
    const auto ticket = ask(Command::GetPosition);
    clock.advance(1ms);
    clock.stall(400ms);
    clock.advance(1ms); // timers come before the port is read
    EXPECT_FALSE(reply);
    port.say(position);
    EXPECT_TRUE(isGood());
    EXPECT_GT(line->answerTimes().patience(25ms), 25ms) << "a busy machine waits longer from now on";
    EXPECT_LE(line->answerTimes().patience(25ms), 200ms);
}

TEST_F(SupermodifiedPort, AnAnswerThatHasBegunIsHeardOut)
{
    clock.advance(100ms);
    const auto ticket = ask(Command::GetPosition);
    clock.advance(27ms);
    port.say("55 AA 77 04 6F 04");
    clock.advance(2500us);
    EXPECT_FALSE(reply) << "it is under way";
    port.say("33 16 00 00 4E");
    EXPECT_TRUE(isGood());
}

TEST_F(SupermodifiedPort, AnAnswerThatHasBegunAndDoesNotGoOnIsGivenUp)
{
    clock.advance(100ms);
    const auto ticket = ask(Command::GetPosition);
    clock.advance(27ms);
    port.say("55 AA 77 04 6F 04");
    clock.advance(2500us);
    EXPECT_FALSE(reply) << "it may be under way";
    clock.advance(20ms);
    ASSERT_TRUE(reply && !reply->has_value());
    EXPECT_EQ(reply->error().fault, Fault::Timeout);
}

TEST_F(SupermodifiedPort, WhatIsPolledIsAskedAgainOnceTheLinkIsOpenAnew)
{
    (void)line->polls().add(asking(Node{4, 57600, Dialect::D1}, Command::GetPosition), 50ms, {});
    clock.advance(300ms);
    ASSERT_GT(port.count(Command::GetPosition), 0);
    port.close();
    clock.advance(1s);
    port.sent.clear();
    ASSERT_TRUE(port.open());
    clock.advance(500ms);
    EXPECT_GT(port.count(Command::GetPosition), 0);
}

TEST_F(SupermodifiedPort, ALateAnswerTellsHowLongAnswersTake)
{
    clock.advance(100ms);
    const auto first = ask(Command::GetPosition);
    clock.advance(40ms);
    ASSERT_TRUE(reply && !*reply);
    const auto second = ask(Command::GetCurrent);
    clock.advance(20ms);
    port.say(position);
    EXPECT_GE(line->answerTimes().patience(25ms), 55ms);
}

TEST_F(SupermodifiedPort, AnIdleLineKeepsTheTimesOfTheProtocol)
{
    clock.advance(100ms);
    for (int i = 0; i < 20; ++i) {
        const auto ticket = ask(Command::GetPosition);
        clock.advance(5ms);
        port.say(position);
        ASSERT_TRUE(isGood());
    }
    EXPECT_EQ(line->answerTimes().patience(25ms), 25ms);
}

TEST(SupermodifiedBusyMachine, ANodeWhoseAnswersAreAllLateIsFoundHeardAndDriven)
{
    std::string slow = "supermodified:4,dialect=D1,baud=57600";
    for (int frame = 1; frame <= 2000; ++frame)
        slow += ",fault=delay@" + std::to_string(frame) + ":60";
    Bench bench("sim:serial?bitrate=57600");
    Simulator &node = bench.add(slow);
    const auto device = bench.connect(4);
    EXPECT_EQ(device->identity().dialect, "D1");
    bench.clock.advance(2s);
    EXPECT_TRUE(device->liveness().heard);
    ASSERT_TRUE(device->command(setPoint(Mode::Velocity, 1000.0)));
    bench.clock.advance(3s);
    EXPECT_TRUE(node.isOutputOn());
    EXPECT_TRUE(device->liveness().heard);
    device->stop();
    bench.clock.advance(1s);
    EXPECT_FALSE(node.isOutputOn());
}

TEST(SupermodifiedBusyMachine, ASilentNodeIsAskedAgainByItself)
{
    for (const std::string dialect : {"D1", "D3"}) {
        Bench bench;
        Simulator &node = bench.add("supermodified:4,dialect=" + dialect);
        bench.add("supermodified:5");
        const auto device = bench.connect(4);
        const auto other = bench.connect(5);
        bench.clock.advance(1s);
        bench.line.setLoss(1.0);
        bench.clock.advance(400ms);
        bench.line.setLoss(0.0);
        bench.clock.advance(1s);
        EXPECT_TRUE(device->liveness().heard) << dialect;
        node.setPowered(false);
        bench.clock.advance(60s);
        EXPECT_FALSE(device->liveness().heard);
        node.setPowered(true);
        bench.clock.advance(1s);
        EXPECT_TRUE(device->liveness().heard) << dialect;
    }
}

TEST(SupermodifiedGuardian, ItsScriptStopsANodeInWhateverMomentOfAnExchangeTheProgramDied)
{
    for (const int rate : {9600, 57600, 115200}) {
        for (int moment = 0; moment < 80; ++moment) {
            Bench bench("sim:serial?bitrate=" + std::to_string(rate));
            Simulator &node = bench.add("supermodified:4,dialect=D1");
            int crashed = 0;
            const Subscription events
                = node.events().add([&](const SimulatorEvent &event) { crashed += event.what == "crashed" ? 1 : 0; });
            StopScript script;
            {
                const auto device = bench.connect(4);
                ASSERT_TRUE(device->command(setPoint(Mode::Velocity, 1000.0)));
                bench.clock.advance(500ms);
                ASSERT_TRUE(node.isOutputOn());
                bench.sent.clear();
                ASSERT_TRUE(bench.clock.runUntil([&] { return !bench.sent.empty(); }, 1s));
                script = device->stopScript();
                bench.clock.advance(bench.host.byteTime() * moment / 2);
                bench.host.close(); // the program is killed here, and sends nothing any more
            }
            ASSERT_TRUE(bench.host.open());
            for (const StopStep &step : script.steps) {
                for (int attempt = 0; attempt < (step.reply.empty() ? 1 : 4); ++attempt) {
                    if (!step.bytes.empty()) {
                        ASSERT_TRUE(bench.host.send(step.bytes));
                    }
                    bench.clock.advance(step.wait);
                }
            }
            EXPECT_EQ(crashed, 0) << rate << ' ' << moment;
            EXPECT_FALSE(node.isOutputOn()) << rate << ' ' << moment;
        }
    }
}

// A relative move is done once

struct SupermodifiedLateAnswers : SupermodifiedPort {
    SupermodifiedLateAnswers()
    {
        line->roster().noteSetting(4, Command::P, 1000);
        line->roster().noteSetting(4, Command::ProfileVelocity, 800);
        line->roster().noteSetting(4, Command::ProfileAcceleration, 800);
        clock.advance(100ms);
        EXPECT_TRUE(motion.command(setPoint(Mode::Position, 0.0)));
        for (const std::string_view answer : {stopped, standing, started, "55 AA 77 04 08 00 08"sv})
            hear(answer);
        EXPECT_TRUE(motion.isEnergized() && !motion.isBusy());
    }
    void hear(std::string_view answer)
    {
        clock.advance(3ms);
        port.say(answer);
        clock.advance(3ms);
    }
    static SetPoint by(double distance, Mode mode = Mode::Position)
    {
        SetPoint made = setPoint(mode, distance);
        made.relative = true;
        return made;
    }
    static constexpr std::string_view standing = "55 AA 77 04 6F 04 00 00 00 00 6B";
    static constexpr std::string_view started = "55 AA 77 04 19 00 19";
    static constexpr std::string_view halfPacket = "55 AA 77 04 FA 01 51 AA";
    static constexpr std::string_view moved = "55 AA 77 04 09 00 09";
    Node node{4, 57600, Dialect::D1};
    MotionGate gate;
    Motion motion{
        *line, node, gate, {[] {}, [](auto) {}, [this](auto &) { motion.setPosition(0); }, [](auto, auto) {}}};
};

TEST_F(SupermodifiedLateAnswers, TheAnswerToAnEarlierQuestionDoesNotPassForTheLookBeforeARelativeMove)
{
    const auto ticket = ask(Command::GetPosition);
    clock.advance(500ms);
    ASSERT_TRUE(reply && !reply->has_value()) << "it was given up";
    ASSERT_TRUE(motion.command(by(500.0)));
    hear(standing);   // late
    hear(halfPacket); // the answer to the look
    clock.advance(300ms);
    EXPECT_EQ(port.count(Command::MoveRelative), 0) << "it looks again";
    hear(standing);
    clock.advance(300ms);
    EXPECT_EQ(port.count(Command::MoveRelative), 1);
    hear(moved);
    clock.advance(1s);
    EXPECT_EQ(port.count(Command::MoveRelative), 1) << "done once";
    EXPECT_FALSE(motion.isBusy());
}

TEST_F(SupermodifiedLateAnswers, ALookThatIsAnsweredOnceAfterALostQuestionIsGoodEnough)
{
    const auto ticket = ask(Command::GetPosition);
    clock.advance(500ms);
    ASSERT_TRUE(motion.command(by(500.0)));
    hear(standing);
    EXPECT_EQ(port.count(Command::MoveRelative), 0) << "whether more comes is waited for";
    clock.advance(250ms);
    EXPECT_EQ(port.count(Command::MoveRelative), 1);
}

TEST_F(SupermodifiedLateAnswers, AnotherNodesStopDoesNotEndThatWaitWithAMove)
{
    const auto ticket = ask(Command::GetPosition);
    clock.advance(500ms);
    ASSERT_TRUE(motion.command(by(500.0)));
    hear(standing);
    Line::Request stop = asking(Node{5, 57600, Dialect::D1}, Command::Stop);
    stop.rank = Line::Rank::Stop;
    const auto other = line->submit(stop, [](const Result<Frame> &) {});
    clock.advance(10ms);
    EXPECT_EQ(port.count(Command::Stop), 2) << "at once";
    port.say("55 AA 77 05 1B 00 1B");
    clock.advance(20ms);
    EXPECT_EQ(port.count(Command::MoveRelative), 0);
    EXPECT_GT(port.count(Command::GetPosition), 2) << "it looks again";
}

TEST_F(SupermodifiedLateAnswers, AfterASettingThatWasNotAnsweredItIsLookedOnceMore)
{
    SetPoint ramp = by(500.0, Mode::RampPosition);
    ramp.velocity = 1000.0;
    ASSERT_TRUE(motion.command(ramp));
    hear(standing);
    ASSERT_EQ(port.count(Command::ProfileVelocity), 1);
    ASSERT_TRUE(clock.runUntil([this] { return port.count(Command::ProfileVelocity) == 2; }, 1s));
    const int looks = port.count(Command::GetPosition);
    hear("55 AA 77 04 04 00 04"); // of the first
    EXPECT_EQ(port.count(Command::MoveProfiledRelative), 0);
    EXPECT_EQ(port.count(Command::GetPosition), looks + 1);
}

TEST_F(SupermodifiedLateAnswers, WhatItWasToldIsOverWhereItSwitchedItselfOff)
{
    ASSERT_TRUE(motion.command(by(500.0)));
    clock.advance(3ms);
    ASSERT_TRUE(motion.isBusy());
    motion.tripped(say("over-temperature"));
    EXPECT_FALSE(motion.isBusy());
    hear(standing);
    clock.advance(1s);
    EXPECT_EQ(port.count(Command::MoveRelative), 0);
}

TEST(SupermodifiedPolls, OneThatIsTakenAwayIsNotAskedAgainAndTheOthersAre)
{
    VirtualClock clock;
    LinePolls polls(clock, [] {});
    const auto gone = polls.add({}, 10ms, {});
    const auto kept = polls.add({}, 10ms, {});
    polls.remove(gone);
    EXPECT_FALSE(polls.has(gone));
    for (int i = 0; i < 3; ++i) {
        const auto next = polls.next(false);
        ASSERT_TRUE(next);
        EXPECT_EQ(next->key, kept);
        EXPECT_FALSE(polls.next(false));
        clock.advance(10ms);
    }
}

TEST(SupermodifiedPatience, ThatALinkIsGivenIsThatOfTasksOnly)
{
    Bench bench;
    LineTiming timing(bench.host, bench.clock);
    using enum LineRequest::Rank;
    const auto patience = [&timing](LineRequest::Rank rank, Duration own = answerTime) {
        LineRequest request;
        request.rank = rank;
        request.patience = own;
        return timing.patienceFor(request);
    };
    for (const auto rank : {Stop, Move, Task, Poll})
        EXPECT_EQ(patience(rank), answerTime);
    bench.host.settings().patience.timeout = 3s;
    for (const auto rank : {Stop, Move, Poll})
        EXPECT_EQ(patience(rank), answerTime) << "a motor waits for its stop behind it";
    EXPECT_EQ(patience(Task), 3s);
    bench.host.settings().patience.timeout = 5ms;
    EXPECT_EQ(patience(Task), 5ms);
    EXPECT_EQ(patience(Task, 200ms), 200ms) << "what takes that long is waited for";
}

} // namespace
} // namespace mb::supermodified
