// SPDX-License-Identifier: GPL-3.0-or-later
// What ended a trial, in a notebook that another version of this program wrote.
#include "async/virtualclock.h"
#include "storage/trialbook.h"
#include "support/coreapplication.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <QVariant>

using namespace mb;
using tuning::EndReason;

TEST(TrialReasons, AWordOfANewerVersionIsUnknownAndDoesNoHarm)
{
    test::needCoreApplication();
    VirtualClock clock;
    const QTemporaryDir folder;
    const auto database = Database::open(folder.filePath("trials.sqlite").toStdString());
    ASSERT_TRUE(database);
    for (const QVariant &word : {QVariant("done"), QVariant("of a newer version"), QVariant(QVariant::String)}) {
        ASSERT_TRUE((*database)->run("INSERT INTO trial (time, device, unit, firmware, simulated, mode, axis, slot, "
                                     "stimulus, envelope, gains, metrics, flags, reason, detail, stopped, samples, "
                                     "lost) VALUES (1, 'd', 'u', '1.23', 1, 'velocity', 1, 0, '{}', '{}', '{}', '{}', "
                                     "'[]', ?, '', 1, 4711, 0)",
            {word}));
    }
    const auto rows = TrialBook(**database, clock).list();
    ASSERT_TRUE(rows);
    ASSERT_EQ(rows->size(), 3U);
    for (const KeptTrial &kept : *rows) {
        const std::vector<EndReason> reasons{EndReason::Done, EndReason::Unknown, EndReason::None};
        EXPECT_EQ(kept.trial.reason, reasons.at(static_cast<std::size_t>(kept.number) - 1));
        EXPECT_EQ(kept.trial.mayGoOn(), kept.number == 1);
    }
}
