// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/scope.h"
#include "model/parameterfile.h"
#include "model/unit.h"
#include "settings/history.h"
#include "settingsbench.h"

#include <map>
#include <random>

namespace mb {
namespace {

using settings::Origin;
using settings::Proof;
using settings::Purpose;
using settings::SettingsChange;

class Histories : public test::SettingsBench {
protected:
    Result<SettingsChange> undo(Device &device) { return run(settings::undo(device, Origin::Window, *book, progress)); }
    Result<SettingsChange> redo(Device &device) { return run(settings::redo(device, Origin::Window, *book, progress)); }
    [[nodiscard]] std::vector<SettingsChange> changes(const Device &device)
    {
        const auto all = book->changes(unitKeyOf(device));
        EXPECT_TRUE(all) << (all ? "" : all.error().text());
        return all.value_or(std::vector<SettingsChange>{});
    }
};

TEST_F(Histories, EveryWriteTellsWhoWroteWhatFromWhere)
{
    Device &five = *bench.device(5);
    const auto oldGain = reads(five, "slot0.p");
    const auto oldIntegral = reads(five, "slot0.i");
    ASSERT_GT(oldIntegral, 7) << "it is lowered, which goes first (writeorder.h)";
    ASSERT_TRUE(write(five, {change(five, "slot0.p", 65536), change(five, "slot0.i", 7)}));
    const auto all = changes(five);
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0].person, "anna");
    EXPECT_EQ(all[0].origin, Origin::Window);
    EXPECT_EQ(all[0].purpose, Purpose::Write);
    EXPECT_EQ(all[0].device, "sim:can/dmc60c:5");
    EXPECT_GT(all[0].time, 0.0);
    const std::vector<settings::ValueChange> asWritten{
        {"slot0.i", oldIntegral, 7, Proof::Equal}, {"slot0.p", oldGain, 65536, Proof::Equal}};
    EXPECT_EQ(all[0].values, asWritten);
}

TEST_F(Histories, AWriteThatIsCutOffIsInTheHistoryInTheOrderOfWriting)
{
    Device &five = *bench.device(5);
    ASSERT_GT(reads(five, "slot0.i"), 7);
    {
        Scope cutOff(bench.clock);
        cutOff.spawn(settings::writeKept(five, {change(five, "slot0.p", 65536), change(five, "slot0.i", 7)},
            {Origin::Window}, book.get(), progress));
        ASSERT_TRUE(bench.clock.runUntil([&] { return !changes(five).empty(); }, std::chrono::seconds(1)));
    }
    const auto all = changes(five);
    ASSERT_EQ(all.size(), 1U);
    ASSERT_EQ(all[0].values.size(), 2U);
    EXPECT_EQ(all[0].values[0].key, "slot0.i");
    EXPECT_EQ(all[0].values[1].key, "slot0.p");
    EXPECT_EQ(all[0].values[0].proof, Proof::Open) << "nobody saw what came of it";
}

TEST_F(Histories, ANewNumberIsInTheHistoryAndNotUndone)
{
    Device &five = *bench.device(5);
    ASSERT_TRUE(write(five, {change(five, "slot0.p", 65536)}));
    ASSERT_TRUE(run(settings::renumberKept(five, 12, Origin::Window, book.get(), progress)));
    const auto all = changes(five);
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all[1].values, (std::vector<settings::ValueChange>{{"number", 5, 12, Proof::Equal}}));
    EXPECT_EQ(settings::textOf(five.family(), all[1]), "number: 5 → 12");
    SettingsChange words;
    words.values = {{"slot0.p", std::nullopt, 32768, Proof::Equal}, {"current_limit.enabled", 0, 1, Proof::Equal}};
    const Message text = settings::textOf(five.family(), words);
    EXPECT_EQ(text, "slot0.p: ? → 0.5000, current_limit.enabled: off → on");
    ASSERT_EQ(text.arguments().size(), 2U) << "in parts, so that a window says them in its language";
    const Message switched = std::get<Message>(text.arguments()[1].value);
    EXPECT_EQ(std::get<Message>(switched.arguments()[2].value), "on");
    ASSERT_TRUE(undo(five));
    EXPECT_EQ(five.identity().address, 12) << "others may have its old number by now";
    EXPECT_EQ(changes(five).back().values.front().key, "slot0.p");
}

