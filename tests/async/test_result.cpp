// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/result.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace mb {
namespace {

using Owned = std::unique_ptr<std::string>;

Result<Owned> made(const std::string &text)
{
    if (text.empty())
        return fail(Fault::OutOfRange, say("nothing to own"));
    return std::make_unique<std::string>(text);
}

Result<void> checked(int value)
{
    return value < 0 ? Result<void>(fail(Fault::Refused, say("%1 is negative", value))) : Result<void>();
}

Result<std::string> joined(const std::string &first, const std::string &second, int value, bool &hasEnded)
{
    MB_TRY(auto one, made(first));
    if (value != 0) {
        MB_TRY_VOID(checked(value));
    }
    MB_TRY(const auto two, made(second));
    hasEnded = true;
    *one += *two;
    return *one;
}

TEST(Try, YieldsTheValueAlsoOneThatCanOnlyBeMoved)
{
    bool hasEnded = false;
    EXPECT_EQ(joined("axis ", "three", 1, hasEnded), "axis three");
    EXPECT_TRUE(hasEnded);
}

TEST(Try, EndsTheFunctionWithTheSameError)
{
    bool hasEnded = false;
    EXPECT_EQ(joined("axis ", "", 0, hasEnded).error(), made("").error());
    EXPECT_EQ(joined("axis ", "three", -2, hasEnded).error(), checked(-2).error());
    EXPECT_FALSE(hasEnded);
}

} // namespace
} // namespace mb
