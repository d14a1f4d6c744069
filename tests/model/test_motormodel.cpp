// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of docs/names.md#motor-model; golden values from an independent RK4 integration with 2 µs steps.
#include "simulation/motormodel.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace mb;

constexpr double step = 100e-6;

/// Without what the golden run left out: heat and load-dependent loss.
MotorParameters plain(std::string_view name)
{
    MotorParameters parameters = *motorByName(name);
    parameters.thermal.reset();
    parameters.torqueLoss = 0.0;
    return parameters;
}

void run(MotorModel &motor, double duty, Bridge bridge, double seconds, double part = step)
{
    const int count = static_cast<int>(std::lround(seconds / part));
    for (int i = 0; i < count; ++i)
        motor.step(duty, bridge, part);
}

} // namespace

TEST(MotorParameters, AreFoundByName)
{
    for (const char *name : {"cim", "775pro", "rs775", "25d", "25dlp", "n20"}) {
        ASSERT_NE(motorByName(name), nullptr) << name;
        EXPECT_EQ(motorByName(name)->name, name);
    }
    EXPECT_EQ(motorByName("neo"), nullptr);
    EXPECT_EQ(motors().size(), 6U);
}

TEST(MotorParameters, FollowFromWhatVendorsPrint)
{
    struct Row {
        const char *name;
        double resistance, constant, friction, viscosity, frictionVolts;
    };
    for (const Row &row :
        {Row{"cim", 0.0902, 0.02114, 4.57e-2, 2.05e-5, 0.195}, Row{"775pro", 0.0896, 0.00609, 3.41e-3, 4.3e-7, 0.050},
            Row{"25d", 2.4, 0.01045, 2.51e-3, 5.8e-7, 0.576}, Row{"n20", 16.0, 0.00300, 1.92e-4, 1.3e-8, 1.024},
            Row{"rs775", 0.667, 0.018, 2.30e-2, 9.5e-6, 0.853}, Row{"25dlp", 13.33, 0.01906, 9.1e-4, 3.9e-7, 0.640}}) {
        const MotorParameters &p = *motorByName(row.name);
        EXPECT_NEAR(p.resistance / row.resistance, 1.0, 1e-3) << row.name;
        EXPECT_NEAR(p.constant / row.constant, 1.0, 2e-3) << row.name;
        EXPECT_NEAR(p.friction / row.friction, 1.0, 1e-2) << row.name;
        EXPECT_NEAR(p.viscosity / row.viscosity, 1.0, 5e-2) << row.name; // printed with two digits
        EXPECT_NEAR(p.resistance * p.friction / p.constant, row.frictionVolts, 2e-3) << row.name;
        EXPECT_GE(p.torqueLoss, 0.0) << row.name;
        EXPECT_LT(p.torqueLoss, 0.5) << row.name;
    }
}

TEST(MotorModel, RunsAtTheFreeSpeedOfItsDataSheet)
{
    for (const MotorParameters &motor : motors()) {
        MotorModel model(plain(motor.name), 1.0, {12.0, 0.0, 0.0});
        run(model, 1.0, Bridge::Drive, 2.0);
        EXPECT_NEAR(model.speed() / motor.rotorFreeSpeed(), 1.0, 1e-5) << motor.name;
        EXPECT_NEAR(model.current() / motor.freeCurrent, 1.0, 1e-4) << motor.name;
        EXPECT_NEAR(model.countSpeed(), motor.rotorFreeSpeed() * motor.countsPerTurn / (2 * std::numbers::pi),
            model.countSpeed() * 1e-5);
    }
}

TEST(MotorModel, MatchesTheGoldenStepOfTheCim)
{
    MotorModel model(plain("cim"), 1.0, {12.0, 0.02, 0.005});
    run(model, 0.5, Bridge::Drive, 0.06);
    EXPECT_NEAR(model.current(), 4.1227, 1e-4); // RK4: 4.1222
    EXPECT_NEAR(model.speed(), 264.537, 1e-3);  // RK4: 264.540
    EXPECT_NEAR(model.angle(), 11.7492, 1e-4);  // RK4: 11.7505
    EXPECT_NEAR(model.busVoltage(), 12.0 - 0.02 * 0.5 * model.current(), 1e-12);
    EXPECT_EQ(model.counts(), static_cast<std::int64_t>(std::floor(model.angle() * 4096 / (2 * std::numbers::pi))));
}

TEST(MotorModel, CutsLongStepsItself)
{
    MotorModel fine(plain("cim"));
    MotorModel coarse(plain("cim"));
    run(fine, 0.5, Bridge::Drive, 0.06);
    run(coarse, 0.5, Bridge::Drive, 0.06, 2e-3);
    EXPECT_NEAR(coarse.speed(), fine.speed(), 1e-9);
    EXPECT_NEAR(coarse.angle(), fine.angle(), 1e-9);
    coarse.step(0.5, Bridge::Drive, 0.0);
    EXPECT_NEAR(coarse.angle(), fine.angle(), 1e-9);
}

