// SPDX-License-Identifier: GPL-3.0-or-later
// Changes that nobody has kept: of this run, and of those before it. Virtual time.
#include "settingscore.h"

namespace mb {
namespace {

using namespace std::chrono_literals;
using settings::Purpose;

class ProvisionalCore : public test::SettingsCore {
protected:
    /// As an earlier run has left it, which was killed.
    void leave(std::string_view key, std::int64_t before, std::int64_t after)
    {
        settings::SettingsChange left;
        left.unit = unitKeyOf(*device(7));
        left.device = device(7)->selector();
        left.purpose = Purpose::Provisional;
        left.values = {{std::string(key), before, after, settings::Proof::Equal}};
        auto beginning = book->begin(left);
        beginning.start();
        ASSERT_TRUE(clock.runUntil([&beginning] { return beginning.isFinished(); }, 1s));
    }
    [[nodiscard]] std::vector<UnconfirmedView::State> waiting()
    {
        std::vector<UnconfirmedView::State> states;
        for (const UnconfirmedView &one : core.snapshot().unconfirmed)
            states.push_back(one.state);
        return states;
    }
    using States = std::vector<UnconfirmedView::State>;
};

TEST_F(ProvisionalCore, AWriteOfThisRunIsNoReasonForWhatAnEarlierOneHasLeftToGoBackByItself)
{
    clock.advance(3s);
    const std::int64_t old = known("current_limit.peak").value_or(0);
    leave("current_limit.peak", old / 2, old);
    ASSERT_TRUE(write({change("slot0.p", 65536)}));
    clock.advance(1s);
    EXPECT_EQ(waiting(), States{UnconfirmedView::State::Offered});
    core.send(orders::UndoWrite{id(), false}, heard());
    ASSERT_TRUE(ends());
    clock.advance(60s);
    EXPECT_EQ(known("current_limit.peak"), old);
    EXPECT_EQ(waiting(), States{UnconfirmedView::State::Offered});
    ASSERT_TRUE(write({change("current_limit.continuous", known("current_limit.continuous").value_or(0) + 1)}));
    clock.advance(1s);
    EXPECT_EQ(waiting(), (States{UnconfirmedView::State::Offered, UnconfirmedView::State::Counting}));
}

TEST_F(ProvisionalCore, WhatAnEarlierRunHasLeftIsOfferedAlsoWhereNoSnapshotOfTheUnitCanBeKept)
{
    clock.advance(3s);
    const std::int64_t old = known("current_limit.peak").value_or(0);
    leave("current_limit.peak", old / 2, old);
    const std::size_t before = snapshots().size();
    ASSERT_TRUE(database->run(
        "CREATE TRIGGER full BEFORE INSERT ON snapshot BEGIN SELECT RAISE(ABORT, 'database or disk is full'); END"));
    core.send(orders::CloseLink{"sim:can"});
    core.send(orders::OpenLink{*LinkAddress::parse("sim:can")});
    ASSERT_TRUE(clock.runUntil([this] { return device(7) && device(7)->liveness().heard; }, 10s));
    clock.advance(3s);
    EXPECT_EQ(snapshots().size(), before);
    EXPECT_EQ(waiting(), States{UnconfirmedView::State::Offered});
}

TEST_F(ProvisionalCore, AHistoryThatDidNotAnswerIsAskedAgain)
{
    clock.advance(3s);
    const std::int64_t old = known("current_limit.peak").value_or(0);
    leave("current_limit.peak", old / 2, old);
    ASSERT_TRUE(database->run("ALTER TABLE change RENAME TO elsewhere"));
    core.provisional().look(id());
    clock.advance(1s);
    EXPECT_TRUE(waiting().empty());
    ASSERT_TRUE(database->run("ALTER TABLE elsewhere RENAME TO change"));
    clock.advance(6s);
    EXPECT_EQ(waiting(), States{UnconfirmedView::State::Offered});
}

TEST_F(ProvisionalCore, WhatAProgramThatIsGoneHasLeftIsOfferedAndNothingGoesByItself)
{
    clock.advance(3s);
    const std::int64_t old = known("current_limit.peak").value_or(0);
    leave("current_limit.peak", old / 2, old);
    core.provisional().look(id());
    clock.advance(60s);
    ASSERT_EQ(core.snapshot().unconfirmed.size(), 1U);
    EXPECT_EQ(core.snapshot().unconfirmed.front().state, UnconfirmedView::State::Offered);
    EXPECT_EQ(known("current_limit.peak"), old);
    core.send(orders::PutBackChange{id(), core.snapshot().unconfirmed.front().change}, heard());
    ASSERT_TRUE(ends());
    clock.advance(1s);
    EXPECT_EQ(known("current_limit.peak"), old / 2);
    EXPECT_TRUE(core.snapshot().unconfirmed.empty());
}

TEST_F(ProvisionalCore, AWiderLimitIsOfferedAfterALostLinkAndDoesNotGoByItself)
{
    core.send(orders::CloseLink{"sim:can"});
    core.send(orders::OpenLink{*LinkAddress::parse("sim:can?fault=busoff@15")});
    ASSERT_TRUE(clock.runUntil([this] { return device(7) && device(7)->liveness().heard; }, 10s));
    clock.advance(3s);
    const std::int64_t old = known("current_limit.peak").value_or(0);
    ASSERT_TRUE(write({change("current_limit.peak", old * 2)}));
    clock.advance(1s);
    ASSERT_EQ(core.snapshot().unconfirmed.size(), 1U);
    const auto state = [this] { return core.session().links().front()->state(); };
    ASSERT_TRUE(clock.runUntil([&] { return state() == LinkState::Lost; }, 20s));
    ASSERT_TRUE(clock.runUntil([&] { return state() == LinkState::Open; }, 20s));
    clock.advance(60s);
    EXPECT_EQ(known("current_limit.peak"), old * 2);
    ASSERT_EQ(core.snapshot().unconfirmed.size(), 1U);
    EXPECT_EQ(core.snapshot().unconfirmed.front().state, UnconfirmedView::State::Offered);
}

} // namespace
} // namespace mb
