// SPDX-License-Identifier: GPL-3.0-or-later
// How the line listens before it talks, and how long it waits on a machine that is busy.
#include "families/supermodifiedbench.h"

namespace mb::supermodified {
namespace {

using namespace std::chrono_literals;
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

} // namespace
} // namespace mb::supermodified
