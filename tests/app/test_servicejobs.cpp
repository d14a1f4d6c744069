// SPDX-License-Identifier: GPL-3.0-or-later
// Units served in the engine's session: the link is lent, nothing turns unarmed, STOP ends all. Virtual time.
#include "servedbench.h"

#include <algorithm>

namespace mb {
namespace {

using namespace std::chrono_literals;
using test::Served;

TEST_F(Served, EveryUnitOfALinkAndTheEngineLeavesItAloneMeanwhile)
{
    ASSERT_TRUE(serve({recipe(plain), {"sim:can"}, std::nullopt}));
    EXPECT_TRUE(view().running);
    test::Heard<> refused;
    core->send(orders::Identify{core->session().idOf(*device(7))}, refused.finished());
    ASSERT_TRUE(refused.has_value());
    EXPECT_FALSE(*refused) << "the link is lent";
    ASSERT_TRUE(clock.runUntil([this] { return !view().running; }, 10min));
    EXPECT_GE(view().counts.passed, 2);
    EXPECT_EQ(view().counts.ended(), static_cast<int>(view().rows.size()));
    EXPECT_GE(journal->list({})->size(), static_cast<std::size_t>(view().counts.passed));
    core->send(orders::Identify{core->session().idOf(*device(7))}, refused.finished());
    ASSERT_TRUE(clock.runUntil([&refused] { return refused && *refused; }, 10s)) << "it is given back";
}

TEST_F(Served, NoHandReachesIntoALinkThatIsLent)
{
    const DeviceId seven = core->session().idOf(*device(7));
    SetPoint slow;
    slow.mode = Mode::Duty;
    slow.target = 0.1;
    ASSERT_TRUE(serve({recipe(moving), {"sim:can"}, std::nullopt}));
    test::Heard<> started;
    core->send(orders::StartMotion{seven, slow, 500ms}, started.finished());
    ASSERT_TRUE(started.has_value());
    EXPECT_FALSE(*started);
    test::Heard<> released;
    core->send(orders::ReleaseMoves{seven}, released.finished());
    ASSERT_TRUE(released.has_value());
    EXPECT_EQ(released->error().detail.english(), "units are served on this link");
    test::Heard<> sent;
    core->send(orders::SendFrame{"sim:can", *canFrameFromText("123#00")}, sent.finished());
    ASSERT_TRUE(sent.has_value());
    EXPECT_FALSE(*sent);
    clock.advance(200ms);
    EXPECT_FALSE(anyMoves());
}

TEST_F(Served, ALinkWhoseMotorIsDrivenByHandIsNotServed)
{
    const DeviceId seven = core->session().idOf(*device(7));
    SetPoint slow;
    slow.mode = Mode::Duty;
    slow.target = 0.1;
    test::Heard<> started;
    core->send(orders::StartMotion{seven, slow, 500ms}, started.finished());
    ASSERT_TRUE(*started);
    EXPECT_FALSE(serve({recipe(moving), {"sim:can"}, std::nullopt}));
    EXPECT_FALSE(view().running);
    core->send(orders::StopMotion{seven});
    EXPECT_TRUE(serve({recipe(moving), {"sim:can"}, std::nullopt}));
}

TEST_F(Served, TheSameLinkAgainAndARetryOfNothingGivesItBack)
{
    for (int round = 0; round < 2; ++round) {
        ASSERT_TRUE(serve({recipe(plain), {"sim:can"}, std::nullopt}));
        EXPECT_FALSE(serve({recipe(plain), {"sim:can"}, std::nullopt})) << "it runs";
        EXPECT_TRUE(isLent());
        ASSERT_TRUE(clock.runUntil([this] { return !view().running; }, 10min));
        EXPECT_GE(view().counts.passed, 2);
        core->send(orders::RetryUnit{12345});
        EXPECT_FALSE(view().running);
    }
    test::Heard<> free;
    core->send(orders::Identify{core->session().idOf(*device(7))}, free.finished());
    ASSERT_TRUE(clock.runUntil([&free] { return free.has_value(); }, 10s));
    EXPECT_TRUE(*free);
}

TEST_F(Served, TheFiveMinutesOfAnArmingDoNotRunWhileAUnitIsThere)
{
    for (Simulator *unit : core->session().bench(*core->session().links().front())->simulators())
        unit->setPowered(false);
    clock.advance(10s);
    ASSERT_TRUE(serve({recipe(moving), {"sim:can"}, 0}));
    core->send(orders::ArmService{true});
    clock.advance(4min + 40s);
    ASSERT_TRUE(view().isArmed());
    EXPECT_LT(view().armedUntil - clock.now(), 30s);
    for (Simulator *unit : core->session().bench(*core->session().links().front())->simulators())
        unit->setPowered(true);
    const auto isServed = [this] {
        return std::ranges::any_of(
            view().rows, [](const service::QueueRow &row) { return row.state == service::RowState::Running; });
    };
    ASSERT_TRUE(clock.runUntil(isServed, 15s));
    EXPECT_GT(view().armedUntil - clock.now(), 4min + 50s);
}

TEST_F(Served, NothingTurnsUnlessItIsArmed)
{
    ASSERT_TRUE(serve({recipe(moving), {"sim:can"}, std::nullopt}));
    EXPECT_FALSE(clock.runUntil([this] { return anyMoves() || !view().running; }, 20min));
    EXPECT_TRUE(view().waitsForArm());
    EXPECT_EQ(waiting().visit.step, service::Step::Test);
    EXPECT_EQ(waiting().what.english(), "waits until the station is armed");
    EXPECT_TRUE(waiting().mayInterrupt);
    EXPECT_EQ(view().counts.failed, 0);
    core->send(orders::CancelService{});
    ASSERT_TRUE(clock.runUntil([this] { return !view().running; }, 1min));
    EXPECT_EQ(view().counts.passed + view().counts.failed, 0) << "it goes on when it is resumed";
    EXPECT_FALSE(view().waitsForArm());
}

TEST_F(Served, WhoWaitsForArmingGoesOnByItselfAndWhoComesAfterAFailWaits)
{
    ASSERT_TRUE(serve({recipe(failing), {"sim:can"}, std::nullopt}));
    ASSERT_TRUE(clock.runUntil([this] { return view().waitsForArm(); }, 5min));
    clock.advance(1min);
    const std::uint32_t first = waiting().id;
    core->send(orders::ArmService{true});
    EXPECT_FALSE(view().waitsForArm());
    ASSERT_TRUE(renewedUntil([this] { return view().counts.failed == 1; }));
    EXPECT_FALSE(view().isArmed()) << "FAIL disarms";
    ASSERT_TRUE(renewedUntil([this] { return view().waitsForArm(); }));
    EXPECT_NE(waiting().id, first);
    clock.advance(1min);
    EXPECT_EQ(view().counts.failed, 1) << "the next waits, and has not failed";
    core->send(orders::ArmService{true});
    ASSERT_TRUE(renewedUntil([this] { return !view().running; }));
    EXPECT_EQ(view().counts.failed, 2);
    for (const service::QueueRow &row : view().rows) {
        if (row.state == service::RowState::Failed) {
            EXPECT_NE(row.visit.cause.english().find("settle"), std::string::npos) << row.visit.cause.english();
        }
    }
}

TEST_F(Served, AFailOnOneBusEndsNoSelfTestOnAnother)
{
    core->send(orders::OpenLink{*LinkAddress::parse("sim:can?seed=2")});
    clock.advance(5s);
    ASSERT_TRUE(serve({recipe(failing), {"sim:can", "sim:can?seed=2"}, std::nullopt}));
    core->send(orders::ArmService{true});
    EXPECT_TRUE(clock.runUntil(
        [this] {
            if (view().mayTurn != MayTurn::Nothing) // as the page does
                core->send(orders::RenewService{});
            if (!view().isArmed() && view().counts.failed % 2 == 0)
                core->send(orders::ArmService{true});
            return view().counts.failed >= 4;
        },
        10min));
    for (const service::QueueRow &row : view().rows) {
        if (row.state == service::RowState::Failed) {
            EXPECT_NE(row.visit.cause.english().find("settle"), std::string::npos) << row.visit.cause.english();
        }
    }
    core->send(orders::ArmService{false});
    EXPECT_EQ(view().mayTurn, MayTurn::Nothing) << "whoever disarms ends what runs, too";
}

TEST_F(Served, DisarmedInTheLastThreeSecondsItWaitsAgain)
{
    ASSERT_TRUE(serve({recipe(moving), {"sim:can"}, std::nullopt}));
    core->send(orders::ArmService{true});
    ASSERT_TRUE(clock.runUntil([this] { return view().announced > 0; }, 5min));
    core->send(orders::ArmService{false});
    ASSERT_FALSE(clock.runUntil([this] { return anyMoves(); }, 1min));
    EXPECT_TRUE(view().waitsForArm());
    EXPECT_EQ(view().announced, 0);
    EXPECT_EQ(view().counts.failed, 0);
    core->send(orders::ArmService{true});
    EXPECT_TRUE(renewedUntil([this] { return anyMoves(); }));
}

TEST_F(Served, ArmedAnewInTheLastThreeSecondsItIsAnnouncedAnew)
{
    ASSERT_TRUE(serve({recipe(moving), {"sim:can"}, std::nullopt}));
    core->send(orders::ArmService{true});
    ASSERT_TRUE(clock.runUntil([this] { return view().announced > 0; }, 5min));
    clock.advance(200ms);
    core->send(orders::ArmService{false});
    clock.advance(2600ms);
    core->send(orders::ArmService{true});
    const Instant armed = clock.now();
    EXPECT_TRUE(renewedUntil([this] { return anyMoves(); }));
    EXPECT_GE(clock.now() - armed, 3s);
}

TEST_F(Served, AUnitThatIsTakenOffWhileItWaitsForArmingHasFailedForThat)
{
    ASSERT_TRUE(serve({recipe(moving), {"sim:can"}, std::nullopt}));
    ASSERT_TRUE(clock.runUntil([this] { return view().waitsForArm(); }, 5min));
    const std::uint32_t first = waiting().id;
    const int address = core->session().find(waiting().device)->identity().address;
    for (Simulator *unit : core->session().bench(*core->session().links().front())->simulators()) {
        if (unit->name() == "dmc60c:" + std::to_string(address))
            unit->setPowered(false);
    }
    ASSERT_TRUE(clock.runUntil([this] { return view().counts.failed == 1; }, 1min));
    const service::QueueRow row = view().rows.front();
    EXPECT_EQ(row.id, first);
    EXPECT_NE(row.visit.cause.english().find("taken off"), std::string::npos) << row.visit.cause.english();
    ASSERT_TRUE(clock.runUntil([this] { return view().waitsForArm(); }, 1min)) << "and the rest goes on";
}

TEST_F(Served, ArmedItSaysSoThreeSecondsBeforeAMotorTurns)
{
    ASSERT_TRUE(serve({recipe(moving), {"sim:can"}, std::nullopt}));
    core->send(orders::ArmService{true});
    EXPECT_TRUE(view().isArmed());
    ASSERT_TRUE(clock.runUntil([this] { return view().announced > 0; }, 5min));
    const Instant told = clock.now();
    ASSERT_TRUE(clock.runUntil(
        [this] {
            core->send(orders::RenewService{});
            return anyMoves();
        },
        1min));
    EXPECT_GE(clock.now() - told, 3s);
    core->stopAll(StopCause::User);
    core->stopAll(StopCause::User);
    EXPECT_FALSE(view().isArmed());
    ASSERT_TRUE(clock.runUntil([this] { return !view().running && !anyMoves(); }, 30s));
}

TEST_F(Served, WhoTakesTheArmingBackBetweenTwoPushesEndsTheSelfTest)
{
    ASSERT_TRUE(serve({recipe(pushing), {"sim:can"}, std::nullopt}));
    core->send(orders::ArmService{true});
    ASSERT_TRUE(renewedUntil([this] { return isDriven(); }));
    ASSERT_TRUE(renewedUntil([this] { return !isDriven() && !anyMoves(); })) << "the first push has ended";
    ASSERT_EQ(waiting().visit.step, service::Step::Test);
    core->stopAll(StopCause::Program); // the window has lost the focus
    EXPECT_EQ(view().mayTurn, MayTurn::Nothing);
    const auto refusedStart = clock.now() + 10s;
    EXPECT_FALSE(renewedUntil([&] { return isDriven() || clock.now() > refusedStart; }) && isDriven());
    EXPECT_EQ(view().counts.failed, 1);
    EXPECT_EQ(view().rows.front()->visit.cause.english(), "the self-test was stopped by hand");
}

TEST_F(Served, WhoEndsTheQueueLetsTheSelfTestThatTurnsComeToItsEnd)
{
    ASSERT_TRUE(serve({recipe(moving), {"sim:can"}, std::nullopt}));
    core->send(orders::ArmService{true});
    ASSERT_TRUE(renewedUntil([this] { return anyMoves(); }));
    core->send(orders::FinishService{});
    ASSERT_TRUE(clock.runUntil(
        [this] {
            if (view().mayTurn != MayTurn::Nothing) // as the page does
                core->send(orders::RenewService{});
            return !view().running;
        },
        1min));
    EXPECT_EQ(view().counts.passed, 1);
    EXPECT_EQ(view().counts.failed, 0);
}

TEST_F(Served, ALostLinkEndsTheArming)
{
    core->send(orders::OpenLink{*LinkAddress::parse("sim:can?seed=2&fault=busoff@12")});
    clock.advance(5s);
    ASSERT_TRUE(serve({recipe(moving), {"sim:can", "sim:can?seed=2&fault=busoff@12"}, std::nullopt}));
    core->send(orders::ArmService{true});
    ASSERT_TRUE(renewedUntil([this] { return view().mayTurn == MayTurn::Nothing; }));
    EXPECT_TRUE(view().running) << "the other link is served";
    clock.advance(1s);
    EXPECT_FALSE(renewedUntil([this] { return isDriven() || view().waitsForArm(); }) && isDriven());
    core->send(orders::ArmService{true});
    EXPECT_TRUE(view().isArmed()) << "for those that are there";
}

TEST_F(Served, WhatWasServedStaysInSightWhereTheNextQueueIsRefused)
{
    ASSERT_TRUE(serve({recipe(plain), {"sim:can"}, std::nullopt}));
    ASSERT_TRUE(clock.runUntil([this] { return !view().running; }, 10min));
    const std::size_t rows = view().rows.size();
    ASSERT_GT(rows, 0U);
    EXPECT_FALSE(serve({recipe(plain), {"sim:nowhere"}, std::nullopt}));
    EXPECT_FALSE(serve({recipe(plain), {}, std::nullopt})) << "on no link";
    EXPECT_EQ(view().rows.size(), rows);
    test::Heard<> retried;
    core->send(orders::RetryFailedUnits{}, retried.finished());
    ASSERT_TRUE(retried.has_value());
    ASSERT_FALSE(*retried);
    EXPECT_EQ(retried->error().detail.english(), "no unit has failed that is still there");
    core->send(orders::CloseLink{"sim:can"});
    clock.advance(1s);
    core->send(orders::RetryFailedUnits{}, retried.finished());
    EXPECT_FALSE(*retried);
}

TEST_F(Served, WhoeverEndsItDisarms)
{
    ASSERT_TRUE(serve({recipe(moving), {"sim:can"}, 0}));
    core->send(orders::ArmService{true});
    core->send(orders::FinishService{});
    EXPECT_FALSE(view().isArmed());
    EXPECT_FALSE(serve({recipe(moving), {"sim:nowhere"}, 0})) << "no such link";
}

TEST_F(Served, AQueueThatWasEndedWaitsForNoArmingWhateverIsRefusedMeanwhile)
{
    ASSERT_TRUE(serve({recipe(moving), {"sim:can"}, std::nullopt}));
    ASSERT_TRUE(clock.runUntil([this] { return view().counts.failed > 0 || waiting().id != 0; }, 1min));
    ASSERT_FALSE(view().waitsForArm()) << "its self-test is yet to come";
    core->send(orders::FinishService{});
    test::Heard<> retried;
    core->send(orders::RetryUnit{waiting().id}, retried.finished());
    ASSERT_TRUE(retried.has_value());
    EXPECT_FALSE(*retried);
    core->send(orders::RetryFailedUnits{});
    EXPECT_TRUE(clock.runUntil([this] { return !view().running; }, 5min));
    EXPECT_FALSE(view().waitsForArm());
}

TEST_F(Served, WhatEndedAQueueIsSaidUntilItGoesOn)
{
    ASSERT_TRUE(serve(
        {recipe(R"({"recipe":1,"name":"last","family":"dmc60c","number":{"first":63}})"), {"sim:can"}, std::nullopt}));
    ASSERT_TRUE(clock.runUntil([this] { return !view().running; }, 10min));
    const Message trouble = view().trouble;
    ASSERT_NE(trouble.english().find("all numbers are used up"), std::string::npos) << trouble;
    test::Heard<> retried;
    core->send(orders::RetryFailedUnits{}, retried.finished());
    ASSERT_TRUE(retried && !*retried);
    EXPECT_EQ(view().trouble, trouble);
}

TEST_F(Served, TickedUnitsOnlyAndTheOthersAreLeftOut)
{
    const DeviceId seven = core->session().idOf(*device(7));
    ASSERT_TRUE(serve({recipe(plain), {"sim:can"}, std::nullopt, std::vector{seven}}));
    ASSERT_TRUE(clock.runUntil([this] { return !view().running; }, 10min));
    const ServiceView last = view();
    EXPECT_EQ(last.counts.ended(), 1);
    for (const service::QueueRow &row : last.rows)
        EXPECT_EQ(row.state, row.device == seven ? service::RowState::Passed : service::RowState::Skipped);
    EXPECT_GE(last.rows.size(), 2U);
    EXPECT_FALSE(last.run.empty());
    EXPECT_EQ(last.matter->recipe.name, "look");
}

TEST_F(Served, AnotherLinkThatIsNotThereLendsNone)
{
    EXPECT_FALSE(serve({recipe(plain), {"sim:can", "sim:nowhere"}, std::nullopt}));
    EXPECT_FALSE(isLent()) << "it was given back";
}

TEST_F(Served, ALinkOnWhichUnitsAreServedStaysOpen)
{
    ASSERT_TRUE(serve({recipe(plain), {"sim:can"}, std::nullopt}));
    test::Heard<> closed;
    core->send(orders::CloseLink{"sim:can"}, closed.finished());
    ASSERT_TRUE(closed.has_value());
    EXPECT_FALSE(*closed);
    ASSERT_TRUE(clock.runUntil([this] { return !view().running; }, 10min));
    const auto rows = view().rows.size();
    core->send(orders::CloseLink{"sim:can"}, closed.finished());
    EXPECT_TRUE(*closed);
    EXPECT_EQ(view().rows.size(), rows) << "what came of it stays in sight";
    core->send(orders::RetryFailedUnits{}); // of a queue that is gone: nothing
    EXPECT_FALSE(view().running);
}

} // namespace
} // namespace mb
