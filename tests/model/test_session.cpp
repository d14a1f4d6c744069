// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/fakeguard.h"
#include "support/simulatedsession.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <set>

namespace mb {
namespace {

using namespace std::chrono_literals;
using test::SimulatedSession;

Result<Device *> connect(SimulatedSession &bench, const char *selector)
{
    return test::run(bench.clock, bench.session.connect(*DeviceSelector::parse(selector)));
}

TEST(Session, FindsTheBenchInOrderAndTellsOfIt)
{
    SimulatedSession bench;
    int told = 0;
    const auto listening = bench.session.changed().add([&told] { ++told; });
    const auto seen = bench.scan();
    std::string order;
    for (const Device *device : seen)
        order += std::string(device->family().key) + ':' + std::to_string(device->identity().address) + ' ';
    EXPECT_EQ(order, "dmc60c:5 dmc60c:7 dmc60c:9 abstractdc:3 abstractdc:4 abstractdc:5 ");
    EXPECT_EQ(bench.device(9)->identity().state, DeviceState::Bootloader);
    EXPECT_GE(told, 3);
}

TEST(Session, KeepsDevicesAndTheirNamesAcrossScans)
{
    SimulatedSession bench;
    const auto first = bench.scan();
    const DeviceId id = bench.session.idOf(*first[0]);
    EXPECT_EQ(bench.scan(), first);
    EXPECT_EQ(bench.session.devices().size(), 6U);
    EXPECT_EQ(bench.session.find(id), first[0]);
    EXPECT_EQ(bench.session.find({12345}), nullptr);
}

TEST(Session, KeepsADeviceThatDoesNotAnswerAndDoesNotHearIt)
{
    SimulatedSession bench;
    bench.scan();
    bench.clock.advance(500ms);
    ASSERT_TRUE(bench.device(7)->liveness().heard);
    bench.simulator("dmc60c:7")->setPowered(false);
    EXPECT_EQ(bench.scan().size(), 5U);
    bench.clock.advance(500ms);
    ASSERT_TRUE(bench.device(7));
    EXPECT_FALSE(bench.device(7)->liveness().heard);
}

TEST(Session, TakesAUnitAfterAPowerCycleForTheSame)
{
    SimulatedSession bench;
    bench.scan();
    Device *before = bench.device(7);
    const auto session = before->identity().session;
    bench.simulator("dmc60c:7")->setPowered(false);
    bench.clock.advance(1s);
    bench.simulator("dmc60c:7")->setPowered(true);
    bench.clock.advance(1s);
    bench.scan();
    EXPECT_EQ(bench.session.devices().size(), 6U);
    EXPECT_EQ(bench.device(7), before);
    EXPECT_NE(before->identity().session, session);
}

/// A scan reports a unit before it has asked for its texts.
TEST(Session, KeepsTheTextsOfAUnitWhileItIsFoundAgainUnlessItHasRestartedSince)
{
    SimulatedSession bench;
    bench.scan();
    Device *const device = bench.device(5);
    const Identity known = device->identity();
    ASSERT_FALSE(known.name.empty() || known.serial.empty() || known.descriptors.empty());
    bool without = false;
    const auto listening = device->changed().add([&] {
        const Identity &now = device->identity();
        without = without || now.name != known.name || now.serial != known.serial || now.descriptors.empty();
    });
    bench.scan();
    EXPECT_FALSE(without);
    bench.simulator("dmc60c:5")->setPowered(false);
    bench.clock.advance(1s);
    bench.simulator("dmc60c:5")->setPowered(true);
    bench.scan();
    EXPECT_TRUE(without) << "until it has told them again it may be another one";
    EXPECT_EQ(device->identity().serial, known.serial);
}

TEST(Session, TellsWhenALinkComesAndWhenItGoes)
{
    test::SimulatedSession bench;
    int told = 0;
    const auto listening = bench.session.changed().add([&told] { ++told; });
    LinkState last = LinkState::Open;
    const auto hearing = bench.link->stateChanged().add([&last](LinkState state) { last = state; });
    bench.session.closeLink(*bench.link);
    EXPECT_EQ(last, LinkState::Closed) << "whoever knows it by its place in memory must hear that it goes";
    EXPECT_GE(told, 1);
    told = 0;
    ASSERT_TRUE(bench.session.openLink(*LinkAddress::parse("sim:can")));
    EXPECT_GE(told, 1);
}

TEST(Session, OpensALinkOnce)
{
    SimulatedSession bench;
    const auto again = bench.session.openLink(*LinkAddress::parse("sim:can"));
    ASSERT_TRUE(again);
    EXPECT_EQ(*again, bench.link);
    EXPECT_EQ(bench.session.links().size(), 1U);
    const auto other = bench.session.openLink(*LinkAddress::parse("sim:can?seed=2"));
    ASSERT_TRUE(other);
    EXPECT_NE(*other, bench.link);
    EXPECT_TRUE(bench.session.bench(**other));
}

TEST(Session, RefusesALinkThatCannotBe)
{
    SimulatedSession bench;
    for (const char *address : {"sim:can?loss=2", "sim:can?loss=nan", "sim:can?colour=red", "sim:can?fault=melt@1",
             "sim:can?fault=busoff@inf", "sim:can?bitrate=0", "sim:can?seed=x", "socketcan:nosuchcan9"}) {
        const auto opened = bench.session.openLink(*LinkAddress::parse(address));
        ASSERT_FALSE(opened) << address;
        EXPECT_FALSE(opened.error().text().empty());
    }
    EXPECT_EQ(bench.session.links().size(), 1U);
}

TEST(Session, ConnectsToExactlyTheDeviceThatWasNamed)
{
    SimulatedSession bench;
    const auto device = connect(bench, "sim:can/dmc60c:7");
    ASSERT_TRUE(device);
    EXPECT_EQ((*device)->identity().address, 7);
    const auto missing = connect(bench, "sim:can/dmc60c:33");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().fault, Fault::Timeout);
    EXPECT_FALSE(connect(bench, "sim:can/abstractdc:7"));
    EXPECT_FALSE(connect(bench, "sim:can/dmc60c:7@0001"));
}

TEST(Session, YieldsNoSilentUnitWhoseStopAnEarlierRunStillOwes)
{
    VirtualClock clock;
    test::FakeGuard guard;
    Session session(clock, families(), &guard);
    Link &link = **session.openLink(*LinkAddress::parse("sim:can"));
    for (Simulator *one : session.bench(link)->simulators())
        one->setPowered(!one->name().starts_with("abstractdc"));
    const auto silent = [&](const char *selector) {
        return test::run(clock, session.connect(*DeviceSelector::parse(selector), true));
    };
    guard.book.push_back({link.line(), "socketcan:can0/abstractdc:3", {}, clock.now()});
    guard.book.push_back({link.line(), "socketcan:can0/abstractdc:4", {}, clock.now() - DeviceStop::debtLimit});
    clock.advance(2s);
    const auto owed = silent("sim:can/abstractdc:3");
    ASSERT_FALSE(owed);
    EXPECT_EQ(owed.error().fault, Fault::Unsafe) << owed.error().text();
    EXPECT_TRUE(silent("sim:can/abstractdc:6"));
    EXPECT_TRUE(silent("sim:can/abstractdc:4")) << "nobody can see a mute one stand: its debt ends with its time";
    session.stops().dismiss();
    EXPECT_TRUE(silent("sim:can/abstractdc:3"));
}

TEST(Session, YieldsASilentUnitWhereItIsMeantAndAnotherWayInLeadsToIt)
{
    SimulatedSession bench;
    const auto silent = [&bench](const char *selector) {
        return test::run(bench.clock, bench.session.connect(*DeviceSelector::parse(selector), true));
    };
    EXPECT_FALSE(connect(bench, "sim:can/abstractdc:6"));
    const auto beside = silent("sim:can/abstractdc:6");
    ASSERT_FALSE(beside) << "the programmer may hang on another";
    EXPECT_EQ(beside.error().fault, Fault::Timeout);
    EXPECT_NE(beside.error().text().find("take all others off the line"), std::string::npos) << beside.error().text();
    for (const char *other : {"abstractdc:3", "abstractdc:4", "abstractdc:5"})
        bench.simulator(other)->setPowered(false);
    const auto mute = silent("sim:can/abstractdc:6");
    ASSERT_TRUE(mute) << mute.error().text();
    EXPECT_EQ((*mute)->identity().state, DeviceState::Bootloader);
    EXPECT_FALSE((*mute)->identity().detail.empty());
    bench.simulator("abstractdc:3")->setPowered(true);
    const auto there = silent("sim:can/abstractdc:3");
    ASSERT_TRUE(there);
    EXPECT_EQ((*there)->identity().state, DeviceState::Online);
    EXPECT_FALSE(silent("sim:can/dmc60c:33")) << "only the bus leads to it";
    EXPECT_FALSE(silent("sim:can/supermodified:4")) << "it speaks no CAN";
    EXPECT_EQ((*silent("sim:spi/quadquad2drv:0"))->identity().state, DeviceState::Online);
}

TEST(Session, YieldsNoSilentNodeOfALineWhereAnotherOneAnswers)
{
    SimulatedSession bench("sim:serial");
    const auto silent = [&bench] {
        return test::run(
            bench.clock, bench.session.connect(*DeviceSelector::parse("sim:serial/supermodified:9"), true));
    };
    const auto beside = silent();
    ASSERT_FALSE(beside) << "only this one is asked at first";
    EXPECT_EQ(beside.error().fault, Fault::Timeout);
    for (Simulator *const node : bench.session.bench(*bench.link)->simulators())
        node->setPowered(false);
    const auto mute = silent();
    ASSERT_TRUE(mute) << mute.error().text();
    EXPECT_EQ((*mute)->identity().state, DeviceState::Bootloader);
}

TEST(Session, WantsTheSessionWhereANumberIsTakenTwice)
{
    SimulatedSession bench("sim:can?fault=duplicate");
    const auto refused = connect(bench, "sim:can?fault=duplicate/dmc60c:5");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, Fault::Refused);
    std::set<Device *> found;
    for (Device *device : bench.devices("dmc60c")) {
        if (device->identity().address != 5)
            continue;
        EXPECT_EQ(device->identity().state, DeviceState::Duplicate);
        EXPECT_FALSE(device->mayMove());
        EXPECT_NE(refused.error().text().find(device->selector()), std::string::npos) << "the error names both";
        const auto connected = connect(bench, device->selector().c_str());
        ASSERT_TRUE(connected) << connected.error().text();
        EXPECT_EQ(*connected, device);
        found.insert(*connected);
    }
    EXPECT_EQ(found.size(), 2U);
    const auto third = connect(bench, "sim:can?fault=duplicate/dmc60c:5@0001");
    ASSERT_FALSE(third);
    for (const Device *device : found)
        EXPECT_NE(third.error().text().find(device->selector()), std::string::npos) << "it may be either of them";
}

