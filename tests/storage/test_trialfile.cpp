// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/trialfile.h"
#include "support/temporaryfile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>

namespace mb {
namespace {

void setZone(const char *zone)
{
    ::setenv("TZ", zone, 1);
    ::tzset();
}

TEST(TrialFile, ATableSaysTheSameOnComputersOfOtherTimeZonesAndQuotesWhatNeedsIt)
{
    const test::TemporaryFolder folder;
    KeptTrial kept;
    kept.number = 7;
    kept.time = 1.7e9;
    kept.trial.device = "sim:can/dmc60c:5";
    kept.trial.unit = "arm, \"left\"";
    kept.trial.reason = tuning::EndReason::Done;
    kept.note = "two\rlines";
    for (const char *zone : {"UTC", "CET-1"}) {
        setZone(zone);
        ASSERT_TRUE(exportTrials(folder.path("trials.csv"), {kept}));
        const std::string text = folder.read("trials.csv");
        const std::string row = text.substr(text.find('\n') + 1);
        EXPECT_TRUE(row.starts_with("7,2023-11-14T22:13:20Z,sim:can/dmc60c:5,\"arm, \"\"left\"\"\",,0,")) << row;
        EXPECT_TRUE(row.ends_with(",,done,0,0,0,0,\"two\rlines\",\n")) << row;
        const auto cells = [](std::string_view line) { return std::ranges::count(line, ','); };
        EXPECT_EQ(cells(row), cells(text.substr(0, text.find('\n'))) + 1) << "one is inside a cell";
    }
    ::unsetenv("TZ");
    ::tzset();
}

} // namespace
} // namespace mb
