// SPDX-License-Identifier: GPL-3.0-or-later
// Snapshots, the history and undo as the engine's half does them. Virtual time.
#include "settingscore.h"

#include "settings/writing.h"

#include <algorithm>

namespace mb {
namespace {

using namespace std::chrono_literals;
using settings::Occasion;
using settings::Purpose;
using test::SettingsCore;

TEST_F(SettingsCore, EachUnitIsKeptAsItWasFoundOnceARun)
{
    clock.advance(10s);
    for (const int address : {5, 7}) {
        ASSERT_EQ(snapshots(address).size(), 1U) << address;
        EXPECT_EQ(snapshots(address).front().name, "as found");
        EXPECT_EQ(snapshots(address).front().occasion, Occasion::Found);
        EXPECT_EQ(snapshots(address).front().count, 55);
    }
    EXPECT_TRUE(snapshots(9).empty()) << "it waits in its bootloader";
}

TEST_F(SettingsCore, WhatAnEarlierRunWroteIsReadAsInRamUntilItIsProved)
{
    clock.advance(20s);
    const auto read = [this] {
        device(7)->parameters().forgetAll();
        core.send(orders::ReadParameters{id()}, heard());
        EXPECT_TRUE(ends());
        return device(7)->parameters().entry(change("slot0.p", 0).index).state;
    };
    ASSERT_TRUE(write({change("slot0.p", 65536)}));
    EXPECT_EQ(read(), ParameterState::Ram);
    core.send(orders::StoreParameters{id()}, heard());
    ASSERT_TRUE(ends());
    EXPECT_EQ(read(), ParameterState::Stored);
}

TEST_F(SettingsCore, WhatIsKeptOfAPlaceIsTakenBackOnceItsUserHasSaidThatTheUnitIsTheSame)
{
    const auto all = core.session().devices();
    Device &drive = **std::ranges::find(all, "abstractdc", [](const Device *one) { return one->family().key; });
    const ParameterIndex gain = *findParameter(drive.family().parameters, "velocity.p");
    const auto undo = [&] {
        core.send(orders::UndoWrite{core.session().idOf(drive), false}, heard());
        return ends();
    };
    clock.advance(3s);
    for (const std::int64_t value : {7, 8, 9, 10}) {
        core.send(orders::WriteParameters{core.session().idOf(drive), {{gain, value}}}, heard());
        ASSERT_TRUE(ends());
    }
    const Result<void> asked = undo();
    ASSERT_FALSE(asked);
    EXPECT_NE(asked.error().text().find("this place, not this unit"), std::string::npos) << asked.error().text();
    EXPECT_EQ(drive.parameters().entry(gain).raw, 10);
    EXPECT_TRUE(undo());
    EXPECT_TRUE(undo()) << "it is heard all the while";
    EXPECT_EQ(drive.parameters().entry(gain).raw, 8);
    const auto power = [&](bool on) {
        for (Simulator *unit : core.session().bench(drive.link())->simulators())
            unit->setPowered(on);
    };
    power(false);
    ASSERT_TRUE(clock.runUntil([&] { return !drive.liveness().heard; }, 10s));
    clock.advance(2s);
    power(true);
    ASSERT_TRUE(clock.runUntil([&] { return drive.liveness().heard; }, 10s));
    EXPECT_FALSE(undo()) << "another may stand there now";
}

TEST_F(SettingsCore, AWriteIsUndoneAndDoneAgainByNewWrites)
{
    clock.advance(3s);
    const auto old = known("slot0.p");
    ASSERT_TRUE(write({change("slot0.p", 65536)}));
    core.send(orders::UndoWrite{id(), false}, heard());
    ASSERT_TRUE(ends());
    EXPECT_EQ(known("slot0.p"), old);
    core.send(orders::UndoWrite{id(), true}, heard());
    ASSERT_TRUE(ends());
    EXPECT_EQ(known("slot0.p"), 65536);
    core.send(orders::UndoWrite{id(), true}, heard());
    EXPECT_FALSE(ends());
    ASSERT_EQ(changes().size(), 3U);
    EXPECT_EQ(changes()[1].purpose, Purpose::Undo);
    EXPECT_EQ(changes()[2].purpose, Purpose::Redo);
    EXPECT_EQ(changes()[0].origin, settings::Origin::Window);
    EXPECT_TRUE(std::any_of(
        notices.begin(), notices.end(), [](const std::string &text) { return text.starts_with("undone: slot0.p: "); }));
}

TEST_F(SettingsCore, ARestoreAndAWriteOfManyValuesKeepFirstWhatIsThere)
{
    clock.advance(3s);
    core.send(orders::RestoreParameters{id(), {change("slot0.p", 65536)}}, heard());
    ASSERT_TRUE(ends());
    EXPECT_EQ(snapshots().back().occasion, Occasion::Restore);
    EXPECT_EQ(changes().back().purpose, Purpose::Restore);
    std::vector<ParameterChange> many;
    for (const char *key :
        {"slot0.p", "slot0.i", "slot0.d", "slot0.f", "slot1.p", "slot1.i", "slot1.d", "slot1.f", "slot1.ramp"})
        many.push_back(change(key, 5));
    ASSERT_TRUE(write(many));
    EXPECT_EQ(snapshots().back().occasion, Occasion::Import);
    ASSERT_TRUE(write({change("slot0.p", 6)}));
    EXPECT_EQ(snapshots().size(), 3U);
}

TEST_F(SettingsCore, ARestoreIsRefusedWhereWhatIsThereCannotBeKept)
{
    ASSERT_TRUE(clock.runUntil([this] { return !snapshots().empty(); }, 10s));
    const auto before = known("slot0.p");
    ASSERT_TRUE(database->run(
        "CREATE TRIGGER full BEFORE INSERT ON snapshot BEGIN SELECT RAISE(ABORT, 'database or disk is full'); END"));
    core.send(orders::RestoreParameters{id(), {change("slot0.p", 65536)}}, heard());
    const auto refused = ends();
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, Fault::NotKept);
    EXPECT_EQ(refused.error().detail.english().find("nothing was written, because what is there cannot be kept: "), 0U)
        << refused.error().text();
    EXPECT_EQ(known("slot0.p"), before);
    EXPECT_TRUE(changes().empty());
}

TEST_F(SettingsCore, AnUpdateIsRefusedWhereWhatIsThereCannotBeKept)
{
    ASSERT_TRUE(clock.runUntil([this] { return !snapshots().empty(); }, 10s));
    ASSERT_TRUE(database->run(
        "CREATE TRIGGER full BEFORE INSERT ON snapshot BEGIN SELECT RAISE(ABORT, 'database or disk is full'); END"));
    core.send(orders::UpdateFirmware{id(), std::make_shared<FirmwareImage>(), {}}, heard());
    const auto refused = ends();
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, Fault::NotKept);
    EXPECT_EQ(device(7)->identity().state, DeviceState::Online);
}

