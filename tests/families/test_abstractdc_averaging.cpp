// SPDX-License-Identifier: GPL-3.0-or-later
// The averaging of the current: a drive whose averaging was lowered may overwrite its memory until it is switched off and on.
#include "abstractdccontrollerbench.h"
#include "families/abstractdc/parameters.h"

#include <limits>

namespace mb::abstractdc {
namespace {

TEST_F(AbstractDcController, AveragingIsNotChangedWhileTheMotorIsDrivenNorWhileItMerelyTurns)
{
    Simulator &drive = add("abstractdc:3");
    open(3, &dialectF);
    ASSERT_TRUE(device->command(setPoint(Mode::Duty, 0.5)));
    clock.advance(1s);
    EXPECT_EQ(write("current.averaging", 50).error().fault, Fault::Unsafe) << "driven, and it turns";
    EXPECT_TRUE(sentOf("0CB").empty());
    device->stop();
    clock.advance(5s);
    ASSERT_TRUE(drive.disturb("load-torque", -5.0));
    clock.advance(500ms);
    ASSERT_GT(std::abs(drive.speed()), 100.0) << "something else turns it";
    EXPECT_EQ(write("current.averaging", 50).error().fault, Fault::Unsafe) << "nobody drives it, and it turns";
    EXPECT_TRUE(sentOf("0CB").empty());
    ASSERT_TRUE(drive.disturb("load-torque", 0.0));
    clock.advance(20s);
    EXPECT_TRUE(write("current.averaging", 50));
    EXPECT_FALSE(sentOf("0CB").empty());
}

/// Raised, too: what the loop of the current reads would fall to a part.
TEST_F(AbstractDcController, AveragingIsNotChangedWhileADrivenMotorStandsStill)
{
    Simulator &drive = add("abstractdc:3");
    open(3, &dialectF);
    ASSERT_TRUE(drive.disturb("stall", 1.0));
    for (const auto &[mode, target] : {std::pair{Mode::Duty, 0.1}, {Mode::Current, 20.0}}) {
        ASSERT_TRUE(device->command(setPoint(mode, target)));
        clock.advance(2s);
        for (const std::int64_t raw : {50, 500})
            EXPECT_EQ(write("current.averaging", raw).error().fault, Fault::Unsafe) << toString(mode) << ' ' << raw;
        EXPECT_TRUE(sentOf("0CB").empty());
        device->stop();
        clock.advance(2s);
    }
    EXPECT_TRUE(write("current.averaging", 500));
    EXPECT_FALSE(sentOf("0CB").empty());
}

TEST_F(AbstractDcController, ALoweredAveragingNeedsTheDriveSwitchedOffOnce)
{
    Simulator &drive = add("abstractdc:3");
    open(3, &dialectF);
    ASSERT_TRUE(turnsAwayFromZero());
    ASSERT_TRUE(write("current.averaging", 500));
    ASSERT_TRUE(write("current.averaging", 10));
    EXPECT_FALSE(device->mayMove());
    powerCycle(drive, 500ms);
    EXPECT_TRUE(device->mayMove());
    ASSERT_TRUE(write("current.averaging", 60)) << "raised, it owes nothing";
    EXPECT_TRUE(device->mayMove());
}

TEST_F(AbstractDcController, OfTheAveragingOfADriveThatStandsInThePlaceOfAnotherNothingIsKnown)
{
    Simulator &drive = add("abstractdc:3");
    open(3, &dialectF);
    ASSERT_TRUE(turnsAwayFromZero());
    ASSERT_TRUE(write("current.averaging", 50));
    device->knowledge().unitExchanged();
    EXPECT_FALSE(device->mayMove()) << "nothing proves that it was switched off";
    ASSERT_TRUE(write("current.averaging", 50));
    powerCycle(drive, 500ms);
    ASSERT_TRUE(write("current.averaging", 50));
    ASSERT_TRUE(device->mayMove()) << "it had that";
    device->knowledge().unitExchanged();
    EXPECT_FALSE(device->parameters().entry(*findParameter(device->parameters().table(), "current.averaging")).raw);
    ASSERT_TRUE(write("current.averaging", 50));
    EXPECT_FALSE(device->mayMove()) << "another one may have had more";
}

TEST_F(AbstractDcController, ThatAPowerCycleIsOwedIsSaidAsLongAsItIs)
{
    const auto faults = [this] { return device->liveness().faults; };
    const std::vector<std::string> owed{"power_cycle_owed"};
    Simulator &drive = add("abstractdc:3");
    open(3, &dialectF);
    ASSERT_TRUE(turnsAwayFromZero());
    EXPECT_TRUE(faults().empty());
    ASSERT_TRUE(write("current.averaging", 10));
    EXPECT_EQ(faults(), owed);
    device->setIdentity(identityOf(3, &dialectF));
    ASSERT_TRUE(test::run(clock, device->refresh()));
    EXPECT_EQ(faults(), owed) << "a scan and a look do not take it away";
    EXPECT_EQ(device->identity().detail.english().find("Switch it off"), std::string::npos);
    const auto records = test::run(clock, device->readFaults());
    ASSERT_TRUE(records);
    EXPECT_TRUE(std::ranges::any_of(
        *records, [](const FaultRecord &record) { return record.key == "power_cycle_owed" && record.active; }));
    powerCycle(drive, 500ms);
    EXPECT_TRUE(faults().empty());
}

TEST_F(AbstractDcController, AnAveragingThatNobodyKnowsIsTakenForAGreaterOne)
{
    Simulator &drive = add("abstractdc:3");
    open(3, &dialectF);
    ASSERT_TRUE(turnsAwayFromZero());
    ASSERT_TRUE(write("current.averaging", 50));
    EXPECT_EQ(sentOf("0CB").back(), "0CB#02") << "saved, so that it is in force after the power cycle";
    EXPECT_NE(device->mayMove().error().text().find("switch it off"), std::string::npos);
    powerCycle(drive, 500ms);
    EXPECT_TRUE(device->mayMove());
}

TEST_F(AbstractDcController, AnAveragingThatOnlyAFileTellsIsTakenForAGreaterOneToo)
{
    Simulator &drive = add("abstractdc:3");
    open(3, &dialectF);
    ASSERT_TRUE(turnsAwayFromZero());
    device->knowledge().assume(*findParameter(family.parameters, "current.averaging"), 10);
    ASSERT_TRUE(write("current.averaging", 60)) << "the drive may have 500";
    EXPECT_FALSE(device->mayMove());
    powerCycle(drive, 500ms);
    EXPECT_TRUE(device->mayMove());
}

TEST_F(AbstractDcController, AnotherRunOfTheProgramKnowsThatThePowerCycleIsOwed)
{
    Simulator &drive = add("abstractdc:3");
    open(3, &dialectF);
    ASSERT_TRUE(turnsAwayFromZero());
    ASSERT_TRUE(write("current.averaging", 50));
    const DeviceProfile kept = device->knowledge().profile();
    open(3, &dialectF);
    EXPECT_TRUE(device->mayMove());
    device->knowledge().setProfile(kept);
    EXPECT_FALSE(device->mayMove());
    EXPECT_EQ(device->liveness().faults.size(), 1U) << "and says so";
    powerCycle(drive, 500ms);
    EXPECT_TRUE(device->mayMove());
    EXPECT_NE(device->knowledge().profile(), kept) << "to be kept";
}

TEST_F(AbstractDcController, ALoweredAveragingIsNotSentWhereWhatItOwesCannotBeKept)
{
    add("abstractdc:3");
    open(3, &dialectF);
    bool isFull = true;
    bool wasOwed = false;
    device->knowledge().setKeeper([&]() -> Task<void> {
        wasOwed = device->knowledge().profile().counters.at(std::string(counter::powerCycle)) == 1;
        if (isFull)
            co_return fail(Fault::NotKept, say("no room"));
        co_return {};
    });
    EXPECT_EQ(write("current.averaging", 50).error().fault, Fault::NotKept);
    EXPECT_TRUE(wasOwed) << "when it was to be kept";
    EXPECT_TRUE(sentOf("0CB").empty());
    EXPECT_TRUE(device->mayMove());
    EXPECT_TRUE(write("current.averaging", 500)) << "which owes nothing";
    isFull = false;
    EXPECT_TRUE(write("current.averaging", 50));
    EXPECT_FALSE(device->mayMove());
    isFull = true;
    EXPECT_EQ(write("current.averaging", 40).error().fault, Fault::NotKept);
    EXPECT_FALSE(device->mayMove()) << "the one before still owes it";
}

TEST_F(AbstractDcController, ACableThatWasOutIsNoPowerCycle)
{
    add("abstractdc:3");
    open(3, &dialectF);
    ASSERT_TRUE(turnsAwayFromZero());
    ASSERT_TRUE(write("current.averaging", 50));
    bus.setLoss(1.0);
    clock.advance(2s);
    ASSERT_FALSE(device->liveness().heard);
    bus.setLoss(0.0);
    clock.advance(2s);
    ASSERT_TRUE(device->liveness().heard);
    EXPECT_FALSE(device->mayMove());
}

TEST_F(AbstractDcController, ARestartThatIsSeenWhileItAnswersPaysThePowerCycleToo)
{
    Simulator &drive = add("abstractdc:3");
    open(3, &dialectF);
    ASSERT_TRUE(turnsAwayFromZero());
    ASSERT_TRUE(write("current.averaging", 50));
    powerCycle(drive, 20ms);
    ASSERT_TRUE(device->liveness().restarted);
    ASSERT_TRUE(test::run(clock, device->refresh()));
    EXPECT_TRUE(device->mayMove());
}

/// Its position is 0 before and after, with its power and without.
TEST_F(AbstractDcController, AGapOfTheBusNearZeroIsNoPowerCycleAndWhatWouldShowOneIsSaid)
{
    Simulator &drive = add("abstractdc:3");
    open(3, &dialectF);
    ASSERT_TRUE(write("velocity.p", 5));
    ASSERT_TRUE(write("current.averaging", 50));
    EXPECT_NE(device->mayMove().error().remedy.english().find("300 counts away from 0"), std::string::npos);
    bus.setLoss(1.0);
    clock.advance(2s);
    ASSERT_FALSE(device->liveness().heard);
    bus.setLoss(0.0);
    clock.advance(2s);
    ASSERT_TRUE(device->liveness().heard);
    EXPECT_FALSE(device->mayMove());
    EXPECT_FALSE(device->parameters().entry(index("velocity.p")).raw) << "it may have been one";
    ASSERT_TRUE(drive.disturb("load-torque", -5.0));
    clock.advance(500ms);
    ASSERT_TRUE(drive.disturb("load-torque", 0.0));
    clock.advance(20s);
    ASSERT_GT(std::abs(latest("position")), 300.0);
    EXPECT_EQ(device->mayMove().error().remedy.english(), "switch it off and on");
    powerCycle(drive, 500ms);
    EXPECT_TRUE(device->mayMove());
}

TEST_F(AbstractDcController, AParameterThatCannotBeReadIsNoEndOfReadingAndARefusedOneEndsWriting)
{
    add("abstractdc:3");
    open(3, &dialectF);
    NoProgress progress;
    const auto read = test::run(
        clock, readParameters(*device, {index("velocity.p"), index("velocity.i"), index("velocity.d")}, progress));
    ASSERT_TRUE(read);
    ASSERT_EQ(read->size(), 3U) << "none can be read, and each says so";
    for (const TransferOutcome &outcome : *read)
        EXPECT_EQ(outcome.raw.error().fault, Fault::Unsupported);
    const auto written = test::run(
        clock, writeParameters(*device, {{index("velocity.divisor"), 0}, {index("velocity.p"), 5}}, progress));
    ASSERT_TRUE(written);
    ASSERT_EQ(written->size(), 1U) << "what comes after it may need it";
    EXPECT_EQ(written->at(0).raw.error().fault, Fault::OutOfRange);
    EXPECT_TRUE(sentOf("0CB").empty());
}

TEST_F(AbstractDcController, ARefreshTellsHowOftenThePositionJumpedAndWhatWasSaved)
{
    add("abstractdc:3");
    open(3, &dialectF);
    EXPECT_TRUE(device->identity().descriptors.empty());
    ASSERT_TRUE(test::run(clock, device->refresh()));
    ASSERT_FALSE(device->identity().descriptors.empty());
    EXPECT_EQ(device->identity().descriptors.front(), (std::pair<std::string, std::string>("position_glitches", "0")));
}

TEST_F(AbstractDcController, AnAnswerInAnotherFormIsNoProofThatASettingCame)
{
    test::FakeUnit unit(bus, clock);
    unit.answer("388#01", {{"00000404#00000000", "404#000000"}});
    open(4, &dialectF);
    const auto refused = write("velocity.p", 5);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, Fault::Timeout);
    EXPECT_NE(refused.error().text().find("does not answer"), std::string::npos);
    unit.answer("388#01", {{"404#00000000"}});
    EXPECT_TRUE(write("velocity.p", 5));
    host.close();
    EXPECT_EQ(write("velocity.p", 5).error().fault, Fault::LinkLost);
}

TEST(AbstractDcCommand, ADutyIsBetweenAllBackwardsAndAllForwards)
{
    const auto duty = [](double target) {
        SetPoint order;
        order.mode = Mode::Duty;
        order.target = target;
        return commandOf(order, {});
    };
    for (const double beyond : {-1.01, 1.01, -2.0, 2.0})
        EXPECT_EQ(duty(beyond).error().fault, Fault::OutOfRange) << beyond;
    EXPECT_EQ(duty(-1.0)->target, -255);
    EXPECT_EQ(duty(1.0)->target, 255);
    EXPECT_EQ(duty(0.0)->target, 0);
}

TEST(AbstractDcCommand, WhatADriveCannotDoIsSaidInOneClause)
{
    const auto refusal = [](const auto &change) {
        SetPoint order;
        order.mode = Mode::Duty;
        change(order);
        const auto made = commandOf(order, {});
        return made ? std::string() : made.error().text();
    };
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(refusal([](SetPoint &) {}), "");
    EXPECT_EQ(
        refusal([](SetPoint &order) { order.mode = Mode::Voltage; }), "an Abstract DC Drive has no mode 'voltage'");
    EXPECT_EQ(refusal([](SetPoint &order) { order.target = none; }), "duty needs a number");
    for (const double ramp : {none, -0.001})
        EXPECT_EQ(refusal([ramp](SetPoint &order) { order.ramp = ramp; }),
            "the ramp must be 0 or a positive number of duty per second");
    EXPECT_EQ(refusal([](SetPoint &order) { order.target = 1.5; }), "duty 1.5 is outside -1 … 1");
    SetPoint off;
    EXPECT_EQ(off.mode, Mode::Off);
    EXPECT_EQ(commandOf(off, {})->target, 0);
}

TEST(AbstractDcTargetLead, ADutyIsLedFromWhereItWasAsFastAsItsRampSays)
{
    TargetLead lead;
    const Instant begin = Instant{} + 1s;
    const Command full{Loop::Direct, 255};
    EXPECT_EQ(lead.next(full, 1.0, {}, 0.0, begin), 5) << "255 a second, of the first 20 ms";
    EXPECT_EQ(lead.next(full, 1.0, {}, 0.0, begin + 100ms), 31);
    EXPECT_EQ(lead.next({Loop::Direct, -255}, 1.0, {}, 0.0, begin + 200ms), 5) << "downwards too";
    EXPECT_EQ(lead.next({Loop::Direct, -255}, 1.0, {}, 0.0, begin + 300ms), -20);
    EXPECT_EQ(lead.next({Loop::Direct, -21}, 1.0, {}, 0.0, begin + 400ms), -21) << "not beyond its target";
    EXPECT_EQ(lead.next(full, 1.0, {}, 0.0, begin + 400ms), -20) << "at least one";
    EXPECT_EQ(lead.next(full, 0.0, {}, 0.0, begin + 500ms), 82) << "four full ranges a second where nobody says";
    lead.reset();
    EXPECT_EQ(lead.next(full, 0.0, {}, 0.0, begin + 600ms), 20) << "from nothing again";
}

TEST(AbstractDcTargetLead, ALoopIsNeverFurtherAheadOfItsFeedbackThanIsSafe)
{
    TargetLead lead;
    const Instant begin = Instant{} + 1s;
    const Command far{Loop::Position, 1000};
    EXPECT_EQ(lead.next(far, 0.0, 100.0, 50.0, begin), 150);
    EXPECT_EQ(lead.next(far, 0.0, 120.0, 50.0, begin), 170);
    EXPECT_EQ(lead.next(far, 0.0, {}, 50.0, begin), 220) << "from the last target where nothing is known";
    EXPECT_EQ(lead.next({Loop::Position, -1000}, 0.0, 100.0, 50.0, begin), 50);
    EXPECT_EQ(lead.next({Loop::Position, 110}, 0.0, 100.0, 50.0, begin), 110);
    EXPECT_EQ(lead.next({Loop::Velocity, 1000}, 0.0, {}, 30.0, begin), 30) << "another loop begins at nothing";
    EXPECT_EQ(lead.next({Loop::Direct, 255}, 1.0, {}, 0.0, begin + 10s), 5) << "and so does a duty";
    EXPECT_EQ(lead.next({Loop::Velocity, 1000}, 0.0, {}, 30.0, begin + 10s), 30);
}

TEST(AbstractDcTargetLead, ACurrentIsLedFromNothingBecauseItsConverterReadsNoLess)
{
    TargetLead lead;
    const Instant begin = Instant{} + 1s;
    const Command far{Loop::Current, 1000};
    EXPECT_EQ(lead.next(far, 0.0, {}, 640.0, begin), 640);
    EXPECT_EQ(lead.next(far, 0.0, {}, 640.0, begin + 20ms), 640) << "and not from the last target";
    EXPECT_EQ(lead.next({Loop::Current, 600}, 0.0, {}, 640.0, begin + 40ms), 600);
}

TEST_F(AbstractDcController, APositionThatWasNotAnsweredCountsAsLostAndNothingElseDoes)
{
    add("abstractdc:3");
    open(3, &dialectF);
    device->telemetry()->commit();
    ASSERT_EQ(device->telemetry()->lost(channel("position")), 0U);
    bus.setLoss(1.0);
    clock.advance(300ms);
    bus.setLoss(0.0);
    clock.advance(100ms);
    device->telemetry()->commit();
    EXPECT_GE(device->telemetry()->lost(channel("position")), 1U);
    EXPECT_EQ(device->telemetry()->lost(channel("velocity")), 0U);
}

} // namespace
} // namespace mb::abstractdc
