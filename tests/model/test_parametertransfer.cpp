// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/virtualclock.h"
#include "model/parametertransfer.h"
#include "support/loosemotor.h"

namespace mb {
namespace {

constexpr Parameter gainRow(const char *key, Role role)
{
    Parameter row;
    row.key = key;
    row.role = role;
    row.maximum = 1000.0;
    return row;
}

constexpr std::array rowsOfLoop{gainRow("velocity.p", Role::Proportional), gainRow("velocity.d", Role::Derivative)};

constexpr Family loopFamily = [] {
    Family family = test::looseFamily;
    family.parameters = rowsOfLoop;
    return family;
}();

/// Says which of its parameters it was asked about, and refuses the second one.
class AskedMotor final : public test::MuteDevice {
public:
    AskedMotor(Link &link, Clock &clock)
        : MuteDevice(loopFamily, link, clock, {})
    {
    }
    std::string asked;

private:
    Task<void> doMayWrite(ParameterIndex index, std::int64_t, std::span<const ParameterChange> before) override
    {
        asked += std::string(parameters().parameter(index).key) + " after " + std::to_string(before.size()) + ' ';
        if (!before.empty())
            co_return fail(Fault::Refused);
        co_return {};
    }
    Result<void> doCommand(const SetPoint &) override { return {}; }
    void doStop() override { }
    [[nodiscard]] bool isSeenStopped() const override { return true; }
};

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

TEST(ParameterTransfer, WhatWouldBeRefusedIsAskedInTheOrderOfWriting)
{
    VirtualClock clock;
    test::LoggedLink link(clock, {});
    ASSERT_TRUE(link.open());
    AskedMotor motor(link, clock);
    auto asking = findRefused(motor, {{{0}, 7}, {{1}, 7}}); // damping comes before what it damps
    asking.start();
    ASSERT_TRUE(asking.isFinished());
    ASSERT_TRUE(asking.result());
    ASSERT_TRUE(*asking.result());
    EXPECT_EQ((*asking.result())->index.value, 0);
    EXPECT_EQ(motor.asked, "velocity.d after 0 velocity.p after 1 ");
}

} // namespace
} // namespace mb
