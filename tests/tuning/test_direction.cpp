// SPDX-License-Identifier: GPL-3.0-or-later
// The check of the direction from inside: how hard it pushes, what ends it, and for how long nobody need watch.
#include "async/sleep.h"
#include "experiment/gains.h"
#include "experiment/nudge.h"
#include "families/quadquad2drv/codec.h"
#include "model/leaserenewal.h"
#include "support/fakeguard.h"
#include "tests/tuning/experimentbench.h"
#include "tests/tuning/realunit.h"
#include "transport/backends/virtualcan.h"
#include "wire/bytes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

namespace mb::abstractdc {
extern const Family family;
}

namespace mb::tuning {
namespace {

using namespace std::chrono_literals;
using test::ExperimentBench;
using test::stepTo;

constexpr Duration handling = 25ms;

/// A check that has begun on a blocked shaft.
struct BlockedCheck {
    explicit BlockedCheck(std::string_view link = "sim:can", std::string_view family = "dmc60c", int address = 5,
        const Envelope &limits = {})
        : bench(link, family, address)
    {
        EXPECT_TRUE(bench.simulator()->disturb("stall", 1.0));
        ExperimentPlan plan = stepTo(Mode::Velocity, 2000.0);
        plan.limits = limits;
        task = bench.start(plan);
        task.start();
    }
    [[nodiscard]] bool pushes(bool on = true)
    {
        return bench.bench.clock.runUntil([this, on] { return bench.simulator()->isOutputOn() == on; }, 10s);
    }
    /// Until its end; when it was driven last.
    [[nodiscard]] Instant drivenLast()
    {
        Instant driven{};
        EXPECT_TRUE(bench.bench.clock.runUntil(
            [&] {
                if (bench.simulator()->isOutputOn())
                    driven = bench.bench.clock.now();
                return task.isFinished();
            },
            60s));
        return driven;
    }
    [[nodiscard]] Trial trial() { return task.result().value_or(Trial()); }

