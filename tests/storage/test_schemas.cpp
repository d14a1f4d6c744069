// SPDX-License-Identifier: GPL-3.0-or-later
// A file that every released schema has left behind is opened, and nothing in it is lost.
#include "async/virtualclock.h"
#include "storage/servicebook.h"
#include "storage/settingsbook.h"
#include "storage/trialbook.h"
#include "support/coreapplication.h"
#include "support/simulatedsession.h"
#include "support/sourcetree.h"

#include <QFile>
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

INSTANTIATE_TEST_SUITE_P(Kept, Schemas, testing::Values(1, 2, 3, 4, 5, 6, 7, 8, 9));

} // namespace
} // namespace mb
