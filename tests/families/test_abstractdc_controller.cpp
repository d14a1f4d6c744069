// SPDX-License-Identifier: GPL-3.0-or-later
#include "abstractdccontrollerbench.h"
#include "families/abstractdc/codec.h"

namespace mb::abstractdc {
namespace {

TEST_F(AbstractDcController, IsHeardByPollingAndSilentWithoutPower)
{
    Simulator &drive = add("abstractdc:3");
    open(3, &dialectF);
    EXPECT_TRUE(device->liveness().heard);
    EXPECT_EQ(latest("position"), 0.0);
    drive.setPowered(false);
    clock.advance(300ms);
    EXPECT_FALSE(device->liveness().heard);
    drive.setPowered(true);
    clock.advance(1s);
    EXPECT_TRUE(device->liveness().heard);
}

TEST_F(AbstractDcController, AnUnprovenDialectIsWatchedButNotDriven)
{
    Simulator &drive = add("abstractdc:3");
    open(3, nullptr);
    EXPECT_TRUE(device->liveness().heard) << "the speed has one code in all dialects";
    const auto moved = device->command(setPoint(Mode::Duty, 0.5));
    ASSERT_FALSE(moved);
    EXPECT_EQ(moved.error().fault, Fault::Unsafe);
    EXPECT_NE(moved.error().text().find("not proven"), std::string::npos);
    EXPECT_FALSE(write("velocity.p", 1));
    clock.advance(500ms);
    EXPECT_TRUE(sentOf("067").empty());
    EXPECT_TRUE(sentOf("0CB").empty());
    ASSERT_TRUE(device->knowledge().setDialect("F"));
    EXPECT_NE(device->identity().detail.english().find("chosen by hand"), std::string::npos);
    clock.advance(200ms);
    EXPECT_TRUE(device->command(setPoint(Mode::Duty, 0.5)));
    clock.advance(10ms);
    EXPECT_TRUE(drive.isOutputOn());
    device->stop();
    clock.advance(10ms);
    EXPECT_FALSE(drive.isOutputOn());
}

TEST_F(AbstractDcController, TheOldestDialectIsNeverDriven)
{
    add("abstractdc:3,dialect=LL");
    open(3, &dialectLL);
    EXPECT_TRUE(device->liveness().heard);
    const auto allowed = device->mayMove();
    ASSERT_FALSE(allowed);
    EXPECT_NE(allowed.error().text().find("only its power stops it"), std::string::npos);
}

TEST_F(AbstractDcController, StopsWithBothLengthsAndAgain)
{
    for (const Dialect *dialect : {&dialectF, &dialectL, &dialectD}) {
        Simulator &drive = add("abstractdc:"
            + std::to_string(dialect == &dialectF ? 3
                    : dialect == &dialectL        ? 4
                                                  : 5)
            + ",dialect=" + std::string(dialect->key));
        const int offset = dialect == &dialectF ? 3 : dialect == &dialectL ? 4 : 5;
        open(offset, dialect);
        for (int i = 0; i < 10; ++i) {
            ASSERT_TRUE(device->command(setPoint(Mode::Duty, 0.4)));
            clock.advance(20ms);
        }
        EXPECT_TRUE(drive.isOutputOn()) << dialect->key;
        sent.clear();
        device->stop();
        const std::string prefix = dialect == &dialectF ? "067#" : dialect == &dialectL ? "068#" : "069#";
        const auto stops = sentOf(prefix);
        ASSERT_EQ(stops.size(), 3U);
        EXPECT_NE(std::find(stops.begin(), stops.end(), prefix + "0000000000"), stops.end());
        EXPECT_NE(std::find(stops.begin(), stops.end(), prefix + "0000000000000000"), stops.end());
        clock.advance(5ms);
        EXPECT_FALSE(drive.isOutputOn()) << dialect->key;
        EXPECT_FALSE(device->isSeenStopped()) << "nothing younger than the stop was seen";
        clock.advance(1s);
        EXPECT_TRUE(device->isSeenStopped()) << dialect->key;
        const StopScript script = device->stopScript();
        ASSERT_EQ(script.steps.size(), 3U);
        const std::size_t wide = dialect->wide ? 0 : 1; // its own length is told first
        EXPECT_EQ(toText(*script.steps[wide].frame), prefix + "0000000000000000");
        EXPECT_EQ(toText(*script.steps[1 - wide].frame), prefix + "0000000000");
        EXPECT_GE(script.steps[0].attempts, 2);
        const CanFrame question = *script.steps[2].frame;
        const std::string answer = toText(*script.steps[2].replyFrame);
        heard.clear();
        ASSERT_TRUE(host.send(question));
        clock.advance(5ms);
        const auto isAnswer = [&answer](const std::string &frame) {
            return frame.size() == answer.size() && frame.starts_with(answer.substr(0, answer.find('#') + 1));
        };
        EXPECT_TRUE(std::any_of(heard.begin(), heard.end(), isAnswer)) << "what proves the stop is what it answers";
    }
}

TEST_F(AbstractDcController, DutyIsLedToItsTargetAndNeverPastTheEnd)
{
    add("abstractdc:3");
    open(3, &dialectF);
    EXPECT_EQ(device->check(setPoint(Mode::Duty, 1.01)).error().fault, Fault::OutOfRange);
    std::int64_t before = 0;
    for (int i = 0; i < 30; ++i) {
        ASSERT_TRUE(device->command(setPoint(Mode::Duty, 1.0)));
        const auto frame = canFrameFromText(sentOf("067#").back());
        const std::int64_t now = frame->data[1] + 256 * frame->data[2];
        EXPECT_LE(now - before, 22) << "full range in a quarter of a second";
        EXPECT_LE(now, 255);
        before = now;
        clock.advance(20ms);
    }
    EXPECT_EQ(before, 255);
    device->stop();
}

TEST_F(AbstractDcController, APositionTargetNeverLeadsFurtherThanTheOutputCarries)
{
    Simulator &drive = add("abstractdc:3,gains=default");
    open(3, &dialectF);
    ASSERT_TRUE(write("position.p", 800'000));
    ASSERT_TRUE(write("position.divisor", 1'000'000));
    ASSERT_TRUE(write("position.d", 0));
    ASSERT_TRUE(device->command(setPoint(Mode::Position, 60'000.0))); // the wrap of abstractdc/README.md#vectors
    const auto frame = canFrameFromText(sentOf("067#03").back());
    const int target = frame->data[1] + 256 * frame->data[2] + 65536 * frame->data[3];
    EXPECT_EQ(target, 40'000) << "32000 / 0.8";
    clock.advance(200ms);
    EXPECT_GT(drive.speed(), 0.0) << "forwards";
    device->stop();
}

TEST_F(AbstractDcController, ACurrentTargetNeverLeadsFurtherThanTheOutputCarries)
{
    Simulator &drive = add("abstractdc:3");
    open(3, &dialectF);
    for (const auto &[key, raw] :
        {std::pair{"current.divisor", 1}, {"current.i", 0}, {"current.d", 0}, {"current.p", 50}})
        ASSERT_TRUE(write(key, raw));
    SetPointStream stream(*device, clock);
    ASSERT_TRUE(stream.start(setPoint(Mode::Current, 1000.0), 10s));
    for (int i = 0; i < 100; ++i) {
        clock.advance(20ms);
        ASSERT_GE(drive.speed(), 0.0) << "full reverse: 50 * 1000 does not fit into 16 bits";
    }
    EXPECT_TRUE(stream.isRunning()) << stream.reason().english();
    EXPECT_GT(drive.speed(), 0.0);
    for (const std::string &order : sentOf("067#02"))
        EXPECT_EQ(order, "067#0280020000") << "640, 32000 / 50";
    stream.stop();
}

TEST_F(AbstractDcController, AnOutputThatWrapsStopsTheMotor)
{
    Simulator &drive = add("abstractdc:3,gains=default");
    open(3, &dialectF);
    drive.disturb("stall", 1.0);
    ASSERT_TRUE(write("velocity.i", 1'000'000)); // nothing limits the sum
    ASSERT_TRUE(write("velocity.divisor", 1'000'000));
    SetPointStream stream(*device, clock);
    ASSERT_TRUE(stream.start(setPoint(Mode::Velocity, 900.0), 10s));
    clock.advance(3s);
    EXPECT_EQ(stream.end(), SetPointStream::End::Refused);
    EXPECT_NE(stream.reason().english().find("32767"), std::string::npos);
    EXPECT_FALSE(drive.isOutputOn());
    const auto faults = test::run(clock, device->readFaults());
    ASSERT_TRUE(faults);
    EXPECT_EQ(faults->at(1).key, "output_wrapped");
    EXPECT_EQ(faults->at(1).count, 1);
    device->stop();
    ASSERT_TRUE(device->command(setPoint(Mode::Velocity, 900.0)));
    sent.clear();
    ASSERT_TRUE(clock.runUntil([this] { return !sentOf("067#00").empty(); }, 10s)) << "though nobody commands it again";
    clock.advance(1ms);
    EXPECT_FALSE(drive.isOutputOn());
}

TEST_F(AbstractDcController, AnotherMasterIsSeenAndItsSettingsAreBelieved)
{
    add("abstractdc:3");
    open(3, &dialectF);
    VirtualCanLink master(*LinkAddress::parse("sim:can"), bus);
    ASSERT_TRUE(master.open());
    ASSERT_TRUE(master.send(*canFrameFromText("0CB#010040420F00")));
    clock.advance(5ms);
    EXPECT_EQ(device->parameters().entry(index("velocity.p")).raw, 1'000'000);
    ASSERT_TRUE(master.send(*canFrameFromText("067#0420000000")));
    clock.advance(5ms);
    EXPECT_TRUE(device->liveness().foreignMaster);
    EXPECT_FALSE(device->mayMove());
    ASSERT_TRUE(master.send(*canFrameFromText("067#0000000000")));
    clock.advance(5ms);
    EXPECT_FALSE(device->liveness().foreignMaster);
}

TEST_F(AbstractDcController, WhatAnotherMasterStopsStaysOff)
{
    Simulator &drive = add("abstractdc:3");
    VirtualCanLink master(*LinkAddress::parse("sim:can"), bus);
    ASSERT_TRUE(master.open());
    for (const char *stop : {"067#0000000000", "064#0000000000"}) {
        device.reset(); // after its stream
        open(3, &dialectF);
        SetPointStream stream(*device, clock);
        ASSERT_TRUE(stream.start(setPoint(Mode::Duty, 0.4), 60s));
        clock.advance(1s);
        ASSERT_TRUE(drive.isOutputOn());
        for (int i = 0; i < 3; ++i) // as this program stops
            ASSERT_TRUE(master.send(*canFrameFromText(stop)));
        clock.advance(1ms);
        EXPECT_FALSE(drive.isOutputOn()) << stop;
        EXPECT_FALSE(clock.runUntil([&] { return drive.isOutputOn(); }, 3s)) << stop;
        EXPECT_EQ(stream.end(), SetPointStream::End::ForeignMaster) << stop;
        EXPECT_FALSE(device->liveness().foreignMaster) << "it stands and nobody drives it";
        EXPECT_TRUE(device->mayMove()) << stop;
    }
}

TEST_F(AbstractDcController, WhatAnotherMasterAsksForIsRecordedToo)
{
    add("abstractdc:3");
    open(3, &dialectF);
    VirtualCanLink master(*LinkAddress::parse("sim:can"), bus);
    ASSERT_TRUE(master.open());
    const auto samplesOfASecond = [&](bool asked) {
        device->telemetry()->commit();
        const std::size_t before = device->telemetry()->size(channel("position"));
        for (int i = 0; i < 100; ++i) {
            EXPECT_TRUE(!asked || master.send(encodeLogRequest(dialectF, 3, Log::Position)));
            clock.advance(10ms);
        }
        device->telemetry()->commit();
        return device->telemetry()->size(channel("position")) - before;
    };
    const std::size_t alone = samplesOfASecond(false);
    const std::size_t together = samplesOfASecond(true);
    EXPECT_GE(together, alone + 30U);
    EXPECT_FALSE(device->liveness().foreignMaster) << "who asks only moves nothing";
}

TEST_F(AbstractDcController, SettingsAreClampedWhereTheDeviceIsNot)
{
    add("abstractdc:3");
    open(3, &dialectF);
    EXPECT_EQ(write("velocity.divisor", 0).error().fault, Fault::OutOfRange);
    EXPECT_EQ(write("current.averaging", 501).error().fault, Fault::OutOfRange);
    EXPECT_EQ(write("current.averaging", 0).error().fault, Fault::OutOfRange);
    EXPECT_TRUE(sentOf("0CB").empty());
    ASSERT_TRUE(write("current.averaging", 500)) << "no value is greater, so it cannot be a lower one";
    EXPECT_NE(sentOf("0CB").back(), "0CB#02");
    EXPECT_TRUE(device->mayMove());
    ASSERT_TRUE(write("current.averaging", 10));
    EXPECT_EQ(sentOf("0CB").back(), "0CB#02") << "lowered: saved at once";
    EXPECT_NE(device->mayMove().error().text().find("switch it off"), std::string::npos);
}

TEST_F(AbstractDcController, ADivisorIsNotChangedWhileItsLoopRuns)
{
    add("abstractdc:3");
    open(3, &dialectF);
    ASSERT_TRUE(device->command(setPoint(Mode::Velocity, 100.0)));
    EXPECT_EQ(write("velocity.divisor", 10).error().fault, Fault::Unsafe);
    EXPECT_TRUE(write("velocity.p", 10)) << "gains are tuned while it runs";
    EXPECT_TRUE(write("position.divisor", 10)) << "another loop";
    device->stop();
}

struct SaidLines final : Progress {
    void step(const Message &, int, int) override { }
    void part(int, PartState) override { }
    void log(Severity severity, const Message &text) override { lines.emplace_back(severity, text.english()); }
    void mayInterrupt(bool) override { }
    std::vector<std::pair<Severity, std::string>> lines;
};

TEST_F(AbstractDcController, SavesAreCountedWarnedOfAndRefusedBeforeTheFlashBug)
{
    add("abstractdc:3");
    open(3, &dialectF);
    for (int i = 1; i <= 50; ++i) {
        SaidLines log;
        ASSERT_TRUE(write("velocity.p", i));
        ASSERT_TRUE(test::run(clock, device->store(log))) << i;
        EXPECT_EQ(log.lines.empty(), i < 40) << i;
    }
    EXPECT_EQ(device->knowledge().profile().counters.at("saves.velocity"), 50);
    SaidLines log;
    ASSERT_TRUE(write("velocity.p", 51));
    const auto refused = test::run(clock, device->store(log));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, Fault::Unsafe);
    EXPECT_TRUE(write("position.p", 1)) << "other loops have pages of their own";
}

TEST_F(AbstractDcController, CurrentIsCountsUntilTheUserKnowsBetter)
{
    Simulator &drive = add("abstractdc:3");
    open(3, &dialectF);
    EXPECT_EQ(device->telemetry()->channels()[channel("current").value].unit, "counts");
    drive.disturb("stall", 1.0);
    for (int i = 0; i < 30; ++i) {
        ASSERT_TRUE(device->command(setPoint(Mode::Duty, 1.0)));
        clock.advance(20ms);
    }
    EXPECT_NEAR(latest("current"), 100.0, 5.0) << "5 A, 20 counts each";
    ASSERT_TRUE(device->knowledge().calibrate("amperes_per_count", 0.05));
    EXPECT_EQ(device->telemetry()->channels()[channel("current").value].unit, "A");
    clock.advance(500ms);
    EXPECT_NEAR(latest("current"), 5.0, 0.25);
    EXPECT_EQ(device->check(setPoint(Mode::Current, 60.0)).error().fault, Fault::OutOfRange) << "1023 counts are 51 A";
    device->stop();
}

TEST_F(AbstractDcController, AChannelHasTheUnitOfItsOwnCalibrationOnly)
{
    add("abstractdc:3");
    open(3, &dialectF);
    const auto unit = [this](std::string_view key) { return device->telemetry()->channels()[channel(key).value].unit; };
    ASSERT_TRUE(device->knowledge().calibrate("amperes_per_count", 0.05));
    EXPECT_EQ(unit("current"), "A");
    EXPECT_EQ(unit("temperature"), "counts");
    ASSERT_TRUE(device->knowledge().calibrate("degrees_per_count", 0.5));
    EXPECT_EQ(unit("temperature"), "°C");
}

TEST_F(AbstractDcController, TheSetPointOfACurrentIsRecordedAsItWasSent)
{
    add("abstractdc:3");
    open(3, &dialectF);
    (void)write("current.p", 0);
    ASSERT_TRUE(device->command(setPoint(Mode::Current, 40.0))) << "counts, while nobody knows better";
    EXPECT_EQ(latest("setpoint"), 40.0);
    ASSERT_TRUE(device->knowledge().calibrate("amperes_per_count", 0.05));
    clock.advance(2s);
    ASSERT_TRUE(device->command(setPoint(Mode::Current, 3.0)));
    EXPECT_NEAR(latest("setpoint"), 3.0, 1e-9);
    ASSERT_FALSE(sentOf("067#").empty());
    EXPECT_TRUE(sentOf("067#").back().ends_with("3C000000")) << "60 counts of 0.05 A";
    device->stop();
}

TEST_F(AbstractDcController, SlowLogsAreAskedForAsOftenAsTheyAreWished)
{
    add("abstractdc:3");
    open(3, &dialectF);
    const auto asked = [this](const std::string &log) {
        sent.clear();
        clock.advance(20s);
        return static_cast<double>(sentOf(log).size());
    };
    EXPECT_NEAR(asked("387#02"), 100.0, 2.0) << "current, usually five times a second";
    EXPECT_NEAR(asked("387#03"), 20.0, 1.0) << "temperature, once a second";
    for (const double hertz : {0.5, 1.0, 2.0}) {
        ASSERT_TRUE(test::run(clock, device->setRate(channel("current"), hertz)));
        ASSERT_TRUE(test::run(clock, device->setRate(channel("temperature"), hertz)));
        EXPECT_NEAR(asked("387#02"), 20.0 * hertz, 1.0) << hertz;
        EXPECT_NEAR(asked("387#03"), 20.0 * hertz, 1.0) << hertz;
    }
    ASSERT_TRUE(test::run(clock, device->setRate(channel("current"), 0.0)));
    EXPECT_NEAR(asked("387#02"), 100.0, 2.0);
}

TEST_F(AbstractDcController, ATargetFurtherThanItsLeadIsCautionedWhereTheGainsAreNotKnown)
{
    add("abstractdc:3");
    open(3, &dialectF);
    for (const double sign : {1.0, -1.0}) {
        EXPECT_TRUE(device->caution(setPoint(Mode::Position, sign * 1000.0)).empty()) << "32000 / 32 from 0";
        EXPECT_FALSE(device->caution(setPoint(Mode::Position, sign * 1001.0)).empty());
    }
    EXPECT_TRUE(device->caution(setPoint(Mode::Duty, 1.0)).empty()) << "no loop";
    ASSERT_TRUE(write("position.p", 1));
    ASSERT_TRUE(write("position.d", 0));
    ASSERT_TRUE(write("position.divisor", 1));
    EXPECT_TRUE(device->caution(setPoint(Mode::Position, 1001.0)).empty()) << "known";
}

TEST_F(AbstractDcController, LogsThatStandStillAreNotRecorded)
{
    add("abstractdc:3");
    open(3, &dialectF);
    clock.advance(1s);
    EXPECT_TRUE(sentOf("387#01").empty()) << "velocity outside its mode";
    EXPECT_TRUE(sentOf("387#04").empty()) << "output while nothing is driven";
    EXPECT_EQ(latest("velocity"), 0.0) << "computed from positions instead";
    EXPECT_TRUE(std::isnan(latest("duty")));
    ASSERT_TRUE(device->command(setPoint(Mode::Velocity, 1000.0)));
    clock.advance(1s);
    EXPECT_FALSE(sentOf("387#01").empty());
    EXPECT_FALSE(sentOf("387#04").empty());
    device->stop();
}

TEST_F(AbstractDcController, GlitchesOfOneWrapAreFilteredAndCounted)
{
    add("abstractdc:3,glitches=10");
    open(3, &dialectF);
    clock.advance(2s);
    device->telemetry()->commit();
    const auto range = device->telemetry()->extremes(channel("position"), Instant{}, clock.now());
    ASSERT_TRUE(range);
    EXPECT_EQ(range->low, 0.0);
    EXPECT_EQ(range->high, 0.0);
    EXPECT_GE(device->telemetry()->lost(channel("position")), 3U);
}

TEST_F(AbstractDcController, AJumpOfOneWrapThatStaysCountsOneLostPositionAndBreaksTheLine)
{
    test::FakeUnit unit(bus, clock);
    std::vector<test::FakeUnit::Frames> positions(10, {"483#00000000"});
    positions.push_back({"483#FFFF0000"}); // 65 535, from here on
    unit.answer("387#00", positions);
    open(3, &dialectF);
    clock.advance(2s);
    device->telemetry()->commit();
    EXPECT_EQ(latest("position"), 65535.0);
    EXPECT_EQ(device->telemetry()->lost(channel("position")), 1U);
    const auto gaps = device->telemetry()->gaps(channel("position"), Instant{}, clock.now());
    ASSERT_EQ(gaps.size(), 1U) << "no line leads from one to the other";
    EXPECT_EQ(gaps.front().lost, 1U);
}

TEST_F(AbstractDcController, TwoDrivesShareTheVoltageLogWithoutMixing)
{
    add("abstractdc:3");
    add("abstractdc:6");
    open(3, &dialectF);
    const auto second = family.open(host, clock, identityOf(6, &dialectF));
    clock.advance(200ms);
    for (int i = 0; i < 100; ++i) {
        ASSERT_TRUE(device->command(setPoint(Mode::Duty, 0.2)));
        ASSERT_TRUE(second->command(setPoint(Mode::Duty, -0.4)));
        clock.advance(20ms);
    }
    second->telemetry()->commit();
    device->telemetry()->commit();
    const auto mine = device->telemetry()->extremes(channel("duty"), clock.now() - 1s, clock.now());
    const auto others = second->telemetry()->extremes(channel("duty"), clock.now() - 1s, clock.now());
    ASSERT_TRUE(mine && others);
    EXPECT_NEAR(mine->low, 0.2, 0.01);
    EXPECT_NEAR(mine->high, 0.2, 0.01);
    EXPECT_NEAR(others->low, -0.4, 0.01);
    EXPECT_NEAR(others->high, -0.4, 0.01);
    device->stop();
    second->stop();
}

class AbstractDcSlow : public AbstractDcController {
protected:
    AbstractDcSlow()
        : AbstractDcController(1250)
    {
    }
};

TEST_F(AbstractDcSlow, PollingAndSetPointsLeaveHalfOfASlowWire)
{
    Simulator &drive = add("abstractdc:3");
    open(3, &dialectF);
    clock.advance(5s);
    EXPECT_TRUE(device->liveness().heard);
    SetPointStream stream(*device, clock);
    ASSERT_TRUE(stream.start(setPoint(Mode::Duty, 0.3), 60s));
    clock.advance(10s);
    EXPECT_TRUE(stream.isRunning());
    EXPECT_TRUE(drive.isOutputOn());
    EXPECT_LE(host.backlog(), 2U) << "nothing piles up";
    EXPECT_LE(host.load(clock.now()), 0.75);
    const Instant before = clock.now();
    stream.stop();
    ASSERT_TRUE(clock.runUntil([&] { return !drive.isOutputOn(); }, 2s));
    EXPECT_LE(clock.now() - before, 300ms) << "one frame that is on the wire, then the stop";
    clock.advance(3s);
    EXPECT_TRUE(device->isSeenStopped());
}

} // namespace
} // namespace mb::abstractdc
