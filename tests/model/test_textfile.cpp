// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/textfile.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <sys/stat.h>
#include <unistd.h>

namespace mb {
namespace {

class TextFile : public ::testing::Test {
protected:
    void SetUp() override
    {
        std::string pattern = (std::filesystem::temp_directory_path() / "motorbench-test-XXXXXX").string();
        ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
        m_folder = pattern;
    }
    void TearDown() override { std::filesystem::remove_all(m_folder); }

    [[nodiscard]] std::string path(const std::string &name) const { return (m_folder / name).string(); }
    [[nodiscard]] std::string write(const std::string &name, const std::string &text) const
    {
        std::ofstream(path(name), std::ios::binary) << text;
        return path(name);
    }
    static void expectRefused(const std::string &path, std::size_t maxBytes, const std::string &cause)
    {
        const auto text = readTextFile(path, maxBytes);
        ASSERT_FALSE(text);
        EXPECT_EQ(text.error(), (Error{Fault::OutOfRange, say("%1: %2", path, cause), say("check the path")}));
    }

private:
    std::filesystem::path m_folder;
};

TEST_F(TextFile, ComesByteForByte)
{
    const std::string text = std::string("a\r\n\0\xFF", 5) + std::string(200'000, 'x');
    EXPECT_EQ(readTextFile(write("file", text), text.size()), text);
    EXPECT_EQ(readTextFile(write("empty", ""), 0), "");
}

TEST_F(TextFile, IsRefusedAboveTheLimit)
{
    expectRefused(write("file", "123456789"), 8, "is longer than 8 bytes");
    expectRefused("/proc/self/status", 10, "is longer than 10 bytes"); // says it has no size
}

TEST_F(TextFile, IsRefusedWithItsCause)
{
    expectRefused(path("missing"), 10, "no such file");
    expectRefused(path(""), 10, "is a directory");
    expectRefused(write("file", "x") + "/inside", 10, "no such file");
    expectRefused("", 10, "no such file");
    ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
    expectRefused(path("pipe"), 10, "is not a regular file");
    expectRefused("/dev/null", 10, "is not a regular file");
}

TEST_F(TextFile, IsRefusedWithoutPermission)
{
    const std::string file = write("file", "x");
    ASSERT_EQ(::chmod(file.c_str(), 0), 0);
    const bool isRoot = ::geteuid() == 0; // who may read everything
    constexpr uid_t nobody = 65534;
    ASSERT_TRUE(!isRoot || ::seteuid(nobody) == 0);
    expectRefused(file, 10, "no permission to read it");
    ASSERT_TRUE(!isRoot || ::seteuid(0) == 0);
}

} // namespace
} // namespace mb