TEST(MotorModel, RunsTheSameBothWays)
{
    MotorModel forward(*motorByName("25d"), 5.0);
    MotorModel reverse(*motorByName("25d"), 5.0);
    run(forward, 0.7, Bridge::Drive, 0.3);
    run(reverse, -0.7, Bridge::Drive, 0.3);
    EXPECT_DOUBLE_EQ(forward.speed(), -reverse.speed());
    EXPECT_DOUBLE_EQ(forward.angle(), -reverse.angle());
    EXPECT_LT(reverse.counts(), 0);
}

TEST(MotorModel, AccountsForEveryJoule)
{
    for (const char *name : {"cim", "25d"}) {
        MotorParameters p = *motorByName(name);
        p.thermal.reset();
        const MotorSupply supply;
        constexpr double load = 5.0;
        MotorModel model(p, load, supply);
        double in = 0.0;
        double heat = 0.0;
        double rubbed = 0.0;
        constexpr double part = 2e-6;
        for (int i = 0; i < 300'000; ++i) {
            const double duty = i < 200'000 ? 0.8 : 0.1; // drives, then brakes into the battery
            model.step(duty, Bridge::Drive, part);
            const double current = model.current();
            const double w = std::abs(model.speed());
            in += supply.voltage * duty * current * part;
            heat += current * current * (p.resistance + supply.bridgeResistance + duty * duty * supply.resistance)
                * part;
            rubbed += (p.friction + p.torqueLoss * std::abs(p.constant * current) + p.viscosity * w) * w * part;
        }
        const double stored = 0.5 * p.inertia * load * model.speed() * model.speed()
            + 0.5 * p.inductance * model.current() * model.current();
        EXPECT_NEAR((heat + rubbed + stored) / in, 1.0, 2e-3) << name;
    }
}

TEST(MotorModel, GivesBackLessThanItHad)
{
    MotorModel model(plain("cim"), 9.0);
    run(model, 1.0, Bridge::Drive, 1.0);
    const double kinetic = 0.5 * 9.0 * model.parameters().inertia * model.speed() * model.speed();
    double back = 0.0;
    double highest = 0.0;
    for (int i = 0; i < 10'000; ++i) {
        model.step(0.3, Bridge::Drive, step);
        back -= std::min(0.0, model.supplyCurrent()) * model.busVoltage() * step;
        highest = std::max(highest, model.busVoltage());
    }
    EXPECT_GT(back, 0.0);
    EXPECT_LT(back, kinetic);
    EXPECT_GT(highest, 12.0); // it pumps the bus up
}

TEST(MotorModel, StaysStuckBelowTheBreakawayTorque)
{
    MotorModel model(plain("25d"), 5.0);
    run(model, 0.04, Bridge::Drive, 1.0); // kS is 0.576 V: 4.8 % of 12 V while moving
    EXPECT_TRUE(model.isStuck());
    EXPECT_EQ(model.speed(), 0.0);
    EXPECT_EQ(model.angle(), 0.0);
    EXPECT_NEAR(model.current(), 0.04 * 12.0 / 2.4, 0.01);
    run(model, 0.07, Bridge::Drive, 1.0);
    EXPECT_FALSE(model.isStuck());
    EXPECT_GT(model.speed(), 1.0);
    // A duty that could not start it keeps it going: friction at rest is greater.
    run(model, 0.0525, Bridge::Drive, 1.0);
    EXPECT_GT(model.speed(), 1.0);
    run(model, 0.0, Bridge::Drive, 1.0);
    EXPECT_EQ(model.speed(), 0.0);
    run(model, 0.0525, Bridge::Drive, 1.0);
    EXPECT_EQ(model.speed(), 0.0);
}

TEST(MotorModel, FrictionNeverTurnsAMotorAgainstItsTorque)
{
    for (const MotorParameters &motor : motors()) {
        for (double duty = 0.002; duty < 0.2; duty += 0.002) {
            MotorModel model(motor, 5.0);
            bool backwards = false;
            for (int i = 0; i < 2000 && !backwards; ++i) {
                model.step(duty, Bridge::Drive, step);
                backwards = model.angle() < 0.0 || model.speed() < 0.0;
            }
            EXPECT_FALSE(backwards) << motor.name << " at " << duty;
            EXPECT_TRUE(model.isStuck() || model.speed() > 0.0) << motor.name << " at " << duty;
        }
    }
}

