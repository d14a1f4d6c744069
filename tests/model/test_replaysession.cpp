// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings played through the same session and devices as the live run that they were made of.
#include "model/snapshot.h"
#include "model/standstill.h"
#include "support/simulatedsession.h"
#include "support/temporaryfile.h"
#include "traffic/trafficrecorder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

namespace mb {
namespace {

using namespace std::chrono_literals;

/// By family, address and channel: times in microseconds, as histories keep them, and values.
using Samples
    = std::map<std::tuple<std::string_view, int, std::string_view>, std::vector<std::pair<std::int64_t, double>>>;

std::int64_t micros(Instant time)
{
    return std::chrono::floor<std::chrono::microseconds>(time.time_since_epoch()).count();
}

/// What a frame says is known at once; a drive that is polled is known by several: questions before answers, and velocities
/// over positions of the last quarter of a second.
Duration settling(const Device &device)
{
    return device.family().key == "dmc60c" ? Duration::zero() : Duration(1s);
}

/// What the device measured: all but the set-point, which the host that drives knows.
void collect(Samples &into, const Device &device, Instant from)
{
    from += settling(device);
    device.telemetry()->commit();
    for (std::size_t i = 0; i < device.family().channels.size(); ++i) {
        const ChannelIndex channel{static_cast<std::uint16_t>(i)};
        const std::string_view key = device.family().channels[i].key;
        if (key == "setpoint" || device.telemetry()->size(channel) == 0)
            continue;
        auto &samples = into[{device.family().key, device.identity().address, key}];
        device.telemetry()->forEach(channel, from, Instant::max(), [&](const Point &point) {
            if (!point.isGap())
                samples.emplace_back(micros(point.time), point.value);
        });
        if (samples.empty())
            into.erase({device.family().key, device.identity().address, key});
    }
}

std::unique_ptr<TrafficRecorder> recordTraffic(Link &link, VirtualClock &clock, const std::string &path)
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
        auto recorder = recordTraffic(*live.link, live.clock, path);
        const std::array driven{live.device(5), live.device(3, "abstractdc"), live.device(4, "abstractdc")};
        SetPoint setPoint;
        setPoint.mode = Mode::Duty;
        setPoint.target = 0.25;
        for (Device *const unit : driven)
            EXPECT_TRUE(live.session.stream(*unit).start(setPoint, 10s));
        live.clock.advance(4s);
        for (Device *const unit : driven)
            live.session.stream(*unit).stop();
        live.clock.advance(6s);
        state = recorder->state();
        recorder.reset();
        for (const Device *device : live.session.devices())
            collect(samples, *device, from);
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
        EXPECT_TRUE(opened) << (opened ? "" : opened.error().text());
        link = replayOf(**opened);
        auto found = test::run(clock, session.scan(*link));
        EXPECT_TRUE(found) << (found ? "" : found.error().text());
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

    [[nodiscard]] Device *device(std::string_view family, int address) const
    {
        const auto found = std::find_if(devices.begin(), devices.end(), [&](const Device *device) {
            return device->family().key == family && device->identity().address == address;
        });
        return found == devices.end() ? nullptr : *found;
    }

