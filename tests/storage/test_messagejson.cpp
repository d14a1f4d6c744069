// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/messagejson.h"

#include <QJsonObject>

#include <gtest/gtest.h>

namespace mb {
namespace {

Message again(const Message &message)
{
    return messageFrom(savedText(message).toStdString());
}

TEST(MessageJson, AMessageComesBackWithItsParts)
{
    const Message said = say("%1: speed %2 counts/s is above %3 × %4", say("trial #%1", std::int64_t{1} << 60), 5200.25,
        MessageNumber{1.2, 1, {}}, "the \"limit\" {x}");
    const Message read = again(said);
    EXPECT_EQ(read.english(), said.english());
    EXPECT_EQ(read.literal(), said.literal());
    ASSERT_EQ(read.arguments().size(), 4U);
    EXPECT_EQ(std::get<Message>(read.arguments()[0].value).literal(), "trial #%1");
    EXPECT_EQ(std::get<std::int64_t>(std::get<Message>(read.arguments()[0].value).arguments()[0].value),
        std::int64_t{1} << 60)
        << "JSON alone would round it";
    EXPECT_EQ(std::get<MessageNumber>(read.arguments()[2].value).decimals, 1);
    EXPECT_FALSE(read.isVerbatim());
    EXPECT_FALSE(again(say("done")).isVerbatim()) << "one without arguments too";
}

TEST(MessageJson, WhatOlderVersionsWroteStaysAsItIs)
{
    const Message old = messageFrom(std::string("speed 5200 counts/s is above 1.2 × 4000 counts/s"));
    EXPECT_TRUE(old.isVerbatim());
    EXPECT_EQ(savedText(old), QStringLiteral("speed 5200 counts/s is above 1.2 × 4000 counts/s"));
    EXPECT_TRUE(messageFrom(std::string()).empty());
    EXPECT_EQ(messageFrom(std::string("{\"a\":1}")).english(), "{\"a\":1}") << "braces alone make no message";
}

TEST(MessageJson, DamagedPartsAreNoReasonToFail)
{
    EXPECT_EQ(messageFrom(std::string(R"({"say":"%1 and %2","of":["a"]})")).english(), "a and %2");
    EXPECT_EQ(messageFrom(std::string(R"({"say":"","of":[]})")).english(), "");
    EXPECT_EQ(messageFrom(std::string(R"({"say":"%1","of":[{"number":null}]})")).english(), "nan");
}

} // namespace
} // namespace mb
