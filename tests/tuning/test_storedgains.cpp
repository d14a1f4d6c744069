// SPDX-License-Identifier: GPL-3.0-or-later
// What the simulated drives of the bench store: gains with which a step goes well, before anybody has tuned them.
#include "simulation/motorparameters.h"
#include "tests/tuning/experimentbench.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace mb::tuning {
namespace {

using namespace mb::test;

struct StoredStep {
    int address;
    Mode mode;
    double to;
};

class StoredGains : public testing::TestWithParam<StoredStep> { };

TEST_P(StoredGains, OfABenchDriveStepWell)
{
    ExperimentBench bench("sim:can", "abstractdc", GetParam().address);
    const auto trial = bench.run(stepTo(GetParam().mode, GetParam().to));
    ASSERT_TRUE(trial) << trial.error().text();
    EXPECT_EQ(trial->reason, tuning::EndReason::Done);
    EXPECT_LE(trial->metrics.overshoot.value_or(1.0), 0.05);
    EXPECT_LE(std::abs(trial->metrics.sse.value_or(1.0)), 0.05);
    EXPECT_LE(trial->metrics.rise.value_or(9.0), 0.5);
}

std::string nameOf(const testing::TestParamInfo<StoredStep> &info)
{
    return std::to_string(info.param.address) + std::string(toString(info.param.mode))
        + std::to_string(static_cast<int>(info.param.to));
}

INSTANTIATE_TEST_SUITE_P(Bench, StoredGains,
    testing::Values(StoredStep{3, Mode::Velocity, 2000.0}, StoredStep{3, Mode::Velocity, 4000.0},
        StoredStep{3, Mode::Position, 1000.0}, StoredStep{3, Mode::Position, 2000.0},
        StoredStep{4, Mode::Velocity, 2000.0}, StoredStep{4, Mode::Position, 1000.0},
        StoredStep{5, Mode::Velocity, 1000.0}, StoredStep{5, Mode::Velocity, 2000.0},
        StoredStep{5, Mode::Position, 1000.0}, StoredStep{5, Mode::Position, 2000.0}),
    nameOf);

/// `motor=` and `load=` make any drive of these.
TEST(StoredGains, OfADriveWithAnotherMotorDoNotOvershoot)
{
    for (const char *const motor : {"cim", "rs775", "25d", "25dlp", "n20"}) {
        const MotorParameters &parameters = *motorByName(motor);
        const double full = parameters.rotorFreeSpeed() * parameters.countsPerTurn / (2.0 * std::numbers::pi);
        for (const char *const load : {"2", "5", "12"}) {
            ExperimentBench bench(
                "sim:can", "abstractdc", 3, "abstractdc:3,dialect=F,motor=" + std::string(motor) + ",load=" + load);
            for (const auto &[mode, share] : {std::pair(Mode::Velocity, 0.3), std::pair(Mode::Position, 0.1)}) {
                const auto trial = bench.run(stepTo(mode, std::round(share * full)));
                ASSERT_TRUE(trial) << motor << ' ' << load << ": " << trial.error().text();
                EXPECT_LE(trial->metrics.overshoot.value_or(1.0), 0.08) << motor << ' ' << load << toString(mode);
            }
        }
    }
}

TEST(TrialGains, WhatIsTriedBesideTheGainsOfItsLoopIsInTheTrialToo)
{
    test::ExperimentBench bench;
    ExperimentPlan plan = test::stepTo(Mode::Velocity, 60'000.0);
    plan.gains = {bench.change("slot1.p", 0.25), bench.change("current_limit.enabled", 1.0)};
    const auto trial = bench.run(plan);
    ASSERT_TRUE(trial && trial->reason == EndReason::Done);
    const std::map gains(trial->gains.begin(), trial->gains.end());
    EXPECT_EQ(gains.size(), trial->gains.size()) << "each key once";
    EXPECT_NEAR(gains.at("slot1.p").value_or(0.0), 0.25, 1e-4);
    EXPECT_EQ(gains.at("current_limit.enabled"), 1.0);
    EXPECT_TRUE(gains.contains("slot0.p"));
}

} // namespace
} // namespace mb::tuning
