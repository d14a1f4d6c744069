// SPDX-License-Identifier: GPL-3.0-or-later
// Whole stories of DMC60Cs, compared with stored texts (docs/testing.md#golden-conversations).
#include "families/storysteps.h"
#include "firmware/firmwareimage.h"
#include "support/hextext.h"
#include "transport/canlink.h"

#include <gtest/gtest.h>

namespace mb {
namespace {

using namespace std::chrono_literals;
using namespace test;

/// One that is asked, and one beside it that must not react.
struct TwoDmc60c {
    explicit TwoDmc60c(Conversation &told, const std::string &options = {}, std::uint64_t seed = 1)
        : stage(told, "sim:can", seed)
        , unit(stage.unit("dmc60c:5,session=0x1234,serial=210334A47A9F" + options))
        , bystander(stage.unit("dmc60c:6,session=0x4321,motor=775pro"))
    {
        stage.sum([this] {
            rows = stage.scan();
            const Identity found = rowOf(rows, "dmc60c", 5);
            device = found.family.empty() ? nullptr : &stage.open(found);
            stage.advance(300ms);
        });
        if (device)
            stage.forgetOutcomes();
    }
    Result<std::int64_t> write(std::string_view key, double number)
    {
        const ParameterIndex index = indexOf(*device, key);
        const auto raw = toRaw(device->parameters().parameter(index), number);
        return stage.perform("write " + std::string(key) + ' ' + numberOf(number), device->write(index, *raw));
    }
    void send(CanLink &link, std::string_view frame) { EXPECT_TRUE(link.send(*canFrameFromText(frame))); }

