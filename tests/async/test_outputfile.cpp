// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/outputfile.h"
#include "support/fulldisk.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace mb {
namespace {

class OutputFileTest : public testing::Test {
protected:
    OutputFileTest()
    {
        std::string pattern = (fs::temp_directory_path() / "outputfile-XXXXXX").string();
        m_folder = ::mkdtemp(pattern.data());
    }
    ~OutputFileTest() override { fs::remove_all(m_folder); }

    [[nodiscard]] std::string path(const std::string &name) const { return m_folder + '/' + name; }
    [[nodiscard]] std::string make(const std::string &name, const std::string &text) const
    {
        std::ofstream(path(name)) << text;
        return path(name);
    }
    static std::string read(const std::string &path)
    {
        std::ostringstream text;
        text << std::ifstream(path).rdbuf();
        return text.str();
    }
    [[nodiscard]] std::ptrdiff_t files() const
    {
        return std::distance(fs::directory_iterator(m_folder), fs::directory_iterator());
    }

private:
    std::string m_folder;
};

TEST_F(OutputFileTest, IsThereUnderItsNameOnlyAfterCommit)
{
    OutputFile file(path("new.txt"));
    ASSERT_TRUE(file.open());
    file.write("one ");
    file.write("two");
    EXPECT_FALSE(fs::exists(path("new.txt")));
    ASSERT_TRUE(file.commit());
    EXPECT_EQ(read(path("new.txt")), "one two");
    EXPECT_EQ(files(), 1);
}

TEST_F(OutputFileTest, LeavesTheOldFileWhenTheRoomEnds)
{
    const std::string old = make("backup.json", "precious");
    const test::FullDisk limit(1000);
    const auto written = writeFile(old, std::string(5000, 'x'));
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().detail, old + " cannot be written: the file has reached the greatest size there");
    EXPECT_EQ(written.error().remedy, "choose another place");
    EXPECT_EQ(read(old), "precious");
    EXPECT_EQ(files(), 1);
}

TEST_F(OutputFileTest, CanBeAskedBeforeWhetherItCouldBeWritten)
{
    EXPECT_TRUE(checkWritable(path("new.txt")));
    EXPECT_TRUE(checkWritable(make("old.txt", "precious")));
    EXPECT_EQ(read(path("old.txt")), "precious");
    EXPECT_EQ(files(), 1) << "asking leaves nothing";
    EXPECT_FALSE(checkWritable(path("no/such/folder")));
    EXPECT_FALSE(checkWritable(path("")));
    EXPECT_FALSE(checkWritable(""));
    ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
    EXPECT_TRUE(checkWritable(path("pipe"))) << "its reader may come later";
}

TEST_F(OutputFileTest, LeavesTheOldFileWithoutCommit)
{
    const std::string old = make("backup.json", "precious");
    {
        OutputFile file(old);
        ASSERT_TRUE(file.open());
        file.write(std::string(200'000, 'x'));
    }
    EXPECT_EQ(read(old), "precious");
    EXPECT_EQ(files(), 1);
}

TEST_F(OutputFileTest, HoldsNoDescriptorOnceItIsDoneOrGivenUp)
{
    const auto open = [] { return std::distance(fs::directory_iterator("/proc/self/fd"), fs::directory_iterator()); };
    const auto before = open();
    for (int i = 0; i < 10; ++i) {
        OutputFile given(path("given up"));
        ASSERT_TRUE(given.open());
        given.write("x");
    }
    EXPECT_EQ(open(), before);
    ASSERT_TRUE(writeFile(path("done"), "x"));
    ASSERT_FALSE(writeFile("/dev/full", "x"));
    EXPECT_EQ(open(), before);
    EXPECT_EQ(files(), 1);
}

TEST_F(OutputFileTest, WritesManyAtOnceUnderNamesOfTheirOwn)
{
    const std::string target = path("same");
    OutputFile first(target);
    OutputFile second(target);
    ASSERT_TRUE(first.open());
    ASSERT_TRUE(second.open());
    first.write("first");
    second.write("second");
    EXPECT_EQ(files(), 2);
    ASSERT_TRUE(first.commit());
    EXPECT_EQ(read(target), "first");
    ASSERT_TRUE(second.commit());
    EXPECT_EQ(read(target), "second") << "the later one";
    EXPECT_EQ(files(), 1);
}

TEST_F(OutputFileTest, KeepsTheModeOfTheOldFile)
{
    const std::string old = make("secret", "old");
    fs::permissions(old, fs::perms::owner_read | fs::perms::owner_write);
    ASSERT_TRUE(writeFile(old, "new"));
    EXPECT_EQ(fs::status(old).permissions(), fs::perms::owner_read | fs::perms::owner_write);
    EXPECT_EQ(read(old), "new");
}

TEST_F(OutputFileTest, ANewFileIsForThoseWhomTheUmaskLets)
{
    const auto before = ::umask(0022);
    ASSERT_TRUE(writeFile(path("shared"), "text"));
    ::umask(0077);
    ASSERT_TRUE(writeFile(path("private"), "text"));
    ::umask(before);
    EXPECT_EQ(static_cast<unsigned>(fs::status(path("shared")).permissions()), 0644U);
    EXPECT_EQ(static_cast<unsigned>(fs::status(path("private")).permissions()), 0600U);
}

TEST_F(OutputFileTest, WritesTheTargetOfALinkWhichStaysALink)
{
    const std::string target = make("target", "old");
    fs::create_symlink("target", path("link"));
    fs::create_symlink("later", path("dangling"));
    ASSERT_TRUE(writeFile(path("link"), "new"));
    ASSERT_TRUE(writeFile(path("dangling"), "made"));
    EXPECT_TRUE(fs::is_symlink(path("link")));
    EXPECT_EQ(read(target), "new");
    EXPECT_EQ(read(path("later")), "made");
}

TEST_F(OutputFileTest, WritesIntoWhatIsNoRegularFile)
{
    ASSERT_TRUE(writeFile("/dev/null", "nothing"));
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
    const int reader = ::open(path("pipe").c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    ASSERT_TRUE(writeFile(path("pipe"), "through"));
    std::array<char, 16> got{};
    EXPECT_EQ(::read(reader, got.data(), got.size()), 7);
    ::close(reader);
    EXPECT_TRUE(fs::is_fifo(path("pipe")));
}

TEST_F(OutputFileTest, SaysWhyNothingCanBeWritten)
{
    const auto cause = [](const std::string &where) {
        const auto written = writeFile(where, "text");
        return written ? std::string("written") : written.error().text();
    };
    EXPECT_EQ(cause("/dev/full"), "/dev/full cannot be written: the disk is full; make room, or choose another place");
    EXPECT_EQ(cause(path("none/file")),
        path("none/file") + " cannot be written: there is no such folder; choose another one");
    EXPECT_EQ(cause(path("")), path("") + " cannot be written: it is a folder; name a file");
    ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
    EXPECT_EQ(
        cause(path("pipe")), path("pipe") + " cannot be written: nobody reads from this pipe; start the reader first");
}

} // namespace
} // namespace mb
