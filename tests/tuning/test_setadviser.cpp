// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/tuning/tuningbench.h"
#include "tuning/proofcourse.h"
#include "tuning/setadviser.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace mb::tuning {
namespace {

using test::ExperimentBench;
using State = SetAdvice::State;

const PlantModel livelyMotor{1'285'000.0, 0.26, 0.0507, 0.002};

ProposalBasis advisedBasis(const ExperimentBench &bench, Mode loop = Mode::Velocity)
{
    Envelope envelope;
    envelope.duty = 1.0;
    envelope.speed = 1'500'000.0;
    envelope.travel = 2e7;
    return {bench.device->family(), bench.device->knowledge().profile(), loop, 1, 0, livelyMotor, envelope, {}};
}

/// Of a drive whose slot has these, and zeros beside them.
KnownGains slotWith(std::vector<std::pair<std::string, double>> values)
{
    KnownGains now;
    for (const char *name : {"p", "i", "d", "f", "i_zone", "allowable_error", "ramp", "max_forward", "max_reverse",
             "nominal_forward", "nominal_reverse"})
        now.emplace_back(std::string("slot0.") + name, 0.0);
    for (const auto &[key, value] : values) {
        const std::string &wanted = key;
        std::find_if(now.begin(), now.end(), [&wanted](const auto &known) { return known.first == wanted; })->second
            = value;
    }
    return now;
}

SetAdvice adviceOn(Cause cause, const ProposalBasis &basis, const Proposal &proposal, const KnownGains &now)
{
    for (const SetAdvice &advice : adviseOnSet(basis, proposal, now)) {
        if (advice.cause == cause)
            return advice;
    }
    ADD_FAILURE() << toString(cause);
    return {};
}

TEST(SetAdviser, HasItsPlacesInOneOrderAlsoWhereAllIsWell)
{
    const ExperimentBench bench;
    const ProposalBasis basis = advisedBasis(bench);
    const auto all = adviseOnSet(basis, proposalFor(basis, {}).value(), slotWith({}));
    ASSERT_EQ(all.size(), 5U);
    const Cause order[]{Cause::FeedForward, Cause::Deadband, Cause::DerivativeNoise, Cause::Resolution, Cause::Ramp};
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(all[i].cause, order[i]);
        EXPECT_EQ(all[i].state, State::Fine) << toString(all[i].cause);
        EXPECT_TRUE(all[i].changes.empty());
    }
}

TEST(SetAdviser, AFeedForwardInForceThatTheSetTakesAwayIsFixedInTheSet)
{
    const ExperimentBench bench;
    const ProposalBasis basis = advisedBasis(bench);
    const Proposal proposal = proposalFor(basis, {}).value();
    const double half = 0.5 / livelyMotor.gain * 32767.0 / basis.family.loop->velocityTime; // F·K of a half
    const SetAdvice advice = adviceOn(
        Cause::FeedForward, basis, proposal, slotWith({{"slot0.p", 1.0}, {"slot0.i", 0.003}, {"slot0.f", half}}));
    EXPECT_EQ(advice.state, State::Fixed);
    EXPECT_NEAR(advice.number, proposal.design.response + livelyMotor.delay, 0.03) << "what F leaves to I is little";
    EXPECT_EQ(adviceOn(Cause::FeedForward, basis, proposal, slotWith({{"slot0.f", half}})).state, State::Fine)
        << "without I it pays nothing back";
}

TEST(SetAdviser, FrictionThatPCannotOvercomeHasTheLeastOutputAsItsRemedy)
{
    const ExperimentBench bench;
    ProposalBasis basis = advisedBasis(bench, Mode::Position);
    basis.plant.friction = 0.05;
    Proposal proposal = proposalFor(basis, {}).value();
    std::erase_if(proposal.gains.rows,
        [](const ScaledGains::Row &row) { return row.role == Role::LeastForward || row.role == Role::LeastReverse; });
    const SetAdvice advice = adviceOn(Cause::Deadband, basis, proposal, slotWith({}));
    EXPECT_EQ(advice.state, State::Notable);
    EXPECT_DOUBLE_EQ(advice.number, deadband(basis.plant, proposal.gains.made));
    ASSERT_EQ(advice.changes.size(), 2U);
    EXPECT_EQ(advice.changes[0], (std::pair<std::string, double>("slot0.nominal_forward", 2048.0)));
    EXPECT_EQ(advice.changes[1], (std::pair<std::string, double>("slot0.nominal_reverse", -2048.0)));
    const SetAdvice helped = adviceOn(Cause::Deadband, basis, proposal, slotWith({{"slot0.nominal_forward", 2048.0}}));
    EXPECT_EQ(helped.state, State::Fine);
    basis.loop = Mode::Velocity;
    EXPECT_EQ(adviceOn(Cause::Deadband, basis, proposal, slotWith({})).state, State::Fine) << "it would never rest";
    for (const SetAdvice &one : adviseOnSet(advisedBasis(bench, Mode::Current), proposal, slotWith({})))
        EXPECT_NE(one.cause, Cause::Deadband);
}

