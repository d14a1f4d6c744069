// SPDX-License-Identifier: GPL-3.0-or-later
// Where the output of a loop does not fit into 16 bits the motor turns to full reverse: targets are led from where it is.
#include "abstractdccontrollerbench.h"
#include "families/abstractdc/parameters.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>

namespace mb::abstractdc {
namespace {

class AbstractDcLead : public AbstractDcController {
protected:
    void gains(const std::string &loop, std::int64_t p, std::int64_t d)
    {
        for (const auto &[name, raw] :
            {std::pair<const char *, std::int64_t>{".divisor", 1}, {".i", 0}, {".d", d}, {".p", p}})
            ASSERT_TRUE(write(loop + name, raw)) << name;
    }
    /// The slowest that it turns meanwhile, counts/s.
    double slowest(Simulator &drive, Duration duration)
    {
        double least = drive.speed();
        for (Duration passed{}; passed < duration; passed += 1ms) {
            clock.advance(1ms);
            least = std::min(least, drive.speed());
        }
        return least;
    }
    /// The fastest.
    double fastest(Simulator &drive, Duration duration)
    {
        double most = drive.speed();
        for (Duration passed{}; passed < duration; passed += 1ms) {
            clock.advance(1ms);
            most = std::max(most, drive.speed());
        }
        return most;
    }
};

TEST_F(AbstractDcLead, ASecondRunIsNotLedFromTheSpeedAtWhichTheFirstEnded)
{
    Simulator &drive = add("abstractdc:3,gains=default,load=60");
    open(3, &dialectF);
    gains("velocity", 50, 0);
    for (int run = 1; run <= 2; ++run) {
        sent.clear();
        SetPointStream stream(*device, clock);
        ASSERT_TRUE(stream.start(setPoint(Mode::Velocity, 2000.0), 10s));
        EXPECT_GE(slowest(drive, 2s), -50.0) << "full reverse: 50 * 2000 does not fit into 16 bits, run " << run;
        ASSERT_TRUE(stream.isRunning()) << stream.reason().english();
        ASSERT_GT(drive.speed(), 500.0);
        ASSERT_GE(sentOf("067#01").size(), 2U);
        EXPECT_EQ(sentOf("067#01").front(), "067#0180020000") << "640, 32000 / 50";
        stream.stop();
        clock.advance(3s);
        ASSERT_NEAR(drive.speed(), 0.0, 1.0);
    }
}

TEST_F(AbstractDcLead, WhatTheDriveMeasuredInTheLastRunIsNotRecordedInTheNext)
{
    add("abstractdc:3,gains=default,load=60");
    open(3, &dialectF);
    gains("velocity", 50, 0);
    for (int run = 1; run <= 2; ++run) {
        const Instant begun = clock.now();
        SetPointStream stream(*device, clock);
        ASSERT_TRUE(stream.start(setPoint(Mode::Velocity, 2000.0), 10s));
        clock.advance(30ms);
        device->telemetry()->commit();
        for (const char *key : {"velocity", "duty"}) {
            const auto seen = device->telemetry()->extremes(channel(key), begun, clock.now());
            EXPECT_TRUE(!seen || seen->high < 500.0) << key << ", run " << run << ": " << seen->high;
        }
        EXPECT_FALSE(device->telemetry()->extremes(channel("duty"), begun, clock.now()))
            << "its loop has hardly passed";
        clock.advance(2s);
        device->telemetry()->commit();
        EXPECT_TRUE(device->telemetry()->extremes(channel("duty"), begun, clock.now())) << "later it is";
        stream.stop();
        clock.advance(3s);
    }
}

TEST_F(AbstractDcLead, WhereItsFirstSetPointWasLostASecondRunIsNotLedFromTheFirstEither)
{
    Simulator &drive = add("abstractdc:3,gains=default,load=60");
    open(3, &dialectF);
    gains("velocity", 50, 0);
    for (const bool isLost : {false, true}) {
        SetPointStream stream(*device, clock);
        bus.setLoss(isLost ? 1.0 : 0.0);
        ASSERT_TRUE(stream.start(setPoint(Mode::Velocity, 2000.0), 10s));
        clock.advance(1ms);
        bus.setLoss(0.0);
        EXPECT_GE(slowest(drive, 2s), -50.0) << "full reverse, lost " << isLost;
        EXPECT_TRUE(stream.isRunning()) << stream.reason().english() << ", lost " << isLost;
        stream.stop();
        clock.advance(3s);
    }
}

TEST_F(AbstractDcLead, AFastDutyDoesNotBecomeAVelocityThatTurnsToFullReverse)
{
    Simulator &drive = add("abstractdc:3,gains=default,load=60");
    open(3, &dialectF);
    gains("velocity", 50, 0);
    SetPointStream stream(*device, clock);
    ASSERT_TRUE(stream.start(setPoint(Mode::Duty, 0.6), 60s));
    clock.advance(3s);
    const double fast = drive.speed();
    ASSERT_GT(fast, 1500.0);
    sent.clear();
    const auto refused = stream.update(setPoint(Mode::Velocity, fast));
    ASSERT_FALSE(refused) << "its first pass measures the mean since the drive was switched on";
    EXPECT_EQ(refused.error().fault, Fault::Unsafe);
    EXPECT_TRUE(sentOf("067#01").empty());
    EXPECT_GE(slowest(drive, 500ms), 0.9 * fast);
    EXPECT_TRUE(stream.isRunning()) << "with the duty";
    stream.stop();
    clock.advance(30s); // the mean becomes less
    ASSERT_TRUE(stream.start(setPoint(Mode::Velocity, 1000.0), 60s));
    EXPECT_GE(slowest(drive, 1s), -50.0);
    EXPECT_GT(drive.speed(), 400.0);
    stream.stop();
}

TEST_F(AbstractDcLead, AFirstTargetOfAVelocityStaysWithinReachOfTheMeanThatItMeasures)
{
    Simulator &drive = add("abstractdc:3,gains=default,load=60");
    open(3, &dialectF);
    gains("velocity", 50, 0);
    SetPointStream stream(*device, clock);
    ASSERT_TRUE(stream.start(setPoint(Mode::Duty, 0.6), 60s));
    clock.advance(3s);
    stream.stop();
    clock.advance(20s);
    ASSERT_NEAR(drive.speed(), 0.0, 1.0);
    ASSERT_TRUE(stream.start(setPoint(Mode::Velocity, -1000.0), 60s));
    EXPECT_LE(fastest(drive, 1s), 50.0) << "-640 is too far from what it measures";
    EXPECT_LT(drive.speed(), -400.0);
    stream.stop();
}

/// It measures the mean since it was switched on, which this program has not seen: another one drove it there.
TEST_F(AbstractDcLead, AFirstTargetStaysWithinReachOfTheMeanAlsoWhereThisProgramDidNotSeeItComeThere)
{
    Simulator &drive = add("abstractdc:3,gains=default,load=60");
    open(3, &dialectF);
    gains("velocity", 20, 0);
    {
        SetPointStream duty(*device, clock);
        ASSERT_TRUE(duty.start(setPoint(Mode::Duty, 0.6), 60s));
        clock.advance(3s);
        duty.stop();
        clock.advance(20s);
    }
    ASSERT_NEAR(drive.speed(), 0.0, 1.0);
    DeviceProfile known; // which is all that it knows
    known.written = device->knowledge().profile().written;
    device.reset();
    device = family.open(host, clock, identityOf(3, &dialectF));
    device->knowledge().setProfile(std::move(known));
    clock.advance(500ms);
    SetPointStream stream(*device, clock);
    const auto refused = stream.start(setPoint(Mode::Velocity, -3000.0), 60s);
    EXPECT_LE(fastest(drive, 1s), 50.0) << "-1600 is too far from what it measures";
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, Fault::Unsafe);
    clock.advance(20s); // the mean becomes less
    ASSERT_TRUE(stream.start(setPoint(Mode::Velocity, -3000.0), 60s));
    EXPECT_LE(fastest(drive, 1s), 50.0);
    EXPECT_LT(drive.speed(), -400.0) << stream.reason().english();
    stream.stop();
}

/// What a run has seen, the next one knows, as long as the motor stands where it stood.
TEST_F(AbstractDcLead, AnotherRunOfTheProgramKnowsWhereTheVelocityPassedLast)
{
    add("abstractdc:3,gains=default,load=60");
    open(3, &dialectF);
    gains("velocity", 20, 0);
    for (int run = 0; run < 3; ++run) {
        {
            SetPointStream stream(*device, clock);
            ASSERT_TRUE(stream.start(setPoint(Mode::Velocity, 1500.0), 60s)) << "run " << run;
            clock.advance(3s);
            ASSERT_TRUE(stream.isRunning()) << stream.reason().english();
            stream.stop();
            clock.advance(3s);
        }
        ASSERT_GT(std::abs(latest("position")), 1000.0);
        DeviceProfile kept = device->knowledge().profile();
        device.reset();
        device = family.open(host, clock, identityOf(3, &dialectF));
        device->knowledge().setProfile(std::move(kept));
        clock.advance(300ms);
    }
}

TEST_F(AbstractDcLead, AWeakVelocityLoopTakesOverAFastDuty)
{
    Simulator &drive = add("abstractdc:3,gains=tuned");
    open(3, &dialectF);
    gains("velocity", 1, 0);
    SetPointStream stream(*device, clock);
    ASSERT_TRUE(stream.start(setPoint(Mode::Duty, 0.6), 60s));
    clock.advance(3s);
    EXPECT_TRUE(stream.update(setPoint(Mode::Velocity, drive.speed())));
    EXPECT_GE(slowest(drive, 1s), 0.0);
    stream.stop();
}

TEST_F(AbstractDcLead, ALongStepOfAPositionStaysWithinWhatItsDampingCarries)
{
    Simulator &drive = add("abstractdc:3,gains=default");
    open(3, &dialectF);
    gains("position", 1, -10);
    SetPointStream stream(*device, clock);
    ASSERT_TRUE(stream.start(setPoint(Mode::Position, 60'000.0), 60s));
    EXPECT_GE(slowest(drive, 1s), 0.0) << "full reverse: 32 000 and 16 000 more by D do not fit into 16 bits";
    EXPECT_TRUE(stream.isRunning()) << stream.reason().english();
    EXPECT_GT(drive.position(), 100.0);
    EXPECT_EQ(sentOf("067#03").front(), "067#03F3050000")
        << "1523, 32000 / (1 + 2 * 10): a first pass may be 1 ms long";
    ASSERT_TRUE(stream.update(setPoint(Mode::Position, -60'000.0)));
    clock.advance(3s);
    EXPECT_TRUE(stream.isRunning()) << stream.reason().english();
    EXPECT_LT(drive.speed(), 0.0);
    stream.stop();
}

TEST_F(AbstractDcLead, GainsAreNotKnownUntilTheirDampingIs)
{
    add("abstractdc:3,gains=default");
    open(3, &dialectF);
    ASSERT_TRUE(write("position.divisor", 1));
    ASSERT_TRUE(write("position.p", 1));
    EXPECT_FALSE(device->caution(setPoint(Mode::Position, 1001.0)).empty());
    ASSERT_TRUE(device->command(setPoint(Mode::Position, 60'000.0)));
    EXPECT_EQ(sentOf("067#03").back(), "067#03E8030000") << "1000";
    device->stop();
    ASSERT_TRUE(write("position.d", 0));
    EXPECT_TRUE(device->caution(setPoint(Mode::Position, 1001.0)).empty());
}

/// There no target is near enough, and dialect L has no log of its output that would stop it.
TEST_F(AbstractDcLead, ATargetWhereTheMotorStandsProvesNothingOfGainsThatNobodyKnows)
{
    add("abstractdc:3,gains=default");
    open(3, &dialectF);
    ASSERT_TRUE(turnsAwayFromZero());
    const double here = latest("position");
    SetPointStream stream(*device, clock);
    ASSERT_TRUE(stream.start(setPoint(Mode::Position, here), 60s));
    clock.advance(3s);
    ASSERT_TRUE(stream.update(setPoint(Mode::Position, here + 100000.0)));
    EXPECT_NEAR(latest("setpoint"), here + 1000.0, 50.0);
}

TEST_F(AbstractDcLead, GainsWithWhichAnErrorOfOneTurnsTheOutputRoundMoveNothing)
{
    add("abstractdc:3,gains=default");
    add("abstractdc:4,gains=default,dialect=L");
    for (const auto &[offset, dialect] : {std::pair{3, &dialectF}, {4, &dialectL}}) {
        open(offset, dialect);
        for (const Mode mode : {Mode::Velocity, Mode::Current, Mode::Position}) {
            for (const auto &[p, d, fits] : {std::tuple{32'000, 0, true}, {32'001, 0, false}, {60'000, 0, false},
                     {-60'000, 0, false}, {0, 320'000, true}, {0, 320'010, false}, {0, -320'010, false}}) {
                gains(std::string(toString(mode)), p, d);
                EXPECT_EQ(device->check(setPoint(mode, 100.0)).has_value(), fits) << toString(mode) << ' ' << p << d;
                EXPECT_EQ(fits || device->command(setPoint(mode, 100.0)).error().fault == Fault::Unsafe, true);
            }
        }
        EXPECT_TRUE(device->check(setPoint(Mode::Duty, 0.1)));
        EXPECT_TRUE(sentOf("06").empty());
    }
}

TEST_F(AbstractDcLead, GainsAreNotRaisedBeyondTheErrorThatStands)
{
    Simulator &drive = add("abstractdc:3,gains=default,load=60");
    ASSERT_TRUE(drive.disturb("stall", 1.0));
    open(3, &dialectF);
    gains("velocity", 50, 0);
    SetPointStream stream(*device, clock);
    ASSERT_TRUE(stream.start(setPoint(Mode::Velocity, 600.0), 60s));
    sent.clear();
    EXPECT_EQ(write("velocity.p", 51).error().fault, Fault::Unsafe) << "its first pass is yet to come";
    clock.advance(500ms);
    for (const auto &[key, raw] : {std::pair{"velocity.p", 54}, {"velocity.p", -54}, {"velocity.d", 40}})
        EXPECT_EQ(write(key, raw).error().fault, Fault::Unsafe) << key << ' ' << raw;
    EXPECT_TRUE(sentOf("0CB").empty());
    for (const auto &[key, raw] :
        {std::pair{"velocity.d", 30}, {"velocity.d", 0}, {"velocity.p", 53}, {"velocity.p", 5}, {"position.p", 60'000}})
        EXPECT_TRUE(write(key, raw)) << key << ' ' << raw;
    EXPECT_TRUE(stream.isRunning()) << stream.reason().english();
    ASSERT_TRUE(drive.disturb("stall", 0.0));
    clock.advance(2s);
    EXPECT_GT(drive.speed(), 100.0);
    stream.stop();
}

TEST_F(AbstractDcLead, ATargetIsLedByAGainThatIsStillOnItsWay)
{
    Simulator &drive = add("abstractdc:3,gains=default");
    ASSERT_TRUE(drive.disturb("stall", 1.0));
    open(3, &dialectF);
    gains("velocity", 50, 0);
    SetPointStream stream(*device, clock);
    ASSERT_TRUE(stream.start(setPoint(Mode::Velocity, 10.0), 60s));
    clock.advance(500ms);
    sent.clear();
    auto raised = device->write(index("velocity.p"), 3000);
    raised.start();
    ASSERT_FALSE(sentOf("0CB").empty());
    ASSERT_FALSE(raised.isFinished());
    ASSERT_TRUE(stream.update(setPoint(Mode::Velocity, 600.0)));
    clock.advance(500ms);
    EXPECT_TRUE(raised.isFinished());
    for (const std::string &order : sentOf("067#"))
        EXPECT_EQ(order, "067#010A000000") << "32000 / 3000";
    stream.stop();
}

TEST_F(AbstractDcLead, ATargetStaysWithinWhatEitherGainAllowsWhereNobodyKnowsWhichIsInForce)
{
    Simulator &drive = add("abstractdc:3,gains=default");
    ASSERT_TRUE(drive.disturb("stall", 1.0));
    open(3, &dialectF);
    for (const auto &[p, expected] : {std::pair{3000, "067#010A000000"}, {5, "067#0180020000"}}) { // 10 and 640
        gains("velocity", 50, 0);
        SetPointStream stream(*device, clock);
        ASSERT_TRUE(stream.start(setPoint(Mode::Velocity, 10.0), 60s));
        clock.advance(500ms);
        sent.clear();
        {
            auto given = device->write(index("velocity.p"), p);
            given.start();
            ASSERT_FALSE(sentOf("0CB").empty());
            ASSERT_FALSE(given.isFinished());
        }
        ASSERT_FALSE(device->parameters().entry(index("velocity.p")).raw);
        ASSERT_TRUE(stream.update(setPoint(Mode::Velocity, 5000.0)));
        sent.clear();
        clock.advance(500ms);
        EXPECT_FALSE(sentOf("067#").empty());
        for (const std::string &order : sentOf("067#"))
            EXPECT_EQ(order, expected);
        stream.stop();
        clock.advance(1s);
    }
}

TEST_F(AbstractDcLead, AGainThatIsRaisedTooFarLeavesAllThatWereOrderedWithItUnwritten)
{
    Simulator &drive = add("abstractdc:3,gains=default,load=60");
    ASSERT_TRUE(drive.disturb("stall", 1.0));
    open(3, &dialectF);
    gains("velocity", 50, 0);
    SetPointStream stream(*device, clock);
    ASSERT_TRUE(stream.start(setPoint(Mode::Velocity, 600.0), 60s));
    clock.advance(500ms);
    sent.clear();
    NoProgress unseen;
    const auto outcomes
        = test::run(clock, writeParameters(*device, {{index("velocity.d"), 1}, {index("velocity.p"), 54}}, unseen));
    ASSERT_TRUE(outcomes);
    ASSERT_EQ(outcomes->size(), 1U);
    ASSERT_FALSE(outcomes->front().raw);
    EXPECT_EQ(outcomes->front().raw.error().fault, Fault::Unsafe);
    EXPECT_TRUE(sentOf("0CB").empty());
    stream.stop();
}

TEST_F(AbstractDcLead, GainsThatAreCalmerInTheEndAreWrittenInTheOrderInWhichTheyAre)
{
    Simulator &drive = add("abstractdc:3,gains=default,load=60");
    ASSERT_TRUE(drive.disturb("stall", 1.0));
    open(3, &dialectF);
    gains("velocity", 50, 0);
    SetPointStream stream(*device, clock);
    ASSERT_TRUE(stream.start(setPoint(Mode::Velocity, 600.0), 60s));
    clock.advance(500ms);
    NoProgress unseen;
    EXPECT_FALSE(test::run(clock, device->mayWrite(index("velocity.d"), 200))) << "with the P of now it would wrap";
    const auto outcomes
        = test::run(clock, writeParameters(*device, {{index("velocity.d"), 200}, {index("velocity.p"), 10}}, unseen));
    ASSERT_TRUE(outcomes);
    ASSERT_EQ(outcomes->size(), 2U);
    EXPECT_EQ(outcomes->at(0).raw, 10);
    EXPECT_EQ(outcomes->at(1).raw, 200);
    stream.stop();
}

/// The drive's counter has 32 bits, which last for three hours at this speed.
TEST_F(AbstractDcLead, AVelocityStaysWhatItIsWhereThePositionWraps)
{
    constexpr std::int64_t end = std::numeric_limits<std::int32_t>::max();
    test::FakeUnit unit(bus, clock);
    const auto log = [](const char *id, std::int64_t value) {
        const auto bits = static_cast<std::uint32_t>(value);
        std::array<char, 16> text{};
        (void)std::snprintf(text.data(), text.size(), "%s#%02X%02X%02X%02X", id, bits & 0xFF, bits >> 8 & 0xFF,
            bits >> 16 & 0xFF, bits >> 24);
        return test::FakeUnit::Frames{text.data()};
    };
    const auto positionsFrom = [&](std::int64_t from, std::int64_t step) {
        std::vector<test::FakeUnit::Frames> all;
        for (int i = 0; i < 200; ++i)
            all.push_back(log("483", from + i * step));
        return all;
    };
    open(3, &dialectF);
    DeviceProfile known; // its loop has passed there
    known.counters[std::string(counter::place)] = known.counters[std::string(counter::passed)] = end - 200'000;
    device->knowledge().setProfile(std::move(known));
    unit.answer("387#00", positionsFrom(end - 200'000, 0));
    unit.answer("387#01", {log("403", 200'000)});
    for (const auto &[question, answer] : {std::pair("387#02", "503"), {"387#03", "603"}, {"387#04", "680"}})
        unit.answer(question, {log(answer, 100)});
    clock.advance(1s);
    gains("velocity", 1, 0);
    SetPointStream stream(*device, clock);
    ASSERT_TRUE(stream.start(setPoint(Mode::Velocity, 200'000.0), 60s));
    unit.answer("387#00", positionsFrom(end - 200'000, 4000)); // 50 a second
    clock.advance(500ms);
    ASSERT_LT(latest("position"), end - 50'000.0);
    ASSERT_EQ(sentOf("067#01").back(), "067#01400D0300") << "200000";
    sent.clear();
    clock.advance(1500ms);
    ASSERT_LT(latest("position"), 0.0) << "it has wrapped";
    ASSERT_TRUE(stream.isRunning()) << stream.reason().english();
    for (const std::string &frame : sentOf("067#"))
        EXPECT_EQ(frame, "067#01400D0300");
    stream.stop();
}

TEST_F(AbstractDcLead, ASecondJumpOfAPositionIsBelievedOnlyWhereTheFirstWas)
{
    test::FakeUnit unit(bus, clock);
    std::vector<test::FakeUnit::Frames> positions(10, {"483#E8030000"}); // 1000
    positions.push_back({"483#E7030100"});                               // 66 535
    positions.push_back({"483#E903FFFF"});                               // -64 535
    positions.push_back({"483#E8030000"});
    unit.answer("387#00", positions);
    open(3, &dialectF);
    clock.advance(2s);
    device->telemetry()->commit();
    const auto seen = device->telemetry()->extremes(channel("position"), Instant{}, clock.now());
    ASSERT_TRUE(seen);
    EXPECT_EQ(seen->low, 1000.0);
    EXPECT_EQ(seen->high, 1000.0);
    EXPECT_EQ(device->telemetry()->lost(channel("position")), 2U);
}

} // namespace
} // namespace mb::abstractdc