    ExperimentBench bench;
    Task<Trial> task;
};

TEST(Direction, OfALeaseThatNobodyRenewsComesBetweenTwoPushes)
{
    BlockedCheck check;
    ASSERT_TRUE(check.pushes() && check.pushes(false));
    const Instant hung = check.bench.bench.clock.now();
    check.bench.renewal.stop();
    EXPECT_LE(check.drivenLast(), hung + experimentLease + handling);
    EXPECT_EQ(check.trial().reason, tuning::EndReason::User) << check.trial().detail;
}

TEST(Direction, PushesStayWithinTheDutyOfTheEnvelope)
{
    Envelope limits;
    limits.duty = 0.1;
    BlockedCheck drive("sim:can", "dmc60c", 5, limits);
    (void)drive.drivenLast();
    EXPECT_EQ(drive.trial().reason, tuning::EndReason::NoMotion) << drive.trial().detail;
    EXPECT_NE(drive.trial().detail.english().find("at up to 10 % duty"), std::string::npos) << drive.trial().detail;

    BlockedCheck board("sim:spi", "quadquad2drv", 0, limits); // which tells nobody its duty
    int powers = 0;
    const auto heard = board.bench.bench.link->traffic().add([&powers](const Traffic &traffic) {
        if (traffic.direction == Direction::Sent && traffic.bytes.size() == 7
            && traffic.bytes[2] == static_cast<std::uint8_t>(quadquad2drv::PacketId::SetPower)) {
            ++powers;
            EXPECT_LE(static_cast<std::int16_t>(readU16le(traffic.bytes, 4)), 819);
        }
    });
    (void)board.drivenLast();
    EXPECT_EQ(board.trial().reason, tuning::EndReason::NoMotion) << board.trial().detail;
    EXPECT_GT(powers, 2);
}

TEST(Direction, APushThatWasEndedIsTheLast)
{
    test::RealUnit unit; // a simulated one waits for a program that is held up
    EXPECT_TRUE(unit.simulator->disturb("stall", 1.0));
    SetPointStream stream(*unit.device, unit.dated);
    stream.renew();
    DirectionBook directions;
    ExperimentSurroundings around;
    around.directions = &directions;
    ExperimentPlan plan = stepTo(Mode::Velocity, 2000.0);
    plan.limits = {.travel = 1e5, .speed = 1e5, .current = 100.0, .duty = 0.6};
    auto task = runExperiment(*unit.device, stream, plan, around);
    task.start();
    const auto isOn = [&unit] { return unit.simulator->isOutputOn(); };
    ASSERT_TRUE(unit.clock.runUntil(isOn, 10s));
    unit.clock.advance(20ms);
    unit.clock.stall(150ms);
    ASSERT_TRUE(unit.clock.runUntil([&isOn] { return !isOn(); }, 1s));
    EXPECT_TRUE(unit.clock.runUntil([&] { return isOn() || task.isFinished(); }, 10s));
    ASSERT_TRUE(task.isFinished() && task.result()) << "it pushes again";
    EXPECT_EQ(task.result()->reason, tuning::EndReason::Late) << task.result()->detail;
    EXPECT_EQ(stream.end(), SetPointStream::End::Late);
    EXPECT_FALSE(directions.find(unit.device->selector(), 1));
}

TEST(Direction, IsGuardedWhileItPushes)
{
    for (const auto &[what, value, reason] :
        {std::tuple{"temperature", 95.0, "temperature"}, std::tuple{"bus-voltage", 5.0, "bus V"}}) {
        BlockedCheck check;
        ASSERT_TRUE(check.pushes());
        check.bench.bench.clock.advance(20ms);
        const Instant struck = check.bench.bench.clock.now();
        EXPECT_TRUE(check.bench.simulator()->disturb(what, value));
        EXPECT_LE(check.drivenLast(), struck + 100ms) << what;
        EXPECT_EQ(check.trial().reason, tuning::endReasonFrom(reason)) << check.trial().detail;
    }
}

/// It has no duty: what is sent too far the wrong way runs at full power.
TEST(Direction, ANudgeIsStoppedWithinSixtyCounts)
{
    ExperimentBench bench("sim:serial", "supermodified", 4);
    EXPECT_TRUE(bench.simulator()->disturb("encoder-reversed", 1.0));
    EXPECT_TRUE(bench.simulator()->disturb("load-torque", 0.02));
    const double start = bench.simulator()->position();
    ExperimentPlan plan = stepTo(Mode::Position, 1000.0);
    plan.slot = 0;
    auto task = bench.start(plan);
    task.start();
    double farthest = 0.0;
    double fastest = 0.0;
    ASSERT_TRUE(bench.bench.clock.runUntil(
        [&] {
            if (bench.simulator()->isOutputOn()) {
                farthest = std::max(farthest, std::abs(bench.simulator()->position() - start));
                fastest = std::max(fastest, std::abs(bench.simulator()->speed()));
            }
            return task.isFinished();
        },
        60s));

    EXPECT_LE(farthest, 60.0 + 0.02 * fastest);
    ASSERT_TRUE(task.result()) << task.result().error().text();
    EXPECT_EQ(task.result()->reason, tuning::EndReason::WrongDirection) << task.result()->detail;
}

TEST(Direction, AUnitThatFallsSilentIsNoneThatDoesNotMove)
{
    for (auto at = 20ms; at <= 600ms; at += 20ms) {
        ExperimentBench bench("sim:serial", "supermodified", 4);
        EXPECT_TRUE(bench.simulator()->disturb("stall", 1.0));
        ExperimentPlan plan = stepTo(Mode::Position, 1000.0);
        plan.slot = 0;
        const Instant cut = bench.bench.clock.now() + at;
        Timer cuts(bench.bench.clock);
        cuts.startIn(at, [&bench] { bench.simulator()->setPowered(false); });
        const auto &verdicts = bench.device->knowledge().profile().verdicts;
        auto task = bench.start(plan);
        task.start();
        ASSERT_TRUE(
            bench.bench.clock.runUntil([&] { return task.isFinished() || verdicts.contains("direction"); }, 60s));
        const bool isConcluded = verdicts.contains("direction") && bench.bench.clock.now() < cut;
        ASSERT_TRUE(bench.bench.clock.runUntil([&] { return task.isFinished(); }, 60s));
        if (!task.result()) { // before anything was to move
            EXPECT_LE(at, 100ms) << task.result().error().text();
            continue;
        }
        EXPECT_EQ(task.result()->reason, isConcluded ? tuning::EndReason::NoMotion : tuning::EndReason::Link)
            << at.count() << task.result()->detail;
    }
}

/// On a line that outlives the program, so that what has no watchdog needs a guardian.
class InheritableLink final : public VirtualCanLink {
public:
    using VirtualCanLink::VirtualCanLink;

private:
    [[nodiscard]] Outlet doOutlet() const override { return {Outlet::Form::CanSocket, 7}; }
};

/// Of a drive whose every guardian stands so late.
Result<double> dutyThatMoves(Duration late)
{
    test::FakeGuard guard;
    VirtualClock clock;
    VirtualCanBus bus(clock, 1'000'000, 1);
    InheritableLink host(*LinkAddress::parse("socketcan:can0"), bus);
    VirtualCanLink port(*LinkAddress::parse("socketcan:can0"), bus);
    EXPECT_TRUE(host.open() && port.open());
    const auto simulator = std::move(*abstractdc::family.simulate(port, clock, *SimulatedUnit::parse("abstractdc:3")));
    struct Sink final : ScanSink {
        void found(const Identity &identity) override { last = identity; }
        void progress(const Message &, int, int) override { }
        std::optional<Identity> last;
    } sink;
    EXPECT_TRUE(test::run(clock, abstractdc::family.scan(host, clock, sink)));
    const auto device = abstractdc::family.open(host, clock, *sink.last);
    clock.advance(1s);
    guard.standsAtOnce = false;
    device->guard().setSource(&guard);
    SetPointStream stream(*device, clock);
    const LeaseRenewal renewal(clock, [&stream] { stream.renew(); });
    TrialRecorder recorder(*device, stream, Mode::Velocity, 1);
    GuardPlan guards;
    guards.longest = 60s;
    std::optional<Trip> trip;
    auto task = checkDirection(*device, stream, recorder, 1, guards, trip);
    task.start();
    int seen = 0;
    Instant standsAt = Instant::max();
    EXPECT_TRUE(clock.runUntil(
        [&] {
            if (std::exchange(seen, guard.calls) != guard.calls)
                standsAt = clock.now() + late;
            if (guard.isWatching() && clock.now() >= standsAt) {
                standsAt = Instant::max();
                guard.become(GuardWatch::State::Standing);
            }
            return task.isFinished();
        },
        60s));
    EXPECT_GT(seen, 0);
    return task.result();
}

TEST(Direction, APushBeginsOnceItsGuardianStands)
{
    const auto quick = dutyThatMoves(0ms);
    ASSERT_TRUE(quick) << quick.error().text();
    EXPECT_EQ(dutyThatMoves(400ms).value_or(-1.0), *quick) << "and is no harder for it";
}

/// How far it goes while somebody finds out which one it is.
struct Nudged {
    explicit Nudged(ExperimentBench &bench)
    {
        Simulator &motor = *bench.simulator();
        const double start = motor.position();
        auto task = nudge(*bench.device, bench.bench.session.stream(*bench.device), 1, bench.surroundings);
        task.start();
        EXPECT_TRUE(bench.bench.clock.runUntil(
            [&] {
                if (motor.isOutputOn()) {
                    farthest = std::max(farthest, std::abs(motor.position() - start));
                    fastest = std::max(fastest, std::abs(motor.speed()));
                }
                return task.isFinished();
            },
            60s));
        EXPECT_FALSE(motor.isOutputOn());
        result = task.result();
    }