TEST_F(Histories, UndoAndRedoAreNewWritesAlsoAfterTheProgramBeganAgain)
{
    Device &five = *bench.device(5);
    const auto old = reads(five, "slot0.p");
    ASSERT_TRUE(write(five, {change(five, "slot0.p", 65536)}));
    ASSERT_TRUE(write(five, {change(five, "slot0.p", 2 * 65536)}));
    ASSERT_TRUE(run(five.store(progress)));
    open();
    ASSERT_TRUE(undo(five));
    EXPECT_EQ(reads(five, "slot0.p"), 65536);
    open();
    ASSERT_TRUE(undo(five));
    EXPECT_EQ(reads(five, "slot0.p"), old);
    EXPECT_FALSE(undo(five));
    open();
    ASSERT_TRUE(redo(five));
    EXPECT_EQ(reads(five, "slot0.p"), 65536);
    ASSERT_TRUE(redo(five));
    EXPECT_EQ(reads(five, "slot0.p"), 2 * 65536);
    EXPECT_FALSE(redo(five));
    const auto all = changes(five);
    ASSERT_EQ(all.size(), 6U);
    EXPECT_EQ(all[2].purpose, Purpose::Undo);
    EXPECT_EQ(all[2].of, all[1].number);
    EXPECT_EQ(all[2].values[0].proof, Proof::Equal);
}

TEST_F(Histories, AnotherWriteEndsRedoing)
{
    Device &five = *bench.device(5);
    ASSERT_TRUE(write(five, {change(five, "slot0.p", 65536)}));
    ASSERT_TRUE(undo(five));
    ASSERT_TRUE(write(five, {change(five, "slot0.d", 9)}));
    const auto refused = redo(five);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, Fault::Refused);
}

TEST_F(Histories, AWriteWhoseOldValueNobodyKnowsIsPassedOver)
{
    Device &drive = *bench.device(3, "abstractdc");
    ASSERT_TRUE(write(drive, {change(drive, "velocity.p", 12)}));
    EXPECT_FALSE(undo(drive));
    ASSERT_TRUE(write(drive, {change(drive, "velocity.p", 20)}));
    ASSERT_TRUE(undo(drive));
    EXPECT_EQ(drive.parameters().entry(bench.index(drive, "velocity.p")).raw, 12);
    EXPECT_EQ(changes(drive).back().values[0].proof, Proof::Blind);
}

TEST_F(Histories, TheAveragingIsNeverPartOfAnUndo)
{
    const Family &family = bench.device(3, "abstractdc")->family();
    SettingsChange change;
    change.values = {{"current.averaging", 4, 8, Proof::Blind}, {"current.p", 1, 2, Proof::Blind}};
    const auto values = settings::undoable(family, change);
    ASSERT_EQ(values.size(), 1U);
    EXPECT_EQ(values[0].key, "current.p");
}

TEST_F(Histories, AChangeThatNobodySawEndCanBeUndone)
{
    Device &five = *bench.device(5);
    const auto old = reads(five, "slot0.p");
    SettingsChange begun;
    begun.unit = unitKeyOf(five);
    begun.values = {{"slot0.p", old, 65536, Proof::Open}};
    ASSERT_TRUE(run(book->begin(begun)));
    ASSERT_TRUE(run(five.write(bench.index(five, "slot0.p"), 65536)));
    open(); // the program ended in between
    EXPECT_FALSE(settings::viewOf(five.family(), changes(five)).values.contains("slot0.p"));
    ASSERT_TRUE(undo(five));
    EXPECT_EQ(reads(five, "slot0.p"), old);
}

