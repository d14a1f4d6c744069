// SPDX-License-Identifier: GPL-3.0-or-later
// What stands between two stretches of one channel: the computer slept, or another unit had its number.
#include "recording/exportcsv.h"
#include "recording/exportmcap.h"
#include "recording/loadrecording.h"
#include "recording/mcapreader.h"
#include "recording/rollingrecorder.h"
#include "recording/samplecursor.h"
#include "recordingfolder.h"
#include "signals.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>

namespace mb {
namespace {

using namespace test;

/// Since the time that is added, by the value of the sample.
std::map<double, Duration> timesOf(const LoadedRecording &loaded)
{
    std::map<double, Duration> times;
    SampleCursor cursor(loaded.telemetry, {0});
    while (const Point *point = cursor.peek()) {
        if (!point->isGap())
            times[point->value] = point->time - Instant(unixOffset);
        cursor.pop();
    }
    return times;
}

/// Asleep for an hour after 70 ms.
SleepLog hourAfter70ms()
{
    SleepLog sleeps;
    sleeps.look(ms(50), 5s);
    sleeps.look(ms(70), 5s);
    sleeps.look(ms(80), 3605s);
    return sleeps;
}

TEST(RecordedStretches, WhatCameAfterTheComputerSleptIsLaterByThatBehindAGapAndWhatCameBeforeIsNot)
{
    const Folder folder;
    const auto recording = telemetry();
    RollingRecorder recorder(rolling(folder, "run"));
    recorder.follow({{recording, velocity, "sim:can/dmc60c:5", "dmc60c", "velocity", "counts/s", {}, true}}, {});
    SleepLog sleeps;
    sleeps.look(ms(50), 5s);
    put(*recording, velocity, 10, 1.0);
    ASSERT_TRUE(recorder.write(ms(150), unixOffset, sleeps));
    put(*recording, velocity, 60, 2.0); // is not on disk yet when the computer sleeps
    put(*recording, velocity, 90, 3.0);
    put(*recording, velocity, 100, 4.0);
    for (int i = 0; i < 2; ++i)
        ASSERT_TRUE(recorder.writeAll(ms(300), unixOffset + 3600s, hourAfter70ms()));
    ASSERT_TRUE(recorder.save(folder.file("kept.mcap"), {}));
    const auto loaded = loadRecording(folder.file("kept.mcap"));
    ASSERT_TRUE(loaded);
    const std::map<double, Duration> expected{{1.0, 10ms}, {2.0, 60ms}, {3.0, 3600s + 90ms}, {4.0, 3600s + 100ms}};
    EXPECT_EQ(timesOf(**loaded), expected);
    const auto gaps = (*loaded)->telemetry->gaps({0}, Instant::min(), Instant::max());
    ASSERT_EQ(gaps.size(), 1U);
    EXPECT_EQ(gaps[0].to - Instant(unixOffset), 3600s + 90ms);
}

TEST(RecordedStretches, AGapIsKeptWhereverItFallsButBeforeTheFirstSample)
{
    const auto recording = telemetry();
    const auto gap = [&recording] {
        recording->breakLine(velocity);
        recording->commit();
    };
    for (int i = 0; i < 3 * 4096; ++i) {
        if (i % 1024 == 0)
            gap(); // before the first of a block that is read at once, too
        put(*recording, velocity, i, i);
    }
    for (const Instant from : {Instant::min(), ms(0), ms(1024)}) {
        SampleCursor cursor(recording, velocity, from);
        int gaps = 0;
        int samples = 0;
        while (const Point *const point = cursor.peek()) {
            ++(point->isGap() ? gaps : samples);
            cursor.pop();
        }
        const int left = from == ms(1024) ? 1024 : 0;
        EXPECT_EQ(samples, 3 * 4096 - left);
        EXPECT_EQ(gaps, (3 * 4096 - left) / 1024 - 1);
    }
}

TEST(RecordedStretches, AnExportAfterTheComputerSleptHasTheTimesOfBeforeAndAfter)
{
    const Folder folder;
    const auto recording = telemetry();
    put(*recording, velocity, 60, 2.0);
    put(*recording, velocity, 90, 3.0);
    ExportPlan plan;
    plan.channels = {{recording, velocity, "sim:can/dmc60c:5", "dmc60c", "velocity", "counts/s", {}, true}};
    plan.from = ms(60);
    plan.to = ms(100);
    plan.clock.sleeps = hourAfter70ms();
    plan.clock.offset = unixOffset - 5s; // the clock is the world's, which has been slept for before
    ASSERT_TRUE(exportMcap(plan, folder.file("a.mcap"), {}));
    const auto loaded = loadRecording(folder.file("a.mcap"));
    ASSERT_TRUE(loaded);
    const std::map<double, Duration> expected{{2.0, 60ms}, {3.0, 3600s + 90ms}};
    EXPECT_EQ(timesOf(**loaded), expected);
    ASSERT_TRUE(exportCsv(plan, folder.file("a.csv"), {}));
    std::ifstream file(folder.file("a.csv"));
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    EXPECT_NE(text.find("(Unix 1700000000.06)"), std::string::npos) << text;
    EXPECT_NE(text.find("\n0.000000,2\n3600.029999,nan\n3600.030000,3\n"), std::string::npos) << text;
}

TEST(RecordedStretches, AUnitThatTookAnothersNumberIsAChannelOfItsOwnWithItsOwnFacts)
{
    const Folder folder;
    const auto recording = telemetry();
    RollingRecorder recorder(rolling(folder, "run"));
    const auto follow = [&](const std::string &serial) {
        recorder.follow({{recording, velocity, "sim:can/dmc60c:5", "dmc60c", "velocity", "counts/s", {}, true, serial}},
            {{"device sim:can/dmc60c:5" + (serial.empty() ? "" : ' ' + serial), {{"serial", serial}}}});
    };
    const auto send = [&](std::int64_t milliseconds, double value) {
        put(*recording, velocity, milliseconds, value);
        EXPECT_TRUE(recorder.writeAll(ms(milliseconds), unixOffset));
    };
    follow({}); // it was found, and has not told who it is
    send(10, 1.0);
    follow("1");
    send(20, 1.0);
    follow({}); // it was restarted
    send(30, 1.0);
    recording->clear();
    follow("2");
    send(40, 2.0);
    send(50, 2.0);
    recording->clear();
    follow("1"); // and back
    send(60, 1.0);
    ASSERT_TRUE(recorder.save(folder.file("kept.mcap"), {}));
    const auto loaded = loadRecording(folder.file("kept.mcap"));
    ASSERT_TRUE(loaded);
    ASSERT_EQ((*loaded)->table.size(), 2U);
    EXPECT_EQ((*loaded)->table[0].key, "dmc60c:5 velocity");
    EXPECT_EQ((*loaded)->table[1].key, "dmc60c:5 velocity 2");
    const Telemetry &kept = *(*loaded)->telemetry;
    EXPECT_EQ(kept.size({0}), 4U);
    EXPECT_EQ(kept.size({1}), 2U);
    const auto gaps = kept.gaps({0}, Instant::min(), Instant::max());
    ASSERT_EQ(gaps.size(), 1U) << "while another had its number";
    EXPECT_EQ(gaps[0].to - Instant(unixOffset), 60ms);
    EXPECT_EQ((*loaded)->about.at("device sim:can/dmc60c:5 1").at("serial"), "1");
    EXPECT_EQ((*loaded)->about.at("device sim:can/dmc60c:5 2").at("serial"), "2");
}

/// What a joined file says of its channels, in its order: their serial numbers.
std::vector<std::string> serialsIn(const std::string &path)
{
    std::vector<std::string> serials;
    McapReader reader;
    reader.channel = [&serials](std::uint16_t, const std::string &, const mcap::Map &about) {
        serials.push_back(about.contains("serial") ? about.at("serial") : "none");
    };
    EXPECT_TRUE(reader.read(path));
    return serials;
}

/// A recorder of one velocity, and the units that come and go under one number.
class RecordedUnits : public testing::Test {
protected:
    void follow(const std::shared_ptr<Telemetry> &recording, const std::string &serial)
    {
        recorder.follow(
            {{recording, velocity, "sim:can/dmc60c:5", "dmc60c", "velocity", "counts/s", {}, true, serial}}, {});
    }
    void send(Telemetry &recording, std::int64_t milliseconds, double value)
    {
        put(recording, velocity, milliseconds, value);
        EXPECT_TRUE(recorder.writeAll(ms(milliseconds), unixOffset));
    }
    std::shared_ptr<const LoadedRecording> saved()
    {
        EXPECT_TRUE(recorder.save(folder.file("kept.mcap"), {}));
        return loadRecording(folder.file("kept.mcap")).value_or(nullptr);
    }
    Folder folder;
    std::shared_ptr<Telemetry> first = telemetry();
    std::shared_ptr<Telemetry> second = telemetry(); ///< its link was opened anew
    RollingRecorder recorder{rolling(folder, "run")};
};

TEST_F(RecordedUnits, AreNamedInWhatIsKeptThoughTheirSerialNumberCameLate)
{
    follow(first, {});
    send(*first, 10, 1.0);
    follow(first, "1");
    send(*first, 20, 1.0);
    send(*first, 2100, 1.0); // in the next file
    ASSERT_TRUE(saved());
    EXPECT_EQ(serialsIn(folder.file("kept.mcap")), std::vector<std::string>{"1"});
}

TEST_F(RecordedUnits, ThatAreNamedLateAreNotTheUnitBefore)
{
    follow(first, "1");
    send(*first, 10, 1.0);
    follow(second, {});
    send(*second, 20, 2.0);
    follow(second, "2");
    send(*second, 30, 2.0);
    const auto loaded = saved();
    ASSERT_TRUE(loaded);
    EXPECT_EQ(serialsIn(folder.file("kept.mcap")), (std::vector<std::string>{"1", "2"}));
    EXPECT_EQ(loaded->telemetry->size({0}), 1U);
    EXPECT_EQ(loaded->telemetry->size({1}), 2U);
}

TEST_F(RecordedUnits, ThatNeverTellWhoTheyAreAreNotTheUnitBeforeEither)
{
    follow(first, "1");
    send(*first, 10, 1.0);
    follow(second, {});
    send(*second, 20, 2.0);
    const auto loaded = saved();
    ASSERT_TRUE(loaded);
    EXPECT_EQ(serialsIn(folder.file("kept.mcap")), (std::vector<std::string>{"1", "none"}));
    ASSERT_EQ(loaded->table.size(), 2U);
    EXPECT_EQ(loaded->table[1].key, "dmc60c:5 velocity (2)");
    EXPECT_EQ(loaded->telemetry->size({0}), 1U);
}

} // namespace
} // namespace mb