class Driven : public testing::Test {
protected:
    Driven()
    {
        bench.scan();
        bench.clock.advance(500ms);
        SetPoint setPoint;
        setPoint.mode = Mode::Duty;
        setPoint.target = 0.3;
        EXPECT_TRUE(bench.session.stream(*bench.device(5)).start(setPoint, 60s));
        bench.clock.advance(200ms);
        EXPECT_TRUE(bench.simulator("dmc60c:5")->isOutputOn());
    }
    SimulatedSession bench;
};

TEST_F(Driven, StopsEverythingWithoutWaiting)
{
    bench.session.stopAll(StopCause::User);
    EXPECT_FALSE(bench.session.stream(*bench.device(5)).isRunning());
    bench.clock.advance(3ms);
    EXPECT_FALSE(bench.simulator("dmc60c:5")->isOutputOn());
}

TEST(Session, DrivesNoDeviceThatItFindsWhileStopIsPressed)
{
    SimulatedSession bench;
    std::atomic<bool> pressed = true;
    bench.session.setStopGate(&pressed);
    bench.scan();
    bench.clock.advance(500ms);
    SetPoint setPoint;
    setPoint.mode = Mode::Duty;
    setPoint.target = 0.3;
    for (Device *device : bench.session.devices()) {
        EXPECT_TRUE(device->gate().isStopPressed()) << device->selector();
        EXPECT_FALSE(bench.session.stream(*device).start(setPoint, 60s)) << device->selector();
    }
    pressed = false;
    EXPECT_TRUE(bench.session.stream(*bench.device(5)).start(setPoint, 60s));
}

