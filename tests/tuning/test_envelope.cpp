// SPDX-License-Identifier: GPL-3.0-or-later
// What bounds a trial: the limits of the unit itself, those that somebody asks for, what may begin within them, and what no plan has.
#include "experiment/envelope.h"
#include "model/bench.h"
#include "model/family.h"
#include "model/registry.h"
#include "tests/tuning/experimentbench.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <tuple>
#include <utility>

namespace mb::tuning {
namespace {

using namespace std::chrono_literals;
using test::ExperimentBench;
using test::run;
using test::stepTo;

const Family &dmc60c()
{
    return *findFamily(families(), "dmc60c");
}

/// What is known of a DMC60C, and what follows from it.
struct OwnLimits {
    void set(std::string_view key, double number)
    {
        const auto index = findParameter(dmc60c().parameters, key);
        ASSERT_TRUE(index) << key;
        store.setRead(*index, toRaw(store.parameter(*index), number).value_or(0));
    }
    [[nodiscard]] Envelope at(double position) const { return ownLimits(dmc60c(), store.entries(), 1, 0, position); }

    ParameterStore store{dmc60c().parameters};
};

TEST(EnvelopeOfItsOwn, TravelIsThatToTheNearerOfTwoSoftLimits)
{
    OwnLimits own;
    own.set("limit.forward.soft.threshold", 5000.0);
    own.set("limit.reverse.soft.threshold", -1000.0);
    own.set("limit.forward.soft.enabled", 1.0);
    EXPECT_FALSE(own.at(0.0).travel) << "one bounds no travel both ways";
    own.set("limit.reverse.soft.enabled", 1.0);
    for (const auto &[position, travel] :
        {std::pair{0.0, 1000.0}, {1000.0, 2000.0}, {4500.0, 500.0}, {-900.0, 100.0}, {6000.0, 1000.0}})
        EXPECT_EQ(own.at(position).travel, travel) << position;
    own.set("limit.forward.soft.enabled", 0.0);
    EXPECT_FALSE(own.at(0.0).travel);
}

TEST(EnvelopeOfItsOwn, ALimitCountsWhereItIsSwitchedOn)
{
    OwnLimits own;
    EXPECT_EQ(own.at(0.0), Envelope()) << "what is not known bounds nothing";
    own.set("current_limit.continuous", 5.0);
    EXPECT_FALSE(own.at(0.0).current) << "nobody knows whether it is on";
    own.set("current_limit.enabled", 0.0);
    EXPECT_FALSE(own.at(0.0).current);
    own.set("current_limit.enabled", 1.0);
    EXPECT_EQ(own.at(0.0).current, 5.0);
    own.set("slot0.max_forward", 9830.0);
    EXPECT_NEAR(own.at(0.0).duty.value_or(9.0), 0.3, 1e-4) << "it has no switch";
}

TEST(EnvelopeOfItsOwn, IsThatOfTheGainsThatWillBeInForce)
{
    OwnLimits own;
    own.set("slot0.max_forward", 9830.0);
    own.set("current_limit.continuous", 5.0);
    own.set("current_limit.enabled", 0.0);
    const auto change = [](std::string_view key, std::int64_t raw) {
        return ParameterChange{*findParameter(dmc60c().parameters, key), raw};
    };
    const Envelope changed = ownLimits(dmc60c(), own.store.entries(), 1, 0, 0.0,
        {change("slot0.max_forward", 6553), change("current_limit.enabled", 1)});
    EXPECT_NEAR(changed.duty.value_or(9.0), 0.2, 1e-4);
    EXPECT_EQ(changed.current, 5.0);
    EXPECT_NEAR(own.at(0.0).duty.value_or(9.0), 0.3, 1e-4) << "nothing was written";
}

TEST(EnvelopeOfItsOwn, IsAskedOfTheUnit)
{
    ExperimentBench bench;
    auto &clock = bench.bench.clock;
    (void)run(clock, readOwnLimits(*bench.device, 1, 0, 0.0));
    const auto link = bench.bench.session.bench(*bench.bench.link)->hostLink();
    ASSERT_TRUE(link->open());
    const auto elsewhere = bench.device->family().open(*link, clock, bench.device->identity());
    for (const auto &[key, number] :
        {std::pair{"slot0.max_forward", 9830.0}, {"current_limit.continuous", 5.0}, {"current_limit.enabled", 1.0}}) {
        const ParameterChange change = bench.change(key, number);
        ASSERT_TRUE(run(clock, elsewhere->write(change.index, change.raw))) << key;
    }
    const auto own = run(clock, readOwnLimits(*bench.device, 1, 0, 0.0));
    ASSERT_TRUE(own && own->duty && own->current);
    EXPECT_NEAR(*own->duty, 0.3, 1e-4);
    EXPECT_EQ(*own->current, 5.0);
    const auto trial = bench.run(stepTo(Mode::Velocity, 20'000.0));
    ASSERT_TRUE(trial) << trial.error().text();
    EXPECT_EQ(trial->envelope.duty, own->duty);
    EXPECT_EQ(trial->envelope.current, own->current);
}

TEST(EnvelopeOfATrial, WhatNothingBoundsIsAskedFor)
{
    Envelope most;
    most.travel = most.current = most.duty = 1.0;
    struct Row {
        Mode mode;
        bool amperes;
        Envelope asked;
        const char *remedy;
    };
    for (const Row &row : {
             Row{Mode::Velocity, true, most, "give --speed"},
             {Mode::Position, true, most, ""},
             {Mode::Velocity, true, {}, "give --travel and --speed and --duty and --current"},
             {Mode::Position, true, {}, "give --travel and --duty and --current"},
             {Mode::Position, false, {}, "give --travel and --duty"},
         }) {
        const EnvelopeFacts facts{"can0/dmc60c:5", false, row.amperes};
        const auto found = resolve(dmc60c(), facts, row.mode, row.asked, {});
        const std::string remedy = found ? "" : found.error().remedy.english();
        EXPECT_EQ(remedy, row.remedy) << toString(row.mode);
        EXPECT_TRUE(found || found.error().fault == Fault::OutOfRange);
        EXPECT_EQ(resolve(dmc60c(), {"sim:can/dmc60c:5", true, true}, row.mode, {}, {}), dmc60c().trials->bench);
    }
}

TEST(EnvelopeOfATrial, TheNarrowerOfAskedAndOwnHolds)
{
    using Bound = std::optional<double>;
    for (const EnvelopeBound &bound : envelopeBounds) {
        for (const auto &[asked, own] : {std::pair{Bound(0.2), Bound(0.3)}, {Bound(0.3), Bound(0.2)},
                 {Bound(0.2), Bound()}, {Bound(), Bound(0.2)}}) {
            Envelope wished{.travel = 0.9, .speed = 0.9, .current = 0.9, .duty = 0.9};
            Envelope unit;
            wished.*bound.value = asked;
            unit.*bound.value = own;
            const auto found = resolve(dmc60c(), {"can0/dmc60c:5", false, true}, Mode::Velocity, wished, unit);
            ASSERT_TRUE(found) << bound.key;
            EXPECT_EQ((*found).*bound.value, 0.2) << bound.key;
        }
    }
}

TEST(EnvelopeOfATrial, AStimulusThatWouldLeaveItIsRefused)
{
    const Envelope within{.travel = 5000.0, .speed = 8000.0, .current = 5.0, .duty = 0.6};
    struct Row {
        Mode mode;
        double from;
        double to;
        int repeat;
        double position;
        const char *outside; ///< how its message begins; empty: it is inside
    };
    for (const Row &row : {
             Row{Mode::Current, 0.0, 5.0, 1, 0.0, ""},
             {Mode::Current, 0.0, 5.001, 1, 0.0, "current 5.001 "},
             {Mode::Current, 0.0, -5.001, 1, 0.0, "current 5.001 "},
             {Mode::Duty, 0.1, -0.6, 1, 0.0, ""},
             {Mode::Duty, 0.7, 0.1, 1, 0.0, "duty 0.7 "},
             {Mode::Velocity, -9000.0, 1000.0, 1, 0.0, "speed 9000 "},
             {Mode::Velocity, 0.0, 1000.0, 2, 0.0, ""},
             {Mode::Velocity, 0.0, 1000.0, 3, 0.0, "travel 60"},
             {Mode::Velocity, 0.0, -1000.0, 2, 0.0, ""},
             {Mode::Velocity, 0.0, -1000.0, 3, 0.0, "travel 60"},
             {Mode::Position, 30'000.0, 34'000.0, 1, 30'000.0, ""},
             {Mode::Position, 30'000.0, 36'000.0, 1, 30'000.0, "travel 6000 "},
             {Mode::Position, 30'000.0, -30'000.0, 1, 30'000.0, "travel 60000 "},
             {Mode::Position, 20'000.0, 30'500.0, 1, 30'000.0, "travel 10000 "},
         }) {
        const auto stimulus = Stimulus::make(Profile::Step, row.from, row.to, 2.0, 0.02);
        ASSERT_TRUE(stimulus);
        const auto inside = checkInside(within, row.mode, *stimulus, row.repeat, row.position);
        const std::string told = inside ? "" : inside.error().detail.english();
        EXPECT_EQ(inside.has_value(), *row.outside == '\0') << told;
        EXPECT_TRUE(told.starts_with(row.outside)) << told << ", expected " << row.outside;
    }
    const auto onItsWay = [&within](double from, double to) {
        return checkInside(within, Mode::Velocity, *Stimulus::make(Profile::Step, from, to, 0.1, 0.02), 1, 0.0);
    };
    EXPECT_TRUE(onItsWay(4000.0, 4200.0));
    EXPECT_FALSE(onItsWay(8000.0, 7600.0)) << "it is at X before and after";
    const auto up = Stimulus::make(Profile::Step, 0.0, 1000.0, 2.0, 0.02);
    EXPECT_FALSE(checkInside(within, Mode::Velocity, *up, 2, 0.0, 1500.0)) << "farther from where travel is counted";
    EXPECT_TRUE(checkInside(within, Mode::Velocity, *up, 2, 0.0, -1500.0)) << "through it";
}

TEST(PlanOfATrial, ASetOfGainsAnAxisOrANumberOfRunsThatThereIsNotIsRefused)
{
    struct Row {
        std::string_view family;
        int axis;
        int slot;
        int repeat;
        bool isPossible;
    };
    for (const Row &row : {Row{"dmc60c", 1, 0, 1, true}, {"dmc60c", 1, 1, 2, true}, {"dmc60c", 1, 2, 1, false},
             {"dmc60c", 1, -1, 1, false}, {"dmc60c", 0, 0, 1, false}, {"dmc60c", 2, 0, 1, false},
             {"dmc60c", 1, 0, 0, false}, {"dmc60c", 1, 0, -1, false}, {"quadquad2drv", 4, 0, 1, true},
             {"quadquad2drv", 5, 0, 1, false}}) {
        ExperimentPlan plan = stepTo(Mode::Velocity, 100.0);
        plan.axis = row.axis;
        plan.slot = row.slot;
        plan.repeat = row.repeat;
        const auto possible = checkPlan(*findFamily(families(), row.family), plan);
        EXPECT_EQ(possible.has_value(), row.isPossible) << row.family << ' ' << row.axis << row.slot << row.repeat;
        EXPECT_TRUE(possible || possible.error().fault == Fault::OutOfRange);
    }
}

TEST(PlanOfATrial, WhatIsNeverTriedIsRefusedWhateverIsKnownOfIt)
{
    for (const auto &[family, key, mode] :
        {std::tuple{"abstractdc", "current.averaging", Mode::Velocity}, // its noise changes with it
            std::tuple{"supermodified", "uart.baud", Mode::Position},   // after a restart
            std::tuple{"dmc60c", "faults.sticky", Mode::Velocity}}) {   // no setting
        ExperimentPlan plan = stepTo(mode, 100.0);
        plan.slot = 0;
        const Family &known = *findFamily(families(), family);
        plan.gains = {{*findParameter(known.parameters, key), 1}};
        const auto possible = checkPlan(known, plan);
        ASSERT_FALSE(possible) << key;
        EXPECT_EQ(possible.error().fault, Fault::OutOfRange);
        EXPECT_EQ(possible.error().detail.english(), std::string(key) + " is never part of an experiment");
    }
}

} // namespace
} // namespace mb::tuning
