// SPDX-License-Identifier: GPL-3.0-or-later
// The bounds that every proposal keeps, or there is none.
#include "experiment/envelope.h"
#include "tests/tuning/experimentbench.h"
#include "tests/tuning/matrix/groundtruth.h"
#include "tuning/margins.h"
#include "tuning/proposals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace mb::tuning {
namespace {

using test::ExperimentBench;

constexpr double mostDuties = 3.0; ///< that P makes of the step
constexpr double freeShare = 0.3;  ///< of the speed of a motor, that a proof asks for
const PlantModel calmMotor{1'285'000.0, 0.26, 0.0507, 0.002};

Envelope wideEnvelope()
{
    Envelope envelope;
    envelope.duty = 1.0;
    envelope.speed = 1'500'000.0;
    envelope.travel = 2e7;
    return envelope;
}

ProposalBasis basisOf(const Device &device, Mode loop, const PlantModel &plant)
{
    return {device.family(), device.knowledge().profile(), loop, 1, 0, plant, wideEnvelope(), {}};
}

struct AimBounds {
    Aim aim;
    double ms, off;
};
constexpr std::array<AimBounds, 3> aimBounds{{{Aim::Calm, 1.6, 1.9}, {Aim::Normal, 1.6, 1.9}, {Aim::Brisk, 1.7, 2.3}}};

/// Sensitivities of proposals, as the device stores them, at 400 points a decade.
class KeptMargins {
public:
    void look(const ProposalBasis &basis, const AimBounds &bounds)
    {
        const auto proposal = proposalFor(basis, {bounds.aim, {}, {}});
        ASSERT_TRUE(proposal) << proposal.error().text();
        PlantModel off = basis.plant;
        off.gain *= 1.2;
        off.delay *= 1.3;
        const ContinuousGains &gains = proposal->gains.made;
        const double ms = marginsOf(basis.loop, basis.plant, gains, 400).ms;
        const double msOff = marginsOf(basis.loop, off, gains, 400).ms;
        const std::string what = std::string(basis.family.key) + ' ' + std::string(toString(basis.loop)) + ' '
            + std::string(toString(bounds.aim));
        EXPECT_LE(ms, bounds.ms) << what;
        EXPECT_LE(msOff, bounds.off) << what;
        EXPECT_LE(gains.p * proposal->step, 1.001 * mostDuties) << what;
        worst = std::max(worst, ms);
        worstOff = std::max(worstOff, msOff);
    }
    void print(const std::string &of) const
    {
        std::printf("A9 %s: Ms %.4f, %.4f where the model is off\n", of.c_str(), worst, worstOff);
    }

