// SPDX-License-Identifier: GPL-3.0-or-later
// Whole stories of Supermodifieds, compared with stored texts (docs/testing.md#golden-conversations).
#include "families/storysteps.h"
#include "transport/seriallink.h"
#include "wire/bytes.h"

#include <gtest/gtest.h>

namespace mb {
namespace {

using namespace std::chrono_literals;
using namespace test;

constexpr std::string_view usualLine = "sim:serial?bitrate=57600";

/// One that is asked, and one beside it that must not react.
struct TwoNodes {
    explicit TwoNodes(
        Conversation &told, const std::string &options = {}, std::string_view link = usualLine, std::uint64_t seed = 1)
        : stage(told, link, seed)
        , unit(stage.unit("supermodified:4" + options))
        , bystander(stage.unit("supermodified:5,dialect=D2"))
    {
        stage.sum([this] {
            const auto rows = stage.probe("supermodified", 4);
            device = rows.empty() ? nullptr : &stage.open(rows.back());
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
    Simulator &bystander;
    Device *device = nullptr;
};

constexpr std::array<std::string_view, 3> dialects{",dialect=D1", ",dialect=D2", ",dialect=D3"};

TEST(SupermodifiedConversations, ScansOfAMixedLine)
{
    Conversation told;
    {
        StoryStage stage(told, "sim:serial");
        stage.unit("supermodified:4,dialect=D1,baud=57600");
        stage.unit("supermodified:5,dialect=D3,baud=57600");
        Simulator &leaving = stage.unit("supermodified:6,dialect=D2,baud=57600,mask=254");
        stage.unit("supermodified:7,level=1,baud=57600");
        stage.unit("supermodified:8,baud=115200");
        stage.unit("supermodified:9,baud=57600,fault=silent@1");
        stage.unit("supermodified:10,baud=57600,halfpacket=1,fault=delay@2:60");
        stage.unit("supermodified:77,dialect=D3,baud=19200");
        auto rows = stage.scan();
        stage.scan(ScanExtent::Quick, rows);
        leaving.setPowered(false);
        stage.scan(ScanExtent::Usual, rows);
        for (const Identity &row : rows)
            stage.open(row);
        stage.wait(1s);
        stage.scan(ScanExtent::Everything, rows);
        leaving.setPowered(true);
        for (const int node : {4, 6, 8, 9, 77, 100})
            stage.probe("supermodified", node);
    }
    for (const std::string_view link : {"sim:serial?bitrate=115200", "sim:serial?bitrate=9600"}) {
        StoryStage stage(told, link);
        stage.unit("supermodified:4");
        stage.unit("supermodified:119,dialect=D2");
        stage.unit("supermodified:15,dialect=D3,fault=duplicate");
        stage.scan();
        stage.scan(ScanExtent::Everything);
    }
    told.expectAsStored("supermodified-scan");
}

TEST(SupermodifiedConversations, EveryParameterAtItsEnds)
{
    for (const std::string_view dialect : dialects) {
        Conversation told;
        TwoNodes bench(told, std::string(dialect));
        StoryStage &stage = bench.stage;
        (void)stage.perform("refresh", bench.device->refresh());
        tellParameters(stage, *bench.device, true);
        (void)stage.perform("store", bench.device->store(stage.progress()));
        (void)stage.perform("faults", bench.device->readFaults());
        (void)stage.perform("clear", bench.device->clearFaults());
        bench.unit.setPowered(false);
        stage.wait(2s);
        bench.unit.setPowered(true);
        stage.wait(3s);
        (void)stage.perform("refresh", bench.device->refresh());
        (void)stage.perform("read all", readParameters(*bench.device, readable(*bench.device), stage.progress()));
        told.expectAsStored("supermodified-parameters-" + std::string(dialect.substr(9)));
    }
}

TEST(SupermodifiedConversations, EveryModeAndItsStop)
{
    for (const std::string_view dialect : dialects) {
        Conversation told;
        TwoNodes bench(told, std::string(dialect));
        StoryStage &stage = bench.stage;
        Device &device = *bench.device;
        const double scale = dialect.ends_with("D3") ? 8.0 : 1.0;
        drive(stage, device, wish(Mode::Velocity, 1500.0 * scale), 60ms, 500ms);
        drive(stage, device, wish(Mode::Velocity, -1000.0 * scale), 40ms, 500ms, Glide{8000.0, {}});
        halt(stage, device, 40ms, 400ms);
        halt(stage, device, 40ms, 100ms);
        drive(stage, device, wish(Mode::Position, 700.0 * scale), 60ms, 700ms);
        SetPoint step = wish(Mode::Position, 300.0 * scale);
        step.relative = true;
        for (step.order = 1; step.order <= 2; ++step.order)
            drive(stage, device, step, 60ms, 600ms);
        step.target = 0.0;
        drive(stage, device, step, 40ms, 300ms);
        SetPoint ramp = wish(Mode::RampPosition, -1000.0 * scale);
        drive(stage, device, ramp, 60ms, 3s);
        ramp.target = 400.0 * scale;
        ramp.relative = true;
        ramp.order = 7;
        drive(stage, device, ramp, 60ms, 2s);
        ramp.target = 900.0 * scale;
        ramp.order = 8;
        drive(stage, device, ramp, 100ms, 0ms);
        halt(stage, device, 40ms, 600ms);
        drive(stage, device, wish(Mode::RampVelocity, 1200.0 * scale), 60ms, 2s);
        halt(stage, device, 40ms, 800ms);
        SetPoint kept = wish(Mode::RampPosition, 800.0 * scale);
        kept.buffered = true;
        drive(stage, device, kept, 60ms, 300ms);
        stage.answer("release", device.releaseMoves());
        keepDriving(stage, stage.stream(device), 60ms, 1500ms);
        stage.heading("released, and stopped at once");
        kept.order = 2;
        kept.target = 0.0;
        drive(stage, device, kept, 30ms, 0ms);
        (void)device.releaseMoves();
        device.stop();
        stage.advance(60ms);
        stage.wait(500ms);
        (void)stage.perform("zero", device.zeroPosition());
        stage.wait(500ms);
        for (const SetPoint &bad : {wish(Mode::Velocity, 1e9), wish(Mode::Position, 3e9), wish(Mode::Position, 1e6),
                 wish(Mode::RampPosition, 5e9), wish(Mode::RampVelocity, 1e9), wish(Mode::Duty, 0.1),
                 wish(Mode::Current, 1.0), wish(Mode::Velocity, 1.0, 2)})
            stage.answer("check " + textOf(bad), device.check(bad));
        stage.tellStopScript(device);
        stage.tellTelemetry();
        told.expectAsStored("supermodified-motion-" + std::string(dialect.substr(9)));
    }
}

TEST(SupermodifiedConversations, WhateverEndsAMotionEndsInAStop)
{
    Conversation told;
    TwoNodes bench(told);
    StoryStage &stage = bench.stage;
    Device &device = *bench.device;
    SetPointStream &stream = stage.stream(device);
    const SetPoint turning = wish(Mode::Velocity, 1500.0);
    drive(stage, device, turning, 40ms, 0ms);
    stage.heading("nobody renews");
    stage.wait(440ms);
    stage.advance(100ms);
    stage.wait(500ms);
    for (const double code : {0x43, 0x44, 0x51, 0x63}) {
        drive(stage, device, turning, 40ms, 200ms);
        stage.heading("it reports " + numberOf(code));
        bench.unit.disturb("error", code);
        keepDriving(stage, stream, 60ms, 300ms);
        bench.unit.disturb("error", code);
        halt(stage, device, 60ms, 400ms);
        (void)stage.perform("faults", device.readFaults());
        (void)stage.perform("clear", device.clearFaults());
    }
    drive(stage, device, turning, 40ms, 200ms);
    stage.heading("it is reset");
    bench.unit.setPowered(false);
    bench.unit.setPowered(true);
    keepDriving(stage, stream, 100ms, 1s);
    stage.wait(1s);
    (void)stage.perform("refresh", device.refresh());
    drive(stage, device, turning, 40ms, 200ms);
    stage.heading("it goes away");
    bench.unit.setPowered(false);
    keepDriving(stage, stream, 100ms, 2s);
    bench.unit.setPowered(true);
    stage.wait(3s);
    (void)stage.perform("refresh", device.refresh());
    drive(stage, device, turning, 40ms, 200ms);
    stage.heading("the computer is held up");
    stage.clock.stall(300ms);
    keepDriving(stage, stream, 60ms, 500ms);
    told.expectAsStored("supermodified-ends");
}

TEST(SupermodifiedConversations, StopsThatAreNotHeardAndOtherMasters)
{
    Conversation told;
    TwoNodes bench(told);
    StoryStage &stage = bench.stage;
    Device &device = *bench.device;
    SetPointStream &stream = stage.stream(device);
    const SetPoint turning = wish(Mode::Velocity, 1500.0);
    drive(stage, device, turning, 40ms, 200ms);
    stage.heading("nothing is heard while it is stopped");
    stage.setLoss(1.0);
    device.stop();
    stage.advance(100ms);
    stage.wait(3s);
    stage.setLoss(0.0);
    stage.wait(1s);
    drive(stage, device, turning, 40ms, 200ms);
    stage.heading("the cable comes out");
    stage.pullHost();
    keepDriving(stage, stream, 60ms, 1s);
    device.stop();
    stage.wait(500ms);
    stage.answer("open again", stage.host().open());
    stage.advance(100ms);
    stage.wait(2s);
    (void)stage.perform("refresh", device.refresh());
    stage.heading("somebody else starts it");
    auto &other = static_cast<SerialLink &>(stage.other());
    const std::vector<std::uint8_t> start{0x55, 0xAA, 0x04, 0x70, 0x00, 0x00, 0x74};
    EXPECT_TRUE(other.send(start));
    stage.advance(60ms);
    stage.wait(1s);
    halt(stage, device, 60ms, 500ms);
    stage.heading("a motor that cannot turn");
    bench.unit.disturb("stall", 1.0);
    drive(stage, device, turning, 60ms, 2s);
    bench.unit.disturb("stall", 0.0);
    halt(stage, device, 60ms, 500ms);
    (void)stage.perform("faults", device.readFaults());
    drive(stage, device, turning, 60ms, 200ms);
    stage.heading("it is closed while it runs");
    stage.close(device);
    stage.advance(50ms);
    told.expectAsStored("supermodified-stops");
}

TEST(SupermodifiedConversations, TelemetryAtItsRates)
{
    Conversation told;
    for (const std::string_view line : {"sim:serial?bitrate=57600", "sim:serial?bitrate=9600"}) {
        for (const std::string_view dialect : dialects) {
            TwoNodes bench(told, std::string(dialect), line);
            StoryStage &stage = bench.stage;
            Device &device = *bench.device;
            for (const Channel &channel : device.telemetry()->channels()) {
                for (const double hertz : {500.0, 20.0, 1.0, 0.0, -1.0}) {
                    (void)stage.perform(std::string(channel.key) + " at " + numberOf(hertz),
                        device.setRate(*device.telemetry()->find(channel.key), hertz));
                    stage.wait(400ms);
                }
            }
            stage.answer("amperes", device.knowledge().calibrate("amperes_per_count", 0.01));
            bench.unit.disturb("analog1", 2.5);
            (void)stage.perform("fast", device.setRate(*device.telemetry()->find("position"), 200.0));
            drive(stage, device, wish(Mode::Velocity, 1000.0), 40ms, 1s);
            stage.heading("a tenth is lost");
            stage.setLoss(0.1);
            keepDriving(stage, stage.stream(device), 0ms, 3s);
            stage.setLoss(0.0);
            halt(stage, device, 40ms, 1s);
            stage.tellTelemetry();
        }
    }
    told.expectAsStored("supermodified-telemetry");
}

TEST(SupermodifiedConversations, NumbersAndGroups)
{
    Conversation told;
    {
        TwoNodes bench(told);
        StoryStage &stage = bench.stage;
        for (const int node : {0, 128, 5, 12, 4})
            (void)stage.perform("renumber to " + std::to_string(node), bench.device->renumber(node));
        bench.unit.setPowered(false);
        stage.wait(1s);
        bench.unit.setPowered(true);
        stage.wait(3s);
        stage.scan();
        (void)stage.perform("identify", bench.device->identify());
        (void)stage.perform("rename", bench.device->rename("x"));
        (void)stage.perform("restart", bench.device->restart());
    }
    for (const char *mask : {"1", "4", "248", "254"}) {
        StoryStage stage(told, usualLine);
        stage.heading(std::string("mask ") + mask);
        stage.unit("supermodified:4,dialect=D1");
        stage.unit(std::string("supermodified:6,dialect=D2,mask=") + mask);
        const auto rows = stage.scan();
        for (const Identity &row : rows) {
            Device &device = stage.open(row);
            stage.wait(300ms);
            stage.answer("may move", device.mayMove());
            drive(stage, device, wish(Mode::Velocity, 500.0), 60ms, 500ms);
            halt(stage, device, 60ms, 500ms);
            (void)stage.perform("zero", device.zeroPosition());
            (void)stage.perform("read", device.read(indexOf(device, "node.mask")));
            (void)stage.perform("write", device.write(indexOf(device, "node.mask"), 255));
        }
        stage.tellTelemetry();
    }
    told.expectAsStored("supermodified-groups");
}

TEST(SupermodifiedConversations, LostAndLateAnswers)
{
    Conversation told;
    std::vector<std::string> variants;
    for (const std::string_view dialect : dialects) {
        for (int seed = 1; seed <= 6; ++seed)
            variants.push_back(std::string(dialect) + '#' + std::to_string(seed));
        for (const char *fault : {"reset@2", "brownout@2", "stall@2", "encoder-dead@2", "encoder-reversed", "duplicate",
                 "power@9", "power@40", "power@60", "silent@9", "silent@40", "delay@4:80", "delay@20:80",
                 "delay@45:200", "corrupt@3", "corrupt@20", "drop@3", "drop@25", "drop@44"})
            variants.push_back(std::string(dialect) + ",fault=" + fault);
    }
    addHoles(variants, 1, 30);
    tellVariants(told, variants, [](Conversation &one, const std::string &variant) {
        const auto hash = variant.find('#');
        const std::uint64_t seed = hash == std::string::npos ? 1 : std::stoull(variant.substr(hash + 1));
        TwoNodes bench(one, variant.starts_with(',') ? variant.substr(0, hash) : "", usualLine, seed);
        StoryStage &stage = bench.stage;
        if (!bench.device)
            return stage.outcomes();
        Device &device = *bench.device;
        if (hash != std::string::npos)
            stage.setLoss(0.15);
        stage.tear(holeOf(variant, 1200us, 8ms));
        (void)stage.perform("refresh", device.refresh());
        (void)stage.perform("read", device.read(indexOf(device, "gain.p")));
        (void)bench.write("profile.velocity", 2000.0);
        drive(stage, device, wish(Mode::Velocity, 800.0), 500ms, 0ms);
        halt(stage, device, 300ms, 0ms);
        SetPoint step = wish(Mode::RampPosition, 500.0);
        step.relative = true;
        step.order = 1;
        drive(stage, device, step, 900ms, 0ms);
        halt(stage, device, 600ms, 0ms);
        (void)stage.perform("zero", device.zeroPosition());
        (void)stage.perform("clear", device.clearFaults());
        stage.tellTelemetry();
        return stage.outcomes();
    });
    told.expectAsStored("supermodified-losses");
}

TEST(SupermodifiedConversations, ScansThatLoseAnswers)
{
    Conversation told;
    std::vector<std::string> variants;
    for (int seed = 1; seed <= 16; ++seed)
        variants.push_back(std::to_string(seed));
    addHoles(variants, 1, 20);
    tellVariants(told, variants, [](Conversation &one, const std::string &variant) {
        const bool lossy = variant.find(' ') == std::string::npos;
        StoryStage stage(one, usualLine, lossy ? std::stoull(variant) : 1);
        stage.unit("supermodified:4,dialect=D1");
        stage.unit("supermodified:5,dialect=D3");
        Simulator &leaving = stage.unit("supermodified:6,dialect=D2,mask=254");
        stage.unit("supermodified:1,dialect=D2");
        stage.unit("supermodified:127,level=1");
        stage.host();
        stage.setLoss(lossy ? 0.2 : 0.0);
        stage.tear(holeOf(variant, 1200us, 8ms));
        const auto rows = stage.scan();
        leaving.setPowered(false);
        for (const int node : {1, 4, 6, 127})
            stage.probe("supermodified", node);
        stage.scan(ScanExtent::Usual, rows);
        return stage.outcomes();
    });
    told.expectAsStored("supermodified-scan-losses");
}

TEST(SupermodifiedConversations, ADeviceThatIsFoundElsewhere)
{
    Conversation told;
    StoryStage stage(told, "sim:serial");
    Simulator &unit = stage.unit("supermodified:4,dialect=D1,baud=57600");
    Simulator &faster = stage.unit("supermodified:4,dialect=D1,baud=115200");
    Simulator &wider = stage.unit("supermodified:4,dialect=D3,baud=115200");
    faster.setPowered(false);
    wider.setPowered(false);
    Device &device = stage.open(stage.probe("supermodified", 4).back());
    stage.wait(500ms);
    for (const auto &[from, to] : {std::pair(&unit, &faster), {&faster, &wider}}) {
        from->setPowered(false);
        to->setPowered(true);
        stage.wait(3s);
        const auto rows = stage.probe("supermodified", 4);
        if (rows.empty())
            continue;
        device.setIdentity(rows.back());
        stage.advance(50ms);
        stage.wait(500ms);
        drive(stage, device, wish(Mode::Velocity, 700.0), 50ms, 300ms);
        halt(stage, device, 50ms, 300ms);
        stage.heading("the cable comes out");
        stage.pullHost();
        stage.wait(200ms);
        stage.answer("open again", stage.host().open());
        stage.advance(60ms);
        stage.wait(1s);
    }
    stage.tellTelemetry();
    told.expectAsStored("supermodified-elsewhere");
}

} // namespace
} // namespace mb
