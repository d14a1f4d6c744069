// SPDX-License-Identifier: GPL-3.0-or-later
// STOP while the engine thread is blocked: the lane in virtual time, and the real engine on a real terminal.
#include "app/engine.h"
#include "async/virtualclock.h"
#include "families/supermodifiedbench.h"
#include "model/registry.h"
#include "support/eventloop.h"
#include "support/pseudoterminal.h"
#include "support/textmotor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <future>

#include <poll.h>

namespace mb {
namespace {

using namespace std::chrono_literals;

/// The lane, with one line that takes everything.
class Lane : public testing::Test {
protected:
    Lane()
    {
        EXPECT_TRUE(bus.openLink(*LinkAddress::parse("sim:can")));
        Outlet way{Outlet::Form::SpiSocket, 0};
        way.aside = [this](std::span<const std::uint8_t> bytes) {
            if (room == 0)
                return false;
            --room;
            times.push_back(clock.now() - pressed);
            sent.emplace_back(bytes.begin(), bytes.end());
            return true;
        };
        outlet = std::make_shared<StopOutlet>(*bus.links().front(), way);
        lane.setOrders({{outlet, {first, second}}});
    }
    const guardian::Script first{{{1, 2}, {}, {}, 20ms, 1}}; ///< of one device each
    const guardian::Script second{{{3}, {}, {}, 20ms, 1}};
    VirtualClock clock;
    Session bus{clock, families()};
    StopLane lane{clock};
    std::shared_ptr<StopOutlet> outlet;
    int room = 1000; ///< messages that the line takes
    std::vector<guardian::Bytes> sent;
    Instant pressed{};
    std::vector<Duration> times; ///< of each, since then
    const std::vector<guardian::Bytes> all{{1, 2}, {3}};
};

TEST_F(Lane, LeavesTheEngineItsTimeAndThenSendsEverythingOnce)
{
    lane.press();
    clock.advance(StopLane::patience - 1us);
    EXPECT_TRUE(sent.empty());
    clock.advance(2us);
    EXPECT_EQ(sent, all);
    clock.advance(10s);
    EXPECT_EQ(sent, all);
}

TEST_F(Lane, SendsNothingWhereTheEngineHasComeToIt)
{
    lane.press();
    clock.advance(1ms);
    lane.served();
    clock.advance(1s);
    EXPECT_TRUE(sent.empty());
}

TEST_F(Lane, SendsAgainWhenItIsPressedAgain)
{
    lane.press();
    clock.advance(1s);
    lane.press();
    clock.advance(1s);
    EXPECT_EQ(sent.size(), 2 * all.size());
}

TEST_F(Lane, GoesOnWhereALineThatWasFullHasRoomAgain)
{
    room = 1;
    lane.press();
    clock.advance(50ms);
    EXPECT_EQ(sent, (std::vector<guardian::Bytes>{{1, 2}}));
    room = 1000;
    clock.advance(2ms);
    EXPECT_EQ(sent, all);
}

TEST_F(Lane, SendsAStopThatMayBeRefusedAsOftenAsItsScriptSays)
{
    lane.setOrders({{outlet, {{{{1, 2}, {}, {}, 20ms, 3}}, second}}});
    lane.press();
    clock.advance(24ms);
    EXPECT_EQ(sent, all);
    clock.advance(10s);
    EXPECT_EQ(sent, (std::vector<guardian::Bytes>{{1, 2}, {3}, {1, 2}, {1, 2}}));
}

TEST_F(Lane, LeavesEachNodeOfALineWithOneWireTheTimeToAnswer)
{
    const guardian::Step pause{{}, {}, {}, 6ms, 1};
    const auto stopOf = [](std::uint8_t node) { return guardian::Step{{node}, {9}, {0xFF}, 27ms, 3}; };
    lane.setOrders({{outlet, {{pause, stopOf(4)}, {pause, stopOf(5)}}}});
    pressed = clock.now();
    lane.press();
    clock.advance(10s);
    EXPECT_EQ(sent, (std::vector<guardian::Bytes>{{4}, {5}, {4}, {5}, {4}, {5}})) << "they take turns";
    EXPECT_EQ(times, (std::vector<Duration>{11ms, 38ms, 65ms, 92ms, 119ms, 146ms}));
}

TEST_F(Lane, KeepsNoStepWaitingWhereNothingFallsIntoAnAnswer)
{
    const auto step = [](std::uint32_t id, int attempts) {
        return StopStep{standardFrame(id, {}), {}, {}, {}, 10ms, attempts, standardFrame(9, {})};
    };
    lane.setOrders({{outlet, laneScripts({{step(1, 2), step(2, 2), step(3, 1)}}, Outlet::Form::CanSocket)}});
    pressed = clock.now();
    lane.press();
    clock.advance(10s);
    EXPECT_EQ(times, (std::vector<Duration>{5ms, 5ms, 5ms, 15ms, 15ms}));
    ASSERT_EQ(sent.size(), 5U);
    EXPECT_EQ(sent[3], sent[0]);
    EXPECT_EQ(sent[4], sent[1]);
}

TEST_F(Lane, EndsOnceTheEngineHasComeToIt)
{
    lane.setOrders({{outlet, {{{{1, 2}, {9}, {0xFF}, 20ms, 100}}}}});
    lane.press();
    clock.advance(30ms);
    lane.served();
    clock.advance(10s);
    EXPECT_EQ(sent.size(), 2U);
}

TEST_F(Lane, ByTheProgramSendsOnlyWhatStopsThatWhichItHasMoved)
{
    lane.setOrders({{outlet, {first, second}, {second}}});
    lane.press(StopCause::Program);
    clock.advance(10s);
    EXPECT_EQ(sent, (std::vector<guardian::Bytes>{{3}}));
}

/// Nodes of one line, each with its motor turning, whose engine hangs from now on.
class LaneOnOneWire : public testing::Test {
protected:
    static constexpr std::array ids{4, 5, 6, 7};
    LaneOnOneWire()
    {
        std::vector<std::unique_ptr<Device>> devices;
        for (const int id : ids) {
            nodes.push_back(&bench.add("supermodified:" + std::to_string(id) + ",dialect=D1"));
            events.push_back(nodes.back()->events().add([this, id](const SimulatorEvent &event) {
                if (event.what == "crashed")
                    crashed += std::to_string(id);
            }));
        }
        for (const int id : ids) {
            devices.push_back(bench.connect(id));
            EXPECT_TRUE(devices.back()->command(supermodified::test::setPoint(Mode::Velocity, 1000.0)));
            bench.clock.advance(500ms);
        }
        EXPECT_EQ(running(), 4);
        for (const auto &device : devices)
            scripts.push_back(laneScripts(device->stopScript(), Outlet::Form::Stream).front());
        const StopScript ofFirst = devices.front()->stopScript();
        bench.host.close(); // the engine hangs, and sends nothing any more
        devices.clear();
        EXPECT_TRUE(bench.host.open());
        Outlet way{Outlet::Form::Stream, 0};
        way.aside = [this](std::span<const std::uint8_t> bytes) {
            times.push_back(bench.clock.now());
            return bench.host.send(bytes).has_value();
        };
        lane.setOrders({{std::make_shared<StopOutlet>(bench.host, way), scripts,
            laneScripts(ofFirst, Outlet::Form::Stream, StopCause::Program)}});
    }
    [[nodiscard]] int running() const
    {
        return static_cast<int>(std::ranges::count_if(nodes, [](const Simulator *node) { return node->isOutputOn(); }));
    }
    supermodified::test::Bench bench;
    std::vector<Simulator *> nodes;
    std::vector<Subscription> events;
    std::vector<guardian::Script> scripts;
    std::vector<Instant> times; ///< of each message
    std::string crashed;
    StopLane lane{bench.clock};
};

TEST_F(LaneOnOneWire, StopsAllNodesWithinTwentyMilliseconds)
{
    lane.press();
    bench.clock.advance(20ms);
    EXPECT_EQ(running(), 0);
}

TEST_F(LaneOnOneWire, StopsForAnotherCauseOnlyWhatThisProgramHasMoved)
{
    lane.press(StopCause::Program);
    bench.clock.advance(100ms);
    EXPECT_FALSE(nodes.front()->isOutputOn());
    EXPECT_EQ(running(), 3);
}

/// With its own bytes in the answers that it asks for it would hang the nodes that run, and stop none behind the first.
TEST_F(LaneOnOneWire, StopsThoseThatRefuseOnceAndSendsNothingIntoAnAnswer)
{
    for (Simulator *node : nodes)
        node->disturb("error", 0x43);
    lane.press();
    bench.clock.advance(100ms);
    EXPECT_EQ(running(), 0);
    EXPECT_EQ(crashed, "");
    ASSERT_GT(times.size(), 10U);
    const Duration exchange = bench.host.byteTime() * 14; // of a stop and its answer
    for (std::size_t i = 3; i < times.size(); ++i)        // after zeros and the stop of all
        EXPECT_GE(times[i] - times[i - 1], exchange + 3ms) << i;
}

TEST_F(Lane, LeavesOutLinksWhoseMotorsStandWithTheEngine)
{
    EXPECT_TRUE(stopOrdersOf(bus, {}).empty());
}

class BlockedEngine : public testing::Test {
protected:
    BlockedEngine()
    {
        engine.send(orders::OpenLink{*LinkAddress::parse("serial:" + terminal.path())});
        EXPECT_TRUE(loop.runUntil([this] { return !engine.snapshot().devices.empty(); }));
        block();
    }
    ~BlockedEngine() override { release(); }
    void block(const std::function<void(EngineCore &)> &before = {})
    {
        m_released = std::promise<void>();
        m_isReleased = false;
        auto begun = std::make_shared<std::promise<void>>();
        engine.post([before, begun, until = m_released.get_future().share()](EngineCore &core) {
            if (before)
                before(core);
            begun->set_value();
            until.wait();
        });
        begun->get_future().wait();
    }
    void drivesAndIsBlocked()
    {
        release();
        block([](EngineCore &core) {
            Device &motor = *core.session().devices().front();
            motor.stopping().driven();
            motor.changed().notify();
        });
    }
    void release()
    {
        if (!std::exchange(m_isReleased, true))
            m_released.set_value();
    }
    [[nodiscard]] bool hasHeard(std::string_view line)
    {
        pollfd source{terminal.descriptor(), POLLIN, 0};
        if (::poll(&source, 1, 0) == 1) {
            const auto bytes = terminal.read();
            m_heard.append(bytes.begin(), bytes.end());
        }
        return m_heard.find(line) != std::string::npos;
    }
    /// Waits for a line; false when none came for twenty seconds.
    [[nodiscard]] bool hears(std::string_view line)
    {
        while (m_heard.find(line) == std::string::npos) {
            pollfd source{terminal.descriptor(), POLLIN, 0};
            if (::poll(&source, 1, 20'000) != 1)
                return false;
            const auto bytes = terminal.read();
            m_heard.append(bytes.begin(), bytes.end());
        }
        return true;
    }

    test::EventLoop loop;
    test::PseudoTerminal terminal;
    Engine engine{test::textFamilies, false};

private:
    std::promise<void> m_released;
    bool m_isReleased = false;
    std::string m_heard;
};

TEST_F(BlockedEngine, StopOfTheUserReachesTheLineAllTheSame)
{
    engine.stopAll(StopCause::User);
    EXPECT_TRUE(hears(test::textStop)) << "although the engine has not come to it";
    release();
}

TEST_F(BlockedEngine, TheEndWaitsForAnEngineThatHangsOnlyUntilItsLimitAndStopsPastItWhatThisProgramMoved)
{
    drivesAndIsBlocked();
    EXPECT_FALSE(engine.end(std::chrono::milliseconds(200)));
    EXPECT_TRUE(hears(test::textStop)) << "although the engine has not come to it";
    release();
    EXPECT_TRUE(engine.end(std::chrono::seconds(20))) << "it came to itself";
}

TEST_F(BlockedEngine, TheEndOfAnEngineThatHangsLeavesAloneWhatAnotherMasterDrives)
{
    EXPECT_FALSE(engine.end(std::chrono::milliseconds(500)));
    EXPECT_FALSE(hasHeard(test::textStop)) << "this program has moved nothing";
    release();
    EXPECT_TRUE(engine.end(std::chrono::seconds(20)));
}

TEST_F(BlockedEngine, StopIsServedBeforeOrdersThatWaitedLonger)
{
    std::vector<int> order;
    engine.post([&order](EngineCore &) { order.push_back(1); });
    engine.stopAll(StopCause::User);
    bool stopped = false;
    engine.post([&](EngineCore &core) {
        stopped = core.session().devices().front()->stopping().state() == StopState::Stopping;
        order.push_back(2);
    });
    std::promise<void> done;
    engine.post([&done](EngineCore &) { done.set_value(); });
    release();
    done.get_future().wait();
    EXPECT_TRUE(stopped);
    EXPECT_EQ(order, (std::vector{1, 2})) << "the others keep their order";
}

/// What it is answered with once the engine comes to it; its motor stands by then, or turns.
class OrderBeforeAStop : public BlockedEngine, public testing::WithParamInterface<StopCause> {
protected:
    template <class O> void given(O order)
    {
        ++m_given;
        engine.send(std::move(order), [this](const Result<AnswerOf<O>> &result) {
            answers.push_back(result ? std::optional<Fault>() : result.error().fault);
        });
    }
    void answered()
    {
        release();
        EXPECT_TRUE(loop.runUntil([this] { return answers.size() == m_given; }));
    }
    [[nodiscard]] orders::StartMotion start() const
    {
        SetPoint setPoint;
        setPoint.mode = Mode::Duty;
        setPoint.target = 0.1;
        return {engine.snapshot().devices.front().id, setPoint, 10s};
    }
    std::vector<std::optional<Fault>> answers;

private:
    std::size_t m_given = 0;
};

TEST_P(OrderBeforeAStop, TurnsNoMotorAfterIt)
{
    given(start());
    engine.stopAll(GetParam());
    answered();
    EXPECT_EQ(answers, std::vector{std::optional(Fault::Cancelled)});
    EXPECT_FALSE(hasHeard(test::textDrive));
}

TEST_P(OrderBeforeAStop, IsTakenBackWhereItArmsOrReleasesOrTries)
{
    const DeviceId id = engine.snapshot().devices.front().id;
    given(orders::ArmService{true});
    given(orders::ReleaseMoves{id});
    given(orders::RunTrial{id, {}, {}});
    engine.stopAll(GetParam());
    answered();
    EXPECT_EQ(answers, std::vector(3, std::optional(Fault::Cancelled)));
}

TEST_P(OrderBeforeAStop, IsCarriedOutWhereNothingTurnsByIt)
{
    given(orders::StopMotion{engine.snapshot().devices.front().id});
    given(orders::DismissStops{});
    engine.stopAll(GetParam());
    answered();
    EXPECT_EQ(answers, std::vector(2, std::optional<Fault>()));
}

/// Frames and queues are none of what this program has moved.
TEST_P(OrderBeforeAStop, ThatBeginsAQueueOrSendsAFrameIsTakenBackByTheUserOnly)
{
    given(orders::SendFrame{"socketcan:none", {}});
    given(orders::ServeUnits{});
    engine.stopAll(GetParam());
    answered();
    const bool byUser = GetParam() == StopCause::User;
    EXPECT_EQ(answers.front() == Fault::Cancelled, byUser);
    EXPECT_EQ(answers.back() == Fault::Cancelled, byUser);
}

TEST_P(OrderBeforeAStop, ThatIsGivenAfterTheStopIsCarriedOut)
{
    engine.stopAll(GetParam());
    given(start());
    answered();
    EXPECT_EQ(answers, std::vector{std::optional<Fault>()});
    EXPECT_TRUE(hears(test::textDrive));
}

TEST_P(OrderBeforeAStop, IsNotBegunByAnEngineThatEnds)
{
    given(start());
    EXPECT_FALSE(engine.end(1ms));
    answered();
    EXPECT_EQ(answers, std::vector{std::optional(Fault::Cancelled)});
    EXPECT_FALSE(hasHeard(test::textDrive));
}

INSTANTIATE_TEST_SUITE_P(Causes, OrderBeforeAStop, testing::Values(StopCause::User, StopCause::Program),
    [](const auto &row) { return std::string(row.param == StopCause::User ? "User" : "Program"); });

TEST_F(BlockedEngine, ALinkThatIsClosedIsNotHeldByTheStopLane)
{
    release();
    const std::string address = "serial:" + terminal.path();
    engine.send(orders::CloseLink{address});
    EXPECT_TRUE(loop.runUntil([this] { return engine.snapshot().links.empty(); }));
    pollfd source{terminal.descriptor(), POLLIN, 0};
    EXPECT_EQ(::poll(&source, 1, 20'000), 1);
    EXPECT_NE(source.revents & POLLHUP, 0) << "nobody has the other end open";
}

} // namespace
} // namespace mb