TEST(MotorModel, BrakesMuchFasterThanItCoasts)
{
    MotorModel braked(plain("cim"), 9.0);
    MotorModel coasting(plain("cim"), 9.0);
    MotorModel shorted(plain("cim"), 9.0);
    for (MotorModel *model : {&braked, &coasting, &shorted})
        run(*model, 1.0, Bridge::Drive, 1.0);
    const double speed = braked.speed();
    run(braked, 1.0, Bridge::Brake, 0.2); // the duty does not count
    run(coasting, 1.0, Bridge::Coast, 0.2);
    run(shorted, 0.0, Bridge::Drive, 0.2);
    EXPECT_DOUBLE_EQ(braked.speed(), shorted.speed());
    EXPECT_LT(braked.speed(), 0.3 * speed);
    EXPECT_LT(braked.current(), -10.0);
    EXPECT_GT(coasting.speed(), 0.95 * speed);
    EXPECT_EQ(coasting.current(), 0.0);
    // Coasting slows by friction alone.
    const MotorParameters &p = coasting.parameters();
    const double torque = p.friction + p.viscosity * speed;
    EXPECT_NEAR(speed - coasting.speed(), torque / (9.0 * p.inertia) * 0.2, 0.05 * speed * 0.2);
    run(coasting, 0.0, Bridge::Coast, 20.0);
    EXPECT_EQ(coasting.speed(), 0.0);
    EXPECT_TRUE(coasting.isStuck());
}

TEST(MotorModel, ConductsThroughTheDiodesWhenItCoastsTooFast)
{
    MotorModel model(plain("cim"), 9.0);
    run(model, 1.0, Bridge::Drive, 1.0);
    ASSERT_TRUE(model.disturb("bus-voltage", 6.0));
    model.step(0.0, Bridge::Coast, 5e-3);
    EXPECT_LT(model.current(), 0.0);
    EXPECT_LT(model.supplyCurrent(), 0.0);
    run(model, 0.0, Bridge::Coast, 5.0);
    EXPECT_EQ(model.current(), 0.0);
    EXPECT_GE(model.speed(), 0.0);
}

TEST(MotorModel, DrawsTheStallCurrentWhenLocked)
{
    MotorModel model(plain("775pro"), 7.0, {12.0, 0.0, 0.0});
    run(model, 0.5, Bridge::Drive, 0.5);
    EXPECT_GT(model.speed(), 100.0);
    model.setLocked(true);
    const double angle = model.angle();
    run(model, 0.5, Bridge::Drive, 0.1);
    EXPECT_EQ(model.speed(), 0.0);
    EXPECT_EQ(model.angle(), angle);
    EXPECT_NEAR(model.current(), 67.0, 0.1);
    model.setLocked(false);
    run(model, 0.5, Bridge::Drive, 0.1);
    EXPECT_GT(model.speed(), 10.0);
}

TEST(MotorModel, SagsTheBatteryWithTheSupplyCurrent)
{
    MotorModel model(plain("cim"), 1.0, {12.0, 0.02, 0.005});
    model.setLocked(true);
    run(model, 1.0, Bridge::Drive, 0.1);
    EXPECT_NEAR(model.current(), 12.0 / (model.parameters().resistance + 0.025), 0.01);
    EXPECT_NEAR(model.busVoltage(), 12.0 - 0.02 * model.current(), 1e-9);
}

TEST(MotorModel, ReachesTheWindingLimitAtStallWhenItsHeatModelSays)
{
    struct Row {
        const char *name;
        double duty, seconds;
    };
    for (const Row &row : {Row{"cim", 1.0, 6.0}, Row{"cim", 0.5, 31.0}, Row{"775pro", 1.0, 2.1},
             Row{"775pro", 0.5, 9.6}, Row{"25d", 1.0, 13.7}}) {
        MotorModel model(*motorByName(row.name), 1.0, {12.0, 0.0, 0.0});
        model.setLocked(true);
        double seconds = 0.0;
        while (model.temperature() < 155.0 && seconds < 60.0) {
            model.step(row.duty, Bridge::Drive, 1e-3);
            seconds += 1e-3;
        }
        EXPECT_NEAR(seconds, row.seconds, 0.02 * row.seconds + 0.05) << row.name << " at " << row.duty;
        EXPECT_GT(model.housingTemperature(), 25.0);
    }
}

