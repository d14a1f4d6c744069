// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/scope.h"
#include "experiment/envelope.h"
#include "support/heldbackground.h"
#include "tests/tuning/tuningbench.h"
#include "tuning/frequencyresponse.h"
#include "tuning/proposals.h"
#include "tuning/uncertainty.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <ctime>

namespace mb::tuning {
namespace {

using test::ExperimentBench;

const PlantModel slow{1'285'000.0, 0.26, 0.0507, 0.002};

ProposalBasis basisOf(const ExperimentBench &bench, Mode loop = Mode::Velocity)
{
    Envelope envelope;
    envelope.duty = 1.0;
    envelope.speed = 1'500'000.0;
    envelope.travel = 2e7;
    return {bench.device->family(), bench.device->knowledge().profile(), loop, 1, 0, slow, envelope, {}};
}

TEST(Proposals, AreThoseOfTheEngineWithoutADevice)
{
    ExperimentBench bench("sim:can", "dmc60c", 7);
    TunePlan plan;
    plan.propose = true;
    const auto report = test::run(bench.bench.clock,
        autotune(*bench.device, bench.bench.session.stream(*bench.device), plan, bench.surroundings));
    ASSERT_TRUE(report) << report.error().text();
    ASSERT_EQ(report->proposals.size(), 3U);
    ProposalBasis basis = basisOf(bench);
    EXPECT_EQ(report->envelope.speed, basis.envelope.speed);
    basis.plant = report->plant;
    basis.taking = report->taking;
    for (const Proposal &proposed : report->proposals) {
        const auto again = proposalFor(basis, {proposed.aim, {}, {}});
        ASSERT_TRUE(again) << again.error().text();
        EXPECT_EQ(again->gains.made, proposed.gains.made);
        EXPECT_EQ(again->predicted.measured, proposed.predicted.measured);
    }
    for (const int slot : {0, 1}) {
        basis.slot = slot;
        EXPECT_EQ(proposalFor(basis, {})->gains.rows.front().key, slot == 0 ? "slot0.p" : "slot1.p");
    }
}

/// Whatever was searched for under the limits of before.
TEST(Proposals, WithinOtherLimitsMakeTheStepOfOnesThatAreFoundThere)
{
    const ExperimentBench bench("sim:can", "dmc60c", 5);
    for (const Mode loop : {Mode::Velocity, Mode::Position}) {
        const ProposalBasis wide = basisOf(bench, loop);
        ProposalBasis narrow = wide;
        narrow.envelope.speed = 100'000.0;
        narrow.envelope.duty = 0.5;
        const auto found = proposalFor(wide, {});
        const auto there = proposalFor(narrow, {});
        ASSERT_TRUE(found && there);
        const auto moved = movedTo(narrow, *found);
        ASSERT_TRUE(moved);
        EXPECT_EQ(moved->gains.made, found->gains.made);
        EXPECT_EQ(moved->step, there->step);
        EXPECT_NE(moved->step, found->step);
        EXPECT_FALSE(isAlikeWithin(wide.envelope, narrow, found->gains.made));
        narrow.envelope = wide.envelope;
        narrow.envelope.travel = 1.001 * *wide.envelope.travel;
        EXPECT_TRUE(isAlikeWithin(wide.envelope, narrow, found->gains.made));
    }
}

TEST(Proposals, TheSlidersAreFollowedUntilABoundHoldsThemAndSaysSo)
{
    const ExperimentBench bench;
    const ProposalBasis basis = basisOf(bench);
    double before = 0.0;
    for (const double response : {0.4, 0.2, 0.1}) {
        const auto asked = proposalFor(basis, {Aim::Normal, response, 1.6});
        ASSERT_TRUE(asked);
        EXPECT_DOUBLE_EQ(asked->design.response, response);
        EXPECT_TRUE(asked->design.bounds.empty());
        EXPECT_GT(asked->gains.made.p, before);
        before = asked->gains.made.p;
    }
    const auto quick = proposalFor(basis, {Aim::Normal, 0.005, 1.3});
    ASSERT_TRUE(quick);
    EXPECT_GT(quick->design.response, 0.02);
    EXPECT_EQ(quick->design.bounds, (std::vector<std::string_view>{"margin"}));
    EXPECT_LE(quick->margins.ms, 1.31);
    const auto lively = proposalFor(basis, {Aim::Normal, 0.005, 2.0});
    EXPECT_LT(lively->design.response, quick->design.response);
    const auto noisy = proposalFor(basisOf(bench, Mode::Position), {Aim::Normal, 0.0005, 2.0});
    EXPECT_TRUE(!noisy || !noisy->design.bounds.empty());
}

TEST(Proposals, OneIsDesignedAndItsBandDrawnBetweenTwoFrames)
{
    const ExperimentBench bench;
    const ProposalBasis basis = basisOf(bench);
    std::vector<double> milliseconds;
    for (int i = 0; i < 40; ++i) {
        const std::clock_t begin = std::clock();
        const auto proposal = proposalFor(basis, {Aim::Normal, 0.01 + 0.005 * i, 1.2 + 0.02 * i});
        ASSERT_TRUE(proposal);
        const PredictionBand band = bandOf(proposal->predicted, Mode::Velocity, slow, {5000.0, 0.001, 0.0005},
            proposal->gains.made, proposal->step, 1.0, predictionPeriod(basis));
        ASSERT_FALSE(band.low.isEmpty());
        milliseconds.push_back(1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    }
    std::sort(milliseconds.begin(), milliseconds.end());
    std::printf("a proposal with its band: median %.1f ms, at most %.1f ms of processor time (to reach: 16 ms)\n",
        milliseconds[20], milliseconds.back());
    EXPECT_LE(milliseconds[20], 16.0);
}

TEST(Proposals, ThreeOfThemMoveToAnotherSlotWithinAFrame)
{
    const ExperimentBench bench;
    for (const Mode loop : {Mode::Velocity, Mode::Position}) {
        ProposalBasis basis = basisOf(bench, loop);
        std::vector<Proposal> all;
        for (const Aim aim : {Aim::Calm, Aim::Normal, Aim::Brisk}) {
            auto proposal = proposalFor(basis, {aim, {}, {}});
            ASSERT_TRUE(proposal) << proposal.error().text();
            all.push_back(std::move(*proposal));
        }
        basis.slot = 1;
        const std::clock_t begin = std::clock();
        for (const Proposal &proposal : all) {
            const auto moved = movedTo(basis, proposal);
            ASSERT_TRUE(moved) << moved.error().text();
            EXPECT_EQ(moved->gains.made, proposal.gains.made);
            EXPECT_EQ(moved->gains.rows.size(), proposal.gains.rows.size());
            for (std::size_t i = 0; i < moved->gains.rows.size(); ++i) {
                EXPECT_EQ(moved->gains.rows[i].key.rfind("slot1.", 0), 0U);
                EXPECT_EQ(moved->gains.rows[i].raw, proposal.gains.rows[i].raw);
            }
        }
        const double took = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
        std::printf("three proposals in another slot, %s: %.3f ms of processor time (to reach: 16 ms)\n",
            std::string(toString(loop)).c_str(), took);
        EXPECT_LE(took, 16.0);
    }
}

TEST(Proposals, AreSearchedForInTheBackgroundWhereThereIsOne)
{
    ExperimentBench bench("sim:can", "dmc60c", 7);
    test::HeldBackground background;
    bench.device->link().settings().background = &background;
    TunePlan plan = test::planOf(Mode::Velocity);
    plan.propose = true;
    std::optional<Result<TuneReport>> report;
    Scope scope(bench.bench.clock);
    scope.spawn<TuneReport>(
        autotune(*bench.device, bench.bench.session.stream(*bench.device), plan, bench.surroundings),
        [&report](Result<TuneReport> result) { report = std::move(result); });
    ASSERT_TRUE(
        bench.bench.clock.runUntil([&background] { return background.waiting() > 0; }, std::chrono::minutes(2)));
    EXPECT_EQ(background.lane(), "design");
    bench.bench.clock.advance(std::chrono::seconds(1));
    EXPECT_FALSE(report) << "the thread of the session is free meanwhile";
    background.release();
    ASSERT_TRUE(bench.bench.clock.runUntil([&report] { return report.has_value(); }, std::chrono::seconds(1)));
    ASSERT_TRUE(*report) << report->error().text();
    EXPECT_EQ((*report)->proposals.size(), 3U);
    bench.device->link().settings().background = nullptr;
}

TEST(PredictionBands, HoldEveryStepOfAPlantInsideItsErrors)
{
    const ExperimentBench bench;
    const ProposalBasis basis = basisOf(bench);
    const auto proposal = proposalFor(basis, {});
    ASSERT_TRUE(proposal);
    const PlantErrors errors{100'000.0, 0.03, 0.01};
    const PredictionBand band = bandOf(proposal->predicted, Mode::Velocity, slow, errors, proposal->gains.made,
        proposal->step, 1.0, predictionPeriod(basis));
    ASSERT_EQ(band.low.size(), proposal->predicted.measured.size());
    double widest = 0.0;
    for (std::size_t i = 0; i < band.low.size(); ++i) {
        EXPECT_LE(band.low.y[i], proposal->predicted.measured.y[i]);
        EXPECT_GE(band.high.y[i], proposal->predicted.measured.y[i]);
        widest = std::max(widest, band.high.y[i] - band.low.y[i]);
    }
    EXPECT_GT(widest, 0.1 * proposal->step);
    const PredictionBand none = bandOf(proposal->predicted, Mode::Velocity, slow, {}, proposal->gains.made,
        proposal->step, 1.0, predictionPeriod(basis));
    EXPECT_EQ(none.low.y, none.high.y);
}

KnownGains numbersOf(const ScaledGains &gains)
{
    KnownGains numbers;
    for (const ScaledGains::Row &row : gains.rows)
        numbers.emplace_back(row.key, row.number);
    return numbers;
}

TEST(FormerGains, AreTriedWithinTheBoundsOfAProposalOnly)
{
    const ExperimentBench bench("sim:can", "abstractdc", 3);
    ProposalBasis basis = basisOf(bench, Mode::Position);
    basis.plant = {80'000.0, 0.12, 0.031, 0.02};
    const auto proposal = proposalFor(basis, {Aim::Normal, {}, {}});
    ASSERT_TRUE(proposal) << proposal.error().text();
    const auto asFormer = [&](double stiffer, double damper) {
        ContinuousGains gains = proposal->gains.made;
        gains.p *= stiffer;
        gains.d *= damper;
        const auto scaled = scaleGains(basis.family, basis.profile, basis.loop, 1, 0, gains);
        return formerProposal(basis, numbersOf(*scaled), proposal->step);
    };
    const auto same = asFormer(1.0, 1.0);
    ASSERT_TRUE(same);
    EXPECT_TRUE(same->beyond.empty()) << same->beyond.english();
    EXPECT_NEAR(same->proposal.margins.ms, proposal->margins.ms, 1e-6);
    EXPECT_NEAR(
        same->proposal.predicted.metrics.rise.value_or(0.0), proposal->predicted.metrics.rise.value_or(1.0), 0.02);
    EXPECT_TRUE(asFormer(0.5, 1.0)->beyond.empty());
    EXPECT_NE(asFormer(2.5, 1.0)->beyond.english().find("sensitivity"), std::string::npos);
    EXPECT_FALSE(asFormer(1.0, 0.0)->beyond.empty()) << "nothing damps it";
    EXPECT_FALSE(asFormer(1.0, 4.0)->beyond.empty()) << "too little margin";
}

} // namespace
} // namespace mb::tuning
