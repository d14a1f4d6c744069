// SPDX-License-Identifier: GPL-3.0-or-later
// Experiments as the engine's half runs them: kept, stopped at any phase. Virtual time.
#include "trialcore.h"

#include "async/noncopyable.h"
#include "storage/settingsbook.h"
#include "support/coreapplication.h"
#include "tuning/frequencyresponse.h"

#include <QTemporaryDir>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

namespace mb {
namespace {

using namespace std::chrono_literals;
using tuning::Keep;

/// What the engine writes is kept in a database, until this goes. Needs a core application.
struct KeptHistory : NonCopyable {
    KeptHistory(EngineCore &of, Clock &clock)
        : core(of)
        , database(Database::open(folder.path().toStdString() + "/motorbench.db").value())
        , book(*database, clock, "anna")
    {
        core.setSettingsLog(&book);
    }
    ~KeptHistory() { core.setSettingsLog(nullptr); }

    EngineCore &core;
    QTemporaryDir folder;
    std::unique_ptr<Database> database;
    SettingsBook book;
};

using test::TrialCore;

TEST_F(TrialCore, MeasuresBeforeTheMotorIsBackKeepsTheTrialAndTheGains)
{
    const std::int64_t before = stored();
    start(Keep::WhenDone);
    ASSERT_TRUE(ends());
    ASSERT_TRUE(*ended) << ended->error().detail;
    const tuning::Trial &trial = **ended;
    EXPECT_EQ(trial.reason, tuning::EndReason::Done) << trial.detail;
    EXPECT_TRUE(trial.stopped);
    EXPECT_EQ(trial.number, 1);
    ASSERT_EQ(measured.size(), 1U);
    ASSERT_TRUE(measured.front().second.metrics.settle);
    EXPECT_EQ(measured.front().second.metrics.rise, trial.metrics.rise);
    EXPECT_LT(measured.front().first, clock.now() - 200ms) << "not before the way back";
    EXPECT_EQ(journal.log, (std::vector<std::string>{"begin", "owe", "release", "complete"}));
    EXPECT_NE(before, 30'000);
    EXPECT_EQ(stored(), 30'000) << "what a done trial has written stays";
    EXPECT_FALSE(isOutputOn());
}

TEST_F(TrialCore, TunesAnOvershootingUnitInOneOrderAndAgainFromTheModelWithoutPushes)
{
    const std::int64_t before = stored();
    test::Heard<tuning::TuneReport> tuned;
    const auto tune = [this, &tuned](const tuning::TunePlan &plan) {
        tuned.reset();
        core.send(orders::RunTuning{id(), plan}, tuned.finished());
        return clock.runUntil([&tuned] { return tuned.has_value(); }, 120s) && *tuned;
    };
    tuning::TunePlan plan;
    plan.propose = true;
    ASSERT_TRUE(tune(plan));
    EXPECT_EQ((*tuned)->result, tuning::TuneResult::Proposed) << (*tuned)->evidence;
    ASSERT_EQ((*tuned)->proposals.size(), 3U);
    EXPECT_GT((*tuned)->proposals[0].design.response, (*tuned)->proposals[2].design.response) << "brisk is quicker";
    EXPECT_EQ(stored(), before) << "a proposal writes nothing";
    const std::size_t pushes = (*tuned)->trials.size();
    EXPECT_GE(pushes, 5U);

    plan.propose = false;
    plan.known = (*tuned)->plant;
    plan.taking = (*tuned)->taking;
    ASSERT_TRUE(tune(plan));
    EXPECT_EQ((*tuned)->result, tuning::TuneResult::Kept) << (*tuned)->evidence;
    EXPECT_GE((*tuned)->trials.size(), 2U) << "a step each way";
    EXPECT_LE((*tuned)->trials.size(), 4U) << "and once more where the proof bettered the gains, but no pushes";
    EXPECT_LT((*tuned)->measured.overshoot.value_or(1.0), 0.05);
    EXPECT_NE(stored(), before);
    EXPECT_FALSE(isOutputOn());
}

TEST_F(TrialCore, LinesOfATuningAreInTheLogWhenTheyAreSaidAndNormalProgressIsNoCaution)
{
    struct Line {
        Instant time;
        Severity severity;
        std::string text;
    };
    std::vector<Line> lines;
    const Subscription listening
        = core.noticed().add([this, &lines](Severity severity, const std::string &, const Message &text) {
              lines.push_back({clock.now(), severity, text.english()});
          });
    test::Heard<tuning::TuneReport> tuned;
    core.send(orders::RunTuning{id(), {}}, tuned.finished());
    ASSERT_TRUE(clock.runUntil([&tuned] { return tuned.has_value(); }, 120s) && *tuned);
    std::set<Instant> times;
    std::set<std::string> told;
    for (const Line &line : lines) {
        times.insert(line.time);
        EXPECT_NE(line.severity, Severity::Caution) << line.text;
        told.insert(line.text.substr(0, line.text.find(' ')));
    }
    EXPECT_EQ(told.count("pushing") + told.count("proving:"), 2U);
    EXPECT_GT(times.size(), 6U) << "each when it was said";
    EXPECT_LT(lines.front().time, clock.now() - 5s);
}

TEST_F(TrialCore, ATrialThatIsNotKeptIsACaution)
{
    journal.isFull = true;
    std::vector<std::string> cautions;
    const Subscription listening
        = core.noticed().add([&cautions](Severity severity, const std::string &, const Message &text) {
              if (severity == Severity::Caution)
                  cautions.push_back(text.english());
          });
    test::Heard<tuning::Trial> ran;
    tuning::ExperimentPlan plan;
    plan.mode = Mode::Velocity;
    plan.to = 20'000.0;
    core.send(orders::RunTrial{id(), plan, {}}, ran.finished());
    ASSERT_TRUE(clock.runUntil([&ran] { return ran.has_value(); }, 60s));
    EXPECT_EQ(cautions, std::vector<std::string>{"this trial is not kept: the disk is full"});
}

TEST_F(TrialCore, AStepThatWasHeldTooBrieflySaysHowFarItCame)
{
    std::string said;
    const Subscription listening
        = core.noticed().add([&said](Severity, const std::string &, const Message &text) { said = text.english(); });
    test::Heard<tuning::Trial> ran;
    tuning::ExperimentPlan plan;
    plan.mode = Mode::Velocity;
    plan.to = 60'000.0;
    plan.seconds = 0.05;
    core.send(orders::RunTrial{id(), plan, {}}, ran.finished());
    ASSERT_TRUE(clock.runUntil([&ran] { return ran.has_value(); }, 60s) && *ran);
    EXPECT_FALSE((*ran)->metrics.overshoot);
    EXPECT_TRUE(said.starts_with("trial #1: it came to ")) << said;
}

TEST_F(TrialCore, StopInATuningStopsTheMotorAndLeavesTheGainsAsTheyWere)
{
    const std::int64_t before = stored();
    for (const Duration moment : {5ms, 700ms, 3000ms, 8000ms, 14000ms}) {
        test::Heard<tuning::TuneReport> tuned;
        core.send(orders::RunTuning{id(), {}}, tuned.finished());
        clock.advance(moment);
        ASSERT_FALSE(tuned) << moment.count();
        core.stopAll(StopCause::User);
        clock.advance(5ms);
        EXPECT_FALSE(isOutputOn()) << moment.count();
        ASSERT_TRUE(clock.runUntil([&tuned] { return tuned.has_value(); }, 20s));
        EXPECT_TRUE(!*tuned || (*tuned)->result == tuning::TuneResult::Stopped) << moment.count();
        clock.advance(2s);
        EXPECT_FALSE(isOutputOn());
        EXPECT_EQ(stored(), before) << moment.count();
    }
}

TEST_F(TrialCore, AFrequencyResponseIsMeasuredSineBySineAndEndsWhereItsUserStopsIt)
{
    const tuning::PlantModel plant{1'285'000.0, 0.26, 0.0507, 0.002};
    Envelope limits;
    limits.duty = 1.0;
    limits.speed = 1'500'000.0;
    limits.travel = 2e7;
    auto plan = tuning::planSweep(plant, limits, 0.02);
    ASSERT_TRUE(plan) << plan.error().text();
    plan->hertz = {1.0, 2.0};
    test::Heard<tuning::FrequencyResponse> swept;
    const auto sweep = [&] {
        swept.reset();
        core.send(orders::RunSweep{id(), *plan, plant}, swept.finished());
    };
    sweep();
    ASSERT_TRUE(clock.runUntil([&swept] { return swept.has_value(); }, 120s));
    ASSERT_TRUE(*swept) << swept->error().text();
    EXPECT_TRUE((*swept)->stopReason == tuning::EndReason::None) << (*swept)->evidence;
    ASSERT_EQ((*swept)->points.size(), 2U) << (*swept)->evidence;
    for (const tuning::FrequencyPoint &point : (*swept)->points) {
        const double expected = plant.gain / std::hypot(1.0, 6.2832 * point.hertz * plant.tau);
        EXPECT_NEAR(point.magnitude, expected, 0.25 * expected) << point.hertz; // the model is a guess
        EXPECT_TRUE(point.trusted);
    }
    EXPECT_EQ((*swept)->trials.size(), 2U) << "each sine is a trial of the notebook";
    EXPECT_TRUE((*swept)->simulated);
    EXPECT_FALSE(isOutputOn());

    sweep();
    clock.advance(4s);
    ASSERT_FALSE(swept);
    core.stopAll(StopCause::User);
    clock.advance(5ms);
    EXPECT_FALSE(isOutputOn());
    ASSERT_TRUE(clock.runUntil([&swept] { return swept.has_value(); }, 20s));
    EXPECT_TRUE(!*swept || (*swept)->stopReason == tuning::EndReason::Interrupted);
}

TEST_F(TrialCore, StopAtAnyPhaseStopsTheMotorAndPutsGainsBack)
{
    const std::int64_t before = stored();
    for (const Duration moment : {0ms, 2ms, 20ms, 150ms, 400ms, 900ms, 1600ms, 2400ms}) {
        start(Keep::WhenDone);
        clock.advance(moment);
        ASSERT_FALSE(ended) << moment.count();
        core.stopAll(StopCause::User);
        clock.advance(5ms);
        EXPECT_FALSE(isOutputOn()) << moment.count();
        ASSERT_TRUE(ends());
        EXPECT_FALSE(isOutputOn()) << moment.count();
        EXPECT_TRUE(!*ended || (**ended).reason == tuning::EndReason::Interrupted) << moment.count();
        EXPECT_EQ(stored(), before) << moment.count();
        EXPECT_TRUE(journal.owed.empty()) << moment.count();
    }
}

TEST_F(TrialCore, HaltEndsItAndASecondOneIsRefusedMeanwhile)
{
    start(Keep::Never);
    clock.advance(1s);
    test::Heard<tuning::Trial> second;
    core.send(orders::RunTrial{id(), {}, {}}, second.finished());
    ASSERT_TRUE(second);
    EXPECT_EQ(second->error().fault, Fault::Unsafe);
    core.send(orders::StopMotion{id()});
    ASSERT_TRUE(ends());
    ASSERT_TRUE(*ended);
    EXPECT_EQ((**ended).reason, tuning::EndReason::Interrupted);
    EXPECT_TRUE((**ended).stopped);
}

TEST_F(TrialCore, NoSetPointOfAHandReachesAnExperimentNorWhatItPutsBack)
{
    SetPoint byHand;
    byHand.mode = Mode::Duty;
    byHand.target = 0.3;
    const auto isRefused = [&] {
        test::Heard<> started;
        test::Heard<> updated;
        core.send(orders::StartMotion{id(), byHand, 500ms}, started.finished());
        core.send(orders::UpdateMotion{id(), byHand}, updated.finished());
        return started && updated && !*started && !*updated && started->error().fault == Fault::Unsafe
            && updated->error().fault == Fault::Unsafe;
    };
    start(Keep::Never);
    ASSERT_TRUE(clock.runUntil([this] { return device()->liveness().moving; }, 10s));
    EXPECT_TRUE(isRefused());
    core.send(orders::StopMotion{id()});
    ASSERT_FALSE(ended) << "it still puts back what it has changed";
    EXPECT_TRUE(isRefused());
    ASSERT_TRUE(ends());
    ASSERT_TRUE(*ended);
    EXPECT_EQ((**ended).reason, tuning::EndReason::Interrupted);
    test::Heard<> started;
    core.send(orders::StartMotion{id(), byHand, 500ms}, started.finished());
    EXPECT_TRUE(started && *started) << "once it is over";
}

TEST_F(TrialCore, AWindowThatHangsEndsItByItsLease)
{
    start(Keep::Never);
    clock.advance(1s);
    renewal.stop();
    ASSERT_TRUE(ends());
    ASSERT_TRUE(*ended);
    EXPECT_EQ((**ended).reason, tuning::EndReason::User);
    EXPECT_FALSE(isOutputOn());
}

TEST_F(TrialCore, ALinkStaysOpenUntilATrialOnItHasPutBackWhatItChanged)
{
    const std::int64_t before = stored();
    start(Keep::Never);
    ASSERT_TRUE(clock.runUntil([this] { return isOutputOn(); }, 20s));
    test::Heard<> closed;
    core.send(orders::CloseLink{"sim:can"}, closed.finished());
    ASSERT_TRUE(closed && !*closed);
    EXPECT_EQ(closed->error().fault, Fault::Unsafe);
    EXPECT_TRUE(isOutputOn());
    ASSERT_TRUE(ends());
    EXPECT_EQ(ended->value().reason, tuning::EndReason::Done);
    EXPECT_EQ(stored(), before);
    core.send(orders::CloseLink{"sim:can"}, closed.finished());
    EXPECT_TRUE(*closed);
}

TEST_F(TrialCore, ATrialWhoseLinkWasLostAndIsClosedIsNobodysAnyMore)
{
    start(Keep::Never);
    ASSERT_TRUE(clock.runUntil([this] { return isOutputOn(); }, 20s));
    core.session().links().front()->close();
    core.send(orders::CloseLink{"sim:can"});
    EXPECT_EQ(std::count(journal.log.begin(), journal.log.end(), "abandon"), 1);
    EXPECT_EQ(std::count(journal.log.begin(), journal.log.end(), "complete"), 0);
}

/// So Ctrl+Z takes it back, and nobody calls it changed elsewhere.
TEST_F(TrialCore, WhatADoneTrialLeavesInForceIsInTheHistoryAndWhatItPutsBackIsNot)
{
    test::needCoreApplication();
    KeptHistory history(core, clock);
    const std::int64_t before = stored();
    const auto changes = [&] { return history.book.changes(unitKeyOf(*device())); };
    const std::size_t known = changes()->size();
    for (const Keep keep : {Keep::Never, Keep::WhenDone}) {
        EXPECT_EQ(changes()->size(), known);
        start(keep);
        ASSERT_TRUE(ends());
        ASSERT_TRUE(*ended) << ended->error().detail;
    }
    ASSERT_EQ(changes()->size(), known + 1);
    const auto all = *changes();
    const auto ours = std::max_element(
        all.begin(), all.end(), [](const auto &one, const auto &other) { return one.number < other.number; });
    EXPECT_EQ(ours->origin, settings::Origin::Window);
    ASSERT_EQ(ours->values.size(), 1U);
    EXPECT_EQ(ours->values.front().key, "slot0.p");
    EXPECT_EQ(ours->values.front().before, before);
    EXPECT_EQ(ours->values.front().after, 30'000);
}

TEST_F(TrialCore, ATuningThatNoNotebookCouldPutBackIsRefusedBeforeTheMotorTurns)
{
    test::needCoreApplication();
    KeptHistory history(core, clock);
    ASSERT_TRUE(history.database->run(
        "CREATE TRIGGER full BEFORE INSERT ON snapshot BEGIN SELECT RAISE(ABORT, 'database or disk is full'); END"));
    test::Heard<tuning::TuneReport> tuned;
    core.send(orders::RunTuning{id(), {}}, tuned.finished());
    ASSERT_TRUE(clock.runUntil([&] { return tuned.has_value() || isOutputOn(); }, 60s));
    EXPECT_FALSE(isOutputOn());
    ASSERT_TRUE(tuned && !*tuned);
    EXPECT_EQ(tuned->error().fault, Fault::NotKept) << tuned->error().text();
}

} // namespace
} // namespace mb