    VirtualClock clock;
    Session session;
    ReplayLink *link = nullptr;
    std::vector<Device *> devices;
};

std::vector<std::string> selectors(const std::vector<Device *> &devices)
{
    std::vector<std::string> names;
    for (const Device *device : devices)
        names.push_back(std::string(device->family().key) + ':' + std::to_string(device->identity().address));
    return names;
}

std::string nameOf(const Samples::key_type &key)
{
    const auto &[family, address, channel] = key;
    return std::string(family) + ':' + std::to_string(address) + ' ' + std::string(channel);
}

void expectSame(const Samples &replayed, const Samples &live)
{
    for (const auto &[key, samples] : replayed)
        EXPECT_TRUE(live.contains(key)) << nameOf(key) << " has " << samples.size() << " samples that were not there";
    for (const auto &[key, samples] : live) {
        ASSERT_TRUE(replayed.contains(key)) << nameOf(key) << " has none of " << samples.size();
        const auto &again = replayed.at(key);
        ASSERT_EQ(again.size(), samples.size()) << nameOf(key);
        const auto [theirs, ours] = std::mismatch(again.begin(), again.end(), samples.begin());
        EXPECT_TRUE(theirs == again.end())
            << nameOf(key) << ": number " << theirs - again.begin() << " is " << theirs->second << " at "
            << theirs->first << ", live " << ours->second << " at " << ours->first;
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
            ASSERT_EQ(selectors(playback.devices),
                (std::vector<std::string>{
                    "abstractdc:3", "abstractdc:4", "abstractdc:5", "dmc60c:5", "dmc60c:7", "dmc60c:9"}));
            ASSERT_GE(run.samples.size(), 27U);
            expectSame(playback.play(run.from), run.samples);
            for (const Device *device : playback.devices)
                EXPECT_FALSE(device->liveness().foreignMaster) << "our own frames came back as another's";
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
    for (const Duration position : {Duration(3s), Duration(500ms), Duration(8s)}) {
        ASSERT_TRUE(playback.session.seek(*playback.link, position));
        Device *const device = playback.session.find(id);
        ASSERT_NE(device, nullptr) << "the device keeps its id";
        const Instant begin(playback.link->replay().start + position);
        const Samples replayed = playback.play(begin);
        Samples live;
        for (const Device *original : run.live.session.devices())
            collect(live, *original, begin);
        expectSame(replayed, live);
    }
}

TEST(ReplaySession, HasTheRecordingsTimeAndStandsWithIt)
{
    const LiveRun run;
    Playback playback("replay:" + run.path);
    const Device &device = *playback.device("dmc60c", 5);
    playback.link->play();
    playback.clock.advance(1s);
    EXPECT_TRUE(device.liveness().heard);
    EXPECT_TRUE(device.liveness().moving);
    playback.link->pause();
    playback.clock.advance(1h);
    EXPECT_TRUE(device.liveness().heard) << "time stands for the devices, too";
    EXPECT_EQ(device.clock().now(), Instant(playback.link->replay().start + 1s));
    const LinkView view = viewOf(*playback.link, device.clock());
    EXPECT_EQ(view.time, device.clock().now());
    EXPECT_EQ(view.replay->position, 1s);
}

TEST(ReplaySession, LetsNothingBeDrivenOrWritten)
{
    const LiveRun run;
    Playback playback("replay:" + run.path);
    Device &device = *playback.device("dmc60c", 5);
    playback.link->play();
    playback.clock.advance(1s);
    EXPECT_EQ(device.mayMove().error().fault, Fault::Unsupported);
    EXPECT_NE(device.mayMove().error().text().find("run.log is a recording"), std::string::npos);
    SetPoint setPoint;
    setPoint.mode = Mode::Duty;
    setPoint.target = 0.1;
    EXPECT_FALSE(device.command(setPoint));
    EXPECT_EQ(test::run(playback.clock, device.restart()).error().fault, Fault::Unsupported);
    playback.link->pause(); // nothing that waits ends
    EXPECT_EQ(test::run(playback.clock, standsStill(device)).error().fault, Fault::Unsupported);
    auto read = test::run(playback.clock, device.read(ParameterIndex{0}));
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().fault, Fault::Unsupported);
    const auto sent = playback.link->counters().tx; // what the recorder had sent
    playback.session.stopAll(StopCause::User);
    EXPECT_FALSE(device.command(setPoint));
    EXPECT_EQ(playback.link->counters().tx, sent);
}

TEST(ReplaySession, KnowsADeviceBetterWhenTheRecordingHasItsAnswers)
{
    test::TemporaryFolder folder;
    test::SimulatedSession live;
    {
        const auto recorder = recordTraffic(*live.link, live.clock, folder.path("scan.log"));
        live.scan();
    }
    Playback playback("replay:" + folder.path("scan.log"));
    ASSERT_EQ(playback.devices.size(), 6U);
    for (const Device *device : playback.devices) {
        const Identity &known = live.device(device->identity().address, device->family().key)->identity();
        EXPECT_EQ(device->identity().dialect, known.dialect);
        EXPECT_EQ(device->identity().session, known.session);
        EXPECT_EQ(device->identity().state, known.state);
        EXPECT_EQ(device->identity().firmware, known.firmware);
        EXPECT_EQ(device->identity().bootloader, known.bootloader);
    }
    Device &device = *playback.devices.front();
    const DeviceId id = playback.session.idOf(device);
    for (const char *const serial : {"A7", "A8"}) {
        Identity identity = device.identity();
        identity.serial = serial;
        device.setIdentity(identity);
        EXPECT_EQ(playback.session.idOf(device), id) << "who sends in a recording is not asked";
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
    ASSERT_TRUE(connected) << connected.error().text();
    EXPECT_EQ((*connected)->identity().address, 7);
    const auto nobody
        = test::run(clock, session.connect(*DeviceSelector::parse("replay:" + run.path + "?speed=max/dmc60c:33")));
    ASSERT_FALSE(nobody);
    EXPECT_EQ(nobody.error().fault, Fault::Timeout);
    EXPECT_EQ(nobody.error().text(),
        "no dmc60c sends as number 33 in replay:" + run.path + "?speed=max; a scan of the recording lists who does");
    const std::string damaged = run.folder.write("damaged.log", run.folder.read("run.log") + "rubbish\nmore\n");
    const auto broken = session.openLink(*LinkAddress::parse("replay:" + damaged));
    ASSERT_TRUE(broken);
    const auto scanned = test::run(clock, session.scan(**broken));
    ASSERT_FALSE(scanned);
    EXPECT_EQ(scanned.error().fault, Fault::OutOfRange);
    EXPECT_NE(scanned.error().text().find("is not a line of candump -L"), std::string::npos);
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
    EXPECT_EQ(state.problem, "/dev/full: the disk is full; make room, or choose another place");
    EXPECT_EQ(told, 1);
    EXPECT_GT(state.frames, 1000U);
    EXPECT_EQ(state.lost, state.frames);
}

} // namespace
} // namespace mb
