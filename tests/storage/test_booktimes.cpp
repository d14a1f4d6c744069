// SPDX-License-Identifier: GPL-3.0-or-later
// What the books write down is dated by Unix time, on a clock that counts from somewhere else.
#include "async/virtualclock.h"
#include "storage/servicebook.h"
#include "storage/settingsbook.h"
#include "storage/trialbook.h"
#include "support/coreapplication.h"
#include "support/datedclock.h"
#include "support/simulatedsession.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>

namespace mb {
namespace {

TEST(BookTimes, AreThoseOfTheDayInEveryBook)
{
    test::needCoreApplication();
    const QTemporaryDir folder;
    auto opened = Database::open(folder.path().toStdString() + "/motorbench.db");
    ASSERT_TRUE(opened) << opened.error().text();
    Database &database = **opened;
    VirtualClock clock;
    clock.advance(std::chrono::hours(1));
    const test::DatedClock dated(clock);
    constexpr double today = 500'001.0 * 3600.0;

    TrialBook trials(database, dated);
    const auto number = test::run(clock, trials.begin({}));
    ASSERT_TRUE(number);
    EXPECT_DOUBLE_EQ(trials.find(*number)->time, today);
    ASSERT_TRUE(test::run(clock, trials.owe(*number, "unit", {{"slot0.p", 1}})));
    const auto owed = test::run(clock, trials.owedTo("unit"));
    ASSERT_TRUE(owed);
    ASSERT_EQ(owed->size(), 1U);
    EXPECT_DOUBLE_EQ(owed->front().time, today);

    SettingsBook settings(database, dated, "anna");
    const auto snapshot = test::run(clock, settings.keep({}));
    ASSERT_TRUE(snapshot);
    EXPECT_DOUBLE_EQ(snapshot->time, today);

    ServiceBook visits(database, dated, "bench 1", "anna");
    const auto visit = test::run(clock, visits.open({}));
    ASSERT_TRUE(visit);
    EXPECT_DOUBLE_EQ(visit->time, today);
}

} // namespace
} // namespace mb