TEST_F(SettingsCore, AWiderLimitGoesBackAfterThirtySecondsUnlessSomebodyKeepsIt)
{
    clock.advance(3s);
    const std::int64_t old = known("current_limit.peak").value_or(0);
    ASSERT_TRUE(write({change("current_limit.peak", old * 2), change("slot0.p", 65536)}));
    clock.advance(500ms);
    ASSERT_EQ(core.snapshot().unconfirmed.size(), 1U);
    const UnconfirmedView waiting = core.snapshot().unconfirmed.front();
    EXPECT_EQ(waiting.state, UnconfirmedView::State::Counting);
    EXPECT_NEAR(waiting.left, 29.5, 0.3);
    EXPECT_TRUE(waiting.text.english().starts_with("current_limit.peak: ")) << waiting.text;
    clock.advance(28s);
    EXPECT_EQ(known("current_limit.peak"), old * 2);
    clock.advance(3s);
    EXPECT_EQ(known("current_limit.peak"), old);
    EXPECT_EQ(known("slot0.p"), 65536);
    EXPECT_TRUE(core.snapshot().unconfirmed.empty());
    EXPECT_EQ(changes().back().purpose, Purpose::Revert);

    ASSERT_TRUE(write({change("current_limit.peak", old * 2)}));
    clock.advance(1s);
    ASSERT_EQ(core.snapshot().unconfirmed.size(), 1U);
    core.send(orders::KeepChange{id(), core.snapshot().unconfirmed.front().change}, heard());
    ASSERT_TRUE(ends());
    clock.advance(60s);
    EXPECT_TRUE(core.snapshot().unconfirmed.empty());
    EXPECT_EQ(known("current_limit.peak"), old * 2);
}

TEST_F(SettingsCore, WhatNothingWouldTakeBackIsNotWrittenWhereItsRecordCannotBeKept)
{
    clock.advance(3s);
    const std::int64_t old = known("current_limit.peak").value_or(0);
    ASSERT_TRUE(write({change("current_limit.peak", old / 2)}));
    ASSERT_TRUE(database->run(
        "CREATE TRIGGER full BEFORE INSERT ON change BEGIN SELECT RAISE(ABORT, 'database or disk is full'); END"));
    const auto wider = write({change("current_limit.peak", old * 2)});
    core.send(orders::UndoWrite{id(), false}, heard());
    for (const Result<void> &refused : {wider, ends()}) {
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().fault, Fault::NotKept) << refused.error().text();
    }
    EXPECT_EQ(known("current_limit.peak"), old / 2);
    EXPECT_TRUE(write({change("current_limit.peak", old / 4)})) << "that is safer";
    EXPECT_EQ(known("current_limit.peak"), old / 4);
    EXPECT_EQ(changes().size(), 1U);
}

