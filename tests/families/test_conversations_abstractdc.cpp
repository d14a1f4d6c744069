// SPDX-License-Identifier: GPL-3.0-or-later
// Whole stories of Abstract DC Drives, compared with stored texts (docs/testing.md#golden-conversations).
#include "families/storysteps.h"
#include "transport/canlink.h"

#include <gtest/gtest.h>

namespace mb {
namespace {

using namespace std::chrono_literals;
using namespace test;

/// One that is asked, and one beside it that must not react.
struct TwoDrives {
    explicit TwoDrives(
        Conversation &told, const std::string &options = {}, std::string_view link = "sim:can", std::uint64_t seed = 1)
        : stage(told, link, seed)
        , unit(stage.unit("abstractdc:3" + options))
        , bystander(stage.unit("abstractdc:4,dialect=F,motor=n20"))
    {
        stage.sum([this] {
            const auto rows = stage.scan();
            const Identity found = rowOf(rows, "abstractdc", 3);
            device = found.family.empty() ? nullptr : &stage.open(found);
            stage.advance(500ms);
        });
        if (device)
            stage.forgetOutcomes();
    }
    Result<std::int64_t> write(std::string_view key, std::int64_t raw)
    {
        return stage.perform(
            "write " + std::string(key) + ' ' + std::to_string(raw), device->write(indexOf(*device, key), raw));
    }
    Result<bool> store() { return stage.perform("store", device->store(stage.progress())); }
    void send(CanLink &link, std::string_view frame) { EXPECT_TRUE(link.send(*canFrameFromText(frame))); }
    /// The gains of the simulated drive, as its user would know them.
    void tellGains()
    {
        stage.sum([this] {
            for (const auto &[key, raw] :
                {std::pair{"velocity.p", 20}, {"velocity.i", 2}, {"velocity.d", 0}, {"velocity.divisor", 100},
                    {"current.p", 20}, {"current.i", 1}, {"current.d", 0}, {"current.divisor", 10}, {"position.p", 50},
                    {"position.i", 0}, {"position.d", 20}, {"position.divisor", 100}})
                (void)write(key, raw);
        });
    }