    StoryStage stage;
    Simulator &unit;
    Simulator &bystander;
    std::vector<Identity> rows;
    Device *device = nullptr;
};

TEST(Dmc60cConversations, AScanOfAMixedBus)
{
    Conversation told;
    StoryStage stage(told, "sim:can");
    stage.unit("dmc60c:5,session=0x1234");
    Simulator &leaving = stage.unit("dmc60c:7,session=0x1235,motor=775pro,name=left,firmware=1.25");
    stage.unit("dmc60c:9,state=bootloader");
    stage.unit("dmc60c:12,fault=silent@1");
    stage.unit("dmc60c:20,fault=duplicate");
    stage.unit("dmc60c:0");
    stage.unit("dmc60c:33,product=600");
    stage.unit("abstractdc:3,dialect=F,motor=25d");
    stage.scan();
    for (const int address : {5, 20, 9})
        (void)stage.perform("refresh", stage.open(rowOf(stage.scan(), "dmc60c", address)).refresh());
    leaving.setPowered(false);
    stage.scan();
    stage.wait(3s);
    leaving.setPowered(true);
    stage.advance(400ms);
    stage.scan();
    stage.wait(3s);
    stage.tellTelemetry();
    told.expectAsStored("dmc60c-scan");
}

TEST(Dmc60cConversations, EveryParameterAtItsEnds)
{
    Conversation told;
    TwoDmc60c bench(told);
    tellParameters(bench.stage, *bench.device, false);
    bench.stage.wait(20s);
    told.expectAsStored("dmc60c-parameters");
}

TEST(Dmc60cConversations, WhatIsWrittenIsStoredAndOutlivesThePower)
{
    Conversation told;
    TwoDmc60c bench(told);
    StoryStage &stage = bench.stage;
    Device &device = *bench.device;
    stage.wait(16s);
    (void)stage.perform("store with nothing written", device.store(stage.progress()));
    (void)bench.write("slot0.p", 2.5);
    (void)stage.perform("store one change", device.store(stage.progress()));
    (void)bench.write("slot0.p", 2.5);
    (void)stage.perform("store the same", device.store(stage.progress()));
    (void)bench.write("slot0.p", 3.5);
    (void)bench.write("slot0.i", 0.25);
    (void)stage.perform("store two", device.store(stage.progress()));
    (void)bench.write("slot0.d", 0.125);
    bench.unit.setPowered(false);
    stage.wait(3s);
    (void)stage.perform("read from a dead unit", device.read(indexOf(device, "slot0.p")));
    bench.unit.setPowered(true);
    stage.wait(3s);
    (void)stage.perform("refresh", device.refresh());
    for (const char *key : {"slot0.p", "slot0.i", "slot0.d"})
        (void)stage.perform(std::string("read ") + key, device.read(indexOf(device, key)));
    (void)bench.write("slot1.p", 4.0);
    (void)stage.perform("restart", device.restart());
    (void)stage.perform("read slot1.p", device.read(indexOf(device, "slot1.p")));
    stage.tellTelemetry();
    told.expectAsStored("dmc60c-store");
}

TEST(Dmc60cConversations, WhatAUnitIsAndIsCalled)
{
    Conversation told;
    TwoDmc60c bench(told);
    StoryStage &stage = bench.stage;
    Device &device = *bench.device;
    (void)stage.perform("refresh", device.refresh());
    (void)stage.perform("identify", device.identify());
    stage.wait(2s);
    (void)stage.perform("rename", device.rename("left arm"));
    (void)stage.perform("rename to a letter", device.rename("x"));
    (void)stage.perform("rename to the longest", device.rename(std::string(64, 'a')));
    (void)stage.perform("rename to one more", device.rename(std::string(65, 'a')));
    (void)stage.perform("rename to nothing", device.rename(""));
    (void)stage.perform("rename in Latin-1", device.rename("gr\xC3\xBCn"));
    (void)stage.perform("rename with the first letter in Latin-1", device.rename("\xC3\xBCn"));
    (void)stage.perform("rename to half a letter", device.rename("gr\xC3"));
    (void)stage.perform("rename to what it has not", device.rename("\xE7\xB6\xA0"));
    for (const int number : {0, 64, 6, 5, 63, 1, 5})
        (void)stage.perform("renumber to " + std::to_string(number), device.renumber(number));
    (void)stage.perform("restart", device.restart());
    (void)stage.perform("zero", device.zeroPosition());
    stage.answer("buffered moves", device.releaseMoves());
    stage.answer("may move", device.mayMove());
    stage.answer("may stop", device.mayStop());
    stage.tellStopScript(device);
    stage.scan();
    told.expectAsStored("dmc60c-identity");
}

TEST(Dmc60cConversations, EveryModeAndItsStop)
{
    Conversation told;
    TwoDmc60c bench(told);
    StoryStage &stage = bench.stage;
    Device &device = *bench.device;
    stage.sum([&] { (void)stage.perform("read all", readParameters(device, readable(device), stage.progress())); });
    drive(stage, device, wish(Mode::Duty, 0.3), 70ms, 400ms);
    drive(stage, device, wish(Mode::Duty, 0.0), 50ms, 200ms);
    drive(stage, device, wish(Mode::Duty, -0.3), 50ms, 500ms, Glide{1.0, {}});
    halt(stage, device, 60ms, 400ms);
    halt(stage, device, 30ms, 0ms);
    drive(stage, device, wish(Mode::Velocity, 3000.0), 50ms, 400ms);
    drive(stage, device, wish(Mode::Velocity, -1000.0), 30ms, 400ms, Glide{5000.0, {}});
    halt(stage, device, 40ms, 500ms);
    SetPoint move = wish(Mode::Position, 2000.0);
    move.slot = 1;
    drive(stage, device, move, 50ms, 600ms);
    move.target = -500.0;
    drive(stage, device, move, 30ms, 600ms, Glide{4000.0, 100.0});
    halt(stage, device, 40ms, 400ms);
    drive(stage, device, wish(Mode::Current, 4.0), 50ms, 300ms);
    drive(stage, device, wish(Mode::Voltage, 3.0), 50ms, 300ms);
    SetPoint special = wish(Mode::Duty, 0.25);
    special.ramp = 0.5;
    special.brake = true;
    special.reverseMotor = true;
    special.overrideLimits = true;
    special.disableForwardLimit = true;
    drive(stage, device, special, 50ms, 300ms);
    special.brake = false;
    special.reverseSensor = true;
    special.disableReverseLimit = true;
    drive(stage, device, special, 50ms, 100ms);
    halt(stage, device, 40ms, 1s);
    drive(stage, device, wish(Mode::Follow, 6), 50ms, 100ms);
    halt(stage, device, 40ms, 300ms);
    for (const SetPoint &bad : {wish(Mode::Duty, 1.1), wish(Mode::Velocity, 1e9), wish(Mode::Position, 1e12),
             wish(Mode::Current, 1000.0), wish(Mode::Voltage, 99.0), wish(Mode::Follow, 64), wish(Mode::Follow, 0),
             wish(Mode::RampPosition, 10.0), wish(Mode::Duty, 0.1, 2)})
        stage.answer("check " + textOf(bad), device.check(bad));
    stage.tellTelemetry();
    told.expectAsStored("dmc60c-motion");
}

TEST(Dmc60cConversations, WhateverEndsAMotionEndsInAStop)
{
    Conversation told;
    TwoDmc60c bench(told);
    StoryStage &stage = bench.stage;
    Device &device = *bench.device;
    SetPointStream &stream = stage.stream(device);
    drive(stage, device, wish(Mode::Duty, 0.2), 40ms, 0ms);
    stage.heading("nobody renews");
    stage.wait(450ms);
    stage.advance(100ms);
    stage.wait(500ms);
    drive(stage, device, wish(Mode::Duty, 0.2), 40ms, 200ms);
    stage.heading("another master");
    auto &other = static_cast<CanLink &>(stage.other());
    bench.send(other, "02060005#0000000000000000");
    keepDriving(stage, stream, 60ms, 300ms);
    stage.wait(3s);
    drive(stage, device, wish(Mode::Duty, 0.2), 40ms, 200ms);
    stage.heading("it is reset");
    bench.unit.setPowered(false);
    bench.unit.setPowered(true);
    keepDriving(stage, stream, 200ms, 1s);
    stage.wait(2s);
    (void)stage.perform("refresh", device.refresh());
    drive(stage, device, wish(Mode::Duty, 0.2), 40ms, 200ms);
    stage.heading("it goes away");
    bench.unit.setPowered(false);
    keepDriving(stage, stream, 200ms, 2s);
    bench.unit.setPowered(true);
    stage.wait(3s);
    (void)stage.perform("refresh", device.refresh());
    drive(stage, device, wish(Mode::Duty, 0.2), 40ms, 200ms);
    stage.heading("the computer is held up");
    stage.clock.stall(300ms);
    keepDriving(stage, stream, 60ms, 500ms);
    drive(stage, device, wish(Mode::Duty, 0.2), 40ms, 200ms);
    stage.heading("the cable comes out");
    stage.pullHost();
    keepDriving(stage, stream, 60ms, 1s);
    stage.answer("open again", stage.host().open());
    stage.wait(3s);
    (void)stage.perform("refresh", device.refresh());
    stage.heading("a stop with a motion that waits");
    drive(stage, device, wish(Mode::Duty, 0.2), 0ms, 0ms);
    stage.heading("at once");
    device.stop();
    stage.advance(60ms);
    device.stop();
    device.repeatStop();
    stage.advance(60ms);
    stage.tellTelemetry();
    told.expectAsStored("dmc60c-ends");
}

TEST(Dmc60cConversations, TelemetryAtItsRates)
{
    Conversation told;
    TwoDmc60c bench(told);
    StoryStage &stage = bench.stage;
    Device &device = *bench.device;
    for (const char *key : {"position", "current", "duty", "bus_voltage", "analog1", "setpoint"}) {
        for (const double hertz : {1000.0, 200.0, 37.0, 1.0, 0.0, -1.0}) {
            (void)stage.perform(
                std::string(key) + " at " + numberOf(hertz), device.setRate(*device.telemetry()->find(key), hertz));
            stage.wait(600ms);
        }
    }
    stage.tellTelemetry();
    (void)stage.perform("fast", device.setRate(*device.telemetry()->find("position"), 500.0));
    stage.advance(20ms);
    stage.heading("a tenth is lost");
    stage.setLoss(0.1);
    stage.wait(2s);
    stage.setLoss(0.0);
    stage.wait(1s);
    stage.tellTelemetry();
    stage.heading("somebody else changes a period");
    auto &other = static_cast<CanLink &>(stage.other());
    bench.send(other, "02061885#3412320A000000");
    stage.wait(1s);
    bench.send(other, "02061885#34123364000000");
    stage.wait(3s);
    stage.tellTelemetry();
    told.expectAsStored("dmc60c-telemetry");
}

TEST(Dmc60cConversations, FaultsThatComeAndGo)
{
    Conversation told;
    TwoDmc60c bench(told);
    StoryStage &stage = bench.stage;
    Device &device = *bench.device;
    const auto both = [&](const std::string &when) {
        (void)stage.perform("faults " + when, device.readFaults());
        (void)stage.perform("clear " + when, device.clearFaults());
        (void)stage.perform("faults after", device.readFaults());
    };
    both("at first");
    for (const auto &[what, value, back] :
        {std::tuple{"bus-voltage", 5.0, 12.0}, {"temperature", 130.0, 25.0}, {"gate-fault", 1.0, 0.0},
            {"forward-limit", 1.0, 0.0}, {"reverse-limit", 1.0, 0.0}, {"analog-input", 2.5, 0.0}}) {
        stage.heading(std::string(what) + ' ' + numberOf(value));
        bench.unit.disturb(what, value);
        stage.advance(60ms);
        stage.wait(1500ms);
        drive(stage, device, wish(Mode::Duty, 0.3), 30ms, 300ms);
        halt(stage, device, 0ms, 500ms);
        bench.unit.disturb(what, back);
        stage.wait(1500ms);
        both("after " + std::string(what));
    }
    stage.heading("stall");
    bench.unit.disturb("stall", 1.0);
    drive(stage, device, wish(Mode::Duty, 1.0), 30ms, 3s);
    halt(stage, device, 30ms, 1s);
    bench.unit.disturb("stall", 0.0);
    both("after the stall");
    stage.tellTelemetry();
    told.expectAsStored("dmc60c-faults");
}

/// Everything that a device is asked for, on a bus that loses or delays.
std::string askOfDmc60c(Conversation &told, const std::string &options, double loss, std::uint64_t seed)
{
    TwoDmc60c bench(told, options.starts_with(',') ? options : "", seed);
    StoryStage &stage = bench.stage;
    if (!bench.device)
        return stage.outcomes();
    Device &device = *bench.device;
    stage.setLoss(loss);
    stage.tear(holeOf(options, 140us, 60ms));
    (void)stage.perform("refresh", device.refresh());
    (void)stage.perform("read", device.read(indexOf(device, "slot0.p")));
    (void)bench.write("slot0.p", 1.5);
    (void)stage.perform("clear", device.clearFaults());
    (void)stage.perform("rate", device.setRate(*device.telemetry()->find("position"), 200.0));
    (void)stage.perform("rename", device.rename("worn"));
    (void)stage.perform("renumber", device.renumber(11));
    (void)stage.perform("identify", device.identify());
    drive(stage, device, wish(Mode::Duty, 0.2), 300ms, 0ms);
    halt(stage, device, 300ms, 0ms);
    (void)stage.perform("store", device.store(stage.progress()));
    (void)stage.perform("restart", device.restart());
    stage.tellTelemetry();
    return stage.outcomes();
}

TEST(Dmc60cConversations, LostAndLateAnswers)
{
    Conversation told;
    std::vector<std::string> losses;
    for (int seed = 1; seed <= 12; ++seed)
        losses.push_back(std::to_string(seed));
    tellVariants(told, losses, [](Conversation &one, const std::string &seed) {
        return askOfDmc60c(one, {}, 0.25, static_cast<std::uint64_t>(std::stoi(seed)));
    });
    std::vector<std::string> faults{",fault=duplicate", ",fault=reset@0.9", ",fault=reset@1.2", ",fault=reset@1.5",
        ",fault=busoff@0.9", ",fault=busoff@1.2", ",fault=brownout@1", ",fault=silent@60", ",fault=power@66"};
    addHoles(faults, 1, 34);
    tellVariants(
        told, faults, [](Conversation &one, const std::string &fault) { return askOfDmc60c(one, fault, 0.0, 1); });
    told.expectAsStored("dmc60c-losses");
}

FirmwareImage storyImage(std::uint16_t version = 0x0118)
{
    HexText hex = smallApplication(version);
    hex.add(0x1000, {1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 0});
    return *FirmwareImage::fromIntelHex(hex.text());
}

std::string updateDmc60c(Conversation &told, const std::string &options, double loss, std::uint64_t seed,
    const UpdateOptions &wanted = {}, std::uint16_t version = 0x0118)
{
    TwoDmc60c bench(told, options.starts_with(',') ? options : "", seed);
    StoryStage &stage = bench.stage;
    if (!bench.device)
        return stage.outcomes();
    stage.setLoss(loss);
    stage.tear(holeOf(options, 140us, 60ms));
    const FirmwareImage image = storyImage(version);
    stage.sum([&] {
        const auto report = stage.perform(
            "update", bench.device->family().update(*bench.device, image, wanted, stage.progress()), 10min);
        stage.advance(2s);
        if (!report || report->outcome != UpdateOutcome::Done)
            (void)stage.perform(
                "once more", bench.device->family().update(*bench.device, image, wanted, stage.progress()), 10min);
    });
    return stage.outcomes();
}

TEST(Dmc60cConversations, UpdatesGoodAndBad)
{
    Conversation told;
    (void)updateDmc60c(told, {}, 0.0, 1);
    UpdateOptions force;
    force.force = true;
    UpdateOptions dry;
    dry.dryRun = true;
    (void)updateDmc60c(told, {}, 0.0, 1, {}, 0x0117);
    (void)updateDmc60c(told, {}, 0.0, 1, force, 0x0117);
    (void)updateDmc60c(told, {}, 0.0, 1, dry);
    (void)updateDmc60c(told, ",crc=B", 0.0, 1);
    (void)updateDmc60c(told, ",crc=C", 0.0, 1);
    (void)updateDmc60c(told, ",state=bootloader", 0.0, 1);
    tellVariants(told, {"1", "2", "3", "4", "5", "6"}, [](Conversation &one, const std::string &seed) {
        return updateDmc60c(one, {}, 0.005, static_cast<std::uint64_t>(std::stoi(seed)));
    });
    std::vector<std::string> faults;
    for (const char *fault : {"power-page@0", "power-page@4", "power-page@30", "reset@0.8", "reset@0.95", "reset@1.1",
             "reset@1.3", "busoff@0.8", "busoff@1.1", "brownout@0.7", "duplicate"})
        faults.push_back(std::string(",fault=") + fault);
    addHoles(faults, 1, 12);
    for (const int page : {1, 2, 3}) // around the last frames of each
        addHoles(faults, page * 514 + 6, page * 514 + 9);
    tellVariants(
        told, faults, [](Conversation &one, const std::string &fault) { return updateDmc60c(one, fault, 0.0, 1); });
    told.expectAsStored("dmc60c-updates");
}

} // namespace
} // namespace mb
