// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/motormodel.h"
#include "tests/tuning/tuningbench.h"
#include "tuning/frequencyresponse.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstdio>
#include <numbers>

namespace mb::tuning {
namespace {

using test::ExperimentBench;

Envelope benchLimits()
{
    Envelope envelope;
    envelope.duty = 1.0;
    envelope.speed = 1'500'000.0;
    envelope.travel = 2e7;
    return envelope;
}

/// What a motor of gain and tau, with friction and whole counts, tells of a sine.
Trial sineOf(const PlantModel &plant, double bias, double swing, double hertz, double interval)
{
    Trial trial;
    trial.mode = Mode::Duty;
    trial.stimulus = *Stimulus::make(Profile::Sine, bias - swing, bias + swing, 6.0 / hertz, 0.001);
    Trace position;
    Trace duty;
    double speed = plant.gain * (bias - swing - plant.friction);
    double place = 0.0;
    constexpr double fine = 0.0002;
    double next = -0.2;
    for (double t = -0.2; t < trial.stimulus.time; t += fine) {
        if (t >= next) {
            position.add(t, std::floor(place));
            duty.add(t, trial.stimulus.at(t));
            next += interval;
        }
        const double push = trial.stimulus.at(t);
        speed += fine / plant.tau * (plant.gain * (push - std::copysign(plant.friction, speed)) - speed);
        place += fine * speed;
    }
    trial.signals = {{"position", "counts", position}, {"duty", "fraction", duty}};
    return trial;
}

TEST(FrequencyResponse, ReadsMagnitudePhaseAndCoherenceOutOfASine)
{
    const PlantModel plant{20'000.0, 0.15, 0.0, 0.03};
    for (const double hertz : {0.3, 1.0, 3.0}) {
        const auto point = frequencyPoint(sineOf(plant, 0.25, 0.1, hertz, 0.01), plant.tau);
        ASSERT_TRUE(point) << point.error().text();
        const double lag = 2.0 * std::numbers::pi * hertz * plant.tau;
        EXPECT_NEAR(point->magnitude, plant.gain / std::hypot(1.0, lag), 0.02 * plant.gain / std::hypot(1.0, lag));
        EXPECT_NEAR(point->phase, -std::atan(lag) * 180.0 / std::numbers::pi, 3.0);
        EXPECT_GT(point->coherence, 0.99);
        EXPECT_TRUE(point->trusted);
    }
}

TEST(FrequencyResponse, TrustsNothingBeyondATenthOfTheSampleRateOrWithoutCoherence)
{
    const PlantModel plant{20'000.0, 0.15, 0.0, 0.03};
    const auto sparse = frequencyPoint(sineOf(plant, 0.25, 0.1, 3.0, 0.04), plant.tau);
    ASSERT_TRUE(sparse) << sparse.error().text();
    EXPECT_FALSE(sparse->trusted) << "too few samples a swing";
    EXPECT_FALSE(frequencyPoint(sineOf(plant, 0.25, 0.1, 3.0, 0.05), plant.tau)) << "hardly any";
    const PlantModel coarse{60.0, 0.15, 0.0, 0.03}; // counts of a poor encoder hide the sine
    const auto hidden = frequencyPoint(sineOf(coarse, 0.25, 0.02, 3.0, 0.01), coarse.tau);
    ASSERT_TRUE(hidden) << hidden.error().text();
    EXPECT_LT(hidden->coherence, 0.9);
    EXPECT_FALSE(hidden->trusted);
}

TEST(FrequencyResponse, RefusesASineThatReversesTheMotor)
{
    const PlantModel plant{20'000.0, 0.02, 0.0, 0.0};
    const auto point = frequencyPoint(sineOf(plant, 0.05, 0.2, 0.3, 0.01), plant.tau);
    ASSERT_FALSE(point);
    EXPECT_NE(point.error().text().find("reversed"), std::string::npos);
}

TEST(FrequencyResponse, PlansInsideTheEnvelopeAndSaysWhatItWillDo)
{
    const PlantModel plant{1'285'000.0, 0.26, 0.05, 0.002};
    const auto plan = planSweep(plant, benchLimits(), 0.02);
    ASSERT_TRUE(plan) << plan.error().text();
    EXPECT_EQ(plan->hertz.size(), 8U);
    EXPECT_LE(plan->hertz.back(), 5.0 + 1e-9) << "a tenth of the set-points";
    EXPECT_LE(plan->travel, 2e7);
    EXPECT_LE(plan->speed, 1'500'000.0);
    EXPECT_GT(plan->bias - plan->swing, plant.friction);
    const std::string said = announcementOf(*plan).english();
    for (const char *word : {"duty", "counts/s", "one way", " s"})
        EXPECT_NE(said.find(word), std::string::npos) << said;
    Envelope narrow = benchLimits();
    narrow.travel = 10'000.0;
    const auto refused = planSweep(plant, narrow, 0.02);
    ASSERT_FALSE(refused);
    EXPECT_FALSE(refused.error().remedy.empty());
}

/// What the simulated motor itself answers, by its speed, without drive, link and encoder. counts/s per duty.
double trueMagnitude(const SweepPlan &plan, double hertz)
{
    MotorModel motor(*motorByName("cim"), 9.0);
    const double omega = 2.0 * std::numbers::pi * hertz;
    std::complex<double> sum;
    constexpr double fine = 0.0005;
    const double skipped = 2.0 + 2.0 / hertz;
    const auto count = static_cast<int>(4.0 / hertz / fine);
    motor.step(plan.bias, Bridge::Drive, 2.0);
    for (double t = 2.0; t < skipped; t += fine)
        motor.step(plan.bias + plan.swing * std::cos(omega * t), Bridge::Drive, fine);
    for (int i = 0; i < count; ++i) {
        const double t = skipped + i * fine;
        motor.step(plan.bias + plan.swing * std::cos(omega * t), Bridge::Drive, fine);
        sum += motor.speed() * std::polar(1.0, -omega * t) * (2.0 / count);
    }
    return std::abs(sum) / plan.swing * 4096.0 / (2.0 * std::numbers::pi);
}

TEST(FrequencyResponse, MeasuresTheSimulatedMotorAsItIs)
{
    ExperimentBench bench("sim:can", "dmc60c", 5);
    TunePlan asked;
    asked.propose = true;
    const auto model = test::run(bench.bench.clock,
        autotune(*bench.device, bench.bench.session.stream(*bench.device), asked, bench.surroundings));
    ASSERT_TRUE(model) << model.error().text();
    const auto plan = planSweep(model->plant, benchLimits(), 0.02);
    ASSERT_TRUE(plan) << plan.error().text();
    std::printf("%s\n", announcementOf(*plan).english().c_str());
    const std::size_t before = bench.journal.completed.size();
    const Instant begin = bench.bench.clock.now();
    const auto measured = test::run(bench.bench.clock,
        measureFrequencyResponse(
            *bench.device, bench.bench.session.stream(*bench.device), *plan, model->plant, bench.surroundings));
    ASSERT_TRUE(measured) << measured.error().text();
    EXPECT_TRUE(measured->stopReason == tuning::EndReason::None) << measured->evidence;
    EXPECT_TRUE(measured->stopped);
    ASSERT_EQ(measured->points.size(), plan->hertz.size()) << measured->evidence;
    EXPECT_EQ(measured->trials.size(), plan->hertz.size());
    EXPECT_NEAR(measured->trustedUpTo(), plan->hertz.back(), 1e-3);
    const double seconds = std::chrono::duration<double>(bench.bench.clock.now() - begin).count();
    double farthest = 0.0;
    for (std::size_t i = before; i < bench.journal.completed.size(); ++i) {
        const Trace &position = bench.journal.completed[i].signal("position")->trace;
        for (const double place : position.y)
            farthest = std::max(farthest, std::abs(place - position.y.front()));
    }
    std::printf("announced %.0f s and %.0f counts, done %.0f s and %.0f counts\n", plan->seconds, plan->travel, seconds,
        farthest);
    EXPECT_LE(seconds, plan->seconds);
    EXPECT_GE(seconds, 0.7 * plan->seconds);
    EXPECT_LE(farthest, plan->travel);
    EXPECT_GE(farthest, 0.7 * plan->travel);
    for (const FrequencyPoint &point : measured->points) {
        const double expected = trueMagnitude(*plan, point.hertz);
        const double ofModel
            = model->plant.gain / std::hypot(1.0, 2.0 * std::numbers::pi * point.hertz * model->plant.tau);
        std::printf("%.2f Hz: %.0f of %.0f counts/s per duty (%+.1f %%; model %+.1f %%), %.0f°, coherence %.4f\n",
            point.hertz, point.magnitude, expected, 100.0 * (point.magnitude / expected - 1.0),
            100.0 * (ofModel / expected - 1.0), point.phase, point.coherence);
        EXPECT_NEAR(point.magnitude, expected, (point.hertz < 1.0 ? 0.05 : 0.16) * expected);
    }
}

TEST(FrequencyResponse, IsNoneWhereItsNextSineCouldNotBegin)
{
    ExperimentBench bench("sim:can", "dmc60c", 7);
    const PlantModel plant{1'285'000.0, 0.26, 0.05, 0.002};
    auto plan = planSweep(plant, benchLimits(), 0.02);
    plan->hertz = {2.0, 4.0};
    int sines = 0;
    bench.surroundings.note = [&](const Message &text) {
        sines += text.english().starts_with("sine") ? 1 : 0;
        bench.simulator()->setPowered(sines < 2);
    };
    const auto measured = test::run(bench.bench.clock,
        measureFrequencyResponse(
            *bench.device, bench.bench.session.stream(*bench.device), *plan, plant, bench.surroundings));
    ASSERT_TRUE(measured) << measured.error().text();
    ASSERT_EQ(sines, 2);
    EXPECT_FALSE(measured->stopReason == tuning::EndReason::None);
    EXPECT_FALSE(measured->evidence.empty());
}

TEST(FrequencyResponse, StopsWhereSomebodyStopsIt)
{
    ExperimentBench bench("sim:can", "dmc60c", 7);
    const PlantModel plant{1'285'000.0, 0.26, 0.05, 0.002};
    const auto plan = planSweep(plant, benchLimits(), 0.02);
    Timer later(bench.bench.clock);
    later.startIn(std::chrono::seconds(8), [&] { bench.interruption.interrupt(); });
    const auto measured = test::run(bench.bench.clock,
        measureFrequencyResponse(
            *bench.device, bench.bench.session.stream(*bench.device), *plan, plant, bench.surroundings));
    ASSERT_TRUE(measured) << measured.error().text();
    EXPECT_EQ(measured->stopReason, tuning::EndReason::Interrupted);
    EXPECT_TRUE(measured->stopped);
    EXPECT_TRUE(measured->points.empty());
}

} // namespace
} // namespace mb::tuning