TEST(Session, ThatKeepsNoHistoriesHasNoneOfADevice)
{
    SimulatedSession bench;
    bench.session.keepHistoriesIn(nullptr);
    bench.scan();
    bench.clock.advance(1s);
    const Telemetry &telemetry = *bench.device(5)->telemetry();
    EXPECT_EQ(telemetry.size(*telemetry.find("velocity")), 0U);
    EXPECT_TRUE(telemetry.latest(*telemetry.find("velocity")));
}

TEST(Session, AUnitIsRecognisedWhileItHasToldWhoItIsSinceItRestarted)
{
    SimulatedSession bench;
    bench.scan();
    Device &device = *bench.device(7);
    EXPECT_TRUE(bench.session.isRecognised(device));
    for (const Duration without : {0ms, 1000ms}) {
        bench.simulator("dmc60c:7")->setPowered(false);
        bench.clock.advance(without);
        bench.simulator("dmc60c:7")->setPowered(true);
        bench.clock.advance(3s);
        ASSERT_TRUE(device.liveness().restarted);
        ASSERT_NE(device.identity().serial, "") << "of the one before";
        EXPECT_FALSE(bench.session.isRecognised(device));
        ASSERT_TRUE(test::run(bench.clock, device.refresh()));
        EXPECT_TRUE(bench.session.isRecognised(device));
    }
    Identity identity = device.identity();
    identity.serial.clear();
    device.setIdentity(identity);
    EXPECT_FALSE(bench.session.isRecognised(device)) << "its serial number is not read yet";
}