    double farthest = 0.0;
    double fastest = 0.0;
    Result<double> result;
};

TEST(Nudge, ThatIsAClosedLoopIsEndedByTheCheckOfItsDirectionWhoseGuardOfTravelMayBeFirst)
{
    for (int phase = 0; phase < 20; ++phase) {
        const int node = 4 + phase % 2;
        ExperimentBench bench("sim:serial", "supermodified", node);
        bench.bench.clock.advance(std::chrono::milliseconds(phase));
        EXPECT_TRUE(bench.simulator()->disturb("encoder-reversed", 1.0));
        const Nudged nudged(bench);
        ASSERT_FALSE(nudged.result) << *nudged.result;
        EXPECT_EQ(nudged.result.error().fault, Fault::Unsafe) << nudged.result.error().text();
        EXPECT_NE(nudged.result.error().text().find("reversed"), std::string::npos) << nudged.result.error().text();
        EXPECT_LE(nudged.farthest, 60.0 + 0.02 * nudged.fastest) << node;
    }
}

TEST(Nudge, TurnsAGoodShaftALittle)
{
    for (const auto &[link, family, address] : {std::tuple{"sim:serial", "supermodified", 4},
             {"sim:serial", "supermodified", 5}, {"sim:can", "abstractdc", 3}, {"sim:spi", "quadquad2drv", 0}}) {
        ExperimentBench bench(link, family, address);
        const Nudged nudged(bench);
        ASSERT_TRUE(nudged.result) << family << ' ' << nudged.result.error().text();
        EXPECT_GE(*nudged.result, 8.0) << family;
    }
}

/// Friction holds what 20 counts make of such a P.
void holdSoftly(ExperimentBench &bench)
{
    EXPECT_TRUE(test::run(
        bench.bench.clock, writeGains(*bench.device, {bench.change("gain.p", 500.0), bench.change("gain.i", 0.0)})));
}

TEST(Nudge, TurnsAShaftThatIsHeldSoftly)
{
    for (const int node : {4, 5}) {
        ExperimentBench bench("sim:serial", "supermodified", node);
        holdSoftly(bench);
        const Nudged nudged(bench);
        ASSERT_TRUE(nudged.result) << node << ' ' << nudged.result.error().text();
        EXPECT_GE(*nudged.result, leastNudged);
        EXPECT_EQ(bench.device->knowledge().profile().verdicts.at("direction"), DirectionVerdict::Agrees);
    }
}

TEST(Nudge, ThatIsHeldSoftlyIsEndedByTheCheckOfItsDirectionToo)
{
    ExperimentBench bench("sim:serial", "supermodified", 5);
    holdSoftly(bench);
    EXPECT_TRUE(bench.simulator()->disturb("encoder-reversed", 1.0));
    const Nudged nudged(bench);
    ASSERT_FALSE(nudged.result) << *nudged.result;
    EXPECT_EQ(nudged.result.error().fault, Fault::Unsafe) << nudged.result.error().text();
    EXPECT_LE(nudged.farthest, 60.0 + 0.02 * nudged.fastest);
}

TEST(Nudge, OfABlockedShaftSaysSo)
{
    ExperimentBench bench("sim:serial", "supermodified", 4);
    EXPECT_TRUE(bench.simulator()->disturb("stall", 1.0));
    const Nudged nudged(bench);
    ASSERT_FALSE(nudged.result) << *nudged.result;
    EXPECT_NE(nudged.result.error().text().find("sent 100 counts up"), std::string::npos)
        << nudged.result.error().text();
    EXPECT_EQ(bench.device->knowledge().profile().verdicts.at("direction"), DirectionVerdict::NoMotion);
}

/// A relative move is never sent twice: one that is lost ends it.
TEST(Nudge, GoesOnWhereALineLosesSome)
{
    int turned = 0;
    for (int seed = 1; seed <= 8; ++seed) {
        ExperimentBench bench("sim:serial?loss=0.02&seed=" + std::to_string(seed), "supermodified", 4);
        const Nudged nudged(bench);
        turned += nudged.result ? 1 : 0;
        EXPECT_TRUE(nudged.result || nudged.result.error().text().find("never sent twice") != std::string::npos)
            << seed << ' ' << nudged.result.error().text();
    }
    EXPECT_GE(turned, 5);
}

TEST(Nudge, EndsWhereALineSaysNothingAnyMore)
{
    for (const int node : {4, 5}) {
        ExperimentBench bench("sim:serial", "supermodified", node);
        Timer soon(bench.bench.clock);
        const std::function<void()> cut = [&] {
            if (bench.simulator()->speed() > 10.0)
                bench.simulator()->setPowered(false);
            else
                soon.startIn(1ms, cut);
        };
        cut();
        const Nudged nudged(bench);
        ASSERT_FALSE(nudged.result) << *nudged.result;
        EXPECT_EQ(nudged.result.error().fault, Fault::Unsafe) << nudged.result.error().text();
        EXPECT_LE(nudged.farthest, 60.0) << node;
    }
}

TEST(Nudge, EndsWithAnInterruption)
{
    ExperimentBench bench("sim:serial", "supermodified", 4);
    Timer soon(bench.bench.clock);
    soon.startIn(700ms, [&bench] { bench.interruption.interrupt(); });
    const Nudged nudged(bench);
    ASSERT_FALSE(nudged.result) << *nudged.result;
    EXPECT_EQ(nudged.result.error().fault, Fault::Cancelled) << nudged.result.error().text();
}

TEST(Direction, AndOfAnExperimentBeforeItsMotion)
{
    ExperimentBench bench;
    bench.directions.add(bench.device->selector(), 1, 0.08);
    bench.surroundings.before = [&bench]() -> Task<void> {
        bench.renewal.stop();
        co_await Sleep(bench.bench.clock, experimentLease);
        co_return {};
    };
    auto task = bench.start(stepTo(Mode::Velocity, 20'000.0));
    task.start();
    bool drove = false;
    ASSERT_TRUE(bench.bench.clock.runUntil(
        [&] {
            drove = drove || bench.simulator()->isOutputOn();
            return task.isFinished();
        },
        60s));
    EXPECT_FALSE(drove);
    ASSERT_TRUE(task.result()) << task.result().error().text();
    EXPECT_EQ(task.result()->reason, tuning::EndReason::User) << task.result()->detail;
}

} // namespace
} // namespace mb::tuning
