// SPDX-License-Identifier: GPL-3.0-or-later
// A file that every released schema has left behind is opened, and nothing in it is lost.
#include "async/virtualclock.h"
#include "model/family.h"
#include "model/registry.h"
#include "settings/confirmation.h"
#include "storage/servicebook.h"
#include "storage/settingsbook.h"
#include "storage/trialbook.h"
#include "support/coreapplication.h"
#include "support/simulatedsession.h"
#include "support/sourcetree.h"

#include <QFile>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QTemporaryDir>

namespace mb {
namespace {

class Schemas : public testing::TestWithParam<int> {
protected:
    Schemas() { test::needCoreApplication(); }
    QTemporaryDir folder;
    std::string path = folder.path().toStdString() + "/motorbench.db";
    VirtualClock clock;
};

TEST_P(Schemas, AFileOfAnOlderVersionIsBroughtUpToDateAndKeepsEverything)
{
    const std::string kept = inSourceTree("tests/storage/schemas/version-" + std::to_string(GetParam()) + ".db");
    ASSERT_TRUE(QFile::copy(QString::fromStdString(kept), QString::fromStdString(path))) << kept;
    QFile::setPermissions(QString::fromStdString(path), QFile::ReadOwner | QFile::WriteOwner);
    const auto opened = Database::open(path);
    ASSERT_TRUE(opened) << opened.error().text();
    TrialBook trials(**opened, clock);
    const auto rows = trials.list();
    ASSERT_TRUE(rows) << rows.error().text();
    ASSERT_EQ(rows->size(), 1U);
    EXPECT_EQ(rows->front().note, "kept by schema 1");
    EXPECT_TRUE(rows->front().trial.metrics.rise);
    EXPECT_EQ(trials.signals(1)->size(), 1U);
    const auto owed = test::run(clock, trials.owedTo("simulated dmc60c 2103001"));
    ASSERT_EQ(owed->size(), 1U);
    EXPECT_EQ(owed->front().trial, 1) << "and not a later one of the same key";
    SettingsBook settings(**opened, clock, "anna");
    EXPECT_EQ(settings.snapshots()->size(), GetParam() < 3 ? 0U : 1U);
    EXPECT_TRUE(test::run(clock, settings.keep({})));
    const std::string place = "place can0 supermodified:4";
    EXPECT_EQ(settings.resolved(place), GetParam() < 4 ? place : "tag supermodified left arm");
    ServiceBook journal(**opened, clock, "bench 1", "anna");
    EXPECT_TRUE(test::run(clock, journal.open({})));
    const auto visits = journal.list({});
    ASSERT_EQ(visits->size(), GetParam() < 5 ? 1U : 2U);
    EXPECT_EQ(visits->back().note, GetParam() < 5 ? "" : "kept by schema 5");
    EXPECT_EQ(visits->back().ending, service::Ending::None);
    EXPECT_FALSE(visits->back().unproved);
    EXPECT_EQ(*countUndelivered(**opened, "postgresql://bench-db/journal"), static_cast<int>(visits->size()))
        << "what any server has got is offered once more";
}

/// Nobody could keep it then: it is no question now, and nothing that was undone weeks ago is written.
TEST(SchemaEight, WhatWasUndoneThenIsKept)
{
    test::needCoreApplication();
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("motorbench.db"));
    ASSERT_TRUE(QFile::copy(QString::fromStdString(inSourceTree("tests/storage/schemas/version-8.db")), path));
    QFile::setPermissions(path, QFile::ReadOwner | QFile::WriteOwner);
    {
        QSqlDatabase old = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), QStringLiteral("old"));
        old.setDatabaseName(path);
        ASSERT_TRUE(old.open());
        QSqlQuery writing(old);
        EXPECT_TRUE(writing.exec(QStringLiteral("INSERT INTO change (time, unit, device, person, origin, purpose) "
                                                "VALUES (5, 'place x', 'x', 'anna', 'window', 'undo')")));
        EXPECT_TRUE(writing.exec(QStringLiteral("INSERT INTO changed_value SELECT max(id), 0, 'uart.baud', 3, 5, "
                                                "'equal' FROM change")));
    }
    QSqlDatabase::removeDatabase(QStringLiteral("old"));
    const auto opened = Database::open(path.toStdString());
    ASSERT_TRUE(opened) << opened.error().text();
    VirtualClock clock;
    auto changes = *SettingsBook(**opened, clock, "anna").changes("place x");
    const Family &nodes = *findFamily(families(), "supermodified");
    EXPECT_TRUE(settings::unconfirmed(nodes, changes).empty());
    changes.pop_back();
    EXPECT_EQ(settings::unconfirmed(nodes, changes).size(), 1U) << "it would be asked for now";
}

INSTANTIATE_TEST_SUITE_P(Kept, Schemas, testing::Values(1, 2, 3, 4, 5, 6, 7, 8, 9));

} // namespace
} // namespace mb
