// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/motormodel.h"
#include "tuning/plantfit.h"
#include "tuning/relaycycle.h"
#include "tuning/velocityfilter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <optional>
#include <random>
#include <utility>

namespace mb::tuning {
namespace {

constexpr double fine = 0.00025;

struct Plant {
    std::string_view motor;
    double load;
    std::optional<double> loss{}; ///< share of the torque, in place of its own; it lets go as it turns then
    double busResistance = 0.0;   ///< Ohm, of battery and cables
    double duty = 0.0;            ///< at which that adds to the winding's

    [[nodiscard]] MotorParameters parameters() const
    {
        MotorParameters own = *motorByName(motor);
        if (loss) {
            own.torqueLoss = *loss;
            own.breakaway = own.friction;
        }
        return own;
    }
};

/// What a linear model of a simulated motor is, exactly.
struct Truth {
    explicit Truth(Plant plant)
    {
        const MotorParameters m = plant.parameters();
        const double r = m.resistance + 0.005 + plant.duty * plant.duty * plant.busResistance;
        const double kept = m.constant * (1.0 - m.torqueLoss);
        const double kV = m.constant + r * m.viscosity / kept;
        tau = r * m.inertia * plant.load / kept / kV;
        volts = r * m.friction / kept;
        friction = volts / m.nominalVoltage;
        gain = m.nominalVoltage / kV * m.countsPerTurn / (2.0 * std::numbers::pi);
    }
    double tau = 0.0;
    double gain = 0.0;     ///< counts/s at full duty
    double friction = 0.0; ///< duty
    double volts = 0.0;
};

class Recorder {
public:
    Recorder(Plant plant, double period, double jitter, std::uint64_t seed)
        : m_motor(plant.parameters(), plant.load, MotorSupply{12.0, plant.busResistance, 0.005})
        , m_period(period)
        , m_jitter(0.0, jitter)
        , m_random(seed)
    {
    }
    /// Runs duty(t) for `seconds`; samples from `phase` on.
    template <typename Duty> void run(double seconds, double phase, Duty duty)
    {
        double next = phase;
        for (double t = 0.0; t < seconds; t += fine) {
            const double u = duty(t);
            if (t + 1e-12 >= next) {
                const double stamp = t + m_jitter(m_random);
                position.add(stamp, static_cast<double>(m_motor.counts()));
                applied.add(stamp, u);
                speed.add(stamp, m_motor.countSpeed());
                next += m_period;
            }
            m_motor.step(u, Bridge::Drive, fine);
        }
    }
    [[nodiscard]] MotorModel &motor() { return m_motor; }

    Trace position;
    Trace applied;
    Trace speed;

private:
    MotorModel m_motor;
    double m_period;
    std::normal_distribution<double> m_jitter;
    std::mt19937_64 m_random;
};

std::vector<PushRecord> pushes(Plant plant, double period, double jitter, std::uint64_t seed, double delay = 0.0)
{
    const double seconds = std::max(8.0 * Truth(plant).tau, 12.0 * period);
    std::vector<PushRecord> records;
    for (int i = 0; i < 8; ++i) {
        Recorder recorder(plant, period, jitter, seed * 100 + static_cast<std::uint64_t>(i));
        const double duty = (i % 2 == 0 ? 1.0 : -1.0) * (i < 4 ? 0.4 : 0.25);
        recorder.run(seconds, (i / 2 % 4 + 0.5) / 4.0 * period, [&](double t) { return t < delay ? 0.0 : duty; });
        records.push_back({recorder.position, duty});
    }
    return records;
}

TEST(PushFit, TakesBackWhatEachPushWaitsForThePassOfItsBoard)
{
    const Plant plant{"cim", 9.0};
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U}) {
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> wait(0.0, 0.002);
        std::vector<PushRecord> records;
        for (PushRecord &record : pushes(plant, 0.01, 0.0, seed)) {
            const double late = wait(random);
            for (double &t : record.position.t)
                t += late;
            for (double &counts : record.position.y)
                counts = std::floor(counts / 32.0); // 128 a turn
            records.push_back(std::move(record));
        }
        const auto fit = fitPushes(records, 0.002);
        ASSERT_TRUE(fit) << fit.error().text();
        EXPECT_NEAR(fit->tau / Truth(plant).tau, 1.0, 0.0025) << "seed " << seed;
        EXPECT_EQ(fit->sag, 0.0) << "seed " << seed;
    }
}

