// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/message.h"
#include "async/result.h"

#include <gtest/gtest.h>

#include <limits>

namespace mb {
namespace {

TEST(Message, SaysItsLiteralWithWhatStandsInIt)
{
    EXPECT_EQ(say("the disk is full").english(), "the disk is full");
    EXPECT_EQ(say("%1 units answer as number %2", std::size_t{2}, 5).english(), "2 units answer as number 5");
    EXPECT_EQ(say("%2 before %1", "a", std::string("b")).english(), "b before a");
    EXPECT_EQ(say("%1 % of %1", 3).english(), "3 % of 3");
}

TEST(Message, KeepsItsParts)
{
    const Message message = say("page %1: %2", -7, say("no answer"));
    EXPECT_EQ(message.literal(), "page %1: %2");
    ASSERT_EQ(message.arguments().size(), 2U);
    EXPECT_EQ(std::get<std::int64_t>(message.arguments()[0].value), -7);
    EXPECT_EQ(std::get<Message>(message.arguments()[1].value).literal(), "no answer");
    EXPECT_FALSE(message.isVerbatim());
}

TEST(Message, WhatSomebodyElseSaysIsNoLiteralToTranslate)
{
    const Message name = Message::verbatim("100 %1");
    EXPECT_TRUE(name.isVerbatim());
    EXPECT_EQ(name.english(), "100 %1");
    EXPECT_EQ(name.literal(), "");
    EXPECT_TRUE(name.arguments().empty());
    EXPECT_FALSE(Message::label("Velocity loop").isVerbatim());
    EXPECT_EQ(Message::label("Velocity loop").literal(), "Velocity loop");
}

TEST(Message, AnArgumentIsNoPattern)
{
    EXPECT_EQ(say("%1 and %2", "%2", "x").english(), "%2 and x");
}

TEST(Message, NumbersHaveADotAndAreShortest)
{
    EXPECT_EQ(say("%1", 0.1).english(), "0.1");
    EXPECT_EQ(say("%1", MessageNumber{2.5, 2, "V"}).english(), "2.50 V");
    EXPECT_EQ(say("%1", MessageNumber{12.5, -1, "%"}).english(), "12.5 %");
    EXPECT_EQ(say("%1", std::numeric_limits<double>::quiet_NaN()).english(), "nan");
}

TEST(Message, NothingIsEmptyAndSoIsNoWord)
{
    EXPECT_TRUE(Message().empty());
    EXPECT_TRUE(Message::verbatim("").empty());
    EXPECT_FALSE(Message().isVerbatim());
    EXPECT_EQ(Message().english(), "");
    EXPECT_EQ(joined(Message(), say("b")), "b");
    EXPECT_EQ(joined(say("a"), say("b")), "a; b");
}

TEST(Message, AnErrorHasItsPartsAndJoinsThemForPeople)
{
    const Error error{Fault::LinkLost, say("%1 is switched off", "can0"), say("bring it up"),
        "sudo ip link set can0 up", Ailment::Down};
    EXPECT_EQ(error.text(), "can0 is switched off; bring it up: sudo ip link set can0 up");
    EXPECT_EQ(error.help(), "bring it up: sudo ip link set can0 up");
    EXPECT_EQ(error.about("scan").text(), "scan: can0 is switched off; bring it up: sudo ip link set can0 up");
    EXPECT_EQ(error.about("scan").ailment, Ailment::Down);
    EXPECT_EQ((Error{Fault::Timeout, say("no answer")}).text(), "no answer");
}

} // namespace
} // namespace mb
