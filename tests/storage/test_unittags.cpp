// SPDX-License-Identifier: GPL-3.0-or-later
// Units that are known by their place, and are told to be at another.
#include "storage/unittags.h"

#include "async/virtualclock.h"
#include "storage/settingsbook.h"
#include "storage/trialbook.h"
#include "support/coreapplication.h"
#include "support/simulatedsession.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>

namespace mb {
namespace {

TEST(UnitTags, WhatIsOwedGoesWithItsUnitOnceThatIsMetWhereItIsToBe)
{
    test::needCoreApplication();
    const QTemporaryDir folder;
    const auto opened = Database::open(folder.path().toStdString() + "/motorbench.db");
    ASSERT_TRUE(opened) << opened.error().text();
    VirtualClock clock;
    TrialBook book(**opened, clock);
    SettingsBook settings(**opened, clock, "anna");
    const std::string four = "place usb-1.2 supermodified:4";
    const std::string seven = "place usb-1.2 supermodified:7";
    ASSERT_TRUE(test::run(clock, book.owe(1, four, {{"gain.p", 4000}})));
    const auto isOwed = [&](const std::string &unit) { return !test::run(clock, book.owedTo(unit))->empty(); };
    ASSERT_TRUE(test::run(clock, settings.moves(four, seven)));
    EXPECT_TRUE(isOwed(four)) << "it answers there";
    EXPECT_TRUE(isOwed(seven));
    EXPECT_FALSE(isOwed(four)) << "whoever stands there next is another";
    ASSERT_TRUE(settings.setTag(four, "A"));
    ASSERT_TRUE(settings.setTag(seven, "B"));
    ASSERT_TRUE(test::run(clock, settings.moves(four, seven)));
    ASSERT_TRUE(test::run(clock, settings.moves(seven, four)));
    EXPECT_TRUE(isOwed(four)) << "B was met first";
    EXPECT_EQ(settings.resolved(four), "tag supermodified B");
    EXPECT_EQ(settings.resolved(seven), "tag supermodified A");
}

} // namespace
} // namespace mb
