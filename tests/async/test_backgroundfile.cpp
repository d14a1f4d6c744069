// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/backgroundfile.h"
#include "support/fulldisk.h"
#include "support/temporaryfile.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace mb {
namespace {

TEST(BackgroundFile, WritesEveryRecordInOrder)
{
    const test::TemporaryFolder folder;
    std::string expected;
    {
        const auto file = BackgroundFile::create(folder.path("a.log"));
        ASSERT_TRUE(file);
        for (int i = 0; i < 20'000; ++i) {
            const std::string record = "record " + std::to_string(i) + '\n';
            expected += record;
            ASSERT_TRUE((*file)->append(record));
            if (i % 1000 == 0)
                (*file)->flush();
        }
        EXPECT_EQ((*file)->status().taken, 20'000U);
    }
    EXPECT_EQ(folder.read("a.log"), expected);
}

TEST(BackgroundFile, TellsWhenItIsFinishedAndTakesNothingAfter)
{
    const test::TemporaryFolder folder;
    const auto file = BackgroundFile::create(folder.path("a.log"));
    ASSERT_TRUE((*file)->append("one\n"));
    (*file)->finish();
    EXPECT_FALSE((*file)->append("two\n"));
    while (!(*file)->status().finished)
        std::this_thread::yield();
    EXPECT_EQ((*file)->status().written, 1U);
    EXPECT_EQ((*file)->status().refused, 1U);
    EXPECT_EQ((*file)->status().problem, "");
    EXPECT_EQ(folder.read("a.log"), "one\n");
}

TEST(BackgroundFile, SaysWhyAFileCannotBeMade)
{
    const test::TemporaryFolder folder;
    const auto nowhere = BackgroundFile::create(folder.path("none/a.log"));
    ASSERT_FALSE(nowhere);
    EXPECT_NE(nowhere.error().text().find("there is no such folder; "), std::string::npos);
    EXPECT_NE(BackgroundFile::create(folder.path()).error().text().find("it is a folder; "), std::string::npos);
    EXPECT_FALSE(BackgroundFile::create("/proc/motorbench.log"));
}

TEST(BackgroundFile, SaysOnceThatTheDiskIsFullAndCountsWhatIsMissing)
{
    const auto file = BackgroundFile::create("/dev/full");
    if (!file)
        GTEST_SKIP() << "there is no /dev/full here";
    for (int i = 0; i < 10; ++i)
        ASSERT_TRUE((*file)->append("record\n"));
    (*file)->flush();
    while ((*file)->status().problem.empty())
        std::this_thread::yield();
    EXPECT_EQ((*file)->status().problem, "/dev/full: the disk is full; make room, or choose another place");
    EXPECT_EQ((*file)->status().written, 0U);
    EXPECT_FALSE((*file)->append("record\n"));
    EXPECT_EQ((*file)->status().taken, 10U);
    EXPECT_EQ((*file)->status().refused, 1U);
}

TEST(BackgroundFile, SaysThatItWasDeletedAndThatNothingOfItIsThere)
{
    const test::TemporaryFolder folder;
    const auto file = BackgroundFile::create(folder.path("a.log"));
    ASSERT_TRUE(file);
    ASSERT_TRUE((*file)->append("one\n"));
    (*file)->flush();
    while ((*file)->status().written == 0)
        std::this_thread::yield();
    ASSERT_EQ(std::remove(folder.path("a.log").c_str()), 0);
    ASSERT_TRUE((*file)->append("two\n"));
    (*file)->finish();
    while (!(*file)->status().finished)
        std::this_thread::yield();
    EXPECT_EQ((*file)->status().problem,
        Message::verbatim(folder.path("a.log") + ": the file was deleted while it was written; write it anew"));
    EXPECT_EQ((*file)->status().written, 0U);
    EXPECT_EQ((*file)->status().taken, 2U);
}

TEST(BackgroundFile, WhatNeverHadAFileIsNotTakenForDeleted)
{
    const auto file = BackgroundFile::create("/dev/null");
    ASSERT_TRUE(file);
    ASSERT_TRUE((*file)->append("one\n"));
    (*file)->finish();
    while (!(*file)->status().finished)
        std::this_thread::yield();
    EXPECT_EQ((*file)->status().written, 1U);
    EXPECT_EQ((*file)->status().problem, "");
}

TEST(BackgroundFile, EndsWithAWholeRecordWhenTheDiskIsFullInTheMiddleOfOne)
{
    const test::TemporaryFolder folder;
    const test::FullDisk full(1000);
    const auto file = BackgroundFile::create(folder.path("a.log"));
    ASSERT_TRUE(file);
    std::string expected;
    for (int i = 0; i < 100; ++i) {
        const std::string record = "record number " + std::to_string(100 + i) + '\n'; // 18 bytes
        expected += i < 1000 / 18 ? record : std::string();
        ASSERT_TRUE((*file)->append(record));
    }
    (*file)->finish();
    while (!(*file)->status().finished)
        std::this_thread::yield();
    EXPECT_EQ((*file)->status().written, 1000U / 18);
    EXPECT_NE((*file)->status().problem.english().find("greatest size"), std::string::npos);
    EXPECT_EQ(folder.read("a.log"), expected);
}

TEST(BackgroundFile, IsNotEmptiedByAnotherOneWhileItIsWritten)
{
    const test::TemporaryFolder folder;
    {
        const auto file = BackgroundFile::create(folder.path("a.log"));
        ASSERT_TRUE((*file)->append("one\n"));
        const auto second = BackgroundFile::create(folder.path("a.log"));
        ASSERT_FALSE(second);
        EXPECT_NE(second.error().text().find("a.log: it is being recorded or replayed; "), std::string::npos);
        ASSERT_TRUE((*file)->append("two\n"));
    }
    EXPECT_EQ(folder.read("a.log"), "one\ntwo\n");
    ASSERT_TRUE(BackgroundFile::create(folder.path("a.log")));
    EXPECT_EQ(folder.read("a.log"), "");
}

TEST(BackgroundFile, RefusesWhatDoesNotFitIntoMemory)
{
    const test::TemporaryFolder folder;
    const auto file = BackgroundFile::create(folder.path("a.log"));
    EXPECT_FALSE((*file)->append(std::string(BackgroundFile::mostWaiting + 1, 'x')));
    EXPECT_TRUE((*file)->append("small\n"));
    EXPECT_EQ((*file)->status().refused, 1U);
}

} // namespace
} // namespace mb
