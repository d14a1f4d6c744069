// SPDX-License-Identifier: GPL-3.0-or-later
// The words of a reason stand in notebooks and in what scripts read: they never change.
#include "experiment/endreason.h"

#include <gtest/gtest.h>

#include <array>

using namespace mb;
using tuning::EndReason;

TEST(EndReason, HasTheWordsThatNotebooksHave)
{
    constexpr std::array<std::string_view, 24> words{"", "done", "interrupted", "travel", "speed", "current", "duty",
        "energy", "temperature", "bus V", "wrong direction", "no motion", "oscillation", "time", "link", "user", "late",
        "slept", "device restarted", "foreign master", "unguarded", "refused", "unconfirmed", "unknown"};
    for (std::size_t i = 0; i < words.size(); ++i) {
        const auto reason = static_cast<EndReason>(i);
        EXPECT_EQ(toString(reason), words.at(i));
        EXPECT_EQ(tuning::endReasonFrom(words.at(i)), reason) << words.at(i);
    }
    EXPECT_EQ(EndReason::Unknown, static_cast<EndReason>(words.size() - 1)) << "all of them";
}

TEST(EndReason, OfAnotherVersionIsUnknownAndNoOtherOne)
{
    EXPECT_EQ(tuning::endReasonFrom("of a newer version"), EndReason::Unknown);
    EXPECT_EQ(tuning::endReasonFrom("Done"), EndReason::Unknown);
}