TEST(SetAdviser, AGainOfFewStepsIsNamed)
{
    const ExperimentBench bench;
    const ProposalBasis basis = advisedBasis(bench);
    Proposal proposal = proposalFor(basis, {}).value();
    proposal.gains.rows = {{"slot0.p", 40000, 0.6}, {"slot0.i", 41, 0.0006}, {"slot0.i_zone", 3, 3.0}};
    const SetAdvice advice = adviceOn(Cause::Resolution, basis, proposal, slotWith({}));
    EXPECT_EQ(advice.state, State::Notable);
    EXPECT_EQ(advice.key, "slot0.i");
    EXPECT_DOUBLE_EQ(advice.number, 41.0);
}

TEST(SetAdviser, ARampSlowerThanHalfTheResponseIsToBeSwitchedOffAndAnUnreadOneIsSaid)
{
    const ExperimentBench bench;
    const ProposalBasis basis = advisedBasis(bench);
    const Proposal proposal = proposalFor(basis, {}).value();
    const double quickest = basis.family.loop->period * 32767.0 / proposal.design.response; // takes the whole response
    const SetAdvice advice = adviceOn(Cause::Ramp, basis, proposal, slotWith({{"slot0.ramp", quickest}}));
    EXPECT_EQ(advice.state, State::Notable);
    EXPECT_NEAR(advice.number, 2.0 * advice.limit, 0.01);
    ASSERT_EQ(advice.changes.size(), 1U);
    EXPECT_EQ(advice.changes[0].second, 0.0);
    EXPECT_EQ(adviceOn(Cause::Ramp, basis, proposal, slotWith({{"slot0.ramp", 4.0 * quickest}})).state, State::Fine);
    EXPECT_EQ(adviceOn(Cause::Ramp, basis, proposal, {}).state, State::Unread);
}

TEST(SetAdviser, NoiseOfDIsJudgedWhereDIs)
{
    const ExperimentBench bench;
    const ProposalBasis basis = advisedBasis(bench, Mode::Position);
    Proposal proposal = proposalFor(basis, {}).value();
    proposal.gains.made.d = 0.2 * basis.family.loop->period;
    const SetAdvice advice = adviceOn(Cause::DerivativeNoise, basis, proposal, slotWith({}));
    EXPECT_EQ(advice.state, State::Notable);
    EXPECT_NEAR(advice.number, 0.2, 1e-9);
}

TEST(SetAdviser, NoiseOfDIsThatOfThePassesOfItsLoop)
{
    const ExperimentBench bench("sim:can", "abstractdc", 3);
    const ProposalBasis basis = advisedBasis(bench, Mode::Position);
    Proposal proposal = proposalFor(basis, {}).value();
    EXPECT_EQ(adviceOn(Cause::DerivativeNoise, basis, proposal, {}).state, State::Fine) << "its design kept the bound";
    proposal.gains.made.d = 0.2 * basis.family.loop->cycle;
    EXPECT_NEAR(adviceOn(Cause::DerivativeNoise, basis, proposal, {}).number, 0.2, 1e-9);
}

TEST(ProofCourse, SaysWhereHowLongAndWithinWhat)
{
    const ExperimentBench bench;
    const ProposalBasis basis = advisedBasis(bench);
    const Proposal proposal = proposalFor(basis, {}).value();
    const ProofCourse course = courseOf(basis, proposal);
    EXPECT_EQ(course.slot, 1) << "the slot that the result is not for";
    EXPECT_EQ(course.steps, 4);
    EXPECT_GT(course.seconds, 4.0 * proposal.predicted.metrics.settle.value());
    EXPECT_LT(course.seconds, 30.0);
    EXPECT_DOUBLE_EQ(course.extent.duty, basis.envelope.duty.value_or(1.0));
    EXPECT_GE(course.extent.speed.value_or(0.0), proposal.step);
    EXPECT_GT(course.extent.travel.value_or(0.0), 2.0 * proposal.step * proposal.predicted.metrics.settle.value());
    Metrics measured = proposal.predicted.metrics;
    EXPECT_TRUE(judgeProof(measured, proposal.predicted.metrics, proposal.step, 0.0).empty());
    measured.overshoot = course.limits.overshoot + 0.01;
    EXPECT_FALSE(judgeProof(measured, proposal.predicted.metrics, proposal.step, 0.0).empty());
    measured.overshoot = 0.0;
    measured.settle = *course.limits.settle + 0.01;
    EXPECT_FALSE(judgeProof(measured, proposal.predicted.metrics, proposal.step, 0.0).empty());
}

} // namespace
} // namespace mb::tuning
