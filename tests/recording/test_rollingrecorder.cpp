// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/family.h"
#include "recording/joinrecordings.h"
#include "recording/loadrecording.h"
#include "recording/rollingrecorder.h"
#include "recordingfolder.h"
#include "signals.h"
#include "support/fulldisk.h"

#include <gtest/gtest.h>

#include <filesystem>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mb {
namespace {

using namespace test;
namespace fs = std::filesystem;

/// A device that sends 100 samples a second, and a recorder that looks every half second.
struct Running {
    std::shared_ptr<Telemetry> recording = telemetry();
    Instant now = ms(0);

    /// Half a second more.
    Result<void> write(RollingRecorder &recorder)
    {
        recorder.follow({{recording, velocity, "sim:can/dmc60c:5", "dmc60c", "velocity", "counts/s", {}, true}},
            {{"device sim:can/dmc60c:5", {{"serial", "SN 7"}}}});
        for (int j = 0; j < 50; ++j) {
            now += 10ms;
            recording->append({velocity, now, static_cast<double>(now.time_since_epoch() / 1ms)});
        }
        recording->commit();
        return recorder.write(now, unixOffset);
    }
    void run(RollingRecorder &recorder, int halfSeconds)
    {
        for (int i = 0; i < halfSeconds; ++i)
            ASSERT_TRUE(write(recorder));
    }
};

TEST(RollingRecorder, TheLastSecondsAreAlwaysThere)
{
    const Folder folder;
    Running bench;
    RollingRecorder recorder(rolling(folder, "run"));
    bench.run(recorder, 60);
    const auto report = recorder.save(folder.file("kept.mcap"), {});
    ASSERT_TRUE(report) << report.error().text();
    const auto loaded = loadRecording(folder.file("kept.mcap"));
    ASSERT_TRUE(loaded);
    const double seconds = std::chrono::duration<double>((*loaded)->last - (*loaded)->first).count();
    EXPECT_GE(seconds, 9.9); // what the recorder was asked for, but for what still settles
    EXPECT_LE(seconds, 13.0);
    EXPECT_NEAR(static_cast<double>((*loaded)->telemetry->size({0})), seconds * 100, 2);
    EXPECT_EQ((*loaded)->about.at("device sim:can/dmc60c:5").at("serial"), "SN 7");
    bench.run(recorder, 4); // goes on
    EXPECT_GT(recorder.samples(), 0U);
}

TEST(RollingRecorder, KeepingBeginsBeforeItWasAskedFor)
{
    const Folder folder;
    Running bench;
    RollingRecorder recorder(rolling(folder, "run"));
    bench.run(recorder, 40);
    recorder.startKeeping();
    bench.run(recorder, 80);
    ASSERT_TRUE(recorder.save(folder.file("kept.mcap"), {}));
    EXPECT_FALSE(recorder.isKeeping());
    const auto loaded = loadRecording(folder.file("kept.mcap"));
    ASSERT_TRUE(loaded);
    EXPECT_GE(std::chrono::duration<double>((*loaded)->last - (*loaded)->first).count(), 49.0);
    EXPECT_EQ((*loaded)->telemetry->lost({0}), 0U);
    std::vector<Point> points;
    (void)(*loaded)->telemetry->read({0}, 0, Instant::max(), 1'000'000, points);
    for (std::size_t i = 1; i < points.size(); ++i) // nothing is missing where one file ends and the next begins
        ASSERT_EQ(points[i].value, points[i - 1].value + 10.0);
}

TEST(RollingRecorder, WhatIsSavedHasTheNewestSamplesToo)
{
    const Folder folder;
    Running bench;
    RollingRecorder recorder(rolling(folder, "run"));
    bench.run(recorder, 4);
    ASSERT_TRUE(recorder.writeAll(bench.now, unixOffset));
    ASSERT_TRUE(recorder.save(folder.file("kept.mcap"), {}));
    const auto loaded = loadRecording(folder.file("kept.mcap"));
    ASSERT_TRUE(loaded);
    EXPECT_EQ((*loaded)->telemetry->size({0}), 200U);
}

TEST(RollingRecorder, AFolderThatWasTakenAwayIsToldOnceAndMadeAnewWithAllThatMemoryHas)
{
    const Folder folder;
    Running bench;
    RollingRecorder recorder(rolling(folder, "run"));
    recorder.startKeeping();
    bench.run(recorder, 11); // the third file
    fs::remove_all(folder.path / "run");
    const auto told = bench.write(recorder);
    ASSERT_FALSE(told);
    EXPECT_NE(told.error().text().find("was taken away"), std::string::npos) << told.error().text();
    bench.run(recorder, 4);
    ASSERT_TRUE(recorder.writeAll(bench.now, unixOffset));
    const auto saved = recorder.save(folder.file("kept.mcap"), {});
    ASSERT_TRUE(saved) << saved.error().text();
    const auto loaded = loadRecording(folder.file("kept.mcap"));
    ASSERT_TRUE(loaded);
    EXPECT_EQ((*loaded)->telemetry->size({0}), 800U) << "16 half seconds";
    EXPECT_TRUE(fs::exists(folder.path / "run" / "lock")) << "nobody else recovers it";
}

TEST(RollingRecorder, AFolderThatWasTakenAwayAtTheEndOfAFileIsMadeAnew)
{
    const Folder folder;
    Running bench;
    RollingRecorder recorder(rolling(folder, "run"));
    bench.run(recorder, 2);
    fs::remove_all(folder.path);
    EXPECT_FALSE(bench.write(recorder));
    EXPECT_TRUE(bench.write(recorder));
    EXPECT_EQ(recorder.samples(), 190U) << "but for what still settles";
    EXPECT_TRUE(fs::exists(folder.path / "run" / "lock"));
}

TEST(RollingRecorder, AClockThatIsSetMeanwhileLeavesNoGapAndNoTimeThatGoesBack)
{
    const Folder folder;
    Running bench;
    RollingRecorder recorder(rolling(folder, "run"));
    bench.run(recorder, 2);
    ASSERT_TRUE(recorder.write(bench.now, unixOffset - 30s));
    bench.run(recorder, 2);
    ASSERT_TRUE(recorder.writeAll(bench.now, unixOffset + 3600s));
    ASSERT_TRUE(recorder.save(folder.file("kept.mcap"), {}));
    const auto loaded = loadRecording(folder.file("kept.mcap"));
    ASSERT_TRUE(loaded);
    EXPECT_NEAR(std::chrono::duration<double>((*loaded)->last - (*loaded)->first).count(), 1.99, 0.02);
}

TEST(RollingRecorder, ASegmentThatCannotBeReadIsNotLeftOutWithoutAWord)
{
    const Folder folder;
    Running bench;
    RollingRecorder recorder(rolling(folder, "run"));
    bench.run(recorder, 12);
    recorder.startKeeping();
    fs::remove(folder.path / "run" / "segment-000001.mcap");
    const auto saved = recorder.save(folder.file("kept.mcap"), {});
    ASSERT_FALSE(saved);
    EXPECT_NE(saved.error().text().find("segment-000001.mcap cannot be read"), std::string::npos)
        << saved.error().text();
    EXPECT_TRUE(recorder.isKeeping());
    EXPECT_FALSE(fs::exists(folder.file("kept.mcap")));
}

TEST(RollingRecorder, AFolderThatAnotherProgramRecoversIsLeftToIt)
{
    const Folder folder;
    const fs::path run = folder.path / "killed";
    fs::create_directory(run);
    const int other = ::open((run / "lock").c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600);
    ASSERT_EQ(::flock(other, LOCK_EX | LOCK_NB), 0);
    const auto recovered = recoverRecordings(folder.path.string());
    EXPECT_TRUE(recovered.paths.empty());
    EXPECT_TRUE(recovered.failures.empty());
    EXPECT_TRUE(fs::exists(run));
    ::close(other);
    (void)recoverRecordings(folder.path.string());
    EXPECT_FALSE(fs::exists(run)) << "there was nothing in it";
}

TEST(RollingRecorder, AGapWaitsForTheSampleAfterIt)
{
    const Folder folder;
    const auto recording = telemetry();
    RollingRecorder recorder(rolling(folder, "run"));
    recorder.follow({{recording, velocity, "sim:can/dmc60c:5", "dmc60c", "velocity", "counts/s", {}, true}}, {});
    put(*recording, velocity, 10, 1.0);
    recording->lost(velocity, 5);
    put(*recording, velocity, 500, 2.0);
    ASSERT_TRUE(recorder.write(ms(550), unixOffset)); // the second still settles
    EXPECT_EQ(recorder.samples(), 1U);
    ASSERT_TRUE(recorder.write(ms(700), unixOffset));
    ASSERT_TRUE(recorder.save(folder.file("kept.mcap"), {}));
    const auto loaded = loadRecording(folder.file("kept.mcap"));
    ASSERT_TRUE(loaded);
    EXPECT_EQ((*loaded)->telemetry->size({0}), 2U);
    EXPECT_EQ((*loaded)->telemetry->lost({0}), 5U);
}

TEST(RollingRecorder, SurvivesAKilledProcess)
{
    const Folder folder;
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        Running bench;
        RollingRecorder recorder(rolling(folder, "killed"));
        bench.run(recorder, 15);
        ::kill(::getpid(), SIGKILL);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    RollingRecorder other(rolling(folder, "alive"));
    Running bench;
    bench.run(other, 4);
    fs::create_directory(folder.path / "recovered-killed.mcap"); // what stands there cannot be written over
    EXPECT_EQ(recoverRecordings(folder.path.string()).failures.size(), 1U);
    EXPECT_TRUE(fs::exists(folder.path / "killed")) << "what could not be saved stays for the next time";
    fs::remove(folder.path / "recovered-killed.mcap");
    const auto recovered = recoverRecordings(folder.path.string());
    EXPECT_TRUE(recovered.failures.empty());
    ASSERT_EQ(recovered.paths.size(), 1U); // the one that runs is left alone
    const auto loaded = loadRecording(recovered.paths.front());
    ASSERT_TRUE(loaded);
    EXPECT_GE((*loaded)->telemetry->size({0}), 735U); // of 750; the last tenth of a second was still settling
    EXPECT_FALSE(fs::exists(folder.path / "killed"));
    EXPECT_TRUE(recoverRecordings(folder.path.string()).paths.empty());
}

TEST(RollingRecorder, AnEndInOrderLeavesTheLastSession)
{
    const Folder folder;
    for (int i = 0; i < 2; ++i) {
        Running bench;
        RollingRecorder recorder(rolling(folder, i == 0 ? "first" : "second"));
        bench.run(recorder, 10);
    }
    EXPECT_TRUE(fs::exists(folder.path / "last-session" / "segment-000000.mcap"));
    EXPECT_FALSE(fs::exists(folder.path / "first"));
    EXPECT_TRUE(recoverRecordings(folder.path.string()).paths.empty());
}

TEST(RollingRecorder, WhatCannotTakeThePlaceOfTheLastSessionIsRecoveredAtTheNextStart)
{
    const Folder folder;
    fs::create_directories(folder.path / "run" / "inner");
    {
        RollingRecorder::Options options;
        options.folder = (folder.path / "run" / "inner").string();
        options.name = "../../run"; // no folder can be moved into itself
        Running bench;
        RollingRecorder recorder(options);
        bench.run(recorder, 10);
    }
    const auto recovered = recoverRecordings(folder.path.string());
    ASSERT_EQ(recovered.paths.size(), 1U);
    const auto loaded = loadRecording(recovered.paths.front());
    ASSERT_TRUE(loaded);
    EXPECT_GE((*loaded)->telemetry->size({0}), 485U) << "of 500; the last tenth of a second was still settling";
    EXPECT_FALSE(fs::exists(folder.path / "run"));
}

/// Everything that the bench has sent, each sample once.
void expectComplete(const std::string &path, const Running &bench)
{
    const auto loaded = loadRecording(path);
    ASSERT_TRUE(loaded) << loaded.error().text();
    std::vector<Point> points;
    (void)(*loaded)->telemetry->read({0}, 0, Instant::max(), 1'000'000, points);
    ASSERT_GT(points.size(), 0U);
    EXPECT_EQ(points.front().value, 10.0);
    for (std::size_t i = 1; i < points.size(); ++i)
        ASSERT_EQ(points[i].value, points[i - 1].value + 10.0);
    EXPECT_GE(points.back().value, static_cast<double>((bench.now.time_since_epoch() - 100ms) / 1ms));
}

TEST(RollingRecorder, AFullDiskIsOneErrorAndCostsNothing)
{
    const Folder folder;
    Running bench;
    RollingRecorder recorder(rolling(folder, "run"));
    recorder.startKeeping();
    bench.run(recorder, 9);
    const std::uint64_t before = recorder.samples();
    {
        const FullDisk full(1);
        const auto first = bench.write(recorder);
        ASSERT_FALSE(first);
        EXPECT_NE(first.error().text().find("greatest size"), std::string::npos) << first.error().text();
        for (int i = 0; i < 10; ++i)
            EXPECT_EQ(bench.write(recorder).error().fault, Fault::NotKept); // no link is lost
        EXPECT_EQ(recorder.samples(), before) << "what is not on the disk is not counted";
    }
    const FullDisk none(RLIM_INFINITY);
    const auto saved = recorder.save(folder.file("kept.mcap"), {});
    ASSERT_FALSE(saved) << "samples wait for the disk";
    EXPECT_FALSE(fs::exists(folder.path / "kept.mcap"));
    EXPECT_TRUE(recorder.isKeeping());
    std::uint64_t whole = 0;
    for (const auto &segment : fs::directory_iterator(folder.path / "run")) {
        if (segment.path().extension() != ".mcap")
            continue;
        const auto loaded = loadRecording(segment.path().string());
        ASSERT_TRUE(loaded) << segment.path() << ": " << loaded.error().text();
        whole += (*loaded)->telemetry->size({0});
    }
    EXPECT_EQ(whole, before);
    ASSERT_TRUE(bench.write(recorder)) << "there is room again";
    ASSERT_TRUE(recorder.save(folder.file("kept.mcap"), {}));
    expectComplete(folder.file("kept.mcap"), bench);
}

TEST(RollingRecorder, AFileThatMayNotGrowEndsWithItsLastWholeSample)
{
    const Folder folder;
    Running bench;
    RollingRecorder recorder(rolling(folder, "run"));
    recorder.startKeeping();
    int refused = 0;
    {
        const FullDisk full(6000);
        for (int i = 0; i < 20; ++i)
            refused += bench.write(recorder) ? 0 : 1;
    }
    EXPECT_GT(refused, 3);
    ASSERT_TRUE(bench.write(recorder));
    ASSERT_TRUE(recorder.save(folder.file("kept.mcap"), {}));
    expectComplete(folder.file("kept.mcap"), bench);
}

TEST(RollingRecorder, AFolderThatCannotBeWrittenIsTold)
{
    RollingRecorder::Options options;
    options.folder = "/proc/nonexistent";
    options.name = "run";
    RollingRecorder recorder(options);
    const auto recording = telemetry();
    recorder.follow({{recording, velocity, "sim:can/dmc60c:5", "dmc60c", "velocity", "", {}, true}}, {});
    const auto written = recorder.write(ms(0), unixOffset);
    ASSERT_FALSE(written);
    EXPECT_NE(written.error().text().find("/proc/nonexistent"), std::string::npos);
}

TEST(RollingRecorder, AnotherUnitIsAnotherChannel)
{
    static constexpr std::array<Channel, 3> inCounts{
        {channels[0], channels[1], {"current", "counts", "Current", Quantity::Current}}};
    const Folder folder;
    const auto recording = telemetry();
    RollingRecorder recorder(rolling(folder, "run"));
    recording->useTable(inCounts);
    recorder.follow({{recording, current, "sim:serial/x:5", "x", "current", "counts", {}, true}}, {});
    put(*recording, current, 10, 1000.0);
    put(*recording, current, 20, 1000.0);
    ASSERT_TRUE(recorder.write(ms(500), unixOffset));
    recording->useTable(channels);
    put(*recording, current, 600, 1.5);
    recorder.follow({{recording, current, "sim:serial/x:5", "x", "current", "A", {}, true}}, {});
    ASSERT_TRUE(recorder.write(ms(2600), unixOffset)); // in the next file
    ASSERT_TRUE(recorder.save(folder.file("kept.mcap"), {}));
    const auto loaded = loadRecording(folder.file("kept.mcap"));
    ASSERT_TRUE(loaded);
    const LoadedRecording &file = **loaded;
    ASSERT_EQ(file.table.size(), 2U);
    EXPECT_EQ(file.table[0].unit, "counts");
    EXPECT_EQ(file.telemetry->size({0}), 2U);
    EXPECT_EQ(file.table[1].unit, "A");
    ASSERT_EQ(file.telemetry->size({1}), 1U);
    EXPECT_EQ(file.telemetry->last({1})->value, 1.5);
}

TEST(RollingRecorder, AUnitThatGotAnotherNumberIsRecordedUnderIt)
{
    const Folder folder;
    const auto recording = telemetry();
    RollingRecorder recorder(rolling(folder, "run"));
    recorder.follow({{recording, velocity, "sim:can/dmc60c:0", "dmc60c", "velocity", "counts/s", {}, true}}, {});
    put(*recording, velocity, 10, 1.0);
    ASSERT_TRUE(recorder.writeAll(ms(100), unixOffset));
    const auto next = telemetry(); // has the number that the first one had
    recorder.follow({{recording, velocity, "sim:can/dmc60c:17", "dmc60c", "velocity", "counts/s", {}, true},
                        {next, velocity, "sim:can/dmc60c:0", "dmc60c", "velocity", "counts/s", {}, true}},
        {});
    put(*recording, velocity, 110, 2.0);
    put(*recording, velocity, 120, 2.0);
    put(*next, velocity, 115, 3.0);
    ASSERT_TRUE(recorder.writeAll(ms(200), unixOffset));
    ASSERT_TRUE(recorder.save(folder.file("kept.mcap"), {}));
    const auto loaded = loadRecording(folder.file("kept.mcap"));
    ASSERT_TRUE(loaded);
    const LoadedRecording &file = **loaded;
    ASSERT_EQ(file.table.size(), 2U);
    EXPECT_EQ(file.telemetry->size({0}), 2U);
    EXPECT_EQ(file.telemetry->last({0})->value, 3.0);
    EXPECT_EQ(file.telemetry->size({1}), 2U);
    EXPECT_EQ(file.telemetry->last({1})->value, 2.0);
}

TEST(RollingRecorder, WhatBeganAnewIsRecordedFromItsFirstSampleThoughItHasOutgrownWhatWasForgotten)
{
    const Folder folder;
    const auto recording = telemetry();
    RollingRecorder recorder(rolling(folder, "run"));
    recorder.follow({{recording, velocity, "sim:can/dmc60c:5", "dmc60c", "velocity", "counts/s", {}, true}}, {});
    put(*recording, velocity, 10, 1.0);
    put(*recording, velocity, 20, 1.0);
    ASSERT_TRUE(recorder.writeAll(ms(100), unixOffset));
    recording->clear();
    for (int i = 0; i < 5; ++i)
        put(*recording, velocity, 110 + i, 2.0);
    ASSERT_TRUE(recorder.writeAll(ms(200), unixOffset));
    ASSERT_TRUE(recorder.save(folder.file("kept.mcap"), {}));
    const auto loaded = loadRecording(folder.file("kept.mcap"));
    ASSERT_TRUE(loaded);
    EXPECT_EQ((*loaded)->telemetry->size({0}), 7U);
}

TEST(Export, ChannelsHaveTheUnitsOfTheirDeviceNotOfItsFamily)
{
    static constexpr std::array<Channel, 3> inCounts{
        {channels[0], channels[1], {"current", "counts", "Current", Quantity::Current}}};
    Family family{};
    family.key = "x";
    family.channels = inCounts;
    DeviceView device;
    device.family = &family;
    device.telemetry = telemetry(); // calibrated: in A
    const auto found = channelsOf(device, true);
    ASSERT_EQ(found.size(), 3U);
    EXPECT_EQ(found[current.value].unit, "A");
}

TEST(RollingRecorder, LetsGoOfWhatIsGoneOnceItIsOnTheDisk)
{
    const Folder folder;
    RollingRecorder recorder(rolling(folder, "run"));
    recorder.startKeeping();
    std::weak_ptr<Telemetry> first;
    for (int i = 0; i < 200; ++i) { // as a recording that is played from place to place
        const auto recording = telemetry();
        if (i == 0)
            first = recording;
        recorder.follow({{recording, velocity, "sim:can/dmc60c:5", "dmc60c", "velocity", "counts/s", {}, true}}, {});
        put(*recording, velocity, i * 500, 1.0);
        ASSERT_TRUE(recorder.write(ms(i * 500 + 50), unixOffset)); // this one still settles
    }
    EXPECT_TRUE(first.expired());
    EXPECT_EQ(recorder.samples(), 199U);
    recorder.follow({}, {});
    ASSERT_TRUE(recorder.write(ms(200 * 500), unixOffset));
    EXPECT_EQ(recorder.samples(), 200U);
    ASSERT_TRUE(recorder.save(folder.file("kept.mcap"), {}));
    const auto loaded = loadRecording(folder.file("kept.mcap"));
    ASSERT_TRUE(loaded);
    EXPECT_EQ((*loaded)->telemetry->size({0}), 200U);
}

} // namespace
} // namespace mb
