// SPDX-License-Identifier: GPL-3.0-or-later
// Whole stories of a QuadQuad2Drv, compared with stored texts (docs/testing.md#golden-conversations).
#include "families/quadquad2drvupdatebench.h"
#include "families/storysteps.h"
#include "traffic/trafficline.h"

#include <gtest/gtest.h>

namespace mb {
namespace {

using namespace std::chrono_literals;
using namespace test;

struct OneBoard {
    explicit OneBoard(
        Conversation &told, const std::string &options = {}, std::string_view link = "sim:spi", std::uint64_t seed = 1)
        : stage(told, link, seed)
        , unit(stage.unit("quadquad2drv:0" + options))
    {
        stage.sum([this] {
            const auto rows = stage.scan();
            device = rows.empty() ? nullptr : &stage.open(rows.front());
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

    StoryStage stage;
    Simulator &unit;
    Device *device = nullptr;
};

TEST(QuadQuad2DrvConversations, LooksForABoard)
{
    Conversation told;
    for (const char *options : {"", ",firmware=2.7", ",fault=silent@1", ",fault=drop@1", ",fault=corrupt@1"}) {
        StoryStage stage(told, "sim:spi");
        stage.unit("quadquad2drv:0" + std::string(options));
        const auto rows = stage.scan();
        for (const Identity &row : rows) {
            Device &device = stage.open(row);
            stage.advance(50ms);
            (void)stage.perform("refresh", device.refresh());
            stage.scan();
            stage.tellStopScript(device);
        }
    }
    {
        StoryStage stage(told, "sim:spi");
        stage.heading("nobody is there");
        stage.scan();
    }
    told.expectAsStored("quadquad2drv-scan");
}

TEST(QuadQuad2DrvConversations, EveryParameterAtItsEnds)
{
    for (const char *options : {",inputs=library", ",inputs=datasheet"}) {
        Conversation told;
        OneBoard bench(told, options);
        if (std::string_view(options) == ",inputs=datasheet")
            bench.stage.answer("reading", bench.device->knowledge().calibrate("input_reading", 1.0));
        tellParameters(bench.stage, *bench.device, true);
        (void)bench.stage.perform("store", bench.device->store(bench.stage.progress()));
        bench.stage.heading("it is reset");
        bench.unit.disturb("reset", 1.0);
        bench.stage.wait(1s);
        (void)bench.stage.perform("write again", rewriteSettings(*bench.device, bench.stage.progress()));
        (void)bench.stage.perform("write again", rewriteSettings(*bench.device, bench.stage.progress()));
        (void)bench.stage.perform("restart", bench.device->restart());
        (void)bench.stage.perform("faults", bench.device->readFaults());
        (void)bench.stage.perform("clear", bench.device->clearFaults());
        (void)bench.stage.perform("identify", bench.device->identify());
        (void)bench.stage.perform("rename", bench.device->rename("x"));
        (void)bench.stage.perform("renumber", bench.device->renumber(2));
        (void)bench.stage.perform("zero", bench.device->zeroPosition());
        told.expectAsStored("quadquad2drv-parameters-" + std::string(options + 8));
    }
}

TEST(QuadQuad2DrvConversations, EveryModeAndItsStop)
{
    Conversation told;
    OneBoard bench(told);
    StoryStage &stage = bench.stage;
    Device &device = *bench.device;
    drive(stage, device, wish(Mode::Duty, 0.4), 120ms, 500ms);
    drive(stage, device, wish(Mode::Duty, -0.4), 60ms, 500ms, Glide{2.0, {}});
    halt(stage, device, 40ms, 600ms);
    halt(stage, device, 40ms, 100ms);
    drive(stage, device, wish(Mode::Velocity, 800.0), 120ms, 600ms);
    drive(stage, device, wish(Mode::Velocity, -800.0, 2), 60ms, 600ms);
    drive(stage, device, wish(Mode::Position, 500.0, 3), 60ms, 600ms);
    SetPoint ramp = wish(Mode::RampPosition, 900.0, 4);
    ramp.velocity = 600.0;
    ramp.acceleration = 2000.0;
    drive(stage, device, ramp, 60ms, 900ms);
    drive(stage, device, wish(Mode::Off, 0.0, 2), 60ms, 400ms);
    ramp.target = -300.0;
    drive(stage, device, ramp, 60ms, 900ms);
    SetPoint rising = wish(Mode::RampVelocity, 700.0, 1);
    rising.velocity = 700.0;
    rising.acceleration = 1000.0;
    drive(stage, device, rising, 60ms, 900ms);
    halt(stage, device, 40ms, 1s);
    stage.heading("stopped with orders that wait");
    drive(stage, device, wish(Mode::Velocity, 400.0, 1), 0ms, 0ms);
    drive(stage, device, wish(Mode::Position, 400.0, 2), 0ms, 0ms);
    drive(stage, device, wish(Mode::Duty, 0.2, 3), 3ms, 0ms);
    device.stop();
    stage.advance(40ms);
    device.stop();
    stage.wait(600ms);
    stage.answer("shift", device.knowledge().calibrate("velocity_target_shift", 12.0));
    drive(stage, device, wish(Mode::Velocity, 0.5), 120ms, 300ms);
    halt(stage, device, 40ms, 600ms);
    for (const SetPoint &bad : {wish(Mode::Duty, 1.1), wish(Mode::Duty, -1.1), wish(Mode::Velocity, 1e9),
             wish(Mode::Position, 3e9), wish(Mode::RampPosition, 3e9), wish(Mode::RampVelocity, 1e9),
             wish(Mode::Current, 1.0), wish(Mode::Duty, 0.1, 0), wish(Mode::Duty, 0.1, 5)})
        stage.answer("check " + textOf(bad), device.check(bad));
    stage.tellTelemetry();
    told.expectAsStored("quadquad2drv-motion");
}

TEST(QuadQuad2DrvConversations, WhateverEndsAMotionEndsInAStop)
{
    Conversation told;
    OneBoard bench(told);
    StoryStage &stage = bench.stage;
    Device &device = *bench.device;
    SetPointStream &stream = stage.stream(device);
    const SetPoint turning = wish(Mode::Duty, 0.4);
    drive(stage, device, turning, 60ms, 0ms);
    stage.heading("nobody renews");
    stage.wait(420ms);
    stage.advance(100ms);
    stage.wait(600ms);
    drive(stage, device, turning, 60ms, 300ms);
    stage.heading("it is reset");
    bench.unit.disturb("reset", 1.0);
    keepDriving(stage, stream, 200ms, 1s);
    (void)stage.perform("refresh", device.refresh());
    drive(stage, device, turning, 60ms, 300ms);
    stage.heading("it goes away");
    bench.unit.setPowered(false);
    keepDriving(stage, stream, 200ms, 2s);
    stage.wait(3s);
    bench.unit.setPowered(true);
    stage.wait(2s);
    (void)stage.perform("refresh", device.refresh());
    drive(stage, device, turning, 60ms, 300ms);
    stage.heading("the computer is held up");
    stage.clock.stall(300ms);
    keepDriving(stage, stream, 60ms, 600ms);
    drive(stage, device, turning, 60ms, 300ms);
    stage.heading("it is dead when it is stopped");
    bench.unit.setPowered(false);
    device.stop();
    stage.advance(60ms);
    stage.wait(3s);
    bench.unit.setPowered(true);
    stage.wait(2s);
    (void)stage.perform("refresh", device.refresh());
    drive(stage, device, turning, 60ms, 300ms);
    stage.heading("the cable comes out");
    stage.pullHost();
    keepDriving(stage, stream, 60ms, 1s);
    stage.answer("open again", stage.host().open());
    stage.wait(2s);
    (void)stage.perform("refresh", device.refresh());
    for (const auto &[what, value, back] : {std::tuple{"stall", 1.0, 0.0}, {"input1", 0.0, 1.0}, {"input3", 0.0, 1.0},
             {"load-torque", 0.3, 0.0}, {"bus-voltage", 6.0, 12.0}}) {
        stage.heading(what);
        bench.unit.disturb(what, value);
        drive(stage, device, turning, 60ms, 800ms);
        bench.unit.disturb(what, back);
        halt(stage, device, 40ms, 600ms);
        (void)stage.perform("faults", device.readFaults());
        (void)stage.perform("clear", device.clearFaults());
    }
    stage.tellTelemetry();
    told.expectAsStored("quadquad2drv-ends");
}

TEST(QuadQuad2DrvConversations, TelemetryAtItsRates)
{
    Conversation told;
    for (const std::string_view link : {"sim:spi", "sim:spi?bitrate=50000"}) {
        OneBoard bench(told, {}, link);
        StoryStage &stage = bench.stage;
        Device &device = *bench.device;
        for (const char *key : {"ch1.position", "ch2.velocity", "ch3.status", "ch4.setpoint"}) {
            for (const double hertz : {1000.0, 500.0, 99.0, 10.0, 0.0, -1.0}) {
                (void)stage.perform(
                    std::string(key) + " at " + numberOf(hertz), device.setRate(*device.telemetry()->find(key), hertz));
                stage.wait(500ms);
            }
        }
        (void)stage.perform("fast", device.setRate(*device.telemetry()->find("ch1.position"), 250.0));
        drive(stage, device, wish(Mode::Duty, 0.4), 60ms, 500ms);
        (void)stage.perform("read", device.read(indexOf(device, "ch1.counter")));
        stage.heading("it is reset beside a stream");
        bench.unit.disturb("reset", 1.0);
        stage.advance(60ms);
        stage.wait(2s);
        halt(stage, device, 40ms, 600ms);
        stage.tellTelemetry();
    }
    told.expectAsStored("quadquad2drv-telemetry");
}

TEST(QuadQuad2DrvConversations, Experiments)
{
    Conversation told;
    for (const char *options : {"", ",inputs=datasheet", ",motor=n20,scale=3", ",fault=stall@4", ",fault=reset@6",
             ",fault=encoder-dead@5", ",fault=encoder-reversed"}) {
        OneBoard bench(told, options);
        StoryStage &stage = bench.stage;
        Device &device = *bench.device;
        Timer renewal(stage.clock);
        std::function<void()> renew = [&] {
            stage.stream(device).renew();
            renewal.startIn(100ms, renew);
        };
        renew();
        for (const Experiment &experiment : device.family().experiments) {
            ExperimentOptions wanted;
            wanted.power = 0.3;
            stage.sum([&] {
                (void)stage.perform(std::string(experiment.key) + options,
                    experiment.run(device, stage.stream(device), wanted, stage.progress()), 20min);
                stage.advance(500ms);
            });
        }
        stage.tellTelemetry();
    }
    told.expectAsStored("quadquad2drv-experiments");
}

TEST(QuadQuad2DrvConversations, LostAndGarbledPackets)
{
    Conversation told;
    std::vector<std::string> variants;
    for (int seed = 1; seed <= 10; ++seed)
        variants.push_back('#' + std::to_string(seed));
    for (const char *fault : {"reset@1", "reset@2", "stall@2", "encoder-dead@2", "encoder-reversed", "power@20",
             "power@60", "power@75", "silent@20", "silent@60", "corrupt@40", "corrupt@50", "corrupt@62", "drop@41",
             "drop@52", "drop@63", "drop@70"})
        variants.push_back(std::string(",fault=") + fault);
    for (int piece = 1; piece <= 40; ++piece)
        variants.push_back("request " + std::to_string(piece));
    tellVariants(told, variants, [](Conversation &one, const std::string &variant) {
        const auto hash = variant.find('#');
        const std::uint64_t seed = hash == std::string::npos ? 1 : std::stoull(variant.substr(hash + 1));
        OneBoard bench(one, variant.starts_with(',') ? variant.substr(0, hash) : "", "sim:spi", seed);
        StoryStage &stage = bench.stage;
        if (!bench.device)
            return stage.outcomes();
        Device &device = *bench.device;
        if (hash != std::string::npos)
            stage.setLoss(0.2);
        stage.tear(holeOf(variant, 400us, 2ms));
        (void)stage.perform("refresh", device.refresh());
        (void)bench.write("ch1.velocity.p", 120.0);
        (void)bench.write("ch2.limit.power", 0.5);
        (void)stage.perform("read", device.read(indexOf(device, "ch1.counter")));
        (void)stage.perform("rate", device.setRate(*device.telemetry()->find("ch1.position"), 200.0));
        drive(stage, device, wish(Mode::Duty, 0.3), 500ms, 0ms);
        drive(stage, device, wish(Mode::Velocity, 500.0, 2), 500ms, 0ms);
        halt(stage, device, 600ms, 0ms);
        (void)stage.perform("write again", rewriteSettings(device, stage.progress()));
        stage.tellTelemetry();
        return stage.outcomes();
    });
    told.expectAsStored("quadquad2drv-losses");
}

/// What passes the bootloader's line, and what the update says.
struct ToldUpdate {
    explicit ToldUpdate(Conversation &told, const std::string &options)
        : bench(options)
        , tap(bench.hostEnd.traffic().add([this, &told](const Traffic &traffic) {
            told.event("boot",
                secondsOf(bench.clock.now().time_since_epoch()) + (traffic.direction == Direction::Sent ? " > " : " < ")
                    + hexText(traffic.bytes));
        }))
        , spiTap(bench.spi.traffic().add([this, &told](const Traffic &traffic) {
            told.event("spi",
                secondsOf(bench.clock.now().time_since_epoch()) + (traffic.direction == Direction::Sent ? " > " : " < ")
                    + hexText(traffic.bytes));
        }))
    {
    }
    quadquad2drv::QuadQuad2DrvUpdateBench bench;
    Subscription tap;
    Subscription spiTap;
};

TEST(QuadQuad2DrvConversations, UpdatesGoodAndBad)
{
    Conversation told;
    std::vector<std::string> variants{"", "jumper", "late", "no farewell", "refused", "closed", "silent",
        "other banner", "lf", ",fault=power-page@1", ",fault=power-page@2", ",fault=power-page@3", "loss"};
    for (int after = 0; after <= 3; ++after)
        variants.push_back("lost at line " + std::to_string(after));
    tellVariants(told, variants, [](Conversation &one, const std::string &variant) {
        ToldUpdate update(one, variant.starts_with(',') ? variant : "");
        auto &bench = update.bench;
        quadquad2drv::BootSettings settings;
        if (variant == "no farewell")
            settings.farewell = {};
        if (variant == "refused")
            settings.failures = {"ok"};
        if (variant == "other banner")
            settings.banner = "hello";
        if (variant == "lf")
            settings.ending = "\n";
        if (variant == "loss")
            bench.line.setLoss(0.2);
        bench.boot->setJumper(variant != "late" && variant != "silent");
        bench.hand = [&bench, &variant] {
            const std::string step = bench.operation.status().step.english();
            const bool sending = step.starts_with("sending");
            if (variant == "late" && bench.clock.now().time_since_epoch() > 12s && step.starts_with("close"))
                bench.boot->setJumper(true);
            if (step.starts_with("take the jumper out") && variant != "jumper")
                bench.boot->setJumper(false);
            if (step.starts_with("the jumper is still in") && bench.clock.now().time_since_epoch() > 60s)
                bench.boot->setJumper(false);
            if (sending && variant == "closed")
                bench.hostEnd.close();
            if (sending && variant.starts_with("lost at line ")
                && bench.operation.status().done == std::stoi(variant.substr(13)))
                bench.line.setLoss(1.0);
        };
        const std::string report = valueText(bench.update(settings));
        for (const LogLine &line : bench.operation.status().log)
            one.event("log", secondsOf(line.time.time_since_epoch()) + ' ' + line.text.english());
        for (const auto &[part, state] : bench.operation.status().parts)
            one.event("part", std::to_string(part) + ' ' + std::string(textOf(state)));
        return report + " after " + secondsOf(bench.clock.now().time_since_epoch());
    });
    told.expectAsStored("quadquad2drv-updates");
}

} // namespace
} // namespace mb