TEST(PushFit, GivesTheGoldenPositions)
{
    // K 46.3 rad/s/V, 4.8 V, 0.236 V of friction, tau 168 ms, dead time 12 ms: 0.843376, 15.820435, 173.375946 rad
    const double speed = 46.3 * (4.8 - 0.236);
    const auto at = [speed](double t) {
        const double late = std::max(t - 0.012, 0.0);
        return speed * (late - 0.168 * (1.0 - std::exp(-late / 0.168)));
    };
    EXPECT_NEAR(at(0.05), 0.843376, 1e-6);
    EXPECT_NEAR(at(1.0), 173.375946, 1e-5);
    PushRecord record;
    record.duty = 0.4;
    for (int i = 0; i < 200; ++i)
        record.position.add(i * 0.01, 1000.0 * at(i * 0.01));
    const auto fit = fitPushes(std::vector{record});
    ASSERT_TRUE(fit) << fit.error().text();
    EXPECT_NEAR(fit->tau, 0.168, 0.0002);
    EXPECT_NEAR(fit->delay, 0.012, 0.0002);
    EXPECT_NEAR(fit->speeds.at(0), 1000.0 * speed, 50.0);
}

TEST(Acceptance, A01_TauWithinFivePercentOnThreeMotorsAndLoads)
{
    double worstTau = 0.0;
    double worstGain = 0.0;
    for (const std::string_view motor : {"cim", "775pro", "25d"}) {
        for (std::uint64_t seed = 0; seed < 8; ++seed) {
            const Plant plant{motor, 7.0 * (0.6 + static_cast<double>(seed) / 7.0)};
            const Truth truth(plant);
            const auto records = pushes(plant, 0.01, 0.001, seed);
            const auto fit = fitPushes(records);
            ASSERT_TRUE(fit) << fit.error().text();
            worstTau = std::max(worstTau, std::abs(fit->tau / truth.tau - 1.0));
            EXPECT_LT(std::abs(fit->tau / truth.tau - 1.0), 0.05) << motor << " seed " << seed;
            EXPECT_LT(fit->cost, 3.0) << motor;
            std::vector<double> duties;
            for (const PushRecord &record : records)
                duties.push_back(record.duty);
            const auto gain = fitGain(duties, fit->speeds);
            ASSERT_TRUE(gain) << gain.error().text();
            worstGain = std::max(worstGain, std::abs(gain->gain / truth.gain - 1.0));
            EXPECT_LT(std::abs(gain->gain / truth.gain - 1.0), 0.02) << motor << " seed " << seed;
            EXPECT_LT(gain->asymmetry(), 0.02);
            EXPECT_NEAR(gain->offset, 0.0, 0.002);
        }
    }
    std::printf("A1 tau %.2f %%  gain %.2f %%\n", 100.0 * worstTau, 100.0 * worstGain);
}

TEST(Acceptance, A01_TauWithinThreePercentWhereTheSagOfABatteryIsCorrected)
{
    double worst = 0.0;
    for (const std::string_view motor : {"cim", "775pro", "25d"}) {
        for (std::uint64_t seed = 0; seed < 8; ++seed) {
            const Plant plant{motor, 7.0 * (0.6 + static_cast<double>(seed) / 7.0), {}, 0.02, dutyOfLag};
            const auto fit = fitPushes(pushes(plant, 0.01, 0.001, seed));
            ASSERT_TRUE(fit) << fit.error().text();
            const double off = std::abs(fit->tau / Truth(plant).tau - 1.0);
            EXPECT_LT(off, 0.03) << motor << " seed " << seed;
            worst = std::max(worst, off);
        }
    }
    std::printf("A1 tau %.2f %%, of a battery of 20 mOhm\n", 100.0 * worst);
}

TEST(PushFit, FindsARealDeadTime)
{
    for (const double delay : {0.0, 0.02}) {
        const auto fit = fitPushes(pushes({"cim", 9.0}, 0.01, 0.0005, 3, delay));
        ASSERT_TRUE(fit);
        EXPECT_NEAR(fit->delay, delay, 0.002);
        EXPECT_GT(fit->delayError, 0.0);
        EXPECT_LT(fit->tauError, 0.05 * fit->tau);
    }
}

TEST(PushFit, WorksAtEveryTelemetryPeriod)
{
    for (const double period : {0.001, 0.01, 0.02, 0.05, 0.1}) {
        const auto fit = fitPushes(pushes({"cim", 9.0}, period, 0.0005, 5));
        ASSERT_TRUE(fit) << period;
        EXPECT_NEAR(fit->tau, Truth({"cim", 9.0}).tau, 0.03 * fit->tau) << period;
    }
}