TEST(MotorModel, IsPulledByALoadTorque)
{
    MotorModel model(plain("25d"), 5.0);
    const MotorParameters &p = model.parameters();
    model.setLoadTorque(0.5 * p.breakaway * p.gearRatio);
    run(model, 0.0, Bridge::Coast, 0.1);
    EXPECT_EQ(model.angle(), 0.0);
    model.setLoadTorque(3.0 * p.breakaway * p.gearRatio);
    run(model, 0.0, Bridge::Coast, 0.1);
    EXPECT_LT(model.speed(), 0.0);
    run(model, 0.0, Bridge::Brake, 0.5);
    const double sinking = model.speed();
    EXPECT_LT(sinking, 0.0); // a brake slows a weight, it does not hold it
    run(model, 0.0, Bridge::Coast, 0.5);
    EXPECT_LT(model.speed(), 2.0 * sinking);
}

TEST(MotorModel, CountsBeyond32Bits)
{
    MotorParameters p = plain("cim");
    p.countsPerTurn = 1 << 30;
    MotorModel model(p);
    run(model, 1.0, Bridge::Drive, 0.5);
    EXPECT_GT(model.counts(), std::int64_t{1} << 33);
    EXPECT_EQ(model.counts(), static_cast<std::int64_t>(std::floor(model.countPosition())));
}

TEST(MotorModel, CountsDownwardsFromTheFirstTurnBack)
{
    MotorModel model(plain("cim"));
    for (int i = 0; i < 100 && model.angle() == 0.0; ++i)
        model.step(-0.3, Bridge::Drive, 20e-6);
    EXPECT_LT(model.angle(), 0.0);
    EXPECT_GT(model.angle(), -2 * std::numbers::pi / 4096);
    EXPECT_EQ(model.counts(), -1);
}

TEST(MotorModel, EncoderFaultsDoNotTouchTheMotor)
{
    MotorModel model(plain("cim"));
    run(model, 0.5, Bridge::Drive, 0.5);
    const std::int64_t before = model.counts();
    model.setEncoderReversed(true);
    EXPECT_NEAR(static_cast<double>(model.counts()), static_cast<double>(before), 1.0);
    run(model, 0.5, Bridge::Drive, 0.5);
    EXPECT_LT(model.counts(), before);
    EXPECT_GT(model.countSpeed(), 0.0);
    model.setEncoderDead(true);
    const std::int64_t dead = model.counts();
    run(model, 0.5, Bridge::Drive, 0.5);
    EXPECT_EQ(model.counts(), dead);
    EXPECT_GT(model.countPosition(), 2.0 * static_cast<double>(before));
    model.setEncoderDead(false);
    EXPECT_LT(model.counts(), dead);
}

TEST(MotorModel, WithBacklashTurnsFreelyUntilTheLoadIsTouched)
{
    MotorModel one(*motorByName("25d"), 5.0);
    MotorModel two(*motorByName("25d-backlash"), 5.0);
    run(one, 0.5, Bridge::Drive, 0.01);
    run(two, 0.5, Bridge::Drive, 0.01);
    EXPECT_GT(two.speed(), 3.0 * one.speed()) << "a fifth of the inertia";
    run(one, 0.5, Bridge::Drive, 2.0);
    run(two, 0.5, Bridge::Drive, 2.0);
    EXPECT_NEAR(two.speed() / one.speed(), 1.0, 0.02) << "together they end at the same speed";
    run(two, 0.0, Bridge::Brake, 2.0);
    EXPECT_NEAR(two.speed(), 0.0, 0.1);
}

TEST(MotorModel, IsTurnedByHandWithItsLoad)
{
    MotorModel motor(*motorByName("25d"), 5.0);
    ASSERT_TRUE(motor.disturb("backlash", 0.2));
    const double before = motor.countPosition();
    ASSERT_TRUE(motor.disturb("turn", 1.5));
    EXPECT_NEAR(
        motor.countPosition() - before, 1.5 * motor.parameters().countsPerTurn / (2.0 * std::numbers::pi), 1e-9);
    const double turned = motor.angle();
    motor.step(0.0, Bridge::Brake, 0.1); // its load came along, and does not push
    EXPECT_EQ(motor.angle(), turned);
    EXPECT_EQ(motor.speed(), 0.0);
}

TEST(MotorModel, WithSlipHoldsFirmlyAndLetsGo)
{
    const MotorParameters &p = *motorByName("cim-slip");
    const double volts = 2.0 * p.friction * p.resistance / p.constant; // less than it breaks away at
    MotorModel held(p, 9.0);
    run(held, volts / 12.0, Bridge::Drive, 0.5);
    EXPECT_DOUBLE_EQ(held.speed(), 0.0);
    MotorModel plain(*motorByName("cim"), 9.0);
    run(plain, volts / 12.0, Bridge::Drive, 0.5);
    EXPECT_GT(plain.speed(), 1.0);
    run(held, 0.5, Bridge::Drive, 2.0);
    run(plain, 0.5, Bridge::Drive, 2.0);
    EXPECT_NEAR(held.speed() / plain.speed(), 1.0, 0.01) << "at speed they are the same";
}