TEST_F(SettingsCore, AnUndoThatNobodyHasToKeepIsWrittenAlsoWhereItsRecordCannotBeKept)
{
    clock.advance(3s);
    for (const std::string_view key : {"current_limit.peak", "slot0.p"}) {
        const std::int64_t old = known(key).value_or(0);
        ASSERT_TRUE(write({change(key, old * 2)}));
        clock.advance(1s);
        for (const UnconfirmedView &waiting : core.snapshot().unconfirmed) {
            core.send(orders::KeepChange{id(), waiting.change}, heard());
            ASSERT_TRUE(ends());
        }
        ASSERT_TRUE(database->run(
            "CREATE TRIGGER full BEFORE INSERT ON change BEGIN SELECT RAISE(ABORT, 'database or disk is full'); END"));
        core.send(orders::UndoWrite{id(), false}, heard());
        const auto undone = ends();
        EXPECT_TRUE(undone) << undone.error().text();
        EXPECT_EQ(known(key), old);
        ASSERT_TRUE(database->run("DROP TRIGGER full"));
    }
}

TEST_F(SettingsCore, ASecondWriteDoesNotWalkAroundTheQuestion)
{
    clock.advance(3s);
    const std::int64_t old = known("current_limit.peak").value_or(0);
    for (const std::int64_t second : {old * 3, old * 3 / 2}) {
        ASSERT_TRUE(write({change("current_limit.peak", old * 2)}));
        clock.advance(20s);
        ASSERT_TRUE(write({change("current_limit.peak", second)}));
        clock.advance(20s);
        ASSERT_EQ(core.snapshot().unconfirmed.size(), 1U);
        EXPECT_NEAR(core.snapshot().unconfirmed.front().left, 10.0, 0.5) << "of the newest";
        EXPECT_EQ(known("current_limit.peak"), second);
        clock.advance(11s);
        EXPECT_EQ(known("current_limit.peak"), old);
        EXPECT_TRUE(core.snapshot().unconfirmed.empty());
    }
}

TEST_F(SettingsCore, WhatASecondWriteLeftOpenGoesBackInItsOwnTime)
{
    clock.advance(3s);
    const std::int64_t old = known("current_limit.peak").value_or(0);
    const std::int64_t other = known("current_limit.continuous").value_or(0);
    ASSERT_TRUE(write({change("current_limit.peak", old * 2), change("current_limit.continuous", other + 65536)}));
    clock.advance(20s);
    ASSERT_TRUE(write({change("current_limit.peak", old * 3)}));
    clock.advance(11s);
    EXPECT_EQ(known("current_limit.continuous"), other);
    EXPECT_EQ(known("current_limit.peak"), old * 3);
    clock.advance(20s);
    EXPECT_EQ(known("current_limit.peak"), old);
}

TEST_F(SettingsCore, AnUndoThatWidensALimitGoesBackUnlessSomebodyKeepsIt)
{
    clock.advance(3s);
    const std::int64_t old = known("current_limit.peak").value_or(0);
    ASSERT_TRUE(write({change("current_limit.peak", old / 2)}));
    core.send(orders::UndoWrite{id(), false}, heard());
    ASSERT_TRUE(ends());
    clock.advance(1s);
    EXPECT_EQ(known("current_limit.peak"), old);
    ASSERT_EQ(core.snapshot().unconfirmed.size(), 1U);
    EXPECT_EQ(core.snapshot().unconfirmed.front().state, UnconfirmedView::State::Counting);
    clock.advance(31s);
    EXPECT_EQ(known("current_limit.peak"), old / 2);
    EXPECT_TRUE(core.snapshot().unconfirmed.empty());
}

TEST_F(SettingsCore, AWiderLimitGoesBackOnceTheDeviceIsFreeWhereAJobHasItWhenTheTimeIsOver)
{
    clock.advance(3s);
    const std::int64_t old = known("current_limit.peak").value_or(0);
    ASSERT_TRUE(write({change("current_limit.peak", old * 2)}));
    clock.advance(29s);
    ASSERT_EQ(core.snapshot().unconfirmed.size(), 1U);
    bool reads = true;
    std::function<void()> read = [&] {
        if (reads)
            core.send(orders::ReadParameters{id()}, [&](const Result<void> &) { read(); });
    };
    read();
    clock.advance(3s);
    ASSERT_EQ(core.snapshot().unconfirmed.size(), 1U);
    EXPECT_EQ(core.snapshot().unconfirmed.front().state, UnconfirmedView::State::AwaitsStandstill);
    reads = false;
    clock.advance(3s);
    EXPECT_EQ(known("current_limit.peak"), old);
    EXPECT_TRUE(core.snapshot().unconfirmed.empty());
}

