// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/parametertransfer.h"

#include <gtest/gtest.h>

namespace mb {
namespace {

Error told(Error error)
{
    return errorOf({{3}, fail(std::move(error)), std::nullopt}, "slot0.p");
}

TEST(ParameterTransfer, AnErrorNamesItsParameterOnce)
{
    EXPECT_EQ(told({Fault::Timeout, say("no answer")}).detail, "slot0.p: no answer");
    EXPECT_EQ(told({Fault::BadCheck, say("%1 was written as %2 but reads %3", "slot0.p", "1", "2")}).detail,
        "slot0.p was written as 1 but reads 2");
    EXPECT_EQ(told(Error{Fault::Timeout, say("no answer")}.about("slot0.p")).detail, "slot0.p: no answer");
    EXPECT_EQ(told({Fault::Refused, say("page %1: %2, sent again", 5, say("%1 is read-only", "slot0.p"))}).detail,
        "page 5: slot0.p is read-only, sent again");
}

TEST(ParameterTransfer, AWordThatOnlyLooksLikeItsKeyIsNotItsName)
{
    EXPECT_EQ(told({Fault::Refused, say("%1 is read-only", "slot0.peak")}).detail, "slot0.p: slot0.peak is read-only");
    EXPECT_EQ(told({Fault::Refused, Message::verbatim("slot0.p?")}).detail, "slot0.p: slot0.p?");
}

TEST(ParameterTransfer, AnErrorWithoutACauseSaysItsFault)
{
    EXPECT_EQ(told({Fault::Timeout}).detail, "slot0.p: " + std::string(toString(Fault::Timeout)));
    EXPECT_EQ(told({Fault::Timeout, {}, say("do it again")}).remedy, "do it again");
}

} // namespace
} // namespace mb