TEST_F(Histories, WhatAnotherProgramWroteIsNoticedAndCanBeUndone)
{
    Device &five = *bench.device(5);
    ASSERT_TRUE(write(five, {change(five, "slot0.p", 65536)}));
    ASSERT_TRUE(run(five.write(bench.index(five, "slot0.p"), 3 * 65536)));
    EXPECT_EQ(run(settings::noticeForeign(five, *book)).value_or(-1), 1);
    EXPECT_EQ(run(settings::noticeForeign(five, *book)).value_or(-1), 0);
    const auto all = changes(five);
    EXPECT_EQ(all.back().origin, Origin::Elsewhere);
    EXPECT_EQ(all.back().values[0], (settings::ValueChange{"slot0.p", 65536, 3 * 65536, Proof::Equal}));
    ASSERT_TRUE(undo(five));
    EXPECT_EQ(reads(five, "slot0.p"), 65536);
}

class PlacedHistories : public test::SettingsBench {
protected:
    PlacedHistories()
        : SettingsBench("sim:serial")
    {
    }
};

TEST_F(PlacedHistories, WhatAnotherUnitInTheSamePlaceHasIsNothingToUndo)
{
    Device &node = *bench.device(4, "supermodified");
    const auto standsThere = [&](std::int64_t gain) { // written by nobody who keeps it
        ASSERT_TRUE(write(node, {change(node, "gain.p", 50)}));
        ASSERT_TRUE(run(node.write(bench.index(node, "gain.p"), gain)));
    };
    standsThere(70);
    EXPECT_EQ(run(settings::noticeForeign(node, *book)).value_or(-1), 0);
    ASSERT_TRUE(book->setTag(unitKeyOf(node), "arm"));
    standsThere(80);
    EXPECT_EQ(run(settings::noticeForeign(node, *book)).value_or(-1), 1) << "its user says that it is the same";
}

TEST_F(Histories, ARefusedWriteIsNothingToUndo)
{
    Device &five = *bench.device(5);
    const auto outcomes = write(five, {change(five, "faults.active", 1)});
    ASSERT_TRUE(outcomes);
    EXPECT_FALSE(outcomes->back().raw);
    EXPECT_EQ(changes(five).back().values[0].proof, Proof::Refused);
    EXPECT_FALSE(undo(five));
}

TEST_F(Histories, ADiskThatFailsCostsTheEntryAndNotTheWrite)
{
    Device &five = *bench.device(5);
    ASSERT_TRUE(database->run("DROP TABLE changed_value"));
    ASSERT_TRUE(write(five, {change(five, "slot0.p", 65536)}));
    EXPECT_EQ(reads(five, "slot0.p"), 65536);
}

/// Any sequence of set, undo, redo, restore, snapshot and power cycle ends with what the history says. The model beside it is
/// two plain stacks and two maps: what is in force, and what outlives the power.
class AnySequence : public Histories, public testing::WithParamInterface<int> {
protected:
    using Values = std::map<std::string, std::int64_t>;
    struct Step {
        Values before;
        Values after;
    };

