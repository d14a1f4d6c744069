// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/qttext.h"
#include "model/unit.h"
#include "settings/comparison.h"
#include "settingsbench.h"
#include "storage/unittags.h"

#include <chrono>
#include <cstdio>

namespace mb {
namespace {

using settings::ParameterSnapshot;

class Snapshots : public test::SettingsBench { };

TEST_F(Snapshots, EverythingReadableIsKeptUnderANameByTheSerialNumber)
{
    Device &five = *bench.device(5);
    const auto kept = snapshot(five, "limits for the demo");
    ASSERT_TRUE(kept) << kept.error().text();
    EXPECT_EQ(kept->count, 55);
    EXPECT_EQ(kept->serial, five.identity().serial);
    EXPECT_EQ(kept->unit, "simulated dmc60c " + five.identity().serial);
    EXPECT_DOUBLE_EQ(kept->time, std::chrono::duration<double>(bench.clock.now().time_since_epoch()).count());
    open();
    const auto found = book->find("limits for the demo", kept->unit);
    ASSERT_TRUE(found) << found.error().text();
    const auto side = settings::sideOf(QByteArray::fromStdString(found->file), five.family());
    ASSERT_TRUE(side) << side.error().text();
    EXPECT_TRUE(settings::compare(*side, settings::sideOf(five)).empty());
    EXPECT_EQ(side->serial, five.identity().serial);
}

TEST_F(Snapshots, FiftyFiveParametersTakeATenthOfASecondAtMost)
{
    Device &five = *bench.device(5);
    const Instant before = bench.clock.now();
    const auto wall = std::chrono::steady_clock::now();
    ASSERT_TRUE(snapshot(five));
    const std::chrono::duration<double> bus = bench.clock.now() - before;
    const std::chrono::duration<double> computer = std::chrono::steady_clock::now() - wall;
    std::printf("a snapshot of 55 parameters: %.3f s on the bus, %.3f s of this computer (to reach: 0.1 s)\n",
        bus.count(), computer.count());
    EXPECT_LE(bus.count(), 0.1);
}

TEST_F(Snapshots, TheNewestOfANameIsFoundUnlessSeveralUnitsHaveIt)
{
    Device &five = *bench.device(5);
    Device &seven = *bench.device(7);
    const auto first = snapshot(five, "good");
    const auto second = snapshot(five, "good");
    ASSERT_TRUE(first && second);
    EXPECT_EQ(book->find("good")->number, second->number);
    EXPECT_EQ(book->find(std::to_string(first->number))->number, first->number);
    const auto other = snapshot(seven, "good");
    EXPECT_FALSE(book->find("good"));
    EXPECT_EQ(book->find("good", second->unit)->number, second->number);
    EXPECT_EQ(book->find("good", other->unit)->number, other->number);
    EXPECT_FALSE(book->find("never taken"));
    EXPECT_EQ(book->snapshots()->size(), 3U);
    EXPECT_EQ(book->snapshots(other->unit)->size(), 1U);
}

TEST_F(Snapshots, WhatCannotBeReadStaysMarkedAsAssumed)
{
    Device &drive = *bench.device(3, "abstractdc");
    ASSERT_TRUE(write(drive, {change(drive, "velocity.p", 12)}));
    const auto kept = snapshot(drive);
    ASSERT_TRUE(kept) << kept.error().text();
    EXPECT_EQ(unitByOf(kept->unit), UnitBy::Place);
    EXPECT_EQ(kept->unit, "simulated place sim:can abstractdc:3");
    const auto side
        = settings::sideOf(QByteArray::fromStdString(book->find(std::to_string(kept->number))->file), drive.family());
    ASSERT_TRUE(side);
    const auto &p = side->entries[bench.index(drive, "velocity.p").value];
    const auto &d = side->entries[bench.index(drive, "position.d").value];
    ASSERT_TRUE(p && d);
    EXPECT_EQ(p->raw, 12);
    EXPECT_EQ(p->state, ParameterState::Assumed);
    EXPECT_FALSE(d->raw);
}

TEST_F(Snapshots, AUnitWithATagIsThatUnitWhereverItStands)
{
    Device &drive = *bench.device(3, "abstractdc");
    const std::string place = unitKeyOf(drive);
    ASSERT_TRUE(snapshot(drive, "nobody's"));
    ASSERT_TRUE(book->setTag(place, "lift: left 3"));
    const auto tagged = snapshot(drive, "mine");
    ASSERT_TRUE(tagged);
    EXPECT_EQ(tagged->unit, "simulated tag abstractdc lift: left 3");
    EXPECT_EQ(unitTagIn(tagged->unit), "lift: left 3");
    EXPECT_EQ(unitCaveatOf(unitByOf(tagged->unit)), "");
    EXPECT_EQ(book->snapshots(place)->size(), 1U);
    EXPECT_FALSE(book->find("nobody's", place));
    Device &other = *bench.device(4, "abstractdc");
    EXPECT_EQ(book->setTag("simulated place sim:can/2 abstractdc:3", "lift: left 3").value_or("?"), "");
    EXPECT_EQ(book->find("mine", place)->number, tagged->number) << "it may be brought back";
    EXPECT_EQ(book->setTag(unitKeyOf(other), "lift: left 3").value_or("?"), place); // it got that number
    EXPECT_EQ(book->find("mine", unitKeyOf(other))->number, tagged->number);
    EXPECT_TRUE(book->find("nobody's", place)) << "of two on one line it is one only";
    EXPECT_FALSE(book->setTag(unitKeyOf(*bench.device(5)), "x"));
}

TEST_F(Snapshots, ANameThatStoodAtSeveralPlacesOfALineStandsAtOne)
{
    const std::string places[] = {"simulated place sim:can abstractdc:20", "simulated place sim:can abstractdc:21"};
    for (const std::string &place : places)
        ASSERT_TRUE(database->run("INSERT INTO tag (place, name, time) VALUES (?, 'lift', 0)", {qt(place)}));
    ASSERT_TRUE(book->setTag(unitKeyOf(*bench.device(3, "abstractdc")), "lift"));
    for (const std::string &place : places)
        EXPECT_EQ(book->resolved(place), place);
}

TEST_F(Snapshots, AUnitIsKnownWhereItWasSeenAndUnderItsNewNumber)
{
    Device &five = *bench.device(5);
    const std::string unit = unitKeyOf(five);
    ASSERT_TRUE(snapshot(five));
    const auto isAt = [this, &unit](const char *place) {
        return unitsAt(*database, DeviceSelector::parse(place).value()).contains(unit);
    };
    EXPECT_TRUE(isAt("sim:can/dmc60c:5"));
    EXPECT_TRUE(isAt("sim:can?loss=0.1/dmc60c:5"));
    EXPECT_FALSE(isAt("sim:serial/dmc60c:5"));
    EXPECT_FALSE(isAt("sim:can/abstractdc:5"));
    EXPECT_FALSE(run(settings::renumberKept(five, 7, settings::Origin::Console, book.get(), progress))) << "taken";
    EXPECT_FALSE(isAt("sim:can/dmc60c:7"));
    EXPECT_FALSE(isAt("sim:can/dmc60c:10"));
    ASSERT_TRUE(run(settings::renumberKept(five, 10, settings::Origin::Console, book.get(), progress)));
    EXPECT_TRUE(isAt("sim:can/dmc60c:10"));
}

class NodeSnapshots : public test::SettingsBench {
protected:
    NodeSnapshots()
        : SettingsBench("sim:serial")
    {
    }
};

TEST_F(NodeSnapshots, ATagGoesWithItsUnitToItsNewNumber)
{
    Device &node = *bench.device(4, "supermodified");
    const std::string place = unitKeyOf(node);
    const std::string there = "simulated place sim:serial supermodified:10";
    ASSERT_TRUE(book->setTag(place, "arm"));
    ASSERT_TRUE(book->setTag(there, "one that is not there any more"));
    const auto good = snapshot(node, "good");
    ASSERT_TRUE(good);
    ASSERT_TRUE(run(settings::renumberKept(node, 10, settings::Origin::Window, book.get(), progress)));
    EXPECT_EQ(book->resolved(place), place) << "whoever stands there next is another";
    EXPECT_FALSE(book->find("good", place));
    const auto found = book->find("good", there);
    ASSERT_TRUE(found) << found.error().text();
    EXPECT_EQ(found->number, good->number);
}

TEST_F(Snapshots, AUnitThatFallsSilentLeavesNone)
{
    Device &five = *bench.device(5);
    bench.simulator("dmc60c:5")->setPowered(false);
    EXPECT_FALSE(snapshot(five));
    EXPECT_TRUE(book->snapshots()->empty());
}

TEST_F(Snapshots, DifferencesAreThoseOfSettingsThatBothSpeakOf)
{
    Device &five = *bench.device(5);
    ASSERT_TRUE(snapshot(five));
    const auto before = settings::sideOf(five);
    ASSERT_TRUE(write(five, {change(five, "slot1.p", 65536), change(five, "status.general.period", 20)}));
    ASSERT_TRUE(run(five.write(bench.index(five, "encoder.position"), 1234)));
    const auto differences = settings::compare(before, settings::sideOf(five));
    ASSERT_EQ(differences.size(), 2U); // the position is none: it moves by itself
    EXPECT_EQ(differences[0].index, bench.index(five, "slot1.p"));
    EXPECT_EQ(differences[0].b.raw, 65536);
    EXPECT_EQ(differences[1].index, bench.index(five, "status.general.period"));
    settings::Side silent = before;
    silent.entries[differences[0].index.value].reset();
    EXPECT_EQ(settings::compare(silent, settings::sideOf(five)).size(), 1U);
    silent.entries[differences[0].index.value] = ParameterStore::Entry{};
    EXPECT_EQ(settings::compare(silent, settings::sideOf(five)).size(), 2U);
}

TEST_F(Snapshots, DefaultsAreLegalForEveryFamily)
{
    for (const Family *family : families()) {
        const settings::Side side = settings::defaultsOf(*family);
        for (std::size_t i = 0; i < family->parameters.size(); ++i)
            EXPECT_TRUE(isLegal(family->parameters[i], side.entries[i]->raw.value_or(-1))) << family->parameters[i].key;
    }
}

} // namespace
} // namespace mb
