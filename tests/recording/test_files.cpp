// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/exportcsv.h"
#include "recording/exportmcap.h"
#include "recording/loadrecording.h"
#include "recording/mcapwriter.h"
#include "recordingfolder.h"
#include "signals.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>

namespace mb {
namespace {

using namespace test;
namespace fs = std::filesystem;

std::string textOf(const std::string &path)
{
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Two channels with gaps, of one device.
struct Bench {
    std::shared_ptr<Telemetry> recording = telemetry();

    Bench()
    {
        std::mt19937 random(1);
        std::normal_distribution<double> noise;
        for (int i = 0; i < 2000; ++i) {
            if (i == 700)
                recording->lost(velocity, 84);
            if (i == 900)
                recording->breakLine(position);
            put(*recording, velocity, i, noise(random));
            if (i % 3 == 0)
                put(*recording, position, i, 1e15 + i);
        }
    }
    [[nodiscard]] ExportPlan plan() const
    {
        ExportPlan plan;
        for (const auto channel : {velocity, position})
            plan.channels.push_back({recording, channel, "sim:can/dmc60c:5", "dmc60c",
                std::string(channels[channel.value].key), std::string(channels[channel.value].unit), {}, true});
        plan.from = ms(0);
        plan.to = ms(10'000);
        plan.clock.offset = unixOffset;
        plan.about = {{"device sim:can/dmc60c:5", {{"serial", "SN 7"}, {"name", "lift, \"left\"\nside"}}},
            {"parameters sim:can/dmc60c:5", {{"slot0.p", "1.5"}}}};
        plan.notes = {{ms(500), "load pulse"}};
        return plan;
    }
};

void expectEqual(const Telemetry &actual, const Telemetry &expected, Duration shift)
{
    for (const auto channel : {velocity, position}) {
        std::vector<Point> a;
        std::vector<Point> b;
        const Instant end = Instant::max();
        (void)actual.read(channel, 0, end, 1'000'000, a);
        (void)expected.read(channel, 0, end, 1'000'000, b);
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t i = 0; i < a.size(); ++i) {
            ASSERT_EQ(a[i].isGap(), b[i].isGap()) << i;
            if (a[i].isGap())
                continue;
            ASSERT_EQ(a[i].value, b[i].value) << i;
            ASSERT_EQ(a[i].time, b[i].time + shift) << i;
        }
    }
}

TEST(Mcap, WhatWasWrittenReadsBackWithGapsLossAndFacts)
{
    const Folder folder;
    const Bench bench;
    const auto report = exportMcap(bench.plan(), folder.file("a.mcap"), {});
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_EQ(report->samples, 2667U);
    EXPECT_EQ(report->lost, 84U);
    const auto loaded = loadRecording(folder.file("a.mcap"));
    ASSERT_TRUE(loaded) << loaded.error().text();
    const LoadedRecording &recording = **loaded;
    expectEqual(*recording.telemetry, *bench.recording, unixOffset);
    EXPECT_EQ(recording.telemetry->lost(velocity), 84U);
    EXPECT_EQ(recording.table[0].key, "dmc60c:5 velocity");
    EXPECT_EQ(recording.table[1].unit, "counts");
    EXPECT_EQ(recording.table[0].quantity, Quantity::Velocity);
    EXPECT_EQ(recording.about.at("device sim:can/dmc60c:5").at("serial"), "SN 7");
    EXPECT_EQ(recording.about.at("parameters sim:can/dmc60c:5").at("slot0.p"), "1.5");
    EXPECT_EQ(recording.about.at("loss sim:can/dmc60c:5").at("velocity"), "84 of 2084");
    EXPECT_EQ(recording.about.at("note").at("text"), "load pulse");
    EXPECT_TRUE(recording.complete);
    EXPECT_TRUE(recording.simulated);
    EXPECT_FALSE(fs::exists(folder.file("a.mcap.part")));
}

TEST(Mcap, OfAFileThatIsTooLargeTheFirstSamplesAreReadAndItSaysSo)
{
    const Folder folder;
    ASSERT_TRUE(exportMcap(Bench().plan(), folder.file("a.mcap"), {}));
    const auto some = loadRecording(folder.file("a.mcap"), 1000);
    ASSERT_TRUE(some) << some.error().text();
    EXPECT_EQ(totalsOf(**some).samples, 1000U);
    EXPECT_TRUE((*some)->shortened);
    EXPECT_LT((*some)->last, ms(1000) + unixOffset);
    const auto all = loadRecording(folder.file("a.mcap"), 2667);
    ASSERT_TRUE(all) << all.error().text();
    EXPECT_EQ(totalsOf(**all).samples, 2667U);
    EXPECT_FALSE((*all)->shortened);
}

TEST(Mcap, WhatAFileTellsOfItselfHasABound)
{
    const Folder folder;
    ExportPlan plan = Bench().plan();
    for (int i = 0; i < 5; ++i)
        plan.about.emplace_back("much " + std::to_string(i), mcap::Map{{"text", std::string(15U << 20U, 'x')}});
    ASSERT_TRUE(exportMcap(plan, folder.file("a.mcap"), {}));
    const auto loaded = loadRecording(folder.file("a.mcap"));
    ASSERT_FALSE(loaded);
    EXPECT_NE(loaded.error().text().find("more than 64 MB"), std::string::npos) << loaded.error().text();
}

TEST(Csv, OfATableThatIsTooLargeTheFirstSamplesAreReadAndItSaysSo)
{
    const Folder folder;
    const auto write = [&](const std::string &head, const std::string &columns) {
        std::ofstream file(folder.file("a.csv"));
        file << head << '\n';
        for (int i = 0; i < 90; ++i)
            file << i << columns << '\n';
    };
    write("time_s,a,b", ",1,2");
    const auto wide = loadRecording(folder.file("a.csv"), 100);
    ASSERT_TRUE(wide) << wide.error().text();
    EXPECT_EQ(totalsOf(**wide).samples, 100U);
    EXPECT_TRUE((*wide)->shortened);
    EXPECT_FALSE((*loadRecording(folder.file("a.csv"), 180))->shortened);
    write("t,channel,value,unit", ",a,1,V");
    const auto rows = loadRecording(folder.file("a.csv"), 90);
    ASSERT_TRUE(rows) << rows.error().text();
    EXPECT_EQ(totalsOf(**rows).samples, 30U);
    EXPECT_TRUE((*rows)->shortened);
    EXPECT_FALSE((*loadRecording(folder.file("a.csv"), 270))->shortened);
}

TEST(Mcap, TopicsHaveNoOtherSignsThanLettersDigitsAndSlashes)
{
    ExportChannel channel{nullptr, velocity, "socketcan:can0/dmc60c:5", "dmc60c", "slot0.error", "", {}, false};
    EXPECT_EQ(channel.topic(), "/socketcan_can0/dmc60c_5/slot0/error");
    channel.device.clear();
    channel.key = "2*a/b";
    EXPECT_EQ(channel.topic(), "/derived/2_a/b");
}

/// For tests/recording/read_examples.py, which reads them with nothing of ours.
TEST(Examples, AreWrittenForOtherReaders)
{
    const Folder own;
    const char *wanted = std::getenv("MOTORBENCH_EXAMPLES");
    const fs::path folder = wanted ? fs::path(wanted) : own.path;
    const auto recording = telemetry();
    for (int i = 0; i < 1000; ++i) {
        if (i == 400)
            recording->lost(velocity, 7);
        put(*recording, velocity, i, std::sqrt(i));
        if (i % 4 == 0)
            put(*recording, position, i, -i);
    }
    ExportPlan plan = Bench().plan();
    for (ExportChannel &channel : plan.channels)
        channel.telemetry = recording;
    EXPECT_TRUE(exportMcap(plan, (folder / "example.mcap").string(), {}));
    EXPECT_TRUE(exportCsv(plan, (folder / "example.csv").string(), {}));
}

TEST(Mcap, AFileThatEndsAnywhereGivesWhatIsWhole)
{
    const Folder folder;
    const Bench bench;
    ASSERT_TRUE(exportMcap(bench.plan(), folder.file("whole.mcap"), {}));
    const std::string whole = textOf(folder.file("whole.mcap"));
    std::mt19937 random(3);
    std::uniform_int_distribution<std::size_t> place(0, whole.size() - 1);
    std::size_t most = 0;
    for (int i = 0; i < 200; ++i) {
        const std::size_t length = place(random);
        std::ofstream(folder.file("cut.mcap"), std::ios::binary) << whole.substr(0, length);
        const auto loaded = loadRecording(folder.file("cut.mcap"));
        if (!loaded) {
            EXPECT_NE(loaded.error().text().find("cut.mcap"), std::string::npos);
            continue;
        }
        const std::size_t samples = (*loaded)->telemetry->size(velocity);
        EXPECT_LE(samples, 2000U);
        most = std::max(most, samples);
    }
    EXPECT_GT(most, 1500U);
}

TEST(Mcap, DamagedFilesAreRefusedOrReadButNeverCrash)
{
    const Folder folder;
    const Bench bench;
    ASSERT_TRUE(exportMcap(bench.plan(), folder.file("whole.mcap"), {}));
    const std::string whole = textOf(folder.file("whole.mcap")).substr(0, 6000);
    std::mt19937 random(5);
    for (int i = 0; i < 400; ++i) {
        std::string damaged = whole;
        for (int j = 0; j < 3; ++j)
            damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
        std::ofstream(folder.file("bad.mcap"), std::ios::binary) << damaged;
        (void)loadRecording(folder.file("bad.mcap"));
    }
    EXPECT_FALSE(loadRecording(folder.file("missing.mcap")));
    std::ofstream(folder.file("text.mcap")) << "hello";
    EXPECT_FALSE(loadRecording(folder.file("text.mcap")));
}

TEST(Csv, WhatWasWrittenReadsBackWithGaps)
{
    const Folder folder;
    const Bench bench;
    ASSERT_TRUE(exportCsv(bench.plan(), folder.file("a.csv"), {}));
    const auto loaded = loadRecording(folder.file("a.csv"));
    ASSERT_TRUE(loaded) << loaded.error().text();
    expectEqual(*(*loaded)->telemetry, *bench.recording, unixOffset);
    EXPECT_TRUE((*loaded)->hasClock);
    EXPECT_TRUE((*loaded)->simulated);
    EXPECT_EQ((*loaded)->telemetry->lost({0}), 84U);
    EXPECT_EQ((*loaded)->telemetry->lost({1}), 0U);
    const std::string text = textOf(folder.file("a.csv"));
    EXPECT_EQ(text.find("# MotorBench recording\n# time_s 0 is 2023-11-14T22:13:20.000000Z (Unix 1700000000)\n"), 0U);
    for (const char *line : {"\n# device sim:can/dmc60c:5: serial = SN 7\n",
             "# parameters sim:can/dmc60c:5: slot0.p = 1.5\n", "# loss sim:can/dmc60c:5: velocity = 84 of 2084 lost\n",
             "# note 0.5 s: load pulse\n", "# simulated: dmc60c:5 velocity\n",
             "\ntime_s,dmc60c:5 velocity (counts/s),dmc60c:5 position (counts)\n0.000000,"})
        EXPECT_NE(text.find(line), std::string::npos) << line;
}

TEST(Csv, AJobThatIsEndedLeavesNothing)
{
    const Folder folder;
    const auto recording = telemetry();
    for (int i = 0; i < 50'000; ++i)
        recording->append({velocity, ms(i), 1.0});
    recording->commit();
    ExportPlan plan;
    plan.channels = {{recording, velocity, "sim:can/dmc60c:5", "dmc60c", "velocity", "", {}, false}};
    plan.to = ms(1'000'000);
    int asked = 0;
    const auto stop = [&](double part) {
        EXPECT_GE(part, 0.0);
        EXPECT_LE(part, 1.0);
        return ++asked < 2;
    };
    for (const auto &job : {exportCsv, exportMcap}) {
        asked = 0;
        const auto report = job(plan, folder.file("a"), stop);
        ASSERT_FALSE(report);
        EXPECT_EQ(report.error().fault, Fault::Cancelled);
        EXPECT_TRUE(fs::is_empty(folder.path));
        EXPECT_EQ(job(plan, "/nonexistent/a", {}).error().fault, Fault::OutOfRange);
    }
}

TEST(Table, WhatWatchPrintsCanBeRead)
{
    const Folder folder;
    std::ofstream(folder.file("w.csv"))
        << "t,channel,value,unit\n0.001,velocity,5,counts/s\n0.002,current,1.5,A\n0.003,velocity,6,counts/s\n";
    const auto loaded = loadRecording(folder.file("w.csv"));
    ASSERT_TRUE(loaded) << loaded.error().text();
    EXPECT_EQ((*loaded)->table.size(), 2U);
    EXPECT_EQ((*loaded)->telemetry->size({0}), 2U);
    EXPECT_FALSE((*loaded)->hasClock);
}

TEST(Table, SaysInWhichLineWhatIsWrong)
{
    const Folder folder;
    const std::pair<const char *, const char *> rows[] = {{"time_s,a\n0,1\n1,x\n", "line 3"},
        {"time_s,a\n0,1,2\n", "line 2"}, {"time_s,a\nx,1\n", "line 2"}, {"", "x.csv: the file is empty"},
        {"1,2\n3,4\n", "no table"}, {"time_s,a\n", "no samples"}, {"t,channel,value,unit\n1,a,2\n", "line 2"},
        {"time_s,a\n1e300,1\n", "line 2"}, {"time_s\n0\n", "no table"}};
    for (const auto &[text, says] : rows) {
        std::ofstream(folder.file("x.csv")) << text;
        const auto loaded = loadRecording(folder.file("x.csv"));
        ASSERT_FALSE(loaded) << text;
        EXPECT_NE(loaded.error().text().find(says), std::string::npos) << loaded.error().text();
    }
    EXPECT_FALSE(loadRecording(folder.path.string()));
}

TEST(Table, OfALastLineThatWasCutShortTheRestIsThereAndItSaysThatItsEndIsMissing)
{
    const Folder folder;
    for (const char *const text :
        {"t,channel,value,unit\n0.1,a,5,V\n0.2,a,6,V\n0.3,a,", "time_s,a,b\n0,1,2\n1,2,3\n1,2,-"}) {
        std::ofstream(folder.file("x.csv")) << text;
        const auto loaded = loadRecording(folder.file("x.csv"));
        ASSERT_TRUE(loaded) << loaded.error().text();
        EXPECT_FALSE((*loaded)->complete) << text;
        EXPECT_EQ((*loaded)->telemetry->size({0}), 2U + (text[1] == 'i' ? 1U : 0U)) << text;
    }
    std::ofstream(folder.file("x.csv")) << "time_s,a\n0,1\n1,2"; // of a spreadsheet
    const auto whole = loadRecording(folder.file("x.csv"));
    ASSERT_TRUE(whole) << whole.error().text();
    EXPECT_TRUE((*whole)->complete);
    EXPECT_EQ((*whole)->telemetry->size({0}), 2U);
}

TEST(Table, HasUpTo1000Columns)
{
    const Folder folder;
    const auto load = [&folder](int signals) {
        std::ofstream file(folder.file("x.csv"));
        for (const char *const each : {",a", ",1"}) {
            file << (each[1] == 'a' ? "time_s" : "0");
            for (int i = 0; i < signals; ++i)
                file << each;
            file << '\n';
        }
        file.close();
        return loadRecording(folder.file("x.csv"));
    };
    EXPECT_TRUE(load(999));
    const auto wide = load(1000);
    ASSERT_FALSE(wide);
    EXPECT_NE(wide.error().text().find("no table"), std::string::npos) << wide.error().text();
}

TEST(Table, ALineThatIsTooLongIsRefusedNotTakenForTheEnd)
{
    const Folder folder;
    const std::string tooLong((1U << 20U) + 1, '1');
    for (const std::string &head :
        {std::string("time_s,a\n0,1\n1,2\n"), std::string("t,channel,value,unit\n0,a,1,A\n"), std::string()}) {
        std::ofstream(folder.file("x.csv")) << head << tooLong << "\n3,4\n";
        const auto loaded = loadRecording(folder.file("x.csv"));
        ASSERT_FALSE(loaded) << head;
        EXPECT_NE(loaded.error().text().find("more than 1048576 bytes"), std::string::npos) << loaded.error().text();
    }
    std::ofstream(folder.file("y.csv")) << "time_s,a\n0,1\n1,2"; // no end of its last line
    ASSERT_TRUE(loadRecording(folder.file("y.csv")));
    EXPECT_EQ((*loadRecording(folder.file("y.csv")))->telemetry->size({0}), 2U);
}

} // namespace
} // namespace mb
