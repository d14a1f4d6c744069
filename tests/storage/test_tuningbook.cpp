// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/virtualclock.h"
#include "storage/trialbook.h"
#include "support/coreapplication.h"
#include "support/simulatedsession.h"
#include "support/sourcetree.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>

#include <chrono>
#include <limits>

namespace mb {
namespace {

using namespace tuning;

class KeptTunings : public testing::Test {
protected:
    KeptTunings()
    {
        test::needCoreApplication();
        clock.advance(std::chrono::hours(1000));
    }
    [[nodiscard]] std::unique_ptr<Database> open() const
    {
        auto opened = Database::open(path);
        EXPECT_TRUE(opened) << (opened ? "" : opened.error().text());
        return opened ? std::move(*opened) : nullptr;
    }
    [[nodiscard]] static Prediction prediction(int points)
    {
        Prediction predicted;
        for (int i = 0; i < points; ++i)
            predicted.measured.add(0.001 * i, 10.0 * i);
        predicted.metrics.overshoot = 0.01;
        return predicted;
    }
    [[nodiscard]] static TuneReport report()
    {
        TuneReport report;
        report.result = TuneResult::Kept;
        report.device = "sim:can/dmc60c:7";
        report.unit = "dmc60c 7";
        report.firmware = "1.23";
        report.simulated = true;
        report.evidence = say("the steps did what was predicted");
        report.plant = {105'000.0, 0.168, 0.052, 0.021};
        report.scale = TriedScale{1e-4, 2e-5, 1e-3, 40.0, 0.05, 3e-6, 31'000.0};
        MotorFound motor;
        motor.pushes.tauError = 0.002;
        motor.line.gainError = 120.0;
        motor.line.offset = 0.004;
        motor.line.offsetError = 0.002;
        motor.restNoise = 0.4;
        motor.latency = 0.013;
        motor.ramp = RampFound{
            {0.024, 0.001, 0.02, 0.0005, 104'000.0, 0.999}, {0.026, 0.001, 0.021, 0.0005, 103'000.0, 0.998}};
        motor.filter = VelocityFilter{VelocityFilter::Kind::Block, 0.1, 0.09, 0.1};
        report.motor = motor;
        report.gates = {{"fit", say("the fit leaves 1.4 times"), true, {}, true},
            {"resolution", say("12 counts"), false, say("go faster")}};
        Proposal normal;
        normal.design = {{1e-5, 2e-4, 0.0, 0.0}, 0.152, 0.12, {"largest error", "margin"}};
        normal.gains.rows = {{"slot0.p", 38083, 0.5811}, {"slot0.i", 113, 0.001724}};
        normal.gains.made = {1e-5, 2e-4, 0.0, 0.0};
        normal.margins = {1.44, std::numeric_limits<double>::infinity(), 67.0, 4.0};
        normal.predicted = prediction(5000);
        normal.predicted.shape.window = 0.1;
        normal.predicted.shape.isCounted = true;
        normal.step = 30'000.0;
        normal.profile = ProfileLimits{82'000.0, 490'000.0};
        report.proposals = {normal};
        report.design = normal.design;
        report.proposed = normal.gains;
        report.margins = normal.margins;
        report.predicted = normal.predicted;
        report.profile = normal.profile;
        report.before = {{"slot0.p", 1.165}, {"slot0.d", std::nullopt}};
        report.measured.overshoot = 0.013;
        report.notPutBack = say("slot0.p was not written");
        report.seconds = 38.2;
        report.trials = {1, 2};
        return report;
    }

    QTemporaryDir folder;
    std::string path = folder.path().toStdString() + "/motorbench.db";
    VirtualClock clock;
};

TEST_F(KeptTunings, WhatWasPredictedKeepsTheShapeOfItsLoop)
{
    const auto database = open();
    TrialBook book(*database, clock);
    ASSERT_TRUE(test::run(clock, book.keepTuning(report())));
    const auto found = book.tuningsOf("dmc60c 7");
    ASSERT_TRUE(found && found->size() == 1U);
    EXPECT_EQ(found->front().report.predicted->shape.window, 0.1);
    EXPECT_TRUE(found->front().report.predicted->shape.isCounted);
}

TEST_F(KeptTunings, ATuningComesBackWithItsModelProposalsAndProof)
{
    TuneReport kept = report();
    {
        const auto database = open();
        TrialBook book(*database, clock);
        for (int i = 0; i < 2; ++i) {
            Trial trial;
            trial.stimulus.to = i == 0 ? 30'000.0 : -30'000.0;
            trial.number = test::run(clock, book.begin(trial)).value_or(0);
            kept.proof.push_back(trial);
        }
        ASSERT_TRUE(test::run(clock, book.keepTuning(kept)));
        ASSERT_TRUE(book.remove(2));
    }
    const auto database = open();
    TrialBook book(*database, clock);
    EXPECT_TRUE(book.tuningsOf("dmc60c 5")->empty());
    const auto found = book.tuningsOf("dmc60c 7");
    ASSERT_TRUE(found) << found.error().text();
    ASSERT_EQ(found->size(), 1U);
    EXPECT_DOUBLE_EQ(found->front().time, 3'600'000.0);
    const TuneReport &back = found->front().report;
    EXPECT_EQ(back.result, kept.result);
    EXPECT_EQ(back.device, kept.device);
    EXPECT_EQ(back.firmware, kept.firmware);
    EXPECT_TRUE(back.simulated);
    EXPECT_EQ(back.evidence, kept.evidence);
    EXPECT_EQ(back.plant, kept.plant);
    EXPECT_EQ(back.scale, kept.scale);
    ASSERT_TRUE(back.motor && back.motor->filter);
    EXPECT_EQ(back.motor->filter->kind, VelocityFilter::Kind::Block);
    EXPECT_DOUBLE_EQ(back.motor->line.gainError, 120.0);
    EXPECT_DOUBLE_EQ(back.motor->line.offset, 0.004);
    EXPECT_DOUBLE_EQ(back.motor->line.offsetError, 0.002);
    EXPECT_EQ(back.motor->restNoise, kept.motor->restNoise);
    EXPECT_EQ(back.motor->latency, kept.motor->latency);
    EXPECT_EQ(back.motor->ramp, kept.motor->ramp);
    EXPECT_EQ(back.profile, kept.profile);
    ASSERT_EQ(back.gates.size(), 2U);
    EXPECT_TRUE(back.gates[0].warns);
    EXPECT_FALSE(back.gates[1].passed);
    EXPECT_FALSE(back.gates[1].warns);
    EXPECT_EQ(back.gates[1].remedy, "go faster");
    EXPECT_EQ(back.before, kept.before);
    EXPECT_EQ(back.notPutBack, kept.notPutBack);
    EXPECT_EQ(back.measured, kept.measured);
    EXPECT_EQ(back.trials, kept.trials);
    ASSERT_EQ(back.proposals.size(), 1U);
    const Proposal &normal = back.proposals.front();
    EXPECT_EQ(normal.design.bounds, kept.proposals.front().design.bounds);
    EXPECT_EQ(normal.gains.made, kept.proposals.front().gains.made);
    ASSERT_EQ(normal.gains.rows.size(), 2U);
    EXPECT_EQ(normal.gains.rows[0].raw, 38083);
    EXPECT_EQ(normal.profile, kept.profile);
    EXPECT_TRUE(std::isinf(normal.margins.gain));
    EXPECT_DOUBLE_EQ(normal.margins.ms, 1.44);
    EXPECT_LE(normal.predicted.measured.size(), 400U);
    EXPECT_GT(normal.predicted.measured.size(), 380U) << "thinned out no more than it must";
    EXPECT_DOUBLE_EQ(valueAt(normal.predicted.measured, 2.0), 20'000.0);
    ASSERT_EQ(back.proof.size(), 1U) << "the other trial was deleted";
    EXPECT_DOUBLE_EQ(back.proof.front().stimulus.to, 30'000.0);
}

/// The debt of before could not be taken out of the notebook when they were written.
TEST_F(KeptTunings, KnowWhichOfWhatIsOwedTheyHaveKept)
{
    const auto database = open();
    TrialBook book(*database, clock);
    const auto number = test::run(clock, book.begin(Trial()));
    ASSERT_TRUE(number);
    TuneReport kept = report();
    kept.trials = {*number};
    kept.proposed.rows = {{"slot0.i", 227}, {"slot0.p", 76'349}};
    ASSERT_TRUE(test::run(
        clock, book.owe(*number, kept.unit, {{"slot0.i", 100, 228}, {"slot0.p", 70'000, 76'349}, {"slot1.p", 1, 2}})));
    const auto owed = [&] { return test::run(clock, book.owedTo(kept.unit)).value().at(0).values; };
    for (const OwedValue &value : owed())
        EXPECT_FALSE(value.isKept) << value.key;
    ASSERT_TRUE(test::run(clock, book.keepTuning(kept)));
    ASSERT_EQ(owed().size(), 3U);
    EXPECT_FALSE(owed()[0].isKept) << "another trial has tried another since";
    EXPECT_TRUE(owed()[1].isKept);
    EXPECT_FALSE(owed()[2].isKept);
}

TEST_F(KeptTunings, ANotebookOfTheFirstSchemaKeepsItsTrialsAndTakesTunings)
{
    const std::string kept = inSourceTree("tests/storage/schemas/version-1.db");
    ASSERT_TRUE(QFile::copy(QString::fromStdString(kept), QString::fromStdString(path)));
    QFile::setPermissions(QString::fromStdString(path), QFile::ReadOwner | QFile::WriteOwner);
    ASSERT_TRUE(open());
    const auto database = open(); // which is of the newest version by now
    ASSERT_TRUE(database);
    TrialBook book(*database, clock);
    EXPECT_EQ(book.listOf("simulated dmc60c 210334E719F1")->size(), 1U);
    ASSERT_TRUE(test::run(clock, book.keepTuning(report())));
    EXPECT_EQ(book.tuningsOf("dmc60c 7")->size(), 1U);
}

TEST_F(KeptTunings, AReadOnlyNotebookOfTheFirstSchemaHasNoTunings)
{
    const auto database = open();
    ASSERT_TRUE(database->run("DROP TABLE tuning"));
    TrialBook book(*database, clock);
    const auto tunings = book.tuningsOf("dmc60c 7");
    ASSERT_TRUE(tunings) << tunings.error().text();
    EXPECT_TRUE(tunings->empty());
}

} // namespace
} // namespace mb
