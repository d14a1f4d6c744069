// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/deviceprofile.h"
#include "model/registry.h"
#include "simulation/motormodel.h"
#include "tuning/currentloop.h"
#include "tuning/currentsearch.h"

#include "tuning/gainsearch.h"
#include "tuning/margins.h"
#include "tuning/proposals.h"
#include "tuning/windingfit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

namespace mb::tuning {
namespace {

constexpr double loopPass = 0.5e-3;      // s
constexpr double readingStep = 0.031586; // A
constexpr double bridgeOhm = 0.005;      // Ohm
constexpr double inertiaRatio = 5.0;
constexpr double onItsWay = 0.15e-3; // s, of a sample on its way

/// A motor in a loop that looks every 0.5 ms and puts out at once.
class Winding {
public:
    Winding(const MotorParameters &motor, const ContinuousGains &gains, double noise, std::mt19937_64 &random)
        : m_motor(motor, inertiaRatio)
        , m_gains(gains)
        , m_noise(noise)
        , m_random(random)
    {
    }
    [[nodiscard]] double current() const { return m_motor.current(); }
    [[nodiscard]] double read()
    {
        return std::round(m_motor.current() / readingStep + m_noise * m_normal(m_random)) * readingStep;
    }
    void look(double target)
    {
        const double error = target - read();
        m_integral += m_gains.i * loopPass * error;
        m_motor.step(m_gains.p * error + m_integral, Bridge::Drive, loopPass);
    }

private:
    MotorModel m_motor;
    ContinuousGains m_gains;
    double m_noise; // steps of the readingStep
    std::mt19937_64 &m_random;
    std::normal_distribution<double> m_normal;
    double m_integral = 0.0;
};

double windingResistance(const MotorParameters &motor)
{
    return motor.resistance + bridgeOhm;
}

/// All of its winding but the lag, which is taken.
PlantModel windingPlant(const MotorParameters &motor)
{
    const double kept = motor.constant * (1.0 - motor.torqueLoss);
    PlantModel plant{motor.nominalVoltage / windingResistance(motor), 0.5e-3, 1.5 * loopPass, 0.0};
    plant.backDuty = motor.constant / motor.nominalVoltage; // a count is a radian here
    plant.pickUp = kept / (motor.inertia * inertiaRatio);
    plant.idle = motor.friction / kept;
    plant.reading = readingStep;
    plant.noise = 2.0 * readingStep;
    return plant;
}

double windingStep(const PlantModel &plant)
{
    return currentStep(plant.gain, {});
}

/// `count` steps each way, sampled every millisecond at any time of a loopPass: what was read in the last one.
SteppedLoop steppedWinding(const MotorParameters &motor, int count, double noise, int lostOrders = 0)
{
    const PlantModel plant = windingPlant(motor);
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    SteppedLoop all{currentRule(plant, 1.5e-3), {}, {}, 0.0};
    all.shape.period = loopPass;
    for (const double sign : {1.0, -1.0}) {
        Trial trial;
        trial.mode = Mode::Current;
        trial.stimulus.to = sign * windingStep(plant);
        Signal signal{"current", "A", {}};
        for (int i = 0; i < count; ++i) {
            const double from = 0.4 * i;
            trial.holds.push_back({from, from + 0.08});
            Winding winding(motor, all.gains, noise, random);
            double order = loopPass * share(random) + (i < lostOrders ? 0.02 : 0.0);
            double last = 0.0;
            for (double t = 1e-3 * share(random); t < 0.08; t += 1e-3) {
                for (; order < t; order += loopPass) {
                    last = winding.read();
                    winding.look(trial.stimulus.to);
                }
                signal.trace.add(from + t + onItsWay, last);
            }
        }
        trial.signals.push_back(std::move(signal));
        all.trials.push_back(std::move(trial));
    }
    return all;
}

double errorOfWinding(const MotorParameters &motor, const ContinuousGains &gains, double step)
{
    std::mt19937_64 random(1);
    Winding winding(motor, gains, 0.0, random);
    double itae = 0.0;
    for (double t = loopPass; t <= 0.08; t += loopPass) {
        winding.look(step);
        itae += t * std::abs(1.0 - winding.current() / step) * loopPass;
    }
    return itae;
}

double lagOfWinding(const MotorParameters &motor)
{
    return motor.inductance / windingResistance(motor);
}

TEST(CurrentLoopModel, TheErrorOfItsStepIsThatOfTheMotor)
{
    for (const char *const name : {"cim", "rs775", "25d", "n20"}) {
        const MotorParameters &motor = *motorByName(name);
        PlantModel plant = windingPlant(motor);
        plant.tau = lagOfWinding(motor);
        for (const double lambda : {1e-3, 2e-3}) {
            const ContinuousGains gains = currentRule(plant, lambda);
            const double step = windingStep(plant);
            const double model = errorOfCurrent(plant, gains, {}, step, 0.08, 1.0).itae;
            const double seen = errorOfWinding(motor, gains, step);
            std::printf("  %s: %.3g s² of the model, %.3g of the motor\n", name, model, seen);
            EXPECT_NEAR(model, seen, 0.08 * seen) << name;
        }
    }
}

TEST(WindingFit, StepsOfACurrentTellTheLagOfItsWinding)
{
    for (const char *const name : {"cim", "775pro", "rs775", "25d"}) {
        const MotorParameters &motor = *motorByName(name);
        const auto fit = fitWinding(steppedWinding(motor, 6, 2.0), windingPlant(motor));
        ASSERT_TRUE(fit);
        std::printf("  %s: L/R %.3f ms beside %.3f, +- %.0f %%, late by %.2f ms\n", name, 1e3 * fit->lag,
            1e3 * lagOfWinding(motor), 100.0 * fit->lagError, 1e3 * fit->late);
        EXPECT_NEAR(fit->lag, lagOfWinding(motor), 0.2 * lagOfWinding(motor)) << name;
        EXPECT_LT(fit->lagError, 0.4) << name;
    }
}

TEST(WindingFit, AStepWhoseOrderWasLostIsLeftOut)
{
    const MotorParameters &motor = *motorByName("rs775");
    const auto fit = fitWinding(steppedWinding(motor, 6, 2.0, 2), windingPlant(motor));
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->lag, lagOfWinding(motor), 0.2 * lagOfWinding(motor));
}

TEST(WindingFit, WhatNoiseHidesIsNotTakenForKnown)
{
    for (const char *const name : {"n20", "25dlp"}) {
        const MotorParameters &motor = *motorByName(name);
        EXPECT_FALSE(withWindingOf(steppedWinding(motor, 20, 2.0), windingPlant(motor))) << name;
        EXPECT_TRUE(withWindingOf(steppedWinding(motor, 20, 0.1), windingPlant(motor)))
            << name << " without noise is told";
    }
    EXPECT_FALSE(fitWinding({}, windingPlant(*motorByName("cim"))));
}

SearchTask currentTask(const PlantModel &plant)
{
    SearchTask task;
    task.bounds.largestError = task.step = windingStep(plant);
    task.shape.period = loopPass;
    task.overshoot = 0.03;
    return task;
}

TEST(CurrentSearch, LeavesLessErrorThanTheRuleWithinTheSensitivities)
{
    for (const char *const name : {"cim", "775pro", "rs775", "25d"}) {
        PlantModel plant = windingPlant(*motorByName(name));
        plant.tau = lagOfWinding(*motorByName(name));
        plant.lagDoubt = 0.12;
        const SearchTask task = currentTask(plant);
        const Design rule = design(Mode::Current, plant, 2e-3, task.bounds);
        const Design found = searched(Mode::Current, plant, rule, task);
        const double before = errorOfWinding(*motorByName(name), rule.gains, task.step);
        const double after = errorOfWinding(*motorByName(name), found.gains, task.step);
        std::printf("  %s: %.3g s² by the rule, %.3g by the search\n", name, before, after);
        EXPECT_LT(after, 0.85 * before) << name;
        EXPECT_TRUE(hasMargin(Mode::Current, plant, found.gains, 1.01 * task.mostMs, 1.01 * task.mostMsOff)) << name;
        EXPECT_TRUE(isWithin(found.gains, task.bounds)) << name;
        EXPECT_DOUBLE_EQ(errorOfSteps(Mode::Current, plant, found.gains, task),
            errorOfCurrent(plant, found.gains, task.shape, task.step, 0.08, 1.0).itae);
    }
}

TEST(CurrentSearch, KeepsTheBoundsOfItsTaskAndTheFewestStepsOfAGain)
{
    PlantModel plant = windingPlant(*motorByName("25d"));
    plant.tau = lagOfWinding(*motorByName("25d"));
    plant.lagDoubt = 0.12;
    const SearchTask task = currentTask(plant);
    const auto found = [&plant](const SearchTask &asked) {
        return searched(Mode::Current, plant, design(Mode::Current, plant, 2e-3, asked.bounds), asked).gains;
    };
    const ContinuousGains unbound = found(task);
    SearchTask weaker = task;
    weaker.bounds.strongestError = 0.9 * unbound.p * task.bounds.largestError;
    EXPECT_LE(found(weaker).p, 0.9 * unbound.p);
    SearchTask finer = task;
    finer.least.p = 1.05 * unbound.p;
    EXPECT_GE(found(finer).p, 1.05 * unbound.p);
}

TEST(CurrentSearch, AWindingThatNobodyHasSeenMayHaveAnyLagOfAMotor)
{
    const PlantModel plant = windingPlant(*motorByName("25d"));
    const SearchTask task = currentTask(plant);
    const Design found = searched(Mode::Current, plant, design(Mode::Current, plant, 2e-3, task.bounds), task);
    for (const double lag : {0.3e-3, 0.5e-3, 0.8e-3, 1.4e-3}) {
        PlantModel real = plant;
        real.tau = lag;
        EXPECT_TRUE(hasMargin(Mode::Current, real, found.gains, 1.01 * task.mostMs, 1.01 * task.mostMsOff)) << lag;
    }
    PlantModel seen = plant;
    seen.tau = 0.25e-3;
    seen.lagDoubt = 0.12;
    const Design surer = searched(Mode::Current, seen, design(Mode::Current, seen, 2e-3, task.bounds), task);
    PlantModel other = plant;
    other.tau = 1.4e-3;
    EXPECT_TRUE(hasMargin(Mode::Current, seen, surer.gains, 1.01 * task.mostMs, 1.01 * task.mostMsOff));
    EXPECT_FALSE(hasMargin(Mode::Current, other, surer.gains, task.mostMs, task.mostMsOff)) << "these need to be known";
}

TEST(CurrentSearch, NumbersAndCalmGainsAreThoseOfTheRule)
{
    const PlantModel plant = windingPlant(*motorByName("25d"));
    const DeviceProfile profile;
    const ProposalBasis basis{*findFamily(families(), "dmc60c"), profile, Mode::Current, 1, 0, plant, {}, {}};
    const auto asked = proposalFor(basis, {Aim::Normal, 2.5e-3, {}});
    const auto calm = proposalFor(basis, {Aim::Calm, {}, {}});
    const auto normal = proposalFor(basis, {Aim::Normal, {}, {}});
    ASSERT_TRUE(asked && calm && normal);
    EXPECT_EQ(asked->design.gains, currentRule(plant, 2.5e-3));
    EXPECT_EQ(calm->design.gains, currentRule(plant, responseOf(Mode::Current, Aim::Calm, plant)));
    EXPECT_GT(normal->design.gains.i, currentRule(plant, responseOf(Mode::Current, Aim::Normal, plant)).i);
}

} // namespace
} // namespace mb::tuning
