// SPDX-License-Identifier: GPL-3.0-or-later
// What a tuning tells beside the model: rest and latency, one way and the other, what set-points may ask for.
#include "simulation/motorparameters.h"
#include "tests/tuning/tuningbench.h"
#include "tuning/autotunerun.h"
#include "tuning/crosscheck.h"
#include "tuning/identification.h"
#include "tuning/proposals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>
#include <string_view>

namespace mb::tuning {
namespace {

using test::ExperimentBench;
using test::planOf;
using test::tune;
using test::TunePlan;

constexpr double sampleTime = 0.005;

/// A push of a motor of 50 000 counts/s per duty, 100 ms, 3 % friction, whose encoder trembles by `noise` counts, `late` after its order.
Trial pushed(double duty, double late, double noise, std::uint64_t seed)
{
    std::mt19937_64 random(seed);
    std::normal_distribution<double> tremble(0.0, noise > 0.0 ? noise : 1.0);
    Trial trial;
    trial.mode = Mode::Duty;
    trial.stimulus = *Stimulus::make(Profile::Step, 0.0, duty, 1.0, 0.02);
    trial.holds = {{0.0, 1.0}};
    Signal position{"position", "counts", {}};
    const double speed = 50'000.0 * (duty - std::copysign(0.03, duty));
    for (double t = -0.4; t < 1.0; t += sampleTime) {
        const double since = std::max(t - late, 0.0);
        const double place = speed * (since - 0.1 * (1.0 - std::exp(-since / 0.1)));
        position.trace.add(t, std::round(place + (noise > 0.0 ? tremble(random) : 0.0)));
    }
    trial.signals.push_back(std::move(position));
    return trial;
}

std::vector<Trial> pushes(double late, double noise)
{
    std::vector<Trial> all;
    std::uint64_t seed = 1;
    for (const double duty : {0.4, -0.4, 0.24, -0.24})
        all.push_back(pushed(duty, late, noise, seed++));
    return all;
}

/// What is wrong, and what of the refusal names it.
struct WrongPush {
    std::string_view gate;
    std::string_view says;
    std::function<void(MotorFound &, Trial &)> spoil;
};

TEST(Gates, OfThePushesFailEachByItselfAndTheRefusalSaysWhich)
{
    ExperimentBench bench("sim:can", "dmc60c", 5);
    const std::vector<WrongPush> all{{"fit", "residual 3.01 of what counts and clocks explain, at most 3",
                                         [](MotorFound &found, Trial &) { found.pushes.cost = 3.01; }},
        {"friction", "friction takes 15 % duty of pushes of 20 %",
            [](MotorFound &found, Trial &) { found.line.friction = 0.15; }},
        {"asymmetric load", "the two directions differ by 12 %, at most 10 %",
            [](MotorFound &found, Trial &) { found.line.forward = 1.128 * found.line.reverse; }},
        {"current limit", "the current limit cut into the pushes",
            [](MotorFound &, Trial &push) { push.flags.emplace_back(flag::currentLimit); }},
        {"current limit", "the current limit cut into the pushes", [](MotorFound &, Trial &push) {
             push.envelope.current = 10.0;
             push.metrics.peakCurrent = 9.9;
         }}};
    for (const auto &[gate, says, spoil] : all) {
        MotorFound found;
        found.pushes.cost = 1.0;
        found.line = {50'000.0, 0.03, 0.0, 0.0, 0.0, 0.0, 50'000.0, 50'000.0};
        std::vector<Trial> trials(2);
        for (Trial &push : trials)
            push.stimulus.to = 0.2;
        for (const Gate &good : gatesOf(found, trials))
            EXPECT_TRUE(good.passed) << good.name;
        spoil(found, trials.back());
        AutotuneRun run(
            *bench.device, bench.bench.session.stream(*bench.device), planOf(Mode::Velocity), bench.surroundings);
        const auto taken = run.take({found, {50'000.0, 0.1, 0.02, 0.03}, gatesOf(found, trials), {}});
        ASSERT_FALSE(taken) << gate;
        EXPECT_EQ(taken.error().fault, Fault::Refused);
        EXPECT_NE(taken.error().text().find(says), std::string::npos) << taken.error().text();
        for (const Gate &one : run.report().gates)
            EXPECT_EQ(one.passed, one.name != gate) << one.name;
    }
}

TEST(Findings, NoiseAtRestAndTheTimeFromAnOrderToItsMotion)
{
    for (const double late : {0.012, 0.06}) {
        for (const double noise : {0.0, 2.0}) {
            const auto found = identify(pushes(late, noise));
            ASSERT_TRUE(found) << found.error().text();
            ASSERT_TRUE(found->restNoise && found->latency);
            std::printf("late by %.0f ms, trembling by %.1f counts: %.0f ms, %.2f counts\n", 1e3 * late, noise,
                1e3 * *found->latency, *found->restNoise);
            EXPECT_NEAR(*found->restNoise, std::sqrt(noise * noise + (noise > 0.0 ? 1.0 / 12.0 : 0.0)), 0.25 * noise);
            EXPECT_GE(*found->latency, late);
            EXPECT_LE(*found->latency, late + 0.015);
        }
    }
}

TEST(Findings, WhatWasNotSeenIsNotTold)
{
    std::vector<Trial> all = pushes(0.02, 0.0);
    for (Trial &trial : all) {
        Trace &position = trial.signals.front().trace;
        position = position.part(-0.01, 1.0);
    }
    const auto found = identify(all);
    ASSERT_TRUE(found) << found.error().text();
    EXPECT_FALSE(found->restNoise) << "two samples tell no noise";
    EXPECT_TRUE(found->latency);
}

TEST(Findings, ATuningTellsBothDirectionsItsLoadAndWhatSetPointsMayAskFor)
{
    ExperimentBench bench("sim:can", "dmc60c", 5);
    TunePlan plan = planOf(Mode::Position);
    plan.slot = 1;
    plan.propose = true;
    const auto report = tune(bench, plan);
    ASSERT_TRUE(report) << report.error().text();
    ASSERT_TRUE(report->motor);
    const MotorFound &motor = *report->motor;
    EXPECT_NEAR(motor.line.forward, motor.line.gain, 0.02 * motor.line.gain);
    EXPECT_NEAR(motor.line.reverse, motor.line.gain, 0.02 * motor.line.gain);
    EXPECT_GT(motor.line.offsetError, 0.0);
    EXPECT_LE(std::abs(motor.line.offset), 2.0 * motor.line.offsetError + 1e-4);
    ASSERT_TRUE(motor.restNoise && motor.latency);
    EXPECT_LT(*motor.restNoise, 1.0);
    EXPECT_GT(*motor.latency, 0.0);
    EXPECT_LT(*motor.latency, 0.06);
    ASSERT_TRUE(report->profile);
    const PlantModel &plant = report->plant;
    const double duty = 1.0;
    EXPECT_NEAR(report->profile->speed, 0.8 * plant.gain * (duty - plant.friction), 1.0);
    EXPECT_NEAR(report->profile->acceleration, report->profile->speed / plant.tau, 1.0);
    for (const Proposal &proposal : report->proposals)
        EXPECT_EQ(proposal.profile, report->profile);
    std::printf("order to motion %.1f ms, profile %.0f counts/s, %.0f counts/s²\n", 1e3 * *motor.latency,
        report->profile->speed, report->profile->acceleration);
}

TEST(Findings, OfAUnitWithALittleDutyOfItsOwnNeedNoLimitGiven)
{
    for (const std::optional<double> speed : {std::optional<double>(), std::optional(50'000.0)}) {
        ExperimentBench bench("sim:can", "dmc60c", 5);
        const ParameterChange change = bench.change("slot0.max_forward", 3276.0);
        ASSERT_TRUE(test::run(bench.bench.clock, bench.device->write(change.index, change.raw)));
        TunePlan plan = planOf(Mode::Position);
        plan.propose = true;
        plan.limits.speed = speed;
        const auto report = tune(bench, plan);
        ASSERT_TRUE(report) << report.error().text();
        EXPECT_EQ(report->result, TuneResult::Proposed) << speed.value_or(0.0) << ": " << report->evidence;
        EXPECT_LE(report->motor ? report->plant.friction : 1.0, 0.1);
    }
}

const Gate *crossCheckOf(const std::vector<Gate> &gates)
{
    const auto found
        = std::find_if(gates.begin(), gates.end(), [](const Gate &gate) { return gate.name == "cross-check"; });
    return found == gates.end() ? nullptr : &*found;
}

TEST(CrossCheck, AgreesWithTheFitOnMotorsOfManyCounts)
{
    for (const char *const motor : {"cim", "775pro", "rs775"}) {
        ExperimentBench bench("sim:can", "dmc60c", 6, std::string("dmc60c:6,motor=") + motor + ",load=9");
        TunePlan plan = planOf(Mode::Velocity);
        plan.propose = true;
        const auto report = tune(bench, plan);
        ASSERT_TRUE(report) << report.error().text();
        const Gate *const gate = crossCheckOf(report->gates);
        ASSERT_NE(gate, nullptr) << motor;
        std::printf("%s, fitted %.0f ms: %s\n", motor, 1e3 * report->plant.tau, gate->detail.english().c_str());
        EXPECT_TRUE(gate->passed);
        EXPECT_FALSE(gate->warns) << gate->detail;
    }
}

TEST(CrossCheck, WarnsWhereThePushesAreNoneOfOneLagAndRefusesNothing)
{
    std::vector<Trial> all = pushes(0.012, 0.0);
    const auto clean = identify(all);
    ASSERT_TRUE(clean) << clean.error().text();
    MotorFound wrong = *clean;
    wrong.pushes.tau *= 1.3;
    const std::vector<Gate> gates = gatesOf(wrong, all);
    const Gate *const gate = crossCheckOf(gates);
    ASSERT_NE(gate, nullptr);
    EXPECT_TRUE(gate->passed) << "it decides nothing";
    EXPECT_TRUE(gate->warns);
    const std::vector<Gate> right = gatesOf(*clean, all);
    ASSERT_NE(crossCheckOf(right), nullptr);
    EXPECT_FALSE(crossCheckOf(right)->warns) << crossCheckOf(right)->detail;
}

TEST(CrossCheck, SaysNothingOfALagThatItCannotSee)
{
    PushFit quick;
    quick.tau = 0.03;
    quick.speeds = {9000.0};
    PushRecord record;
    record.duty = 0.3;
    for (int i = 0; i < 100; ++i)
        record.position.add(i * 0.01, i * 90.0);
    EXPECT_FALSE(lagByRegression(std::vector{record}, quick));
    EXPECT_FALSE(lagByRegression({}, quick));
}

/// What a model says that set-points may ask for is followed without an output at its end.
TEST(Findings, AMotorFollowsTheProfileThatItIsToldToFollow)
{
    const PlantModel plant{50'000.0, 0.2, 0.01, 0.05};
    const ProfileLimits limits = profileLimits(plant, 0.6);
    EXPECT_DOUBLE_EQ(limits.speed, 0.8 * 50'000.0 * 0.55);
    EXPECT_DOUBLE_EQ(limits.acceleration, limits.speed / 0.2);
    // at rest it can speed up so quickly, and at its speed it still has a fifth of the duty left
    EXPECT_LE(limits.acceleration * plant.tau / plant.gain + plant.friction, 0.6);
    EXPECT_LE(limits.speed / plant.gain + plant.friction, 0.6);
    EXPECT_DOUBLE_EQ(profileLimits(plant, 0.04).speed, 0.0);
}

/// L/R of 1.3 ms is in the delay where no wait for a pass hides it.
TEST(Findings, TheWindingIsSeenBehindADriveThatPutsADutyOutAtOnce)
{
    ExperimentBench bench("sim:can", "abstractdc", 3, "abstractdc:3,dialect=F,motor=rs775,load=5");
    TunePlan plan = planOf(Mode::Velocity);
    plan.keep = true;
    const auto report = tune(bench, plan);
    ASSERT_TRUE(report) << report.error().text();
    const MotorParameters &motor = *motorByName("rs775");
    const double winding = motor.inductance / motor.resistance;
    const double cycle = bench.device->family().loop->cycle;
    std::printf("delay %.2f ms of %.2f ms\n", 1e3 * report->plant.delay, 1e3 * (2.0 * cycle + winding));
    EXPECT_NEAR(report->plant.delay, 2.0 * cycle + winding, 0.0006); // one and a half passes, and half a window of one
}

TEST(Findings, FeedForwardIsWrittenAsZeroSoThatItDoesNotFightTheIntegral)
{
    ExperimentBench bench("sim:can", "dmc60c", 7);
    const auto report = tune(bench, planOf(Mode::Velocity));
    ASSERT_TRUE(report) << report.error().text();
    ASSERT_EQ(report->result, TuneResult::Kept) << report->evidence;
    for (const Proposal &proposal : report->proposals) {
        bool written = false;
        for (const ScaledGains::Row &row : proposal.gains.rows) {
            if (row.key == "slot0.f") {
                EXPECT_EQ(row.raw, 0);
                written = true;
            }
        }
        EXPECT_TRUE(written) << "one that is left there would fight the integral";
    }
    EXPECT_EQ(test::rawOf(bench, "slot0.f"), 0);
    EXPECT_EQ(test::rawOf(bench, "slot0.i_zone"), 0);
}

TEST(PushFindings, FramesOnTheirWayAreNoDelayOfTheLoop)
{
    const auto delayAt = [](const char *link) {
        ExperimentBench bench(link);
        TunePlan plan = planOf(Mode::Position);
        plan.slot = 1;
        plan.propose = true;
        const auto report = tune(bench, plan);
        EXPECT_TRUE(report) << link;
        return report ? report->plant.delay : 0.0;
    };
    const double atOneMegabit = delayAt("sim:can?bitrate=1000000");
    const double atAQuarter = delayAt("sim:can?bitrate=250000");
    std::printf("delay %.2f ms at 1 Mbit/s, %.2f ms at 250 kbit/s\n", 1e3 * atOneMegabit, 1e3 * atAQuarter);
    EXPECT_NEAR(atAQuarter, atOneMegabit, 0.4e-3); // of two frames 0.8 ms longer
}

} // namespace
} // namespace mb::tuning