/// As a terminal does, or the recipe of a queue that has the link meanwhile.
TEST_F(SettingsCore, WhatSomebodyElseHasWrittenSinceIsNotWrittenOver)
{
    clock.advance(3s);
    const std::int64_t old = known("current_limit.peak").value_or(0);
    for (const settings::Origin origin : {settings::Origin::Console, settings::Origin::Recipe}) {
        ASSERT_TRUE(write({change("current_limit.peak", old * 2)}));
        clock.advance(1s);
        ASSERT_EQ(core.snapshot().unconfirmed.size(), 1U);
        NoProgress progress;
        auto writing = settings::writeKept(
            *device(7), {change("current_limit.peak", old * 3 / 2)}, {origin}, book.get(), progress);
        writing.start();
        ASSERT_TRUE(clock.runUntil([&writing] { return writing.isFinished(); }, 10s));
        notices.clear();
        clock.advance(31s);
        EXPECT_EQ(known("current_limit.peak"), old * 3 / 2);
        EXPECT_TRUE(core.snapshot().unconfirmed.empty());
        EXPECT_TRUE(notices.empty()) << notices.front();
    }
}

TEST_F(SettingsCore, ATighterLimitIsNobodysQuestion)
{
    clock.advance(3s);
    const std::int64_t old = known("current_limit.peak").value_or(0);
    ASSERT_TRUE(write({change("current_limit.peak", old / 2)}));
    clock.advance(1s);
    EXPECT_TRUE(core.snapshot().unconfirmed.empty());
    EXPECT_EQ(changes().back().purpose, Purpose::Write);
}

TEST_F(SettingsCore, ASnapshotIsTakenUnderItsName)
{
    clock.advance(3s);
    core.send(orders::TakeSnapshot{id(), "limits for the demo"}, heard());
    ASSERT_TRUE(ends());
    EXPECT_EQ(snapshots().back().name, "limits for the demo");
}

TEST_F(SettingsCore, AnOrderDoesNotWaitForTheSnapshotThatBeganByItself)
{
    ASSERT_TRUE(clock.runUntil(
        [this] {
            const OperationView *operation = core.snapshot().operation(id());
            return operation && operation->status.state == OperationStatus::State::Running;
        },
        10s));
    EXPECT_TRUE(snapshots().empty());
    EXPECT_TRUE(write({change("slot0.p", 65536)}));
    clock.advance(5s);
    ASSERT_EQ(snapshots().size(), 1U);
    EXPECT_EQ(snapshots().front().name, "as found");
}

TEST_F(SettingsCore, AUnitIsTheSameWhileItIsScannedAgain)
{
    clock.advance(3s);
    const std::string unit = unitKeyOf(*device(7));
    ASSERT_EQ(unitByOf(unit), UnitBy::Serial);
    bool same = true;
    const Subscription watching = device(7)->changed().add([&] { same = same && unitKeyOf(*device(7)) == unit; });
    clock.advance(30s);
    EXPECT_TRUE(same) << "its serial number was forgotten for a moment";
    EXPECT_EQ(book->snapshots()->size(), 2U);
}

TEST_F(SettingsCore, WhatThePowerTookBeforeItWasStoredIsInTheHistory)
{
    clock.advance(30s);
    // damping goes first (writeorder.h), and the first one is stored at once
    ASSERT_TRUE(write({change("slot0.p", 65536), change("slot0.d", 4000)}));
    ASSERT_EQ(changes().back().values.front().key, "slot0.d") << "the history has the order in which they were written";
    for (Simulator *unit : core.session().bench(*core.session().links().front())->simulators()) {
        if (unit->name() == "dmc60c:7") {
            unit->setPowered(false);
            clock.advance(1s);
            unit->setPowered(true);
        }
    }
    clock.advance(5s);
    const auto all = changes();
    ASSERT_EQ(all.back().origin, settings::Origin::Elsewhere);
    ASSERT_EQ(all.back().values.size(), 1U);
    EXPECT_EQ(all.back().values[0].key, "slot0.p");
    EXPECT_EQ(all.back().values[0].before, 65536);
}

} // namespace
} // namespace mb
