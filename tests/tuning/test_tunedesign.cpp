// SPDX-License-Identifier: GPL-3.0-or-later
// What a tuning does with gains of which two sets were proven, by steps whose errors are known.
#include "model/family.h"
#include "model/loopparameters.h"
#include "tests/tuning/tuningbench.h"
#include "tuning/autotunerun.h"
#include "tuning/simulatedloop.h"
#include "tuning/tunedesign.h"

#include <gtest/gtest.h>

namespace mb::tuning {
namespace {

using test::ExperimentBench;
using test::planOf;

/// A step of a velocity that comes to its target after `late` s at once.
Trial lateStep(double late, double aim)
{
    Trial trial;
    trial.mode = Mode::Velocity;
    trial.stimulus.to = aim;
    trial.holds = {{0.0, 1.0}};
    Signal velocity{"ch1.velocity", "counts/s", {}};
    for (int i = 0; i <= 1000; ++i)
        velocity.trace.add(0.001 * i, i < 2 ? 1.0 : 0.001 * i < late ? 0.0 : aim);
    trial.signals = {velocity};
    return trial;
}

/// What these gains do with another motor, both ways: held for a second, and half of one on the way back.
std::vector<Trial> stepsOf(const PlantModel &plant, const TuneReport &report, double step)
{
    std::vector<Trial> trials;
    for (const double sign : {1.0, -1.0}) {
        Trial trial = lateStep(0.0, sign * step);
        trial.returns = {{1.0, 1.5}};
        Trace &velocity = trial.signals.front().trace;
        velocity = {};
        const LoopShape shape = withoutClock(report.predicted->shape);
        SimulatedLoop motor(Mode::Velocity, plant, report.proposed.made, shape, 0.0);
        for (double t = -0.05; t < 1.5; t += shape.period) {
            (void)motor.pass(t >= 0.0 && t < 1.0 ? sign * step : 0.0);
            velocity.add(t, motor.measured());
        }
        trials.push_back(std::move(trial));
    }
    return trials;
}

/// A design of a motor that nothing has moved, with steps of normal gains as its proof; others stand in the unit.
struct ProvenDesign {
    explicit ProvenDesign(TunePlan plan = planOf(Mode::Velocity))
        : run(*bench.device, bench.bench.session.stream(*bench.device), plan, bench.surroundings)
        , design(run)
    {
        run.report().plant = {362'000.0, 0.168, 0.051, 0.02};
        EXPECT_TRUE(test::run(bench.bench.clock, design.propose()));
        if (run.report().proposals.size() != 3U)
            return;
        proven = run.report().proposed.made;
        former = run.report().proposals.back().gains.made; // the brisk ones
        const Family &family = bench.device->family();
        for (const std::string_view name : loopOf(family, plan.loop)->names) { // what a slot has beside them is 0
            const std::string key
                = gainKey(family, std::string(loopOf(family, plan.loop)->prefix) + std::string(name), 1, 0);
            run.report().before.emplace_back(key, 0.0);
            for (const auto &row : run.report().proposals.back().gains.rows) {
                if (row.key == key)
                    run.report().before.back().second = row.number;
            }
        }
        prove(0.4, 0.4);
    }
    void prove(double there, double back)
    {
        run.report().proof = {lateStep(there, run.report().step), lateStep(back, -run.report().step)};
        run.report().result = TuneResult::Kept;
        run.report().evidence = say("done");
    }
    [[nodiscard]] bool isBegunAnew() const
    {
        const TuneReport &report = run.report();
        return report.proof.empty() && report.result == TuneResult::Refused && report.evidence.empty();
    }

    ExperimentBench bench;
    AutotuneRun run;
    TuneDesign design;
    ContinuousGains proven;
    ContinuousGains former;
};

TEST(TuneDesign, GainsThatWereThereAreTriedOnceAndKeptWhereTheirStepsLeaveLess)
{
    ProvenDesign tested;
    EXPECT_FALSE(tested.design.recallFormer(61.0));
    EXPECT_EQ(tested.design.story().english(), "there was no time to compare them with those that were there");
    EXPECT_TRUE(tested.design.isPromising()) << "nothing is held beside it";
    ASSERT_TRUE(tested.design.recallFormer(59.0));
    EXPECT_TRUE(tested.isBegunAnew());
    EXPECT_EQ(tested.run.report().proposed.made, tested.former);
    EXPECT_TRUE(tested.design.isPromising()) << "nothing was seen of it";
    const auto promises = [&tested](double late) {
        tested.run.report().proof = {lateStep(late, tested.run.report().step)};
        return tested.design.isPromising();
    };
    EXPECT_TRUE(promises(0.4 * 1.04)) << "1.08 of the error, which the other way may make up for";
    EXPECT_FALSE(promises(0.4 * 1.06));
    tested.prove(0.9, 0.9);
    EXPECT_TRUE(tested.design.isPromising()) << "both ways together tell";
    tested.prove(0.3, 0.3);
    tested.design.takeTheBetter();
    EXPECT_EQ(tested.run.report().proposed.made, tested.former);
    EXPECT_TRUE(tested.design.isFormer());
    EXPECT_FALSE(tested.design.recallFormer(10.0));
    EXPECT_NE(tested.design.story().english().find("which were there, leave 56"), std::string::npos)
        << tested.design.story().english(); // 0.3² of 0.4²
}

TEST(TuneDesign, GainsThatWereThereAreGivenUpWhereTheirStepsLeaveMore)
{
    ProvenDesign tested;
    ASSERT_TRUE(tested.design.recallFormer(10.0));
    tested.prove(0.41, 0.41);
    tested.design.takeTheBetter();
    EXPECT_EQ(tested.run.report().proposed.made, tested.proven);
    EXPECT_EQ(tested.run.report().proof.size(), 2U);
    EXPECT_FALSE(tested.design.isFormer());
    EXPECT_NE(tested.design.story().english().find("those that were there leave more error"), std::string::npos);
}

TEST(TuneDesign, WhatWasRolledBackIsNotKeptHoweverLittleItsStepsLeft)
{
    ProvenDesign tested;
    ASSERT_TRUE(tested.design.recallFormer(10.0));
    tested.prove(0.1, 0.1);
    tested.run.report().result = TuneResult::RolledBack;
    tested.design.takeTheBetter();
    EXPECT_EQ(tested.run.report().proposed.made, tested.proven);
    EXPECT_EQ(tested.run.report().result, TuneResult::Kept);
    EXPECT_FALSE(tested.design.isFormer());
    tested.design.takeTheBetter(); // nothing is held any more
    EXPECT_EQ(tested.run.report().proposed.made, tested.proven);
    EXPECT_EQ(tested.run.report().proof.size(), 2U);
}

TEST(TuneDesign, AfterAFailureTheCalmGainsComeOnceWhereNothingCorrectsTheModel)
{
    ProvenDesign tested;
    tested.run.report().evidence = say("it did not settle");
    tested.run.report().proof.clear(); // nothing that tells of the motor
    const auto again = [&tested] {
        const Result<bool> other = test::run(tested.bench.bench.clock, tested.design.reconsider());
        return other && *other;
    };
    EXPECT_TRUE(again());
    EXPECT_TRUE(tested.isBegunAnew());
    EXPECT_EQ(tested.run.report().proposed.made, tested.run.report().proposals.front().gains.made);
    EXPECT_EQ(tested.design.before().english(), "the normal gains did not: it did not settle");
    EXPECT_EQ(tested.design.story().english(), "these are the calm gains, the normal gains did not: it did not settle");
    EXPECT_FALSE(again());
}

TEST(TuneDesign, StepsOfAnotherMotorCorrectTheModelBothAfterAFailureAndAfterAProof)
{
    for (const bool failed : {true, false}) {
        ProvenDesign tested;
        const PlantModel thought = tested.run.report().plant;
        PlantModel other = thought;
        other.tau *= 1.25;
        tested.run.report().proof = stepsOf(other, tested.run.report(), tested.run.report().step);
        tested.run.report().evidence = say("it overshot");
        const Result<bool> again = failed ? test::run(tested.bench.bench.clock, tested.design.reconsider())
                                          : test::run(tested.bench.bench.clock, tested.design.sharpen(10.0));
        ASSERT_TRUE(again && *again) << failed;
        EXPECT_TRUE(tested.isBegunAnew()) << "nothing of the first proof counts for the second";
        const PlantModel &corrected = tested.run.report().plant;
        EXPECT_NEAR(corrected.gain / corrected.tau, other.gain / other.tau, 0.05 * other.gain / other.tau);
        EXPECT_EQ(tested.design.before().empty(), !failed);
        if (failed) {
            EXPECT_EQ(tested.design.before().english(), "the normal gains of the first model did not: it overshot");
        }
    }
}

TEST(TuneDesign, WhatIsComparedWithAProofMakesTheSameStep)
{
    ProvenDesign tested;
    PlantModel other = tested.run.report().plant;
    other.gain *= 1.2; // of which a step of its own would be larger
    other.tau *= 1.3;
    const double step = tested.run.report().step;
    tested.run.report().proof = stepsOf(other, tested.run.report(), step);
    const Result<bool> again = test::run(tested.bench.bench.clock, tested.design.sharpen(10.0));
    ASSERT_TRUE(again && *again);
    EXPECT_GT(tested.run.report().plant.gain, 1.1 * other.gain / 1.2);
    EXPECT_EQ(tested.run.report().step, step);
}

TEST(TuneDesign, NumbersThatWereAskedForAreNotChanged)
{
    TunePlan plan = planOf(Mode::Velocity);
    plan.response = 0.1;
    ProvenDesign tested(plan);
    EXPECT_FALSE(tested.design.recallFormer(10.0));
    const Result<bool> again = test::run(tested.bench.bench.clock, tested.design.reconsider());
    EXPECT_TRUE(again && !*again);
    const Result<bool> sharper = test::run(tested.bench.bench.clock, tested.design.sharpen(10.0));
    EXPECT_TRUE(sharper && !*sharper);
    EXPECT_EQ(tested.run.report().proof.size(), 2U);
}

} // namespace
} // namespace mb::tuning