TEST(PushFit, RefusesAMotorThatHardlyMoved)
{
    PushRecord record;
    for (int i = 0; i < 50; ++i)
        record.position.add(i * 0.01, i < 25 ? 0.0 : 30.0);
    const auto fit = fitPushes(std::vector{record});
    ASSERT_FALSE(fit);
    EXPECT_EQ(fit.error().fault, Fault::OutOfRange);
}

TEST(GainFit, TellsALoadThatAlwaysPullsOneWayFromFriction)
{
    std::vector<double> duties{0.2, 0.4, -0.2, -0.4};
    std::vector<double> speeds;
    for (const double duty : duties)
        speeds.push_back(50'000.0 * (duty - 0.06 - (duty > 0.0 ? 0.03 : -0.03)));
    const auto fit = fitGain(duties, speeds);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->gain, 50'000.0, 1.0);
    EXPECT_NEAR(fit->friction, 0.03, 1e-6);
    EXPECT_NEAR(fit->offset, 0.06, 1e-6);
    EXPECT_NEAR(fit->offsetError, 0.0, 1e-6);
    EXPECT_GT(fit->asymmetry(), 0.1);
}

TEST(GainFit, TellsHowWellItKnowsALoad)
{
    constexpr double load = 0.02;
    std::mt19937_64 random(7);
    std::normal_distribution<double> noise(0.0, 150.0);
    int within = 0;
    double mean = 0.0;
    constexpr int rounds = 200;
    for (int round = 0; round < rounds; ++round) {
        std::vector<double> duties{0.2, 0.2, 0.4, 0.4, -0.2, -0.2, -0.4, -0.4};
        std::vector<double> speeds;
        for (const double duty : duties)
            speeds.push_back(50'000.0 * (duty - load - (duty > 0.0 ? 0.03 : -0.03)) + noise(random));
        const auto fit = fitGain(duties, speeds);
        ASSERT_TRUE(fit);
        within += std::abs(fit->offset - load) <= fit->offsetError ? 1 : 0;
        mean += fit->offsetError / rounds;
    }
    std::printf("the load is within its ± in %d of %d, ± %.4f duty\n", within, rounds, mean);
    EXPECT_GE(within, rounds * 85 / 100); // two standard errors
    EXPECT_GT(mean, 0.0005);
    EXPECT_LT(mean, 0.01);
}

TEST(GainFit, OfAWayThatWasNotPushedTellsNothing)
{
    for (const double sign : {1.0, -1.0}) {
        const auto fit = fitGain(std::vector{0.2 * sign, 0.4 * sign}, std::vector{7'500.0 * sign, 17'500.0 * sign});
        ASSERT_TRUE(fit) << fit.error().text();
        EXPECT_NEAR(fit->friction, 0.05, 1e-9);
        EXPECT_NEAR(sign > 0.0 ? fit->forward : fit->reverse, 50'000.0, 1e-3);
        EXPECT_EQ(sign > 0.0 ? fit->reverse : fit->forward, 0.0);
        EXPECT_EQ(fit->asymmetry(), 0.0);
    }
}

TEST(GainFit, NeedsTwoSizesOfDuty)
{
    EXPECT_FALSE(fitGain(std::vector{0.3, -0.3}, std::vector{900.0, -900.0}));
}

struct Window {
    double window;
    double hold;
};

TEST(Acceptance, A03_VelocityFilterWithinTenPercentForRollingAndBlock)
{
    double worst = 0.0;
    for (const Window &made : {Window{0.1, 0.0}, Window{0.1, 0.1}, Window{0.05, 0.0}, Window{0.05, 0.05},
             Window{0.05, 0.01}, Window{0.02, 0.0}, Window{0.02, 0.02}}) {
        for (const double period : {0.005, 0.01, 0.02}) {
            MotorModel motor(*motorByName("cim"), 9.0);
            std::vector<double> history;
            Trace position;
            Trace velocity;
            double held = 0.0;
            const auto span = static_cast<std::size_t>(std::lround(made.window / fine));
            const auto block = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(made.hold / fine)));
            double next = 0.0;
            for (std::size_t k = 0; static_cast<double>(k) * fine < 3.0; ++k) {
                const double t = static_cast<double>(k) * fine;
                history.push_back(static_cast<double>(motor.counts()));
                const double before = k >= span ? history[k - span] : 0.0;
                if (k % block == 0)
                    held = std::round((history[k] - before) / made.window);
                if (t + 1e-12 >= next) {
                    position.add(t, history[k]);
                    velocity.add(t, held);
                    next += period;
                }
                motor.step(t < 0.2 ? 0.1 : (std::fmod(1.7 * t, 1.0) < 0.5 ? 0.5 : 0.25), Bridge::Drive, fine);
            }
            const auto filter = fingerprint(position, velocity);
            ASSERT_TRUE(filter);
            const double delay = made.window / 2.0 + made.hold / 2.0;
            worst = std::max(worst, std::abs(filter->delay - delay) / std::max(0.1 * delay, period));
            EXPECT_NEAR(filter->delay, delay, std::max(0.1 * delay, period))
                << made.window << ' ' << made.hold << ' ' << period;
            if (made.hold > period) {
                EXPECT_NEAR(filter->hold, made.hold, period);
            }
            if (made.window > 3.0 * period) { // less of it is no filter to this telemetry
                const bool isBlock = made.hold > 0.5 * made.window;
                EXPECT_EQ(filter->kind, isBlock ? VelocityFilter::Kind::Block : VelocityFilter::Kind::Rolling)
                    << made.window << ' ' << made.hold << ' ' << period;
            }
        }
    }
    std::printf("A3 delay of the filter within %.0f %% of what is allowed\n", 100.0 * worst);
}

TEST(VelocityFilter, SaysNothingOfAMotorThatNeverChangedItsSpeed)
{
    Trace position;
    Trace velocity;
    for (int i = 0; i < 300; ++i) {
        position.add(i * 0.01, i * 10.0);
        velocity.add(i * 0.01, 1000.0);
    }
    EXPECT_FALSE(fingerprint(position, velocity));
}

TEST(RelayCycle, GivesTheGoldenCycle)
{
    const ExactCycle cycle = exactCycle(556.0, 0.2, 0.0, 0.168, 0.12);
    EXPECT_NEAR(cycle.amplitude, 1.166930, 1e-6);
    EXPECT_NEAR(cycle.speed, 38.1077, 1e-4);
    EXPECT_NEAR(exactCycle(556.0, 0.2, 1e-9, 0.168, 0.12).amplitude, 1.166930, 1e-5);
    const RelayCycle measured{0.24, 1.166930, 0.0, 6};
    EXPECT_NEAR(tauFromRelay(measured, 556.0, 0.2, 0.0).value_or(0.0), 0.168, 1e-4);
}

/// Share by which tau is off that a relay of this duty tells.
double offByRelay(const Plant &plant, double duty, double braking = 1.0)
{
    const Truth truth(plant);
    Recorder recorder(plant, 0.001, 0.0, 1);
    const double begun = static_cast<double>(recorder.motor().counts());
    double sign = 1.0;
    recorder.run(6.0, 0.0, [&](double) {
        const double y = static_cast<double>(recorder.motor().counts()) - begun;
        if (y > 40.0)
            sign = -1.0;
        else if (y < -40.0)
            sign = 1.0;
        return sign * duty;
    });
    const auto cycle = readRelay(recorder.position);
    const auto tau = cycle ? tauFromRelay(*cycle, truth.gain, duty, truth.friction, braking) : std::nullopt;
    const double off = tau.value_or(0.0) / truth.tau - 1.0;
    std::printf("A6 %s d %.3f: tau %+.1f %% (friction/duty %.2f, gear loss %.2f%s)\n", std::string(plant.motor).c_str(),
        duty, 100.0 * off, truth.friction / duty, plant.parameters().torqueLoss,
        braking > 1.0 ? ", its braking known" : "");
    return off;
}

constexpr double mostRelay = 0.5; ///< duty; no relay swings harder

TEST(Acceptance, A06_RelayGivesTauWithinFivePercentUnderPureCoulombFriction)
{
    int swung = 0;
    for (const std::string_view motor : {"cim", "775pro", "25d"}) {
        const Plant plant{motor, 8.0, 0.0};
        for (const double share : {0.05, 0.15, 0.3}) {
            const double duty = Truth(plant).friction / share;
            if (duty > mostRelay)
                continue;
            EXPECT_LT(std::abs(offByRelay(plant, duty)), 0.05) << motor << ' ' << share;
            ++swung;
        }
    }
    EXPECT_GE(swung, 6);
}

/// Low, which is safe for P; as without a loss where pushes have told how much more strongly it brakes.
TEST(Acceptance, A06_RelayGivesTauWithinTwentyPercentWhereAGearLosesTwoFifths)
{
    constexpr double loss = 0.4;
    for (const std::string_view motor : {"25d", "n20"}) {
        const Plant plant{motor, 5.0, loss};
        for (const double share : {0.15, 0.3}) {
            const double duty = Truth(plant).friction / share;
            EXPECT_LT(std::abs(offByRelay(plant, duty)), 0.2) << motor << ' ' << share;
            EXPECT_LT(std::abs(offByRelay(plant, duty, (1.0 + loss) / (1.0 - loss))), 0.05) << motor;
        }
    }
}

} // namespace
} // namespace mb::tuning
