// SPDX-License-Identifier: GPL-3.0-or-later
// Who is known by what a DMC60C sends: vectors of dmc60c/README.md#vectors.
#include "families/dmc60c/unitidentity.h"

#include <gtest/gtest.h>

namespace mb::dmc60c {
namespace {

std::optional<Identity> recognised(const char *text)
{
    return recognise(*canFrameFromText(text));
}

TEST(Dmc60cRecognition, EveryFrameThatOnlyAUnitSendsTellsItsNumber)
{
    for (const char *frame : {"02061405#0040110000000000", "02061485#01E240FED4000014", "0206FCC5#00000600"}) {
        const auto seen = recognised(frame);
        ASSERT_TRUE(seen) << frame;
        EXPECT_EQ(seen->family, "dmc60c");
        EXPECT_EQ(seen->address, 5) << frame;
        EXPECT_EQ(seen->state, DeviceState::Online);
        EXPECT_FALSE(seen->session) << "that is told by an enumeration";
        EXPECT_TRUE(seen->firmware.empty());
    }
    EXPECT_EQ(recognised("02061400#0040110000000000")->state, DeviceState::Unassigned);
}

TEST(Dmc60cRecognition, WhatAMasterSendsIsNobody)
{
    for (const char *frame :
        {"00000240#", "02060005#0F00000000000000", "0206FC05#3412610000000000", "02061805#341229", "123#01"})
        EXPECT_FALSE(recognised(frame)) << frame;
}

TEST(Dmc60cRecognition, AnEnumerationTellsSessionAndVersions)
{
    const auto product = recognised("0206F005#341203012060");
    ASSERT_TRUE(product);
    EXPECT_EQ(product->session, 0x1234);
    EXPECT_TRUE(product->firmware.empty());
    const auto versions = recognised("0206F03F#0100020017010A01");
    ASSERT_TRUE(versions);
    EXPECT_EQ(versions->address, 63);
    EXPECT_EQ(versions->session, 1);
    EXPECT_EQ(versions->firmware, "1.23");
    EXPECT_EQ(versions->bootloader, "1.10");
}

} // namespace
} // namespace mb::dmc60c
