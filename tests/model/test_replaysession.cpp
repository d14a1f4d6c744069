// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings played through the same session and devices as the live run that they were made of.
#include "model/trafficrecorder.h"
#include "support/simulatedsession.h"
#include "support/temporaryfile.h"

#include <gtest/gtest.h>

#include <map>

namespace mb {
namespace {

using namespace std::chrono_literals;

/// Channel by channel: times in microseconds, as histories keep them, and values.
using Samples = std::map<std::pair<int, std::size_t>, std::vector<std::pair<std::int64_t, double>>>;

std::int64_t micros(Instant time)
{
    return std::chrono::floor<std::chrono::microseconds>(time.time_since_epoch()).count();
}

void collect(Samples &into, const Device &device, Instant from)
{
    for (std::size_t i = 0; i < device.family().channels.size(); ++i) {
        const ChannelIndex channel{static_cast<std::uint16_t>(i)};
        device.telemetry()->commit();
        auto &samples = into[{device.identity().address, i}];
        device.telemetry()->forEach(channel, from, Instant::max(), [&](const Point &point) {
            if (!point.isGap())
                samples.emplace_back(micros(point.time), point.value);
        });
    }
}

std::unique_ptr<TrafficRecorder> record(Link &link, VirtualClock &clock, const std::string &path)
{
    auto recorder = TrafficRecorder::start(link, clock, clock.unixOffset(), path);
    EXPECT_TRUE(recorder);
    return recorder ? std::move(*recorder) : nullptr;
}

/// Ten seconds of the simulated bench with a motor that is driven, recorded.
struct LiveRun {
    explicit LiveRun(const std::string &name = "run.log")
        : path(folder.path(name))
    {
        live.scan();
        live.clock.advance(2s);
        from = live.clock.now();
        auto recorder = record(*live.link, live.clock, path);
        Device *const unit = live.device(5);
        SetPoint setPoint;
        setPoint.mode = Mode::Duty;
        setPoint.target = 0.25;
        SetPointStream &stream = live.session.stream(*unit);
        EXPECT_TRUE(stream.start(setPoint, 10s));
        live.clock.advance(4s);
        stream.stop();
        live.clock.advance(6s);
        state = recorder->state();
        recorder.reset();
        for (const Device *device : live.session.devices()) {
            if (device->family().recognise) // the others are not found in recordings
                collect(samples, *device, from);
        }
    }

    test::TemporaryFolder folder;
    test::SimulatedSession live;
    std::string path;
    Instant from{};
    RecordingState state;
    Samples samples;
};

struct Playback {
    explicit Playback(const std::string &address)
        : session(clock, families())
    {
        const auto opened = session.openLink(*LinkAddress::parse(address));
        EXPECT_TRUE(opened) << (opened ? "" : opened.error().detail);
        link = Session::replayOf(**opened);
        auto found = test::run(clock, session.scan(*link));
        EXPECT_TRUE(found) << (found ? "" : found.error().detail);
        devices = found.value_or(std::vector<Device *>{});
    }
    Samples play(Instant from)
    {
        bool ended = false;
        const Subscription end = link->ended().add([&ended] { ended = true; });
        link->play();
        EXPECT_TRUE(clock.runUntil([&] { return ended; }));
        Samples samples;
        for (const Device *device : session.devices())
            collect(samples, *device, from);
        return samples;
    }

