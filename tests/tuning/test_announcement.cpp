// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/announcement.h"
#include "tests/tuning/tuningbench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace mb::tuning {
namespace {

using test::ExperimentBench;
using test::planOf;
using test::tune;

constexpr double glance = 0.05; ///< s, over which a speed is taken

/// What was said before an experiment.
struct Announced {
    double duty = 0.0;
    std::optional<double> speed;
    double travel = 0.0;
};

/// "at most 15 % duty, 1100 counts/s and 900 counts from where it stands"
std::vector<Announced> announcedIn(const std::vector<std::string> &notes)
{
    std::vector<Announced> all;
    for (const std::string &note : notes) {
        if (note.rfind("at most ", 0) != 0 || note.find("from where it stands") == std::string::npos)
            continue;
        Announced told;
        told.duty = std::atof(note.c_str() + 8) / 100.0;
        if (const auto at = note.find("duty, "); at != std::string::npos)
            told.speed = std::atof(note.c_str() + at + 6);
        told.travel = std::atof(note.c_str() + note.find(" and ") + 5);
        all.push_back(told);
    }
    return all;
}

double fastest(const Trace &position)
{
    double most = 0.0;
    for (std::size_t i = 0, k = 0; i < position.size(); ++i) {
        while (position.t[i] - position.t[k + 1] > glance && k + 1 < i)
            ++k;
        if (const double time = position.t[i] - position.t[k]; time > 0.8 * glance)
            most = std::max(most, std::abs(position.y[i] - position.y[k]) / time);
    }
    return most;
}

double farthest(const Trace &position)
{
    double most = 0.0;
    for (const double y : position.y)
        most = std::max(most, std::abs(y - position.y.front()));
    return most;
}

double strongest(const Trial &trial)
{
    double most = 0.0;
    if (const Signal *const duty = trial.signal("duty")) {
        for (const double y : duty->trace.y)
            most = std::max(most, std::abs(y));
    }
    return most;
}

void expectAnnounced(ExperimentBench &bench, Mode loop, int leastOwn)
{
    TunePlan plan = planOf(loop);
    plan.keep = true;
    const auto report = tune(bench, plan);
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_EQ(report->result, TuneResult::Kept) << report->evidence;
    const std::vector<Announced> told = announcedIn(bench.notes);
    const std::vector<Trial> &trials = bench.journal.completed;
    ASSERT_EQ(told.size(), trials.size()) << "each stimulus is announced";
    int own = 0;
    for (std::size_t i = 0; i < told.size(); ++i) {
        const Trace &position = trials[i].signal("position")->trace;
        EXPECT_LE(strongest(trials[i]), told[i].duty + 0.002) << i;
        if (told[i].speed) {
            EXPECT_LE(fastest(position), *told[i].speed) << i;
        }
        EXPECT_LE(farthest(position), told[i].travel) << i;
        EXPECT_LE(told[i].travel, 1.1 * trials[i].envelope.travel.value_or(0.0)) << i; // rounded up to two figures
        own += told[i].travel < 0.5 * trials[i].envelope.travel.value_or(0.0) ? 1 : 0;
    }
    std::printf("%s %s: %zu announced, %d closer than their limits; \"%s\"\n", report->device.c_str(),
        std::string(toString(loop)).c_str(), told.size(), own,
        std::find_if(bench.notes.begin(), bench.notes.end(), [](const std::string &note) {
            return note.rfind("at most ", 0) == 0;
        })->c_str());
    EXPECT_GE(own, leastOwn) << "what is expected, not only what its limits allow";
}

TEST(Announcement, EveryStimulusIsToldWithItsDutySpeedAndTravelBeforeItRuns)
{
    ExperimentBench velocity("sim:can", "dmc60c", 5);
    expectAnnounced(velocity, Mode::Velocity, 4);
    ExperimentBench position("sim:can", "dmc60c", 7);
    expectAnnounced(position, Mode::Position, 4);
    ExperimentBench current("sim:can", "dmc60c", 5);
    expectAnnounced(current, Mode::Current, 0);
    ExperimentBench drive("sim:can", "abstractdc", 3);
    expectAnnounced(drive, Mode::Velocity, 4);
}

TEST(Announcement, TheCheckOfTheDirectionIsToldWhereItComesFirst)
{
    ExperimentBench bench("sim:serial", "supermodified", 4);
    expectAnnounced(bench, Mode::Position, 1);
    ASSERT_FALSE(bench.notes.empty());
    const auto checked = std::find_if(bench.notes.begin(), bench.notes.end(),
        [](const std::string &note) { return note.starts_with("first its direction is checked: 20 counts up; "); });
    ASSERT_NE(checked, bench.notes.end());
    EXPECT_NE(checked->find("at most 100 % duty"), std::string::npos) << *checked;
    EXPECT_NE(checked->find("60 counts from where it stands"), std::string::npos) << *checked;
}

/// One by hand or of a battery, of whose motor nobody has told anything.
TEST(Announcement, AStepByItselfIsToldWithItsDirectionCheckBeforeItRuns)
{
    ExperimentBench bench("sim:can", "dmc60c", 5);
    const auto trial = bench.run(test::stepTo(Mode::Velocity, 20'000.0));
    ASSERT_TRUE(trial) << trial.error().text();
    ASSERT_EQ(trial->reason, tuning::EndReason::Done) << trial->detail;
    const std::vector<Announced> told = announcedIn(bench.notes);
    ASSERT_EQ(told.size(), 1U);
    EXPECT_LE(fastest(trial->signal("position")->trace), told.front().speed.value_or(0.0));
    EXPECT_LE(farthest(trial->signal("position")->trace), told.front().travel);
    const auto checked = std::find_if(bench.notes.begin(), bench.notes.end(), [](const std::string &note) {
        return note.starts_with("first its direction is checked: pushes of 0.3 s, until it turns; at most ");
    });
    ASSERT_NE(checked, bench.notes.end());
    EXPECT_TRUE(checked->find("counts/s and ") != std::string::npos || checked->ends_with("nobody knows yet"))
        << *checked;
    EXPECT_NE(checked->find("counts from where it stands"), std::string::npos) << *checked;
}

TEST(Announcement, OfAStepBetweenTwoSpeedsCountsWhatItGoesAtTheFirst)
{
    ExperimentBench bench("sim:can", "dmc60c", 5);
    ExperimentPlan plan = test::stepTo(Mode::Velocity, 8400.0);
    plan.from = 8000.0;
    plan.seconds = 0.1;
    const auto trial = bench.run(plan);
    ASSERT_TRUE(trial) << trial.error().text();
    ASSERT_EQ(trial->reason, tuning::EndReason::Done) << trial->detail;
    const std::vector<Announced> told = announcedIn(bench.notes);
    ASSERT_EQ(told.size(), 1U);
    EXPECT_LE(farthest(trial->signal("position")->trace), told.front().travel);
    EXPECT_LT(told.front().travel, 8000.0 * 8.0) << "and no more than may be";
}

TEST(Announcement, ALimitOfCurrentThatNobodyCanHoldIsSaidOnceAndTheDutyLimitStandsIn)
{
    ExperimentBench drive("sim:can", "abstractdc", 3);
    int told = 0;
    drive.surroundings.warn = [&](const Message &text) {
        told += text.english() == "the unit tells no current in ampere: the duty limit stands in for 2 A" ? 1 : 0;
    };
    ExperimentPlan plan = test::stepTo(Mode::Velocity, 4000.0);
    const auto free = drive.run(plan);
    ASSERT_TRUE(free) << free.error().text();
    EXPECT_EQ(told, 0) << "nobody asked for one";
    plan.limits.current = 2.0;
    const auto trial = drive.run(plan);
    ASSERT_TRUE(trial) << trial.error().text();
    EXPECT_EQ(trial->reason, tuning::EndReason::Done);
    EXPECT_FALSE(trial->envelope.current);
    EXPECT_EQ(told, 1);
    TunePlan tuning = planOf(Mode::Velocity);
    tuning.propose = true;
    tuning.limits.current = 2.0;
    const auto report = tune(drive, tuning);
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_GT(report->trials.size(), 1U);
    EXPECT_EQ(told, 2) << "of many pushes";
}

TEST(Announcement, ALimitOfCurrentThatItsGuardHoldsNeedsNoWord)
{
    ExperimentBench bench("sim:can", "dmc60c", 5);
    ExperimentPlan plan = test::stepTo(Mode::Velocity, 20'000.0);
    plan.limits.current = 60.0;
    ASSERT_TRUE(bench.run(plan));
    EXPECT_EQ(std::count_if(bench.notes.begin(), bench.notes.end(),
                  [](const std::string &note) { return note.find("stands in") != std::string::npos; }),
        0);
}

/// Its guard lets that pass.
TEST(Announcement, OfASpeedThatTheLimitsBoundIsWhatItsGuardStopsAt)
{
    ExperimentPlan plan;
    plan.mode = Mode::Duty;
    Trial trial;
    trial.stimulus = *Stimulus::make(Profile::Step, 0.0, 0.4, 1.0, 0.02);
    trial.envelope.speed = 1000.0;
    EXPECT_DOUBLE_EQ(extentOf(plan, trial, 0.0, 10'000.0).speed.value_or(0.0), 1200.0);
    EXPECT_DOUBLE_EQ(extentOf(plan, trial, 0.0, 2000.0).speed.value_or(0.0), 800.0);
    EXPECT_DOUBLE_EQ(extentOf(trial.envelope).speed.value_or(0.0), 1200.0);
}

TEST(Announcement, WhatNobodyKnowsIsBoundedByTheLimits)
{
    ExperimentPlan plan;
    plan.mode = Mode::Duty;
    plan.repeat = 2;
    Trial trial;
    trial.stimulus = *Stimulus::make(Profile::Step, 0.0, 0.4, 1.0, 0.02);
    trial.envelope.travel = 5000.0;
    const Extent unknown = extentOf(plan, trial, 0.0, 0.0);
    EXPECT_DOUBLE_EQ(unknown.duty, 0.4);
    EXPECT_FALSE(unknown.speed);
    EXPECT_DOUBLE_EQ(unknown.travel.value_or(0.0), 5000.0);
    EXPECT_EQ(textOf(unknown).english(),
        "at most 40 % duty and 5000 counts from where it stands, at a speed that nobody knows yet");
    const Extent known = extentOf(plan, trial, 0.0, 1000.0);
    EXPECT_DOUBLE_EQ(known.speed.value_or(0.0), 400.0);
    EXPECT_DOUBLE_EQ(known.travel.value_or(0.0), 1000.0); // it rolls on by a quarter
    EXPECT_EQ(textOf(extentOf(Envelope{5000.0, 300.0, {}, 0.4})).english(),
        "at most 40 % duty, 360 counts/s and 5000 counts from where it stands");
    EXPECT_EQ(textOf(extentOf(Envelope{3.75, 0.29, {}, 0.4})).english(),
        "at most 40 % duty, 0.35 counts/s and 3.8 counts from where it stands");
    trial.envelope.speed = 300.0;
    EXPECT_DOUBLE_EQ(extentOf(plan, trial, 0.0, 1000.0).speed.value_or(0.0), 360.0);
}

} // namespace
} // namespace mb::tuning