    double worst = 0.0;
    double worstOff = 0.0;
};

TEST(Acceptance, A09_ProposalsKeepTheirMarginsAsTheDeviceStoresThem)
{
    for (const auto &[family, address] : {std::pair("dmc60c", 5), std::pair("abstractdc", 3)}) {
        const ExperimentBench bench("sim:can", family, address);
        for (const AimBounds &bounds : aimBounds) {
            KeptMargins margins;
            for (const Mode loop : {Mode::Velocity, Mode::Position}) {
                for (PlantModel plant : {PlantModel{367'000.0, 0.168, 0.052, 0.018, 1.2}, calmMotor,
                         PlantModel{8620.0, 0.1066, 0.0134, 0.0759, 2.2}, PlantModel{362'000.0, 0.019, 0.03, 0.02}}) {
                    if (loop == Mode::Position)
                        plant.delay = std::min(plant.delay, 0.03);
                    margins.look(basisOf(*bench.device, loop, plant), bounds);
                }
            }
            margins.print(std::string(family) + ", proposed " + std::string(toString(bounds.aim)));
        }
    }
}

/// The motors of the matrix as its figures tell them, where a family has a loop that the test above has not.
TEST(Acceptance, A09_ProposalsOfABoardOfASupermodifiedAndOfACurrentKeepThemToo)
{
    for (const auto &[family, loop, dialect] : {std::tuple("quadquad2drv", Mode::Velocity, ""),
             std::tuple("quadquad2drv", Mode::Position, ""), std::tuple("supermodified", Mode::Position, "D1"),
             std::tuple("supermodified", Mode::Position, "D2"), std::tuple("dmc60c", Mode::Current, "")}) {
        KeptMargins margins;
        for (const char *const motor : {"cim", "25d"}) {
            test::Cell cell;
            cell.family = family;
            cell.motor = motor;
            cell.loop = loop;
            cell.dialect = dialect;
            test::MatrixUnit unit(cell, true);
            ProposalBasis basis = basisOf(unit.device(), loop, test::groundTruth(cell, 1.0));
            basis.plant = test::groundTruth(cell, freeShare * basis.plant.gain);
            basis.scale = test::trueScale(cell);
            for (const AimBounds &bounds : aimBounds)
                margins.look(basis, bounds);
        }
        margins.print(std::string(family) + ' ' + std::string(toString(loop)) + ' ' + dialect);
    }
}

TEST(Proposals, ThePOfNumbersMakesThreeFullDutiesOfItsStepAtMostAndSaysSo)
{
    test::Cell board;
    board.family = "quadquad2drv";
    board.motor = "25d";
    test::MatrixUnit unit(board, true);
    const ExperimentBench bench;
    const ProposalWish quick{Aim::Normal, 0.005, 2.5};
    for (const auto &[device, gain] : {std::pair(&unit.device(), 8000.0), std::pair(bench.device, 362'000.0)}) {
        const auto proposal = proposalFor(basisOf(*device, Mode::Velocity, {gain, 0.39, 0.0055, 0.02}), quick);
        ASSERT_TRUE(proposal) << proposal.error().text();
        EXPECT_LE(proposal->gains.made.p * proposal->step, 1.001 * mostDuties);
        EXPECT_GE(proposal->gains.made.p * proposal->step, 0.9 * mostDuties) << "no slower than it must";
        EXPECT_EQ(proposal->design.bounds, (std::vector<std::string_view>{"largest error"}));
        EXPECT_EQ(proposal->design.asked, 0.005);
    }
    // a position whose friction takes more than three tenths of the duty is stepped over ten times what that holds
    const PlantModel stiff{362'000.0, 0.168, 0.02, 0.35};
    const auto held = proposalFor(basisOf(*bench.device, Mode::Position, stiff), {Aim::Normal, 0.1, 1.6});
    ASSERT_TRUE(held) << held.error().text();
    EXPECT_LE(held->gains.made.p * held->step, 1.001 * mostDuties);
}

TEST(Proposals, OneThatTheDeviceCannotStoreWithItsMarginIsRefused)
{
    const ExperimentBench bench("sim:can", "abstractdc", 3);
    int refused = 0;
    for (const Mode loop : {Mode::Velocity, Mode::Position}) {
        for (const double ms : {1.05, 1.1, 1.3, 1.6}) {
            for (const double response : {0.02, 0.3, 5.0}) {
                const auto proposal = proposalFor(
                    basisOf(*bench.device, loop, {8620.0, 0.1066, 0.0134, 0.0759}), {Aim::Normal, response, ms});
                if (!proposal) {
                    EXPECT_EQ(proposal.error().fault, Fault::OutOfRange);
                    ++refused;
                    continue;
                }
                EXPECT_LE(proposal->margins.ms, ms) << toString(loop) << ' ' << response;
            }
        }
    }
    EXPECT_GT(refused, 0);
}

TEST(Proposals, AStepDrawsNoMoreThanTheLimitAllowsOrIsNotProposed)
{
    const ExperimentBench bench;
    ProposalBasis basis = basisOf(*bench.device, Mode::Velocity, {367'000.0, 0.2, 0.052, 0.018, 1.34, 125.0, 2.7e-6});
    basis.taking = {0.1, 0.05, 0.0};
    const auto free = proposalFor(basis, {});
    ASSERT_TRUE(free && free->predicted.metrics.peakCurrent);
    for (const double share : {0.97, 0.7, 0.3, 0.15}) {
        basis.envelope.current = share * *free->predicted.metrics.peakCurrent;
        const auto held = proposalFor(basis, {});
        ASSERT_TRUE(held) << share;
        EXPECT_LE(*held->predicted.metrics.peakCurrent, *basis.envelope.current) << share;
        EXPECT_LT(held->step, free->step);
    }
    basis.envelope.current = 0.5; // friction alone takes 2.3 A
    const auto none = proposalFor(basis, {});
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().fault, Fault::OutOfRange);
    EXPECT_NE(none.error().text().find("A that are allowed"), std::string::npos) << none.error().text();
    basis.plant.stallCurrent = 0.0; // nobody knows
    EXPECT_FALSE(proposalFor(basis, {})->predicted.metrics.peakCurrent);
}

} // namespace
} // namespace mb::tuning
