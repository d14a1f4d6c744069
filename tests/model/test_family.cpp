// SPDX-License-Identifier: GPL-3.0-or-later
// What is the same for every family: words that files and the console have, reports that nobody else makes, rows that are looked up.
#include "model/family.h"
#include "model/loopparameters.h"
#include "model/parameterstore.h"
#include "model/registry.h"
#include "model/setpoint.h"
#include "model/setpointstream.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace mb {
namespace {

TEST(FamilyWords, OfOutcomesStatesEndsAndGains)
{
    const auto wordsOf = [](auto first, auto last) {
        std::string all;
        for (int i = static_cast<int>(first); i <= static_cast<int>(last); ++i)
            all += std::string(toString(static_cast<decltype(first)>(i))) + '|';
        return all;
    };
    EXPECT_EQ(wordsOf(UpdateOutcome::Done, UpdateOutcome::Cancelled), "done|up-to-date|refused|failed|cancelled|");
    EXPECT_EQ(wordsOf(DeviceState::Duplicate, DeviceState::Online), "duplicate|unassigned|bootloader|online|");
    using Ends = SetPointStream::End;
    std::string ends;
    for (const Ends end : {Ends::None, Ends::Stopped, Ends::LeaseExpired, Ends::Late, Ends::Slept, Ends::LinkLost,
             Ends::DeviceSilent, Ends::DeviceRestarted, Ends::ForeignMaster, Ends::Unguarded, Ends::Refused})
        ends += std::string(toString(end)) + '|';
    EXPECT_EQ(ends,
        "running|stopped|lease expired|late|slept|link lost|device silent|device restarted|foreign master|unguarded|"
        "refused|");
    EXPECT_EQ(wordsOf(ParameterState::Unknown, ParameterState::Failed), "unknown|stored|ram|volatile|assumed|failed|");
    EXPECT_EQ(wordsOf(LinkKind::Can, LinkKind::Spi), "can|serial|spi|");
    std::string letters;
    for (const Role role : {Role::Proportional, Role::Integral, Role::Derivative, Role::FeedForward})
        letters += gainLetter(role);
    EXPECT_EQ(letters, "PIDF");
    EXPECT_EQ(gainLetter(Role::Limit), "");
    EXPECT_EQ(gainLetter(Role::None), "");
}

TEST(FamilyWords, EveryModeHasANameThatLeadsBackToItAndAUnit)
{
    std::string all;
    for (const Mode mode : {Mode::Off, Mode::Duty, Mode::Velocity, Mode::Position, Mode::Current, Mode::Voltage,
             Mode::Follow, Mode::RampPosition, Mode::RampVelocity}) {
        EXPECT_EQ(modeFromString(toString(mode)), mode);
        all += std::string(toString(mode)) + ' ' + std::string(unitOf(mode)) + '|';
    }
    EXPECT_EQ(all,
        "off |duty |velocity counts/s|position counts|current A|voltage V|follow |ramp-position counts|ramp-velocity "
        "counts/s|");
    for (const char *none : {"", "Duty", "dut", "duty "})
        EXPECT_EQ(modeFromString(none), std::nullopt) << none;
}

TEST(FamilyReports, AnUpdateThatWasCutTellsHowFarItCameAndWhetherSomebodyWantedIt)
{
    const UpdateStanding standing{"1.22", 17, 3};
    const Error lost{Fault::LinkLost, say("the cable is out"), say("plug it in"), "sudo plug", Ailment::Gone};
    const UpdateReport failed = unfinished(standing, lost);
    EXPECT_EQ(failed.outcome, UpdateOutcome::Failed);
    EXPECT_EQ(failed.from, "1.22");
    EXPECT_EQ(failed.to, "");
    EXPECT_EQ(failed.pages, 17);
    EXPECT_EQ(failed.retries, 3);
    EXPECT_FALSE(failed.verified);
    EXPECT_EQ(failed.evidence, "the cable is out");
    EXPECT_EQ(failed.remedy, "plug it in: sudo plug");
    EXPECT_EQ(failed.summary(), "the cable is out; plug it in: sudo plug");
    EXPECT_EQ(failed.fault, Fault::LinkLost);
    const UpdateReport cancelled = unfinished(standing, {Fault::Cancelled, say("stopped by hand")});
    EXPECT_EQ(cancelled.outcome, UpdateOutcome::Cancelled);
    EXPECT_EQ(cancelled.fault, Fault::Cancelled);
    EXPECT_EQ(cancelled.summary(), "stopped by hand");
}

TEST(FamilyRows, AFaultIsFoundByItsKeyWithOrWithoutItsAxis)
{
    const std::array rows{FaultRow{"glitch", "glitch"}, FaultRow{"over_current", "over-current"}};
    Family family{};
    family.faults = rows;
    EXPECT_EQ(findFault(family, "glitch"), &rows[0]);
    EXPECT_EQ(findFault(family, "over_current"), &rows[1]);
    EXPECT_EQ(findFault(family, "ch1.glitch"), &rows[0]);
    EXPECT_EQ(findFault(family, "ch4.over_current"), &rows[1]);
    for (const char *none : {"", "glitc", "x.glitch", "ch1.", "ch1.glitches"})
        EXPECT_EQ(findFault(family, none), nullptr) << none;
}

TEST(FamilyRows, AnUpdateIsSpokenOfAsOnTheWayThatAWindowOffers)
{
    int routed = 0;
    for (const Family *const family : families()) {
        const UpdateWords &words = updateWords(*family);
        EXPECT_EQ(&words, family->routes.empty() ? &family->updateWords : &family->routes[0].words) << family->key;
        routed += family->routes.empty() ? 0 : 1;
    }
    EXPECT_GT(routed, 0);
    EXPECT_LT(routed, static_cast<int>(families().size()));
}

TEST(FamilyRows, AGainIsFoundByItsRoleInItsSlotOfItsLoop)
{
    const Family &family = *findFamily(families(), "dmc60c");
    const auto keyOf = [&family](std::optional<ParameterIndex> index) {
        return index ? std::string(family.parameters[index->value].key) : std::string("none");
    };
    EXPECT_EQ(keyOf(parameterOf(family, Mode::Velocity, 1, 0, Role::Proportional)), "slot0.p");
    EXPECT_EQ(keyOf(parameterOf(family, Mode::Position, 1, 1, Role::Derivative)), "slot1.d");
    EXPECT_EQ(keyOf(parameterOf(family, Mode::Velocity, 1, 7, Role::Proportional)), "none");
    EXPECT_EQ(keyOf(parameterOf(family, Mode::Duty, 1, 0, Role::Proportional)), "none");
    EXPECT_EQ(keyOf(parameterOf(family, Mode::Velocity, 1, 0, Role::Divisor)), "none");
    EXPECT_EQ(keyOf(parameterOfAxis(family, 7, Role::Proportional)), "none");
    EXPECT_EQ(roleOf(family, "slot0.p"), Role::Proportional);
    EXPECT_EQ(roleOf(family, "slot0.pp"), Role::None);
    const Family &board = *findFamily(families(), "quadquad2drv");
    const auto ofThree = parameterOfAxis(board, 3, Role::Proportional);
    ASSERT_TRUE(ofThree);
    EXPECT_TRUE(board.parameters[ofThree->value].key.starts_with("ch3."));
}

} // namespace
} // namespace mb