    VirtualClock clock;
    Session session;
    ReplayLink *link = nullptr;
    std::vector<Device *> devices;
};

std::size_t setPointChannel(const Device &device)
{
    return device.telemetry()->find("setpoint").value_or(ChannelIndex{}).value;
}

/// What the device measured: all but the set-point, which the host that drives knows.
Samples measured(Samples samples, const Device &device)
{
    for (const int address : {5, 7, 9})
        samples.erase({address, setPointChannel(device)});
    std::erase_if(samples, [](const auto &entry) { return entry.second.empty(); });
    return samples;
}

void expectSame(const Samples &replayed, const Samples &live)
{
    ASSERT_EQ(replayed.size(), live.size());
    for (const auto &[key, samples] : live) {
        ASSERT_TRUE(replayed.contains(key)) << key.first << ' ' << key.second;
        EXPECT_EQ(replayed.at(key), samples) << "device " << key.first << " channel " << key.second;
    }
}

TEST(ReplaySession, GivesTheSamplesOfTheLiveRunInBothFormatsAtEverySpeed)
{
    for (const char *const name : {"run.log", "run.asc"}) {
        const LiveRun run(name);
        ASSERT_EQ(run.state.lost, 0U);
        ASSERT_GT(run.state.frames, 2000U);
        for (const char *const speed : {"?speed=max", "?speed=1", "?speed=7.3"}) {
            Playback playback("replay:" + run.path + speed);
            ASSERT_EQ(playback.devices.size(), 3U);
            EXPECT_EQ(playback.devices[0]->identity().address, 5);
            EXPECT_EQ(playback.devices[1]->identity().address, 7);
            const Device &any = *playback.devices[0];
            const Samples live = measured(run.samples, any);
            ASSERT_GE(live.size(), 16U);
            expectSame(measured(playback.play({}), any), live);
            EXPECT_FALSE(playback.devices[0]->liveness().foreignMaster) << "our own frames came back as another's";
        }
    }
}

TEST(ReplaySession, GivesTheSamplesOfTheLiveRunAfterASeek)
{
    const LiveRun run;
    Playback playback("replay:" + run.path);
    playback.link->play();
    playback.clock.advance(8s);
    const DeviceId id = playback.session.idOf(*playback.devices[0]);
    for (const Duration position : {Duration(3s), Duration(500ms), Duration(9s)}) {
        ASSERT_TRUE(playback.session.seek(*playback.link, position));
        Device *const device = playback.session.find(id);
        ASSERT_NE(device, nullptr) << "the device keeps its id";
        const Samples replayed = measured(playback.play({}), *device);
        const std::int64_t begin = micros(Instant(playback.link->replay().start + position));
        Samples live = measured(run.samples, *device);
        for (auto &[key, samples] : live)
            std::erase_if(samples, [begin](const auto &sample) { return sample.first < begin; });
        expectSame(replayed, live);
    }
}

TEST(ReplaySession, HasTheRecordingsTimeAndStandsWithIt)
{
    const LiveRun run;
    Playback playback("replay:" + run.path);
    const Device &device = *playback.devices[0];
    playback.link->play();
    playback.clock.advance(1s);
    EXPECT_TRUE(device.liveness().heard);
    EXPECT_TRUE(device.liveness().moving);
    playback.link->pause();
    playback.clock.advance(1h);
    EXPECT_TRUE(device.liveness().heard) << "time stands for the devices, too";
    EXPECT_EQ(device.clock().now(), Instant(playback.link->replay().start + 1s));
}

TEST(ReplaySession, LetsNothingBeDrivenOrWritten)
{
    const LiveRun run;
    Playback playback("replay:" + run.path);
    Device &device = *playback.devices[0];
    playback.link->play();
    playback.clock.advance(1s);
    EXPECT_EQ(device.mayMove().error().fault, Fault::Unsupported);
    EXPECT_NE(device.mayMove().error().detail.find("run.log is a recording"), std::string::npos);
    SetPoint setPoint;
    setPoint.mode = Mode::Duty;
    setPoint.target = 0.1;
    EXPECT_FALSE(device.command(setPoint));
    auto read = test::run(playback.clock, device.read(ParameterIndex{0}));
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().fault, Fault::Unsupported);
    const auto sent = playback.link->counters().tx; // what the recorder had sent
    playback.session.stopAll();
    EXPECT_FALSE(device.command(setPoint));
    EXPECT_EQ(playback.link->counters().tx, sent);
}

TEST(ReplaySession, KnowsADeviceBetterWhenTheRecordingHasItsAnswers)
{
    test::TemporaryFolder folder;
    test::SimulatedSession live;
    {
        const auto recorder = record(*live.link, live.clock, folder.path("scan.log"));
        live.scan();
    }
    Playback playback("replay:" + folder.path("scan.log"));
    ASSERT_EQ(playback.devices.size(), 3U);
    for (const Device *device : playback.devices) {
        const Identity &known = live.device(device->identity().address)->identity();
        EXPECT_EQ(device->identity().session, known.session);
        EXPECT_EQ(device->identity().state, known.state);
        EXPECT_EQ(device->identity().firmware, known.firmware);
        EXPECT_EQ(device->identity().bootloader, known.bootloader);
    }
    auto again = test::run(playback.clock, playback.session.scan(*playback.link));
    ASSERT_TRUE(again);
    EXPECT_EQ(*again, playback.devices) << "a second scan costs nothing and finds the same";
}

TEST(ReplaySession, IsConnectedBySelectorAndRefusesADamagedFile)
{
    const LiveRun run;
    VirtualClock clock;
    Session session(clock, families());
    const auto selector = DeviceSelector::parse("replay:" + run.path + "?speed=max/dmc60c:7");
    ASSERT_TRUE(selector);
    const auto connected = test::run(clock, session.connect(*selector));
    ASSERT_TRUE(connected) << connected.error().detail;
    EXPECT_EQ((*connected)->identity().address, 7);
    const std::string damaged = run.folder.write("damaged.log", run.folder.read("run.log") + "rubbish\nmore\n");
    const auto broken = session.openLink(*LinkAddress::parse("replay:" + damaged));
    ASSERT_TRUE(broken);
    const auto scanned = test::run(clock, session.scan(**broken));
    ASSERT_FALSE(scanned);
    EXPECT_EQ(scanned.error().fault, Fault::OutOfRange);
    EXPECT_NE(scanned.error().detail.find("is not a line of candump -L"), std::string::npos);
}

TEST(TrafficRecorder, SaysThatTheDiskIsFullAndCountsWhatIsMissing)
{
    test::SimulatedSession live;
    live.scan();
    auto recorder = TrafficRecorder::start(*live.link, live.clock, Duration::zero(), "/dev/full");
    if (!recorder)
        GTEST_SKIP() << "there is no /dev/full here";
    int told = 0;
    const Subscription changed = (*recorder)->changed().add([&told] { ++told; });
    live.clock.advance(1s);
    while ((*recorder)->state().problem.empty())
        std::this_thread::yield();
    live.clock.advance(10s);
    const RecordingState state = (*recorder)->state();
    EXPECT_EQ(state.problem, "/dev/full: the disk is full; make room, or record elsewhere");
    EXPECT_EQ(told, 1);
    EXPECT_GT(state.frames, 1000U);
    EXPECT_EQ(state.lost, state.frames);
}

} // namespace
} // namespace mb