    StoryStage stage;
    Simulator &unit;
    Simulator &bystander;
    Device *device = nullptr;
};

TEST(AbstractDcConversations, AScanOfAMixedBus)
{
    for (const std::string bitrate : {"1000000", "125000", "10000"}) {
        Conversation told;
        StoryStage stage(told, "sim:can?bitrate=" + bitrate);
        stage.unit("abstractdc:3,dialect=F");
        Simulator &leaving = stage.unit("abstractdc:4,dialect=L,motor=n20");
        stage.unit("abstractdc:5,dialect=D,motor=rs775");
        stage.unit("abstractdc:6,dialect=LL");
        stage.unit("abstractdc:27,dialect=F");
        stage.unit("abstractdc:51,dialect=L");
        stage.unit("abstractdc:99,fault=silent@1");
        stage.unit("abstractdc:40,fault=duplicate");
        stage.unit("dmc60c:9,state=bootloader");
        const auto rows = stage.scan();
        for (const Identity &row : rows)
            stage.open(row);
        stage.wait(2s);
        leaving.setPowered(false);
        stage.scan();
        stage.wait(3s);
        leaving.setPowered(true);
        stage.wait(1s);
        stage.scan();
        stage.tellTelemetry();
        told.expectAsStored("abstractdc-scan-" + bitrate);
    }
}

TEST(AbstractDcConversations, EveryParameterAtItsEnds)
{
    Conversation told;
    for (const char *dialect : {"F", "L", "D"}) {
        TwoDrives bench(told, std::string(",dialect=") + dialect);
        tellParameters(bench.stage, *bench.device, false);
        (void)bench.store();
        bench.stage.answer("may move", bench.device->mayMove());
        bench.unit.setPowered(false);
        bench.stage.wait(1s);
        bench.unit.setPowered(true);
        bench.stage.wait(1s);
        (void)bench.stage.perform("refresh", bench.device->refresh());
        bench.stage.answer("may move", bench.device->mayMove());
    }
    told.expectAsStored("abstractdc-parameters");
}

TEST(AbstractDcConversations, SavesAreCountedAndRefusedAfterFifty)
{
    Conversation told;
    TwoDrives bench(told, ",dialect=F");
    bench.stage.sum([&] {
        for (int i = 1; i <= 52; ++i) {
            (void)bench.write("velocity.p", i);
            (void)bench.store();
        }
    });
    (void)bench.stage.perform("refresh", bench.device->refresh());
    (void)bench.write("current.averaging", 100);
    (void)bench.write("current.averaging", 500);
    (void)bench.write("current.averaging", 20);
    bench.stage.answer("may move", bench.device->mayMove());
    bench.unit.setPowered(false);
    bench.stage.wait(2s);
    bench.unit.setPowered(true);
    bench.stage.wait(2s);
    bench.stage.answer("may move", bench.device->mayMove());
    (void)bench.stage.perform("refresh", bench.device->refresh());
    told.expectAsStored("abstractdc-saves");
}

TEST(AbstractDcConversations, EveryModeAndItsStop)
{
    Conversation told;
    for (const char *dialect : {"F", "L", "D"}) {
        TwoDrives bench(told, std::string(",dialect=") + dialect);
        StoryStage &stage = bench.stage;
        Device &device = *bench.device;
        drive(stage, device, wish(Mode::Duty, 0.4), 60ms, 500ms);
        drive(stage, device, wish(Mode::Duty, -0.4), 30ms, 700ms);
        halt(stage, device, 30ms, 800ms);
        halt(stage, device, 30ms, 100ms);
        drive(stage, device, wish(Mode::Velocity, 2000.0), 60ms, 500ms);
        halt(stage, device, 30ms, 800ms);
        bench.tellGains();
        drive(stage, device, wish(Mode::Velocity, 2000.0), 60ms, 700ms);
        drive(stage, device, wish(Mode::Velocity, -2000.0), 60ms, 700ms, Glide{4000.0, {}});
        halt(stage, device, 30ms, 800ms);
        drive(stage, device, wish(Mode::Position, 1500.0), 60ms, 700ms);
        drive(stage, device, wish(Mode::Position, -1500.0), 60ms, 700ms, Glide{3000.0, 0.0});
        halt(stage, device, 30ms, 800ms);
        drive(stage, device, wish(Mode::Current, 20.0), 60ms, 300ms);
        halt(stage, device, 30ms, 800ms);
        SetPoint slow = wish(Mode::Duty, 1.0);
        slow.ramp = 0.5;
        drive(stage, device, slow, 60ms, 900ms);
        halt(stage, device, 30ms, 1s);
        for (const SetPoint &bad : {wish(Mode::Duty, 1.1), wish(Mode::Duty, -1.01), wish(Mode::Velocity, 1e9),
                 wish(Mode::Position, 1e12), wish(Mode::Current, 1e6), wish(Mode::Voltage, 9.0), wish(Mode::Follow, 4),
                 wish(Mode::RampPosition, 10.0), wish(Mode::Duty, 0.1, 2)})
            stage.answer("check " + textOf(bad), device.check(bad));
        stage.tellStopScript(device);
        stage.tellTelemetry();
    }
    told.expectAsStored("abstractdc-motion");
}

TEST(AbstractDcConversations, WhateverEndsAMotionEndsInAStop)
{
    Conversation told;
    TwoDrives bench(told, ",dialect=F");
    StoryStage &stage = bench.stage;
    Device &device = *bench.device;
    bench.tellGains();
    SetPointStream &stream = stage.stream(device);
    drive(stage, device, wish(Mode::Duty, 0.4), 40ms, 0ms);
    stage.heading("nobody renews");
    stage.wait(440ms);
    stage.advance(100ms);
    stage.wait(800ms);
    drive(stage, device, wish(Mode::Duty, 0.4), 40ms, 300ms);
    stage.heading("another master");
    auto &other = static_cast<CanLink &>(stage.other());
    bench.send(other, "067#0400640000");
    keepDriving(stage, stream, 60ms, 300ms);
    stage.wait(3s);
    bench.send(other, "067#0000000000");
    stage.wait(3s);
    stage.heading("somebody else writes a setting and asks");
    bench.send(other, "0CB#0000070000");
    bench.send(other, "387#01");
    bench.send(other, "387#04");
    bench.send(other, "388#04");
    stage.advance(20ms);
    drive(stage, device, wish(Mode::Duty, 0.4), 40ms, 300ms);
    stage.heading("it is reset");
    bench.unit.setPowered(false);
    bench.unit.setPowered(true);
    keepDriving(stage, stream, 100ms, 1s);
    stage.wait(2s);
    drive(stage, device, wish(Mode::Duty, 0.4), 40ms, 300ms);
    stage.heading("it goes away");
    bench.unit.setPowered(false);
    keepDriving(stage, stream, 100ms, 2s);
    bench.unit.setPowered(true);
    stage.wait(3s);
    (void)stage.perform("refresh", device.refresh());
    drive(stage, device, wish(Mode::Duty, 0.4), 40ms, 300ms);
    stage.heading("the computer is held up");
    stage.clock.stall(300ms);
    keepDriving(stage, stream, 60ms, 800ms);
    drive(stage, device, wish(Mode::Duty, 0.4), 40ms, 300ms);
    stage.heading("the cable comes out");
    stage.pullHost();
    keepDriving(stage, stream, 60ms, 1s);
    stage.answer("open again", stage.host().open());
    stage.wait(3s);
    stage.tellTelemetry();
    told.expectAsStored("abstractdc-ends");
}

TEST(AbstractDcConversations, StallsGlitchesAndLoads)
{
    Conversation told;
    TwoDrives bench(told, ",dialect=F");
    StoryStage &stage = bench.stage;
    Device &device = *bench.device;
    SetPointStream &stream = stage.stream(device);
    stage.heading("it is stopped twice");
    device.stop();
    stage.advance(40ms);
    device.repeatStop();
    stage.wait(3s);
    stage.heading("a motor that cannot turn, a glitch, a load");
    bench.unit.disturb("stall", 1.0);
    drive(stage, device, wish(Mode::Duty, 1.0), 30ms, 1s);
    bench.unit.disturb("stall", 0.0);
    bench.unit.disturb("glitch", 1.0);
    keepDriving(stage, stream, 30ms, 1s);
    bench.unit.disturb("load-torque", 0.5);
    keepDriving(stage, stream, 30ms, 1s);
    halt(stage, device, 30ms, 1s);
    (void)stage.perform("faults", device.readFaults());
    (void)stage.perform("clear", device.clearFaults());
    stage.tellTelemetry();
    told.expectAsStored("abstractdc-stalls");
}

TEST(AbstractDcConversations, TelemetryAtItsRates)
{
    Conversation told;
    for (const std::string bitrate : {"1000000", "20000", "1250"}) {
        TwoDrives bench(told, ",dialect=F,glitches=50", "sim:can?bitrate=" + bitrate);
        StoryStage &stage = bench.stage;
        if (!bench.device)
            continue;
        Device &device = *bench.device;
        for (const char *key : {"position", "velocity", "current", "duty", "temperature", "setpoint"}) {
            for (const double hertz : {1000.0, 50.0, 1.0, 0.0, -1.0}) {
                (void)stage.perform(bitrate + ": " + key + " at " + numberOf(hertz),
                    device.setRate(*device.telemetry()->find(key), hertz));
                stage.wait(700ms);
            }
        }
        stage.answer("amperes", device.knowledge().calibrate("amperes_per_count", 0.05));
        stage.answer("degrees", device.knowledge().calibrate("degrees_per_count", 0.1));
        (void)stage.perform("fast", device.setRate(*device.telemetry()->find("position"), 200.0));
        drive(stage, device, wish(Mode::Duty, 0.5), 30ms, 2s);
        stage.heading("a tenth is lost");
        stage.setLoss(0.1);
        keepDriving(stage, stage.stream(device), 0ms, 3s);
        stage.setLoss(0.0);
        halt(stage, device, 30ms, 1s);
        (void)stage.perform("refresh", device.refresh());
        stage.tellTelemetry();
    }
    told.expectAsStored("abstractdc-telemetry");
}

TEST(AbstractDcConversations, LostAndLateAnswers)
{
    Conversation told;
    std::vector<std::string> variants;
    for (const char *dialect : {"F", "L", "LL", "D"}) {
        for (int seed = 1; seed <= 5; ++seed)
            variants.push_back(",dialect=" + std::string(dialect) + '#' + std::to_string(seed));
        for (const char *fault : {"reset@2", "busoff@2", "brownout@2", "stall@2", "encoder-dead@2", "encoder-reversed",
                 "duplicate", "power@9", "power@30", "silent@2", "silent@9", "delay@4:80", "corrupt@3", "corrupt@6"})
            variants.push_back(",dialect=" + std::string(dialect) + ",fault=" + fault);
    }
    addHoles(variants, 1, 12);
    tellVariants(told, variants, [](Conversation &one, const std::string &variant) {
        const auto hash = variant.find('#');
        const std::uint64_t seed = hash == std::string::npos ? 1 : std::stoull(variant.substr(hash + 1));
        TwoDrives bench(one, variant.starts_with(',') ? variant.substr(0, hash) : "", "sim:can", seed);
        StoryStage &stage = bench.stage;
        if (!bench.device)
            return stage.outcomes();
        Device &device = *bench.device;
        if (hash != std::string::npos)
            stage.setLoss(0.25);
        stage.tear(holeOf(variant, 120us, 20ms));
        (void)stage.perform("refresh", device.refresh());
        (void)bench.write("velocity.p", 7);
        (void)bench.write("velocity.divisor", 100);
        (void)bench.store();
        drive(stage, device, wish(Mode::Duty, 0.3), 500ms, 0ms);
        drive(stage, device, wish(Mode::Velocity, 500.0), 500ms, 0ms);
        halt(stage, device, 800ms, 0ms);
        stage.scan();
        stage.tellTelemetry();
        return stage.outcomes();
    });
    told.expectAsStored("abstractdc-losses");
}

TEST(AbstractDcConversations, ScansThatLoseAnswers)
{
    Conversation told;
    std::vector<std::string> variants;
    for (int seed = 1; seed <= 24; ++seed)
        variants.push_back(std::to_string(seed));
    addHoles(variants, 1, 20);
    tellVariants(told, variants, [](Conversation &one, const std::string &variant) {
        const bool lossy = variant.find(' ') == std::string::npos;
        StoryStage stage(one, "sim:can", lossy ? std::stoull(variant) : 1);
        stage.unit("abstractdc:3,dialect=F");
        stage.unit("abstractdc:4,dialect=L");
        stage.unit("abstractdc:5,dialect=D");
        stage.unit("abstractdc:6,dialect=LL");
        stage.unit("abstractdc:51,dialect=L");
        stage.unit("dmc60c:5,session=0x1234");
        stage.unit("dmc60c:20,fault=duplicate");
        stage.host();
        stage.setLoss(lossy ? 0.2 : 0.0);
        stage.tear(holeOf(variant, 120us, 20ms));
        for (const Identity &row : stage.scan())
            stage.open(row);
        stage.scan();
        return stage.outcomes();
    });
    told.expectAsStored("abstractdc-scan-losses");
}

} // namespace
} // namespace mb
