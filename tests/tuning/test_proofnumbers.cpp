// SPDX-License-Identifier: GPL-3.0-or-later
// What a proof reckons with: steps, errors at rest, and the worse of its trials.
#include "model/family.h"
#include "model/registry.h"
#include "support/simulatedsession.h"
#include "tuning/adviser.h"
#include "tuning/modelnumbers.h"
#include "tuning/proof.h"
#include "tuning/uncertainty.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mb::tuning {
namespace {

const Family &provenFamily(std::string_view key)
{
    return **std::find_if(families().begin(), families().end(), [key](const Family *f) { return f->key == key; });
}

TEST(ProofNumbers, AStepOfAPositionIsClearOfFrictionAndOfItsCountsAndWithinItsTravel)
{
    const PlantModel plant{50'000.0, 0.1, 0.0, 0.05};
    const auto stepWith
        = [&plant](double p, const Envelope &envelope) { return proofStep(Mode::Position, plant, {p}, envelope); };
    Envelope envelope;
    envelope.travel = 1e9;
    EXPECT_DOUBLE_EQ(stepWith(0.0002, envelope), 0.5 / 0.0002); // half of all, by P alone; ten times 0.05/p is as much
    const PlantModel stiff{50'000.0, 0.1, 0.0, 0.08};
    EXPECT_DOUBLE_EQ(proofStep(Mode::Position, stiff, {0.0002}, envelope), 10.0 * 0.08 / 0.0002);
    EXPECT_DOUBLE_EQ(stepWith(0.1, envelope), 400.0); // a hundred times what is good enough
    EXPECT_DOUBLE_EQ(stepWith(0.0, envelope), 400.0);
    envelope.travel = 1000.0;
    EXPECT_DOUBLE_EQ(stepWith(0.0002, envelope), 600.0);
    envelope.travel = 1e9;
    envelope.duty = 0.8;
    const PlantModel easy{50'000.0, 0.1, 0.0, 0.01};
    EXPECT_DOUBLE_EQ(proofStep(Mode::Position, easy, {0.0002}, envelope), 2000.0);
    envelope.duty = 0.005; // less than friction takes
    EXPECT_EQ(proofStep(Mode::Velocity, easy, {}, envelope), 0.0);
}

TEST(ProofNumbers, WithoutAnIntegralFrictionHoldsWhatPDoesNotOvercome)
{
    const LoopShape exact;
    const PlantModel plant{50'000.0, 0.1, 0.0, 0.05};
    using Below = RestingError::Below;
    const RestingError held = restingError(Mode::Position, exact, plant, {0.001}, 2.0);
    EXPECT_DOUBLE_EQ(held.error, 50.0);
    EXPECT_EQ(held.below, Below::Motor);
    // with one, half of the time adds to P
    const RestingError late = restingError(Mode::Position, exact, plant, {0.001, 0.004}, 2.0);
    EXPECT_DOUBLE_EQ(late.error, 0.05 / (0.001 + 0.004));
    EXPECT_EQ(late.below, Below::Time);
    EXPECT_EQ(restingError(Mode::Velocity, exact, plant, {0.001, 0.004}, 2.0).error, 0.0) << "an exact integral";
}

TEST(ProofNumbers, AnIntegralOfWholeStepsThatDoesNotMoveLeavesAPositionWhereFrictionHoldsP)
{
    using Below = RestingError::Below;
    const PlantModel plant{50'000.0, 0.1, 0.0, 0.05};
    const auto coarse = std::find_if(
        families().begin(), families().end(), [](const Family *f) { return f->loop && f->loop->integralStep > 0.0; });
    ASSERT_NE(coarse, families().end());
    const LoopScale &scale = *(*coarse)->loop;
    const double unmoved = scale.integralStep / scale.fullDuty / (0.004 * scale.cycle);
    const auto rest = [&](Mode loop, double p) {
        return restingError(loop, shapeOf(**coarse, loop, plant, {}, {}), plant, {p, 0.004}, 2.0);
    };
    EXPECT_DOUBLE_EQ(rest(Mode::Velocity, 0.001).error, unmoved);
    EXPECT_EQ(rest(Mode::Velocity, 0.001).below, Below::Integral);
    EXPECT_DOUBLE_EQ(rest(Mode::Position, 0.01).error, 5.0) << unmoved << ": P has moved it before";
    EXPECT_EQ(rest(Mode::Position, 0.01).below, Below::Motor);
    const double between = rest(Mode::Position, 0.5 * 0.05 / unmoved).error;
    EXPECT_DOUBLE_EQ(between, std::max(unmoved, 0.05 / (0.5 * 0.05 / unmoved + 0.004)));
}

TEST(ProofNumbers, FrictionHelpIsAQuarterMoreThanFrictionAndFourCounts)
{
    const Family &family = provenFamily("dmc60c");
    ASSERT_TRUE(hasFrictionHelp(family));
    const PlantModel plant{50'000.0, 0.1, 0.0, 0.04};
    ScaledGains gains;
    addFrictionHelp(family, Mode::Position, 1, 0, plant, gains);
    ASSERT_EQ(gains.rows.size(), gains.changes.size());
    const auto numberOf = [&gains](Role role) {
        const auto found = std::find_if(
            gains.rows.begin(), gains.rows.end(), [role](const ScaledGains::Row &row) { return row.role == role; });
        return found == gains.rows.end() ? std::nan("") : found->number;
    };
    const double push = std::round(1.25 * 0.04 * family.loop->fullDuty);
    EXPECT_DOUBLE_EQ(numberOf(Role::LeastForward), push);
    EXPECT_DOUBLE_EQ(numberOf(Role::LeastReverse), -push);
    EXPECT_DOUBLE_EQ(numberOf(Role::AllowableError), 4.0);
    const LoopShape shape = shapeOf(family, Mode::Position, plant, {}, {});
    EXPECT_DOUBLE_EQ(shape.leastOutput, 0.05);
    EXPECT_DOUBLE_EQ(shape.goodEnough, 4.0);
    const RestingError rests = restingError(Mode::Position, shape, plant, {0.001}, 2.0);
    EXPECT_DOUBLE_EQ(rests.error, 4.0) << "the help moves it where P alone would not";
    EXPECT_EQ(rests.below, RestingError::Below::Allowed);
    LoopShape weak = shape;
    weak.leastOutput = 0.9 * plant.friction;
    EXPECT_DOUBLE_EQ(restingError(Mode::Position, weak, plant, {0.001}, 2.0).error, 40.0);
    PlantModel sticky = plant;
    sticky.breakaway = 0.07;
    EXPECT_DOUBLE_EQ(shapeOf(family, Mode::Position, sticky, {}, {}).leastOutput, 0.07) << "it lets go later";
    sticky.breakaway = 0.045;
    EXPECT_DOUBLE_EQ(shapeOf(family, Mode::Position, sticky, {}, {}).leastOutput, 0.05);
    EXPECT_EQ(shape.mostDuty, 1.0);
    EXPECT_DOUBLE_EQ(shape.outputStep, 1.0 / family.loop->fullDuty);
    EXPECT_TRUE(shape.isCounted);
    const LoopShape current = shapeOf(family, Mode::Current, plant, {}, {});
    EXPECT_FALSE(current.isCounted);
    EXPECT_EQ(current.leastOutput, 0.0);
    EXPECT_EQ(current.goodEnough, 0.0);
}

TEST(ProofNumbers, AWindowIsNoLongerThanItsDelayHas)
{
    const Family &family = provenFamily("dmc60c");
    const PlantModel plant{50'000.0, 0.1, 0.03, 0.04};
    EXPECT_DOUBLE_EQ(shapeOf(family, Mode::Velocity, plant, {}, {0.05, 0.025, 0.0}).window, 0.05);
    EXPECT_DOUBLE_EQ(shapeOf(family, Mode::Velocity, plant, {}, {0.1, 0.05, 0.0}).window, 0.06);
    EXPECT_EQ(shapeOf(family, Mode::Position, plant, {}, {0.05, 0.025, 0.0}).window, 0.0);
    EXPECT_EQ(shapeOf(family, Mode::Velocity, plant, {}, {0.05, 0.025, 7.0}).windowCounts, 7.0);
}

TEST(ProofNumbers, AVelocityOfAsManyEdgesIsTakenOverTheTimeThatTheyTakeAndAtRestOverNoTime)
{
    test::SimulatedSession bench("sim:spi");
    ASSERT_FALSE(bench.scan().empty());
    Device &board = *bench.session.devices().front();
    ASSERT_TRUE(test::run(bench.clock, board.read(bench.index(board, "history.length"))));
    const VelocityTaking slow = velocityTaking(board, 1.0, {});
    EXPECT_GT(slow.counts, 0.0);
    EXPECT_DOUBLE_EQ(slow.window, slow.counts);
    EXPECT_DOUBLE_EQ(velocityTaking(board, -2.0, {}).window, slow.counts / 2.0);
    EXPECT_DOUBLE_EQ(velocityTaking(board, 1e9, {}).window, board.family().loop->cycle);
    EXPECT_EQ(velocityTaking(board, 0.0, {}).window, 0.0);
}

TEST(ProofNumbers, TheBoundOfAnIntegralIsFreedOnlyOfGainsThatHaveOne)
{
    const Family &family = provenFamily("dmc60c");
    ScaledGains gains;
    freeIntegral(family, Mode::Velocity, 1, 0, gains);
    EXPECT_TRUE(gains.rows.empty());
    gains.made.i = 0.1;
    freeIntegral(family, Mode::Velocity, 1, 0, gains);
    ASSERT_EQ(gains.rows.size(), 2U);
    for (const ScaledGains::Row &row : gains.rows) {
        EXPECT_TRUE(row.role == Role::IntegralZone || row.role == Role::AllowableError);
        EXPECT_EQ(row.raw, 0);
    }
    ScaledGains helped;
    helped.made.i = 0.1;
    addFrictionHelp(family, Mode::Position, 1, 0, {50'000.0, 0.1, 0.0, 0.04}, helped);
    const std::size_t before = helped.rows.size();
    freeIntegral(family, Mode::Position, 1, 0, helped);
    EXPECT_EQ(helped.rows.size(), before + 1U) << "what is good enough stays";
}

TEST(ProofNumbers, TheWorseOfTheTrialsIsTheOneFartherFrom0)
{
    std::vector<Trial> trials(2);
    trials[0].metrics.sse = 0.01;
    trials[1].metrics.sse = -0.02;
    trials[0].metrics.overshoot = 0.05;
    trials[1].metrics.overshoot = 0.04;
    trials[0].metrics.rise = 0.1;
    const Metrics worse = worseOf(trials);
    EXPECT_EQ(worse.sse, -0.02);
    EXPECT_EQ(worse.overshoot, 0.05);
    EXPECT_FALSE(worse.rise) << "one of them has none";
    EXPECT_EQ(worseOf({}), Metrics());
}

/// A current of 4 A that stays `beside` its target over the last quarter of each hold, while the motor speeds up by 500 counts/s².
Trial currentTrial(double beside)
{
    Trial trial;
    trial.mode = Mode::Current;
    trial.stimulus.to = 4.0;
    trial.holds = {{0.0, 1.0}, {2.0, 3.0}};
    trial.signals = {{"current", "A", {}}, {"position", "counts", {}}};
    for (int i = 0; i <= 300; ++i) {
        const double t = 0.01 * i;
        const double since = std::fmod(t + 1e-9, 2.0);
        trial.signals[0].trace.add(t, since > 0.745 && since < 1.005 ? 4.0 - beside : 2.0);
        trial.signals[1].trace.add(t, since < 1.005 ? 250.0 * since * since : 0.0);
    }
    return trial;
}

TEST(ProofNumbers, ACurrentRestsWhereTheMeanOfItsLastQuartersIs)
{
    EXPECT_NEAR(restOfCurrent({currentTrial(0.1)}).value_or(0.0), 0.1 / 4.0, 0.02);
    EXPECT_NEAR(restOfCurrent({currentTrial(0.1), currentTrial(-0.3)}).value_or(0.0), -0.3 / 4.0, 0.02);
    EXPECT_NEAR(restOfCurrent({currentTrial(-0.3), currentTrial(0.1)}).value_or(0.0), -0.3 / 4.0, 0.02);
    EXPECT_FALSE(restOfCurrent({}));
    EXPECT_FALSE(restOfCurrent({currentTrial(0.1), Trial()}));
}

TEST(ProofNumbers, ACurrentDroopsByWhatItsIntegralIsBehindTheMotorsOwnVoltage)
{
    PlantModel plant{100.0, 0.001, 0.0, 0.0};
    plant.backDuty = 2e-5;
    // duty grows by 2e-5·500 a second, which takes an error of that over i; and half a step of the reading, 1.9 A here
    EXPECT_NEAR(droopOf({currentTrial(0.1)}, plant, {0.0, 0.5}), 2e-5 * 500.0 / 0.5 + 0.5 * 1.9, 1e-4);
    EXPECT_NEAR(droopOf({currentTrial(0.1)}, plant, {0.01}), 0.5 * 1.9, 1e-9) << "no integral";
    Trial still = currentTrial(0.1);
    still.signals[1].trace = still.signals[1].trace.part(0.0, 0.065); // seven positions
    EXPECT_NEAR(droopOf({still}, plant, {0.0, 0.5}), 0.5 * 1.9, 1e-9);
    still.signals[1].trace = currentTrial(0.1).signals[1].trace.part(0.0, 0.075);
    EXPECT_GT(droopOf({still}, plant, {0.0, 0.5}), 0.5 * 1.9 + 0.015);
    EXPECT_EQ(droopOf({}, plant, {0.0, 0.5}), 0.0);
}

TEST(PredictionBands, AreTheEnvelopeOfAllCornersAndKeepATwentiethOfALag)
{
    // of a motor without friction under P and I, at the time of one sample
    const PlantModel plant{1000.0, 0.2, 0.02, 0.0};
    const ContinuousGains gains{0.0008, 0.004};
    LoopShape shape;
    shape.period = 0.01;
    const Prediction predicted = predictStep(Mode::Velocity, plant, gains, 0.0, 100.0, 0.5, shape);
    const PlantErrors errors{200.0, 0.05, 0.01};
    const PredictionBand band = bandOf(predicted, Mode::Velocity, plant, errors, gains, 100.0, 1.0, 0.01);
    Trace low = predicted.measured;
    Trace high = predicted.measured;
    for (const double gain : {800.0, 1200.0}) {
        for (const double tau : {0.15, 0.25}) {
            for (const double delay : {0.01, 0.03}) {
                const Trace one
                    = predictStep(Mode::Velocity, {gain, tau, delay, 0.0}, gains, 0.0, 100.0, 0.51, shape).measured;
                for (std::size_t i = 0; i < low.size(); ++i) {
                    low.y[i] = std::min(low.y[i], one.y[i]);
                    high.y[i] = std::max(high.y[i], one.y[i]);
                }
            }
        }
    }
    EXPECT_EQ(band.low.t, predicted.measured.t);
    for (std::size_t i = 0; i < low.size(); ++i) {
        EXPECT_NEAR(band.low.y[i], low.y[i], 1e-9);
        EXPECT_NEAR(band.high.y[i], high.y[i], 1e-9);
    }
    // a lag that may be none at all is a twentieth of what it was thought
    const PredictionBand wide = bandOf(predicted, Mode::Velocity, plant, {0.0, 0.5, 0.0}, gains, 100.0, 1.0, 0.01);
    const Trace quick = predictStep(Mode::Velocity, {1000.0, 0.01, 0.02, 0.0}, gains, 0.0, 100.0, 0.51, shape).measured;
    EXPECT_GE(wide.high.y[7], quick.y[7] - 1e-9);
    EXPECT_LE(wide.low.y[7], quick.y[7] + 1e-9);
}

TuneReport reportOn(const PlantModel &found)
{
    TuneReport report;
    report.plant = found;
    MotorFound &motor = report.motor.emplace();
    motor.plant = found;
    motor.line.gainError = 1.0;
    motor.line.frictionError = 0.001;
    motor.pushes.tauError = 0.002;
    motor.pushes.delayError = 0.003;
    return report;
}

TEST(PlantErrors, AreThoseOfThePushesOrAsMuchAsStepsHaveCorrectedTheModel)
{
    TuneReport report = reportOn({1000.0, 0.1, 0.02, 0.05});
    EXPECT_EQ(errorsOf(report), (PlantErrors{1.0, 0.002, 0.003, 0.001}));
    report.plant = {1020.0, 0.1005, 0.03, 0.04};
    const PlantErrors corrected = errorsOf(report);
    EXPECT_DOUBLE_EQ(corrected.gain, 20.0);
    EXPECT_DOUBLE_EQ(corrected.tau, 0.002);
    EXPECT_NEAR(corrected.delay, 0.01, 1e-12);
    EXPECT_NEAR(corrected.friction, 0.01, 1e-12);
    const ModelNumbers numbers = modelNumbers(report);
    EXPECT_EQ(numbers.gain.error, corrected.gain);
    EXPECT_EQ(numbers.delay.error, corrected.delay);
    EXPECT_EQ(numbers.friction.error, corrected.friction);
    report.motor.reset();
    EXPECT_EQ(errorsOf(report), PlantErrors());
}

TEST(PlantErrors, OfACurrentLoopAreThoseOfALagThatNobodyHasSeen)
{
    TuneReport report = reportOn({100.0, 0.5e-3, 0.75e-3, 0.0});
    report.loop = Mode::Current;
    PlantErrors errors = errorsOf(report);
    EXPECT_NEAR(report.plant.tau + errors.tau, 1.4e-3, 1e-9);
    EXPECT_NEAR(errors.leastTau, 0.3e-3, 1e-9);
    report.plant.lagDoubt = 0.2;
    errors = errorsOf(report);
    EXPECT_NEAR(errors.tau, 0.1e-3, 1e-9);
    EXPECT_EQ(errors.leastTau, 0.0);
}

TEST(PredictionBands, HaveNoLagThatNoMotorHas)
{
    const PlantModel plant{100.0, 0.5e-3, 0.75e-3, 0.0};
    const ContinuousGains gains{0.002, 4.0};
    const Prediction predicted = predictStep(Mode::Current, plant, gains, 0.0, 4.0, 0.02);
    const PlantErrors wide{0.0, 0.9e-3, 0.0};
    PlantErrors bound = wide;
    bound.leastTau = 0.3e-3;
    const PredictionBand any = bandOf(predicted, Mode::Current, plant, wide, gains, 4.0);
    const PredictionBand real = bandOf(predicted, Mode::Current, plant, bound, gains, 4.0);
    EXPECT_TRUE(any.low.y != real.low.y || any.high.y != real.high.y);
    for (std::size_t i = 0; i < real.low.size(); ++i) {
        EXPECT_LE(real.low.y[i], predicted.measured.y[i]);
        EXPECT_GE(real.high.y[i], predicted.measured.y[i]);
    }
}

} // namespace
} // namespace mb::tuning
