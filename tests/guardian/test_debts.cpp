// SPDX-License-Identifier: GPL-3.0-or-later
// Stops that could not be sent: where they are kept, whose business they are, and the real guardian on a line that was cut and is
// back. Prints how long that took; docs/names.md#numbers allows 100 ms.
#include "app/guardian/client/guardianprocess.h"
#include "app/guardian/debts.h"
#include "folder.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

namespace mb {
namespace {

using namespace std::chrono_literals;
using guardian::Debt;
using guardian::DebtBook;
using guardian::Order;
using guardian::test::Folder;
using SteadyClock = std::chrono::steady_clock;

constexpr auto patience = 30s;

Debt debt(const std::string &name)
{
    return {name, {{{'S', 'T', 'O', 'P'}, {'o', 'k'}, {0xFF, 0xFF}, 20ms, 3}}, 1234ms};
}

TEST(DebtBook, KeepsWhatIsOwedForEveryProcessOfTheUser)
{
    const Folder folder;
    DebtBook book(folder.path("run"), "/devices/usb1/1-2");
    EXPECT_FALSE(book.exists());
    EXPECT_TRUE(book.add(debt("a")));
    EXPECT_TRUE(book.add(debt("b")));
    EXPECT_TRUE(book.add(debt("a"))) << "once a device";
    const DebtBook other(folder.path("run"), "/devices/usb1/1-2");
    ASSERT_EQ(other.read().size(), 2U);
    EXPECT_EQ(other.read()[0].script, debt("a").script);
    EXPECT_EQ(other.read()[0].since, 1234ms);
    EXPECT_TRUE(DebtBook(folder.path("run"), "/devices/usb1/1-3").read().empty()) << "another line";
    book.remove("a");
    book.remove("b");
    EXPECT_FALSE(other.exists());
    EXPECT_TRUE(book.add(debt("socketcan:can0/abstractdc:3")));
    EXPECT_TRUE(book.add(debt("socketcan:can0/abstractdc:4")));
    book.remove("socketcan:can1/abstractdc:3"); // the same line under another name
    ASSERT_EQ(other.read().size(), 1U);
    EXPECT_EQ(other.read()[0].name, "socketcan:can0/abstractdc:4");
}

TEST(DebtBook, LosesNothingWhenSeveralWriteAtOnce)
{
    const Folder folder;
    constexpr int writers = 4;
    constexpr int each = 5;
    {
        std::vector<std::jthread> threads;
        for (int writer = 0; writer < writers; ++writer)
            threads.emplace_back([&folder, writer] {
                for (int i = 0; i < each; ++i) {
                    DebtBook book(folder.path("run"), "line"); // as another process has it: a description of its own
                    EXPECT_TRUE(book.add(debt(std::to_string(writer) + ' ' + std::to_string(i))));
                }
            });
    }
    EXPECT_EQ(DebtBook(folder.path("run"), "line").read().size(), std::size_t{writers * each});
}

TEST(DebtBook, HasOneOwnerWhoseLockEndsWithIt)
{
    const Folder folder;
    DebtBook second(folder.path("run"), "line");
    {
        DebtBook first(folder.path("run"), "line");
        EXPECT_TRUE(first.own());
        EXPECT_TRUE(first.own());
        EXPECT_FALSE(second.own());
        DebtBook elsewhere(folder.path("run"), "another line");
        EXPECT_TRUE(elsewhere.own());
    }
    EXPECT_TRUE(second.own());
}

TEST(DebtBook, DoesNotTrustAFolderThatOthersMayWriteTo)
{
    const Folder folder;
    std::filesystem::create_directory(folder.path("run"));
    std::filesystem::permissions(folder.path("run"), std::filesystem::perms::all);
    DebtBook book(folder.path("run"), "line");
    EXPECT_EQ(book.claim(), DebtBook::Claim::Unusable) << "not somebody else's";
    EXPECT_FALSE(book.add(debt("a")));
    EXPECT_TRUE(book.read().empty());
}

TEST(DebtBook, TellsWhoHasItFromNobodyCanHaveIt)
{
    const Folder folder;
    DebtBook first(folder.path("run"), "line");
    DebtBook second(folder.path("run"), "line");
    EXPECT_EQ(first.claim(), DebtBook::Claim::Mine);
    EXPECT_EQ(second.claim(), DebtBook::Claim::Others);
    EXPECT_EQ(DebtBook(folder.path("missing/run"), "line").claim(), DebtBook::Claim::Unusable);
}

TEST(DebtBook, IsSettledOnlyWhereItIsStillThere)
{
    const Folder folder;
    DebtBook book(folder.path("run"), "line");
    EXPECT_FALSE(book.isSettled()) << "nothing was ever owed";
    ASSERT_TRUE(book.add(debt("a")));
    EXPECT_FALSE(book.isSettled());
    book.remove("a");
    EXPECT_TRUE(book.isSettled());
    ASSERT_TRUE(book.add(debt("a")));
    ASSERT_TRUE(book.own());
    std::filesystem::remove_all(folder.path("run"));
    EXPECT_FALSE(book.isSettled()) << "the login ended";
    DebtBook next(folder.path("run"), "line");
    EXPECT_TRUE(next.own());
    EXPECT_FALSE(book.isSettled()) << "another book";
    EXPECT_EQ(book.claim(), DebtBook::Claim::Others) << "the lock of a file that is gone keeps nobody out";
}

TEST(DebtFolder, IsThatOfTheLoginOnlyWhereThatIsOurs)
{
    const Folder folder;
    const char *const known = std::getenv("XDG_RUNTIME_DIR");
    const std::string before = known ? known : "";
    const std::string ofTemporaries = P_tmpdir "/motorbench-" + std::to_string(::geteuid());
    ::setenv("XDG_RUNTIME_DIR", folder.path("missing").c_str(), 1);
    EXPECT_EQ(guardian::debtFolder(), ofTemporaries);
    std::ofstream(folder.path("file")) << "no folder";
    ::setenv("XDG_RUNTIME_DIR", folder.path("file").c_str(), 1);
    EXPECT_EQ(guardian::debtFolder(), ofTemporaries);
    ::setenv("XDG_RUNTIME_DIR", testing::TempDir().c_str(), 1);
    std::filesystem::create_directory(folder.path("run"));
    if (::geteuid() == 0 && ::chown(folder.path("run").c_str(), 1234, 1234) == 0) { // as sudo -E leaves it
        ::setenv("XDG_RUNTIME_DIR", folder.path("run").c_str(), 1);
        EXPECT_EQ(guardian::debtFolder(), ofTemporaries);
    }
    ::setenv("XDG_RUNTIME_DIR", folder.path("mine").c_str(), 1);
    std::filesystem::create_directory(folder.path("mine"));
    EXPECT_EQ(guardian::debtFolder(), folder.path("mine/motorbench"));
    if (known)
        ::setenv("XDG_RUNTIME_DIR", before.c_str(), 1);
    else
        ::unsetenv("XDG_RUNTIME_DIR");
}

TEST(DebtBook, ABrokenFileIsNoDebt)
{
    const Folder folder;
    DebtBook book(folder.path("run"), "line");
    ASSERT_TRUE(book.add(debt("a")));
    for (const auto &entry : std::filesystem::directory_iterator(folder.path("run"))) {
        for (std::uintmax_t size = entry.file_size(); size-- > 0;) {
            std::filesystem::resize_file(entry.path(), size);
            EXPECT_TRUE(book.read().empty()) << size;
        }
    }
}

// The real process

/// The far end of a terminal, under a name that stays.
class Terminal {
public:
    explicit Terminal(const std::string &name)
        : m_master(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC))
    {
        EXPECT_TRUE(m_master >= 0 && ::grantpt(m_master) == 0 && ::unlockpt(m_master) == 0);
        std::filesystem::remove(name);
        termios raw{};
        const int slave = open();
        ::tcgetattr(slave, &raw);
        ::cfmakeraw(&raw);
        ::tcsetattr(slave, TCSANOW, &raw);
        ::close(slave);
        std::filesystem::create_symlink(::ptsname(m_master), name);
    }
    Terminal(const Terminal &) = delete;
    Terminal &operator=(const Terminal &) = delete;
    ~Terminal() { ::close(m_master); }
    [[nodiscard]] speed_t speed() const
    {
        termios now{};
        EXPECT_EQ(::tcgetattr(m_master, &now), 0);
        return ::cfgetospeed(&now);
    }
    void setSpeed(speed_t speed) const
    {
        termios now{};
        EXPECT_EQ(::tcgetattr(m_master, &now), 0);
        ::cfsetspeed(&now, speed);
        EXPECT_EQ(::tcsetattr(m_master, TCSANOW, &now), 0);
    }
    [[nodiscard]] int open() const { return ::open(::ptsname(m_master), O_RDWR | O_NOCTTY | O_CLOEXEC); }
    /// What comes first, at most that long; empty for nothing.
    [[nodiscard]] std::string hear(std::chrono::milliseconds time) const
    {
        const auto end = SteadyClock::now() + time;
        while (SteadyClock::now() < end) {
            pollfd source{m_master, POLLIN, 0};
            std::array<char, 64> part{};
            if (::poll(&source, 1, 5) == 1 && (source.revents & POLLIN) != 0) {
                const ssize_t got = ::read(m_master, part.data(), part.size());
                if (got > 0)
                    return {part.data(), static_cast<std::size_t>(got)};
            }
        }
        return {};
    }
    void answer() const { EXPECT_EQ(::write(m_master, "ok", 2), 2); }

private:
    int m_master;
};

class CutLine : public testing::Test {
protected:
    CutLine()
    {
        terminal = std::make_unique<Terminal>(name);
        const int slave = terminal->open();
        auto started = startGuardian(
            guardianBesideThisProgram(), {{Outlet::Form::Stream, slave}, folder.path("run"), "serial:" + name, name});
        ::close(slave);
        EXPECT_TRUE(started);
        process = *started;
        terminal->setSpeed(B57600);
        tell({Order::Kind::Watch, 1, "motor", debt("motor").script});
        std::array<std::uint8_t, 64> standing{};
        EXPECT_GT(::recv(process.socket, standing.data(), standing.size(), 0), 0);
    }
    ~CutLine() override
    {
        ::kill(process.pid, SIGKILL);
        ::waitpid(process.pid, nullptr, 0);
    }
    void tell(const Order &order) const
    {
        const guardian::Bytes packet = encode(order);
        EXPECT_GT(::send(process.socket, packet.data(), packet.size(), 0), 0);
    }
    /// The cable comes out, then the program dies.
    void cutAndKill()
    {
        cut();
        ::close(process.socket);
        awaitDebt();
    }
    void cut()
    {
        terminal.reset();
        std::filesystem::remove(name);
    }
    void awaitDebt() const
    {
        const auto end = SteadyClock::now() + patience;
        while (!book.exists() && SteadyClock::now() < end)
            ::usleep(2000);
        ASSERT_TRUE(book.exists()) << "the stop is written down";
    }
    [[nodiscard]] bool isGone() const
    {
        const auto end = SteadyClock::now() + patience;
        while (::waitpid(process.pid, nullptr, WNOHANG) == 0) {
            if (SteadyClock::now() > end)
                return false;
            ::usleep(2000);
        }
        return true;
    }