TEST(Session, ASerialNumberThatIsLearnedLaterMakesNoOtherUnitOfADevice)
{
    SimulatedSession bench;
    bench.scan();
    Device &device = *bench.device(3, "abstractdc");
    const DeviceId id = bench.session.idOf(device);
    EXPECT_TRUE(bench.session.isRecognised(device)) << "nothing tells such units apart";
    bench.clock.advance(500ms);
    const std::size_t samples = device.telemetry()->size(*device.telemetry()->find("position"));
    ASSERT_GT(samples, 0U);
    Identity identity = device.identity();
    identity.serial = "A7";
    device.setIdentity(identity);
    EXPECT_EQ(bench.session.idOf(device), id);
    EXPECT_EQ(device.telemetry()->size(*device.telemetry()->find("position")), samples);
    identity.serial = "A8";
    device.setIdentity(identity);
    EXPECT_NE(bench.session.idOf(device), id) << "that is another one";
    EXPECT_EQ(device.telemetry()->size(*device.telemetry()->find("position")), 0U);
}

TEST_F(Driven, AnotherUnitInItsPlaceIsNotDrivenAndNothingReadOfTheOneBeforeIsItsOwn)
{
    Device &device = *bench.device(5);
    Identity identity = device.identity();
    ASSERT_NE(identity.serial, "");
    device.setIdentity(identity);
    SetPointStream &stream = bench.session.stream(device);
    EXPECT_TRUE(stream.isRunning()) << "it is the same";
    const ParameterIndex gain = bench.index(device, "slot0.p");
    device.parameters().setRead(gain, 65536);
    identity.serial = "A8";
    device.setIdentity(identity);
    EXPECT_EQ(stream.end(), SetPointStream::End::Stopped);
    bench.clock.advance(3ms);
    EXPECT_FALSE(bench.simulator("dmc60c:5")->isOutputOn());
    EXPECT_FALSE(device.parameters().entry(gain).raw);
}

TEST_F(Driven, HasOneStreamForADevice)
{
    EXPECT_EQ(&bench.session.stream(*bench.device(5)), &bench.session.stream(*bench.device(5)));
    EXPECT_NE(&bench.session.stream(*bench.device(5)), &bench.session.stream(*bench.device(7)));
}

TEST_F(Driven, SendsAStopBeforeItClosesTheLink)
{
    std::vector<CanFrame> sent;
    const auto tap = bench.link->traffic().add([&sent](const Traffic &traffic) {
        if (traffic.can && traffic.direction == Direction::Sent)
            sent.push_back(*traffic.can);
    });
    bench.session.closeLink(*bench.link);
    ASSERT_FALSE(sent.empty());
    EXPECT_EQ(sent.back().id, 0x02060005U);
    EXPECT_EQ(sent.back().data[0], 0x0F);
    EXPECT_TRUE(bench.session.devices().empty());
    EXPECT_TRUE(bench.session.links().empty());
    bench.clock.advance(1s); // nothing of the link is armed any more, or this crashes
}

TEST_F(Driven, LeavesAlonePureListeners)
{
    const auto before = bench.link->counters().tx;
    bench.session.stream(*bench.device(7)).stop();
    bench.clock.advance(5ms);
    EXPECT_TRUE(bench.simulator("dmc60c:5")->isOutputOn()) << "a stop for one device is for that device";
    EXPECT_GT(bench.link->counters().tx, before);
}

} // namespace
} // namespace mb
