// SPDX-License-Identifier: GPL-3.0-or-later
// Where a motor comes to rest that a guard has stopped, of what its unit and its load make of a stop.
#include "experiment/announcement.h"
#include "tests/tuning/tuningbench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

namespace mb::tuning {
namespace {

using namespace std::chrono_literals;
using test::ExperimentBench;

/// Counts from its start, the farthest that the shaft went: true ones, also after the trial.
class Farthest {
public:
    explicit Farthest(ExperimentBench &bench)
        : m_bench(bench)
        , m_start(counts())
        , m_look(bench.bench.clock)
    {
        look();
    }
    [[nodiscard]] double reached() const { return m_most; }

private:
    [[nodiscard]] double counts() const { return m_bench.simulator()->position(); }
    void look()
    {
        m_most = std::max(m_most, std::abs(counts() - m_start));
        m_look.startIn(5ms, [this] { look(); });
    }

    ExperimentBench &m_bench;
    double m_start;
    Timer m_look;
    double m_most = 0.0;
};

ExperimentPlan pushOf(double duty, double travel)
{
    ExperimentPlan plan = test::stepTo(Mode::Duty, duty);
    plan.slot = 0;
    plan.seconds = 5.0;
    plan.limits.travel = travel;
    plan.limits.speed = 1e6;
    return plan;
}

/// Its unit would let it coast for ten times as far.
TEST(Travel, AStopThatEndsAnExperimentBrakesWhateverTheButtonOfADmc60cSays)
{
    ExperimentBench bench("sim:can", "dmc60c", 6, "dmc60c:6,motor=775pro,load=7,button=coast");
    const Farthest farthest(bench);
    const auto trial = bench.run(pushOf(0.25, 100'000.0));
    ASSERT_TRUE(trial) << trial.error().text();
    bench.bench.clock.advance(20s);
    std::printf("  %s: %.0f counts of 100000\n", std::string(toString(trial->reason)).c_str(), farthest.reached());
    EXPECT_EQ(trial->reason, tuning::EndReason::Travel) << trial->detail;
    EXPECT_LE(farthest.reached(), 100'000.0);
}

/// Braked it takes 0.6 s, four times what is counted where nobody knows.
TEST(Travel, OfAMotorWhoseLagIsKnownIsNotLeftByWhatRollsOn)
{
    ExperimentBench bench("sim:can", "dmc60c", 6, "dmc60c:6,motor=775pro,load=20");
    bench.directions.setLag(bench.device->selector(), 1, 0.61);
    const Farthest farthest(bench);
    const auto trial = bench.run(pushOf(0.5, 600'000.0));
    ASSERT_TRUE(trial) << trial.error().text();
    bench.bench.clock.advance(20s);
    std::printf("  %s: %.0f counts of 600000\n", std::string(toString(trial->reason)).c_str(), farthest.reached());
    EXPECT_EQ(trial->reason, tuning::EndReason::Travel) << trial->detail;
    EXPECT_LE(farthest.reached(), 600'000.0);
    EXPECT_GE(farthest.reached(), 400'000.0);
}

TEST(Travel, OfExperimentsThatShareTheirStartIsCountedFromThere)
{
    ExperimentBench bench("sim:can", "dmc60c", 6, "dmc60c:6,motor=775pro,load=7");
    std::optional<double> start;
    bench.surroundings.start = &start;
    const Farthest farthest(bench);
    ExperimentPlan push = pushOf(0.25, 100'000.0);
    push.seconds = 0.2;
    tuning::EndReason reason = tuning::EndReason::Done;
    int pushes = 0;
    for (; reason == tuning::EndReason::Done && pushes < 50; ++pushes) {
        const auto trial = bench.run(push);
        ASSERT_TRUE(trial) << trial.error().text();
        reason = trial->reason;
    }
    EXPECT_EQ(reason, tuning::EndReason::Travel);
    EXPECT_GT(pushes, 1) << "none goes so far by itself";
    EXPECT_LE(farthest.reached(), 100'000.0);
    ExperimentPlan step = test::stepTo(Mode::Velocity, 40'000.0);
    step.seconds = 1.0;
    step.limits.travel = 100'000.0;
    const auto refused = bench.run(step);
    ASSERT_FALSE(refused) << "what is left is too little";
    EXPECT_EQ(refused.error().fault, Fault::OutOfRange);
    step.to = -step.to;
    const auto back = bench.run(step);
    ASSERT_TRUE(back) << back.error().text();
    EXPECT_EQ(back->reason, tuning::EndReason::Done) << back->detail;
}

TEST(Travel, ATuningTellsTheExperimentsThatFollowHowSlowlyItsMotorStops)
{
    ExperimentBench bench("sim:can", "dmc60c", 6, "dmc60c:6,motor=775pro,load=20");
    TunePlan tuning = test::planOf(Mode::Velocity);
    tuning.propose = true;
    const auto report = test::tune(bench, tuning);
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_NEAR(bench.directions.lag(bench.device->selector(), 1), 0.66, 0.15);
    bench.directions.forget(bench.device->selector());
    EXPECT_EQ(bench.directions.lag(bench.device->selector(), 1), 0.0) << "another motor may hang there";
}

TEST(Travel, OfAPushThatIsToEndWithinAReachIsAnnouncedWithWhatASlowMotorRollsOn)
{
    ExperimentPlan plan;
    plan.mode = Mode::Duty;
    plan.reach = 1000.0;
    Trial trial;
    trial.stimulus = *Stimulus::make(Profile::Step, 0.0, 0.4, 1.0, 0.02);
    EXPECT_DOUBLE_EQ(extentOf(plan, trial, 0.0, 5000.0, 0.15).travel.value_or(0.0), 1250.0);
    EXPECT_DOUBLE_EQ(extentOf(plan, trial, 0.0, 5000.0, 0.7).travel.value_or(0.0), 1250.0 + 2000.0 * 0.5);
}

TEST(Travel, AFreshUnitOfTheBenchStillBrakesByItself)
{
    ExperimentBench bench("sim:can", "dmc60c", 6, "dmc60c:6,motor=775pro,load=7");
    const Farthest farthest(bench);
    const auto trial = bench.run(pushOf(0.25, 100'000.0));
    ASSERT_TRUE(trial) << trial.error().text();
    bench.bench.clock.advance(20s);
    EXPECT_LE(farthest.reached(), 100'000.0);
}

/// Something drives the shaft in the midst of the first proof, which takes most of what is left.
TEST(Minute, ASecondProofIsNotBegunForWhichItIsTooShort)
{
    ExperimentBench bench("sim:can", "dmc60c", 6, "dmc60c:6,motor=775pro,load=20");
    int proofs = 0;
    Timer striking(bench.bench.clock);
    bench.surroundings.note = [&](const Message &text) {
        if (!text.english().starts_with("proving"))
            return;
        ++proofs;
        striking.startIn(3500ms, [&] {
            EXPECT_TRUE(bench.simulator()->disturb("load-torque", -0.15));
            striking.startIn(500ms, [&] { EXPECT_TRUE(bench.simulator()->disturb("load-torque", 0.0)); });
        });
    };
    const auto report = test::tune(bench, test::planOf(Mode::Velocity));
    ASSERT_TRUE(report) << report.error().text();
    std::printf("  %.1f s, %s\n", report->seconds, report->evidence.english().c_str());
    EXPECT_EQ(report->result, TuneResult::RolledBack) << report->evidence;
    EXPECT_EQ(proofs, 1);
    EXPECT_NE(report->evidence.english().find("no time was left to prove others"), std::string::npos)
        << report->evidence;
}

} // namespace
} // namespace mb::tuning