    void set()
    {
        Values after;
        std::vector<ParameterChange> changes;
        for (int i = 1 + pick(3); i > 0; --i) {
            const std::string key = keys[static_cast<std::size_t>(pick(static_cast<int>(keys.size())))];
            if (after.emplace(key, pick(1000)).second)
                changes.push_back(change(device(), key, after[key]));
        }
        ASSERT_TRUE(write(device(), changes));
        did(after);
    }
    void undoOne()
    {
        EXPECT_EQ(undo(device()).has_value(), !undone.empty());
        if (undone.empty())
            return;
        redone.push_back(undone.back());
        undone.pop_back();
        enforce(redone.back().before);
    }
    void redoOne()
    {
        EXPECT_EQ(redo(device()).has_value(), !redone.empty());
        if (redone.empty())
            return;
        undone.push_back(redone.back());
        redone.pop_back();
        enforce(undone.back().after);
    }
    void takeOne()
    {
        const auto kept = snapshot(device());
        ASSERT_TRUE(kept);
        snapshots.emplace_back(kept->number, inForce);
    }
    void restoreOne()
    {
        if (snapshots.empty())
            return;
        const auto &[number, values] = snapshots[static_cast<std::size_t>(pick(static_cast<int>(snapshots.size())))];
        const auto kept = book->find(std::to_string(number));
        const auto file = parseParameterFile(QByteArray::fromStdString(kept->file), device().family());
        ASSERT_TRUE(file);
        Values after;
        std::vector<ParameterChange> changes;
        for (const ParameterDifference &difference : differences(device(), *file)) {
            changes.push_back({difference.index, difference.to});
            after[std::string(device().family().parameters[difference.index.value].key)] = difference.to;
        }
        Values expected;
        for (const auto &[key, value] : values) {
            if (inForce[key] != value)
                expected[key] = value;
        }
        EXPECT_EQ(after, expected);
        ASSERT_TRUE(
            run(settings::writeKept(device(), changes, {Origin::Window, Purpose::Restore}, book.get(), progress)));
        did(after);
    }
    void powerCycle(bool isStored)
    {
        if (isStored)
            store();
        bench.simulator("dmc60c:5")->setPowered(false);
        bench.clock.advance(std::chrono::seconds(1));
        bench.simulator("dmc60c:5")->setPowered(true);
        bench.clock.advance(std::chrono::seconds(2));
        bench.scan();
        (void)run(device().store(progress)); // tells once of a cut before flash was written
        Values lost;
        ASSERT_TRUE(run(mb::readParameters(device(), readable(device()), progress)));
        for (const std::string &key : keys) {
            const auto raw = device().parameters().entry(bench.index(device(), key)).raw;
            ASSERT_TRUE(raw);
            if (*raw != inForce[key])
                lost[key] = *raw;
        }
        EXPECT_TRUE(!isStored || lost.empty()) << "a stored value is lost";
        EXPECT_EQ(run(settings::noticeForeign(device(), *book)).value_or(-1), static_cast<int>(lost.size()));
        did(lost);
    }
    void store()
    {
        const auto stored = run(device().store(progress));
        EXPECT_TRUE(stored) << (stored ? "" : stored.error().text());
    }
    void check()
    {
        const auto view = settings::viewOf(device().family(), changes(device()));
        for (const std::string &key : keys) {
            EXPECT_EQ(reads(device(), key), inForce[key]) << key;
            if (const auto said = view.values.find(key); said != view.values.end()) {
                EXPECT_EQ(said->second, inForce[key]) << key;
            }
        }
        EXPECT_EQ(view.undo.has_value(), !undone.empty());
        EXPECT_EQ(view.redo.has_value(), !redone.empty());
    }
    void did(const Values &after)
    {
        Step step;
        for (const auto &[key, value] : after) {
            if (inForce[key] != value) {
                step.before[key] = inForce[key];
                step.after[key] = value;
            }
        }
        if (!step.after.empty()) {
            undone.push_back(step);
            redone.clear();
        }
        enforce(after);
    }
    void enforce(const Values &values)
    {
        for (const auto &[key, value] : values)
            inForce[key] = value;
    }
    Device &device() { return *bench.device(5); }
    int pick(int below) { return std::uniform_int_distribution<int>(0, below - 1)(dice); }

    const std::vector<std::string> keys{
        "slot0.p", "slot0.d", "slot1.i_zone", "slot1.f", "current_limit.peak_duration", "limit.forward.soft.threshold"};
    std::mt19937 dice{static_cast<std::mt19937::result_type>(GetParam())};
    Values inForce;
    std::vector<Step> undone;
    std::vector<Step> redone;
    std::vector<std::pair<std::int64_t, Values>> snapshots;
};

TEST_P(AnySequence, EndsWithWhatTheHistorySays)
{
    ASSERT_TRUE(run(mb::readParameters(device(), readable(device()), progress)));
    for (const std::string &key : keys)
        inForce[key] = reads(device(), key).value_or(-1);
    for (int i = 0; i < 60 && !HasFailure(); ++i) {
        const int what = pick(100);
        SCOPED_TRACE("step " + std::to_string(i) + ", " + std::to_string(what));
        if (what < 35)
            set();
        else if (what < 55)
            undoOne();
        else if (what < 68)
            redoOne();
        else if (what < 78)
            takeOne();
        else if (what < 88)
            restoreOne();
        else if (what < 92)
            open();
        else
            powerCycle(what < 96);
        check();
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, AnySequence, testing::Range(1, 21));

} // namespace
} // namespace mb