    Folder folder;
    std::string name = folder.path("tty");
    DebtBook book{folder.path("run"), "serial:" + name};
    std::unique_ptr<Terminal> terminal;
    GuardianProcess process;
};

TEST_F(CutLine, ThatIsBackGetsItsStopFirst)
{
    cutAndKill();
    const auto at = SteadyClock::now();
    terminal = std::make_unique<Terminal>(name);
    EXPECT_EQ(terminal->hear(patience), "STOP");
    const auto taken = SteadyClock::now() - at;
    std::printf("a line that is back: stop after %.1f ms (limit 100)\n",
        std::chrono::duration<double, std::milli>(taken).count());
    EXPECT_LE(taken, 100ms);
    terminal->answer();
    EXPECT_TRUE(isGone()) << "the guardian ends with its work";
    EXPECT_FALSE(book.exists());
}

TEST_F(CutLine, IsOwedSinceATimeThatNobodyCanSet)
{
    cutAndKill();
    timespec now{};
    ASSERT_EQ(::clock_gettime(CLOCK_BOOTTIME, &now), 0);
    ASSERT_EQ(book.read().size(), 1U);
    EXPECT_LT(std::chrono::abs(book.read().front().since - std::chrono::seconds(now.tv_sec)), 60s);
}

TEST_F(CutLine, IsTheBusinessOfAProgramThatOpensItAndTheGuardiansAgainIfThatDies)
{
    cutAndKill();
    {
        DebtBook ofProgram(folder.path("run"), "serial:" + name);
        const auto end = SteadyClock::now() + patience;
        while (!ofProgram.own() && SteadyClock::now() < end)
            ::usleep(1000);
        ASSERT_EQ(ofProgram.read().size(), 1U);
        EXPECT_EQ(ofProgram.read().front().name, "motor");
        terminal = std::make_unique<Terminal>(name);
        EXPECT_EQ(terminal->hear(300ms), "") << "nobody but the program talks there";
    }
    EXPECT_EQ(terminal->hear(patience), "STOP");
}

TEST_F(CutLine, OfAProgramThatIsFrozenIsTheBusinessOfItsGuardianWhoeverHasTheLock)
{
    DebtBook ofProgram(folder.path("run"), "serial:" + name);
    ASSERT_TRUE(ofProgram.own());
    cut();
    awaitDebt(); // it is silent, and does not hang up
    terminal = std::make_unique<Terminal>(name);
    ASSERT_EQ(terminal->hear(patience), "STOP");
    terminal->answer();
    const auto end = SteadyClock::now() + patience;
    while (book.exists() && SteadyClock::now() < end)
        ::usleep(2000);
    EXPECT_FALSE(book.exists()) << "it was answered";
}

TEST_F(CutLine, IsNobodysBusinessBetweenTwoTriesOfItsGuardian)
{
    cutAndKill();
    DebtBook ofProgram(folder.path("run"), "serial:" + name);
    int taken = 0;
    for (int i = 0; i < 40; ++i) {
        taken += ofProgram.own() ? 1 : 0;
        ofProgram.disown();
        ::usleep(7000);
    }
    EXPECT_GE(taken, 30) << "a program asks once, when it opens the link";
}

TEST_F(CutLine, GetsItsStopAtTheRateOfItsDeviceWhoeverSetAnother)
{
    terminal->setSpeed(B9600);
    ::usleep(100000);
    tell({Order::Kind::Stop, 1, {}, {}});
    ASSERT_EQ(terminal->hear(patience), "STOP");
    EXPECT_EQ(terminal->speed(), speed_t{B57600});
    terminal->answer();
    terminal->setSpeed(B9600);
    tell({Order::Kind::Watch, 2, "motor", debt("motor").script});
    std::array<std::uint8_t, 64> said{};
    for (int i = 0; i < 2; ++i) // Acted, Standing
        EXPECT_GT(::recv(process.socket, said.data(), said.size(), 0), 0);
    tell({Order::Kind::Stop, 2, {}, {}});
    ASSERT_EQ(terminal->hear(patience), "STOP");
    EXPECT_EQ(terminal->speed(), speed_t{B9600}) << "that of its last watch";
}

TEST_F(CutLine, WhoseBookIsTakenAwayIsNoLineThatWasSettled)
{
    cutAndKill();
    std::filesystem::remove_all(folder.path("run"));
    ::usleep(200000);
    EXPECT_EQ(::waitpid(process.pid, nullptr, WNOHANG), 0) << "it still owes";
    EXPECT_TRUE(book.exists()) << "and has written it down again";
    terminal = std::make_unique<Terminal>(name);
    EXPECT_EQ(terminal->hear(patience), "STOP");
    terminal->answer();
    EXPECT_TRUE(isGone());
}

TEST_F(CutLine, OfTwoDebtsGetsTheOneThatNobodyHasSettled)
{
    guardian::Script other = debt("other").script;
    other.front().bytes = {'H', 'A', 'L', 'T'};
    tell({Order::Kind::Watch, 2, "other", other});
    std::array<std::uint8_t, 64> standing{};
    EXPECT_GT(::recv(process.socket, standing.data(), standing.size(), 0), 0);
    DebtBook ofProgram(folder.path("run"), "serial:" + name);
    ASSERT_TRUE(ofProgram.own());
    cutAndKill();
    const auto end = SteadyClock::now() + patience;
    while (book.read().size() < 2 && SteadyClock::now() < end)
        ::usleep(2000);
    book.remove("motor"); // seen to stand by the program that has the line now
    terminal = std::make_unique<Terminal>(name);
    ofProgram.disown();
    EXPECT_EQ(terminal->hear(patience), "HALT") << "another master may drive it by now";
    terminal->answer();
    EXPECT_TRUE(isGone());
    EXPECT_FALSE(book.exists());
}

TEST_F(CutLine, OfAProgramThatDiedIsFreeForTheNextOneWhileItsGuardianOwes)
{
    const int line = terminal->open();
    ASSERT_EQ(::ioctl(line, TIOCEXCL), 0); // as QSerialPort has it, which does not live to take it back
    ::close(process.socket);
    awaitDebt();
    int isExclusive = -1;
    EXPECT_EQ(::ioctl(line, TIOCGEXCL, &isExclusive), 0);
    EXPECT_EQ(isExclusive, 0) << "it would be told that another program uses the port";
    ::close(line);
}

TEST_F(CutLine, IsForgottenWhenAProgramHasSettledIt)
{
    cutAndKill();
    book.remove("motor");
    EXPECT_TRUE(isGone());
}

} // namespace
} // namespace mb
