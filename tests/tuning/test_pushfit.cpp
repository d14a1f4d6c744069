// SPDX-License-Identifier: GPL-3.0-or-later
// A motor on a battery with a resistance of its own, whose winding warms from push to push.
#include "simulation/motormodel.h"
#include "tuning/plantfit.h"
#include "tuning/refinement.h"
#include "tuning/simulatedloop.h"
#include "tuning/windingheat.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace mb::tuning {
namespace {

constexpr double fineFit = 0.0005;
constexpr double loadFactor = 7.0;

/// Of this motor at 25 °C, at a duty.
double lagOf(const MotorParameters &motor, double duty, double supply, double load = loadFactor)
{
    const double kept = motor.constant * (1.0 - motor.torqueLoss);
    const double resistance = motor.resistance + 0.005 + duty * duty * supply;
    return resistance * motor.inertia * load / kept / (motor.constant + resistance * motor.viscosity / kept);
}

/// Pushes of two sizes both ways, twice each, each braked to a stop before the next; one motor makes them all.
std::vector<PushRecord> pushesOf(
    const MotorParameters &parameters, double supply, double seconds, double load = loadFactor)
{
    MotorModel motor(parameters, load, MotorSupply{12.0, supply, 0.005});
    std::vector<PushRecord> records;
    double heat = 0.0;
    for (int i = 0; i < 8; ++i) {
        PushRecord record;
        record.duty = (i / 2 % 2 == 0 ? 1.0 : -1.0) * (i < 4 ? 0.4 : 0.24);
        record.heat = heat + 0.25 * record.duty * record.duty;
        heat += record.duty * record.duty;
        int step = 0;
        for (double t = 0.0; t < seconds; t += fineFit, ++step) {
            if (step % 20 == 0)
                record.position.add(t, static_cast<double>(motor.counts()));
            motor.step(record.duty, Bridge::Drive, fineFit);
        }
        motor.step(0.0, Bridge::Brake, 1.2 * load / loadFactor);
        records.push_back(std::move(record));
    }
    return records;
}

Result<GainFit> lineOf(const std::vector<PushRecord> &records, const PushFit &fit)
{
    std::vector<double> duties;
    for (const PushRecord &record : records)
        duties.push_back(record.duty);
    return fitGain(duties, fit.speeds);
}

TEST(PushFit, TellsASaggingSupplyAndAWarmingWindingFromTheMotor)
{
    for (const char *const name : {"cim", "775pro"}) {
        for (const double supply : {0.02, 0.05}) {
            const MotorParameters &motor = *motorByName(name);
            const double tau = lagOf(motor, dutyOfLag, supply);
            const auto records = pushesOf(motor, supply, 5.0 * tau);
            const auto fit = fitPushes(records);
            ASSERT_TRUE(fit) << fit.error().text();
            const double whole = lagOf(motor, 1.0, supply);
            std::printf("%s, %.2f Ohm: lag %.4f s of %.4f s, at full duty %.4f s of %.4f s, warming %.3f\n", name,
                supply, fit->tau, tau, fit->tau * sagged(fit->sag, 1.0), whole, fit->warming);
            EXPECT_NEAR(fit->tau, tau, 0.02 * tau) << name << ' ' << supply; // 7 % more with one lag for all
            EXPECT_NEAR(fit->tau * sagged(fit->sag, 1.0), whole, 0.08 * whole) << name << ' ' << supply;
            EXPECT_GT(fit->warming, 0.0);
            const auto line = lineOf(records, *fit);
            ASSERT_TRUE(line) << line.error().text();
            const double friction
                = (motor.resistance + 0.005) * motor.friction / motor.constant / (1.0 - motor.torqueLoss) / 12.0;
            EXPECT_NEAR(line->friction, friction, 0.003) << name << ' ' << supply;
        }
    }
}

TEST(PushFit, AMotorWithoutAnyOfItHasOneLag)
{
    const MotorParameters &motor = *motorByName("rs775"); // which has no heat, and 40 times the resistance
    const auto fit = fitPushes(pushesOf(motor, 0.0, 5.0 * lagOf(motor, dutyOfLag, 0.0)));
    ASSERT_TRUE(fit) << fit.error().text();
    EXPECT_LT(fit->sag, 0.01);
    EXPECT_LT(fit->warming, 0.01);
}

TEST(PushFit, AMotorThatWarmsIsNotTakenForOneWhoseOrderWasLost)
{
    const MotorParameters &motor = *motorByName("775pro");
    const double load = 12.0; // whose lag grows by more than an order may be late
    const double tau = lagOf(motor, dutyOfLag, 0.05, load);
    std::vector<PushRecord> records = pushesOf(motor, 0.05, 5.0 * tau, load);
    for (const double late : {0.0, 0.02}) { // and one whose order was
        for (double &t : records[2].position.t)
            t += late;
        const auto fit = fitPushes(records);
        ASSERT_TRUE(fit) << fit.error().text();
        std::printf("lag %.4f s of %.4f s, delay %.2f ms, cost %.3f\n", fit->tau, tau, 1e3 * fit->delay, fit->cost);
        EXPECT_NEAR(fit->tau, tau, 0.01 * tau) << late; // 2.7 % more with records taken for late
        EXPECT_LT(fit->delay, 0.001) << late;
        EXPECT_LT(fit->cost, 0.1) << late;
    }
}

/// Two steps of a velocity from rest and the ways back, as the proof of a tuning records them, by a motor with so much heat.
Trial warmSteps(const PlantModel &plant, const SteppedLoop &loop, double step, double heat)
{
    constexpr double hold = 0.8;
    Trial trial;
    trial.mode = Mode::Velocity;
    trial.stimulus.to = step;
    trial.holds = {{0.0, hold}, {2.0 * hold, 3.0 * hold}};
    trial.returns = {{hold, 2.0 * hold}, {3.0 * hold, 4.0 * hold}};
    SimulatedLoop simulated(Mode::Velocity, warmed(plant, heat), loop.gains, loop.shape, 0.0);
    Signal velocity{"velocity", "counts/s", {}};
    double t = -0.05;
    for (double at = t; at < 4.0 * hold; at += 0.01) {
        for (; t < at; t += loop.shape.period)
            (void)simulated.pass(t >= 0.0 && std::fmod(t, 2.0 * hold) < hold ? step : 0.0);
        velocity.trace.add(at, simulated.measured());
    }
    trial.signals.push_back(velocity);
    return trial;
}

TEST(Refinement, StepsOfAWarmMotorMakeNoSlowerMotorOfTheColdOne)
{
    PlantModel plant{1.29e6, 0.287, 0.051, 0.007};
    plant.warming = 0.13;
    SteppedLoop loop;
    loop.gains = {1.8e-6, 5.6e-6, 0.0, 0.0};
    loop.heat = 1.5;
    loop.trials = {warmSteps(plant, loop, 385'000.0, 1.6)};
    const PlantModel corrected = refinedBy(loop, plant).value_or(plant);
    std::printf("lag %.4f s of %.4f s, gain %.0f of %.0f\n", corrected.tau, plant.tau, corrected.gain, plant.gain);
    EXPECT_NEAR(corrected.tau, plant.tau, 0.02 * plant.tau);
    EXPECT_NEAR(corrected.gain, plant.gain, 0.012 * plant.gain);
    loop.heat = 0.0;
    ASSERT_TRUE(refinedBy(loop, plant)) << "a cold one is not so slow";
    EXPECT_GT(refinedBy(loop, plant)->tau, 1.1 * plant.tau);
}

TEST(WindingHeat, HalfOfWhatAPushOfFullDutyLeavesIsThereWhenItHasSpedUp)
{
    const PlantModel plant{10'000.0, 0.1, 0.001, 0.0};
    const LoopShape shape;
    SimulatedLoop loop(Mode::Velocity, plant, {1.0, 0.0, 0.0, 0.0}, shape, 0.0); // at its limit
    double heat = 0.0;
    for (double t = 0.0; t < 1.0; t += shape.period) {
        const double before = loop.speed();
        const double duty = loop.pass(1e9);
        heat += heatOf(plant, duty, 0.5 * (before + loop.speed()), shape.period);
    }
    EXPECT_NEAR(heat, 0.5, 0.01);
}

/// Duties that are led up in steps of 0.08 every 20 ms.
std::vector<PushRecord> ledPushesOf(const MotorParameters &parameters, double seconds)
{
    const double kept = parameters.constant * (1.0 - parameters.torqueLoss);
    const double friction = (parameters.resistance + 0.005) * parameters.friction / kept / 12.0;
    std::vector<PushRecord> records;
    for (const double duty : {0.4, -0.4, 0.24, -0.24}) {
        MotorModel motor(parameters, loadFactor, MotorSupply{12.0, 0.0, 0.005});
        PushRecord record;
        record.duty = duty;
        const int count = static_cast<int>(std::lround(std::abs(duty) / 0.08));
        double felt = 0.0;
        for (int i = 0; i < count; ++i) { // friction takes its part of the first
            const double feels = std::max(0.08 * (i + 1) - friction, 0.0) / (std::abs(duty) - friction);
            record.steps.push_back({0.02 * i, feels - felt});
            felt = feels;
        }
        int step = 0;
        for (double t = 0.0; t < seconds; t += fineFit, ++step) {
            if (step % 20 == 0 && (step == 0 || t >= 0.02 * count))
                record.position.add(t, static_cast<double>(motor.counts()));
            motor.step(duty * std::min(step / 40 + 1, count) / count, Bridge::Drive, fineFit);
        }
        records.push_back(std::move(record));
    }
    return records;
}

TEST(PushFit, ADutyThatCameInStepsTellsLagAndWindingAsOneThatCameAtOnce)
{
    const MotorParameters &motor = *motorByName("cim");
    const double tau = lagOf(motor, dutyOfLag, 0.0);
    std::vector<PushRecord> records = ledPushesOf(motor, 5.0 * tau);
    const auto fit = fitPushes(records);
    ASSERT_TRUE(fit) << fit.error().text();
    const double winding = motor.inductance / (motor.resistance + 0.005);
    std::printf("lag %.4f s of %.4f s, delay %.2f ms, L/R %.2f ms\n", fit->tau, tau, 1e3 * fit->delay, 1e3 * winding);
    EXPECT_NEAR(fit->tau, tau, 0.008 * tau);
    EXPECT_NEAR(fit->delay, winding, 0.0002);
    for (PushRecord &record : records) { // the same, as if all of it had come at once in the mean
        double mean = 0.0;
        for (const DutyStep &step : record.steps)
            mean += step.share * step.at;
        for (double &t : record.position.t)
            t -= mean;
        record.steps.clear();
    }
    const auto atOnce = fitPushes(records);
    ASSERT_TRUE(atOnce) << atOnce.error().text();
    EXPECT_LT(atOnce->delay, 0.3 * winding) << "its lag takes all of it";
}

TEST(SimulatedLoop, ALargeDutySpeedsAMotorOnAWeakBatteryUpLater)
{
    PlantModel plant{10'000.0, 0.1, 0.001, 0.0};
    plant.sag = 0.5;
    LoopShape shape;
    shape.period = 0.0005;
    const auto after = [&](double duty, double seconds) {
        SimulatedLoop loop(Mode::Velocity, plant, {1e6, 0.0, 0.0, 0.0}, shape, 0.0); // at its limit
        LoopShape limited = shape;
        limited.mostDuty = duty;
        loop = SimulatedLoop(Mode::Velocity, plant, {1e6, 0.0, 0.0, 0.0}, limited, 0.0);
        for (double t = 0.0; t < seconds - 1e-9; t += shape.period)
            (void)loop.pass(1e9);
        return loop.value() / (10'000.0 * duty);
    };
    EXPECT_NEAR(after(dutyOfLag, 0.1), 1.0 - std::exp(-1.0), 1e-3);
    EXPECT_NEAR(after(1.0, 0.1), 1.0 - std::exp(-1.0 / sagged(0.5, 1.0)), 1e-3);
}

} // namespace
} // namespace mb::tuning
