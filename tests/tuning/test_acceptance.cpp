// SPDX-License-Identifier: GPL-3.0-or-later
// The criteria of acceptance that need whole tunings; those of pure parts stand with their parts, under the same name.
#include "families/quadquad2drv/calibrations.h"
#include "families/quadquad2drv/codec.h"
#include "families/quadquad2drv/simulatoraxis.h"
#include "simulation/motormodel.h"
#include "tests/tuning/tuningbench.h"
#include "tuning/autotune.h"
#include "tuning/margins.h"
#include "wire/bytes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace mb::tuning {
namespace {

using namespace std::chrono_literals;
using test::ExperimentBench;
using test::planOf;
using test::print;
using test::tune;

/// Where a trial's position came to stand at the end of its first hold, and the farthest beyond its target, counts.
struct Rest {
    double residual = 0.0;
    double beyond = 0.0;
    double late = 0.0; ///< s after the profile's end until it stays within 2 % of the way
};

Rest restOf(const Trial &trial, double ramp)
{
    const Trace &position = trial.signal("position")->trace;
    const double from = trial.stimulus.from;
    const double to = trial.stimulus.to;
    const double sign = to > from ? 1.0 : -1.0;
    Rest rest;
    for (std::size_t i = 0; i < position.size() && position.t[i] <= trial.holds.front().to; ++i) {
        rest.beyond = std::max(rest.beyond, sign * (position.y[i] - to));
        rest.residual = std::abs(position.y[i] - to);
        if (rest.residual > 0.02 * std::abs(to - from))
            rest.late = position.t[i] - ramp;
    }
    return rest;
}

/// V, that Coulomb's friction of a simulated motor takes from its supply.
double frictionVolts(const MotorParameters &motor)
{
    constexpr double bridge = 0.005; // Ohm
    return (motor.resistance + bridge) * motor.friction / (motor.constant * (1.0 - motor.torqueLoss));
}

TEST(Acceptance, A02_FrictionThatATuningFindsIsWithinFiftyMillivolt)
{
    double worst = 0.0;
    for (const std::string_view name : {"cim", "775pro", "25d"}) {
        const MotorParameters &motor = *motorByName(name);
        const double truth = frictionVolts(motor);
        for (const std::string_view load : {"5", "8"}) {
            ExperimentBench bench(
                "sim:can", "dmc60c", 6, "dmc60c:6,motor=" + std::string(name) + ",load=" + std::string(load));
            TunePlan plan = planOf(Mode::Velocity);
            plan.propose = true;
            const auto report = tune(bench, plan);
            ASSERT_TRUE(report) << report.error().text();
            ASSERT_EQ(report->result, TuneResult::Proposed) << report->evidence;
            const double off = std::abs(report->plant.friction * motor.nominalVoltage - truth);
            worst = std::max(worst, off);
            std::printf("A2 %s, load %s: friction %.0f mV, found %.0f mV ± %.0f\n", std::string(name).c_str(),
                std::string(load).c_str(), 1e3 * truth, 1e3 * report->plant.friction * motor.nominalVoltage,
                1e3 * report->motor->line.frictionError * motor.nominalVoltage);
            EXPECT_LT(off, std::max(0.15 * truth, 0.05)) << name << " of " << truth << " V";
        }
    }
    std::printf("A2 friction within %.0f mV\n", 1e3 * worst);
}

TEST(Acceptance, A04_TheVelocityLoopOfADmc60cHardlyOvershootsAndSettlesInTime)
{
    for (const int number : {5, 7}) {
        ExperimentBench bench("sim:can", "dmc60c", number);
        const auto report = tune(bench, planOf(Mode::Velocity));
        ASSERT_TRUE(report) << report.error().text();
        ASSERT_EQ(report->result, TuneResult::Kept) << report->evidence;
        ExperimentPlan step = test::stepTo(Mode::Velocity, report->proof.front().stimulus.to);
        step.seconds = 2.0;              // a proof is held shorter than its integral takes to creep in
        bench.bench.clock.advance(2min); // a warm motor is another one
        const auto trial = bench.run(step);
        ASSERT_TRUE(trial) << trial.error().text();
        const Metrics &measured = trial->metrics;
        ASSERT_TRUE(measured.overshoot && measured.settle && measured.sse);
        std::printf("A4 dmc60c %d: overshoot %.1f %%, settled in %.1f delays, rests %.2f %% away\n", number,
            100.0 * *measured.overshoot, *measured.settle / report->plant.delay, 100.0 * *measured.sse);
        EXPECT_LE(*measured.overshoot, 0.05);
        EXPECT_LE(*measured.settle, 8.0 * report->plant.delay);
        EXPECT_LE(std::abs(*measured.sse), 0.002);
    }
}

/// A position loop that was tuned makes moves of a profile, each at another phase of the clock, and so came to rest at worst.
struct Moved {
    TuneReport report;
    Rest rest;
    double omega = 0.0;
};

void moveTuned(ExperimentBench &bench, double counts, Moved &moved, int phases = 1)
{
    constexpr double seconds = 1.5;
    TunePlan plan = planOf(Mode::Position);
    plan.slot = 1;
    const auto report = tune(bench, plan);
    ASSERT_TRUE(report) << report.error().text();
    ASSERT_EQ(report->result, TuneResult::Kept) << report->evidence;
    ExperimentPlan move;
    move.mode = Mode::Position;
    move.slot = 1;
    move.profile = Profile::Ramp;
    move.from = report->proof.back().signal("position")->trace.y.back();
    move.to = *move.from + counts;
    move.seconds = seconds;
    moved = {*report, {}, 1.0 / report->design->response};
    for (int phase = 0; phase < phases; ++phase) {
        const auto trial = bench.run(move);
        ASSERT_TRUE(trial) << trial.error().text();
        ASSERT_EQ(trial->reason, tuning::EndReason::Done) << phase << ": " << trial->detail;
        const Rest rest = restOf(*trial, seconds);
        moved.rest = {std::max(moved.rest.residual, rest.residual), std::max(moved.rest.beyond, rest.beyond),
            std::max(moved.rest.late, rest.late)};
        const Duration since = bench.bench.clock.now().time_since_epoch() % 20ms;
        bench.bench.clock.advance(10s - since + (phase + 1) * 20ms / phases); // a warm one rests farther away
    }
}

TEST(Acceptance, A05_ProfiledMovesOfATunedPositionLoopComeToRestAtTheirTarget)
{
    for (const int number : {5, 7}) {
        ExperimentBench bench("sim:can", "dmc60c", number);
        Moved moved;
        moveTuned(bench, 40'000.0, moved, 30);
        const auto &[report, rest, omega] = moved;
        std::printf(
            "A5 dmc60c %d: beyond %.0f counts of 40000 (%.2f %%), residual %.0f counts, settled %.1f/omega after "
            "its profile\n",
            number, rest.beyond, rest.beyond / 400.0, rest.residual, rest.late * omega);
        EXPECT_LE(rest.beyond, 400.0);
        EXPECT_LE(rest.residual, 6.0);
        EXPECT_LE(rest.late * omega, 7.0);
    }
}

/// 48 and 12 counts a turn of the rotor, behind a gear: at rest within a second, or the answer says that it creeps.
TEST(Acceptance, A05_GearedMotorsOfFewCountsComeToRestOrTheAnswerSaysThatTheyCreep)
{
    for (const auto &[motor, counts] : {std::pair("25d", 2000.0), std::pair("n20", 600.0)}) {
        ExperimentBench bench("sim:can", "dmc60c", 6, std::string("dmc60c:6,motor=") + motor + ",load=5");
        Moved moved;
        moveTuned(bench, counts, moved);
        const bool creeps = moved.report.evidence.english().find("may rest") != std::string::npos;
        std::printf("A5 dmc60c with a %s: beyond %.0f counts of %.0f, residual %.0f counts, at rest %.2f s after its "
                    "profile%s\n",
            motor, moved.rest.beyond, counts, moved.rest.residual, moved.rest.late, creeps ? ", creeping told" : "");
        EXPECT_LE(moved.rest.beyond, std::max(0.01 * counts, 6.0)) << motor;
        EXPECT_TRUE(moved.rest.late <= 1.0 || creeps) << motor << ": " << moved.report.evidence;
        EXPECT_TRUE(moved.rest.residual <= 6.0 || creeps) << motor << ": " << moved.report.evidence;
    }
}

struct Timed {
    std::string_view link;
    std::string_view family;
    int address = 0;
    Mode loop = Mode::Velocity;
};

/// Of a board, once for its firmware (A7).
void knowScales(ExperimentBench &bench)
{
    using namespace quadquad2drv;
    using namespace quadquad2drv::simulation;
    if (bench.device->family().key != "quadquad2drv")
        return;
    for (const auto &[key, scale] : {std::pair(calibration::velocityP, gain::velocityP),
             std::pair(calibration::velocityI, gain::velocityI), std::pair(calibration::positionP, gain::positionP),
             std::pair(calibration::positionI, gain::positionI), std::pair(calibration::positionD, gain::positionD)})
        EXPECT_TRUE(bench.device->knowledge().calibrate(key, scale)) << key;
}

/// Of its firmware the scales of the velocity loop are some number times those of the bench's.
void findScales(int axis, double scale)
{
    using namespace quadquad2drv;
    using namespace quadquad2drv::simulation;
    ExperimentBench bench("sim:spi", "quadquad2drv", 0, "quadquad2drv:0,scale=" + std::to_string(scale));
    ASSERT_LE(bench.device->knowledge().profile().calibrated(calibration::velocityP), 0.0);
    const std::string limit = "ch" + std::to_string(axis) + ".limit.power";
    for (const auto &[key, value] : {std::pair(limit.c_str(), 0.8), std::pair("history.length", 8.0)}) {
        const ParameterChange change = bench.change(key, value);
        ASSERT_TRUE(test::run(bench.bench.clock, bench.device->write(change.index, change.raw))) << key;
    }
    TunePlan plan = planOf(Mode::Velocity);
    plan.axis = axis;
    plan.keep = true;
    const auto report = tune(bench, plan);
    ASSERT_TRUE(report) << report.error().text();
    print(*report);
    const DeviceProfile &profile = bench.device->knowledge().profile();
    const double p = profile.calibrated(calibration::velocityP) / (scale * gain::velocityP) - 1.0;
    const double i = profile.calibrated(calibration::velocityI) / (scale * gain::velocityI) - 1.0;
    std::printf("A7 axis %d, scale %.2f: sP %+.2f %%, sI %+.2f %%\n", axis, scale, 100.0 * p, 100.0 * i);
    EXPECT_LE(std::abs(p), 0.01) << axis;
    EXPECT_LE(std::abs(i), 0.05) << axis;
    EXPECT_EQ(report->result, TuneResult::Kept) << axis << ": " << report->evidence;
    EXPECT_FALSE(bench.simulator()->isOutputOn());
}

TEST(Acceptance, A07_AnUncalibratedBoardFindsItsScalesOnEveryAxisAndIsTunedInOneGo)
{
    for (const int axis : {1, 2, 3, 4})
        findScales(axis, 1.0);
    findScales(1, 3.0);
    findScales(1, 0.4);
}

TEST(Acceptance, A07_TheUserAndTheLimitsHoldWhileTheScalesAreFound)
{
    {
        ExperimentBench bench("sim:spi", "quadquad2drv", 0);
        Timer timer(bench.bench.clock);
        timer.startIn(std::chrono::seconds(8), [&bench] { bench.interruption.interrupt(); });
        TunePlan plan = planOf(Mode::Velocity);
        EXPECT_FALSE(tune(bench, plan)) << "the search writes gains, and those that are there are not known";
        plan.propose = true;
        EXPECT_FALSE(tune(bench, plan)) << "so it does before a proposal";
        plan.propose = false;
        plan.keep = true;
        const auto report = tune(bench, plan);
        ASSERT_TRUE(report) << report.error().text();
        EXPECT_EQ(report->result, TuneResult::Stopped);
        EXPECT_EQ(report->stopReason, tuning::EndReason::Interrupted);
        EXPECT_TRUE(report->stopped);
    }
    ExperimentBench bench("sim:spi", "quadquad2drv", 0);
    TunePlan plan = planOf(Mode::Velocity);
    plan.keep = true;
    plan.limits.travel = 800.0;
    const auto report = tune(bench, plan);
    ASSERT_TRUE(report) << report.error().text();
    std::printf("  %s: %s\n", std::string(toString(report->stopReason)).c_str(), report->evidence.english().c_str());
    EXPECT_EQ(report->stopReason, tuning::EndReason::Travel);
    EXPECT_TRUE(report->stopped);
    EXPECT_LE(bench.device->knowledge().profile().calibrated(quadquad2drv::calibration::velocityP), 0.0);
    EXPECT_FALSE(bench.simulator()->isOutputOn());
}

TEST(Acceptance, A09_EverySetThatIsProposedOnTheModelThatWasFoundKeepsItsMarginsAndTheyAreTold)
{
    for (const Timed &unit :
        {Timed{"sim:can", "dmc60c", 7, Mode::Velocity}, Timed{"sim:can", "dmc60c", 5, Mode::Position},
            Timed{"sim:can", "abstractdc", 3, Mode::Position}, Timed{"sim:spi", "quadquad2drv", 0, Mode::Velocity},
            Timed{"sim:serial", "supermodified", 5, Mode::Position}}) {
        ExperimentBench bench(unit.link, unit.family, unit.address);
        knowScales(bench);
        TunePlan plan = planOf(unit.loop);
        plan.propose = true;
        const auto report = tune(bench, plan);
        ASSERT_TRUE(report) << unit.family << ": " << report.error().text();
        ASSERT_EQ(report->proposals.size(), 3U) << unit.family;
        PlantModel off = report->plant;
        off.gain *= 1.2;
        off.delay *= 1.3;
        for (const Proposal &proposal : report->proposals) {
            const bool isBrisk = proposal.aim == Aim::Brisk;
            const double ms = marginsOf(unit.loop, report->plant, proposal.gains.made).ms;
            const double msOff = marginsOf(unit.loop, off, proposal.gains.made).ms;
            std::printf("A9 %s %d %s: Ms %.2f, %.2f where the model is off\n", std::string(unit.family).c_str(),
                unit.address, std::string(toString(proposal.aim)).c_str(), ms, msOff);
            EXPECT_LE(ms, isBrisk ? 1.7 : 1.6) << unit.family << ' ' << toString(proposal.aim);
            EXPECT_LE(msOff, isBrisk ? 2.3 : 1.9) << unit.family << ' ' << toString(proposal.aim);
            EXPECT_NEAR(proposal.margins.ms, ms, 0.02) << unit.family;
        }
    }
}

TEST(Acceptance, A11_ABlockUpdatedVelocityHardlyOvershootsBecauseItsFilterIsFound)
{
    ExperimentBench bench("sim:can", "dmc60c", 6, "dmc60c:6,motor=cim,load=9,velocity=block");
    const auto report = tune(bench, planOf(Mode::Velocity));
    ASSERT_TRUE(report) << report.error().text();
    print(*report);
    EXPECT_EQ(report->result, TuneResult::Kept) << report->evidence;
    ASSERT_TRUE(report->motor && report->motor->filter);
    EXPECT_EQ(report->motor->filter->kind, VelocityFilter::Kind::Block);
    PlantModel blind = report->plant;
    blind.delay -= report->motor->filter->delay;
    LoopBounds bounds;
    bounds.period = bench.device->family().loop->cycle;
    const Design naive = design(Mode::Velocity, blind, responseOf(Mode::Velocity, Aim::Normal, blind), bounds);
    const Prediction without
        = predictStep(Mode::Velocity, report->plant, naive.gains, 0.0, 100'000.0, 3.0, 1.0, bounds.period);
    std::printf("A11 overshoot %.1f %% with the filter found, %.1f %% would be without\n",
        100.0 * report->measured.overshoot.value_or(1.0), 100.0 * without.metrics.overshoot.value_or(0.0));
    EXPECT_LE(report->measured.overshoot.value_or(1.0), 0.06);
    EXPECT_GE(without.metrics.overshoot.value_or(0.0), 0.2);
}

TEST(Acceptance, A12_ThePositionLoopOfAnAbstractDcIsDampedByANegativeD)
{
    ExperimentBench bench("sim:can", "abstractdc", 3);
    TunePlan plan = planOf(Mode::Position);
    plan.keep = true;
    const auto report = tune(bench, plan);
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_EQ(report->result, TuneResult::Kept) << report->evidence;
    double raw = 0.0;
    for (const ScaledGains::Row &row : report->proposed.rows)
        raw = row.key == "position.d" ? row.number : raw;
    std::printf(
        "A12 abstractdc 3: raw D %.0f, overshoot %.1f %%\n", raw, 100.0 * report->measured.overshoot.value_or(1.0));
    EXPECT_GT(report->design->gains.d, 0.0);
    EXPECT_LT(raw, 0.0);
    EXPECT_LE(report->measured.overshoot.value_or(1.0), 0.01);
}

TEST(Acceptance, A13_ATuningOfEveryFamilyIsKeptWithinAMinute)
{
    double worst = 0.0;
    for (const Timed &unit :
        {Timed{"sim:can", "dmc60c", 5, Mode::Velocity}, Timed{"sim:can", "dmc60c", 7, Mode::Velocity},
            Timed{"sim:can", "dmc60c", 5, Mode::Position}, Timed{"sim:can", "dmc60c", 7, Mode::Position},
            Timed{"sim:can", "dmc60c", 5, Mode::Current}, Timed{"sim:can", "abstractdc", 3, Mode::Velocity},
            Timed{"sim:can", "abstractdc", 3, Mode::Position}, Timed{"sim:serial", "supermodified", 4, Mode::Position},
            Timed{"sim:serial", "supermodified", 5, Mode::Position},
            Timed{"sim:spi", "quadquad2drv", 0, Mode::Velocity}, Timed{"sim:spi", "quadquad2drv", 0, Mode::Position}}) {
        ExperimentBench bench(unit.link, unit.family, unit.address);
        TunePlan plan = planOf(unit.loop);
        plan.keep = unit.family == "abstractdc" || unit.family == "quadquad2drv";
        knowScales(bench);
        const auto report = tune(bench, plan);
        ASSERT_TRUE(report) << report.error().text();
        std::printf("A13 %s %d %s: %s in %.1f s of device time, tau %.0f ms\n", std::string(unit.family).c_str(),
            unit.address, std::string(toString(unit.loop)).c_str(), std::string(toString(report->result)).c_str(),
            report->seconds, 1e3 * report->plant.tau);
        EXPECT_EQ(report->result, TuneResult::Kept) << unit.family << ' ' << unit.address << ": " << report->evidence;
        EXPECT_LE(report->plant.tau, 0.3) << unit.family << ", no motor that the criterion speaks of";
        worst = std::max(worst, report->seconds);
    }
    EXPECT_LE(worst, 60.0);
}

TEST(Acceptance, ASearchForScalesChecksTheDirectionBeforeItClosesALoop)
{
    for (const auto &[fault, reason] :
        {std::pair("encoder-reversed", "wrong direction"), {"encoder-dead", "no motion"}}) {
        ExperimentBench bench("sim:spi", "quadquad2drv", 0);
        ASSERT_TRUE(bench.simulator()->disturb(fault, 1.0)) << fault;
        TunePlan plan = planOf(Mode::Velocity);
        plan.keep = true;
        const auto report = tune(bench, plan);
        ASSERT_TRUE(report) << report.error().text();
        EXPECT_EQ(report->result, TuneResult::Stopped) << fault;
        EXPECT_EQ(toString(report->stopReason), reason) << report->evidence.english();
        EXPECT_TRUE(report->stopped);
        EXPECT_FALSE(bench.simulator()->isOutputOn());
    }
}

/// The board tells nobody its duty, so no guard would see it.
TEST(Acceptance, TheSearchForScalesStaysWithinTheDutyOfThePlan)
{
    using quadquad2drv::PacketId;
    ExperimentBench bench("sim:spi", "quadquad2drv", 0);
    int powers = 0;
    int loops = 0;
    int limit = 0;
    const auto heard = bench.bench.link->traffic().add([&](const Traffic &traffic) {
        if (traffic.direction != Direction::Sent || traffic.bytes.size() < 6)
            return;
        const auto id = static_cast<PacketId>(traffic.bytes[2]);
        const int power = std::abs(static_cast<std::int16_t>(readU16le(traffic.bytes, 4)));
        if (id == PacketId::SetPowerLimit) {
            limit = power;
        } else if (id == PacketId::SetPower) {
            ++powers;
            EXPECT_LE(power, 820);
        } else if (id == PacketId::SetVelocityTarget || id == PacketId::SetPositionTarget) {
            ++loops;
            EXPECT_LE(limit, 820);
        }
    });
    TunePlan plan = planOf(Mode::Velocity);
    plan.keep = true;
    plan.limits.duty = 0.1;
    const auto report = tune(bench, plan);
    if (report)
        std::printf("  %s\n", report->evidence.english().c_str());
    EXPECT_GT(powers, 2);
    EXPECT_GT(loops, 0);
}

} // namespace
} // namespace mb::tuning
