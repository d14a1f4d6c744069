// SPDX-License-Identifier: GPL-3.0-or-later
// The real guardian, started by a real program (guardedprogram) that is then killed, frozen or left without it. Prints how long a
// motor goes on; docs/safety.md allows 700 ms.
#include "app/guardian/client/guardianprocess.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <linux/can.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mb {
namespace {

using namespace std::chrono_literals;
using SteadyClock = std::chrono::steady_clock;
using Instant = SteadyClock::time_point;

constexpr auto limit = 700ms;
constexpr auto patience = 30s; // a program that hangs fails, a slow machine does not

/// Where guardians leave what they owe. They end when it is gone: the lines of these tests do not come back.
class DebtFolder final : public testing::Environment {
public:
    void SetUp() override
    {
        std::string pattern = testing::TempDir() + "/guardiansXXXXXX";
        ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
        m_path = pattern;
        ::setenv("XDG_RUNTIME_DIR", m_path.c_str(), 1);
    }
    void TearDown() override
    {
        std::error_code busy = std::make_error_code(std::errc::directory_not_empty); // one writes there meanwhile
        for (int tries = 0; busy && tries < 100; ++tries)
            std::filesystem::remove_all(m_path, busy);
    }

private:
    std::string m_path;
};

const auto *const guardianLeavings = testing::AddGlobalTestEnvironment(new DebtFolder);

/// Both ends of the line to the motor; `theirs` goes to the program.
struct Line {
    int ours = -1;
    int theirs = -1;
    bool packets = true;
};

Line packetLine()
{
    std::array<int, 2> ends{};
    EXPECT_EQ(::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()), 0);
    return {ends[0], ends[1], true};
}

Line terminalLine()
{
    const int master = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    EXPECT_TRUE(master >= 0 && ::grantpt(master) == 0 && ::unlockpt(master) == 0);
    const int slave = ::open(::ptsname(master), O_RDWR | O_NOCTTY | O_CLOEXEC);
    EXPECT_GE(slave, 0);
    const std::string raw = "stty raw -echo < " + std::string(::ptsname(master));
    EXPECT_EQ(std::system(raw.c_str()), 0);
    return {master, slave, false};
}

/// The motor's end of the line: what it was told, and when.
class MotorEnd {
public:
    explicit MotorEnd(const Line &line)
        : m_line(line)
    {
    }
    ~MotorEnd() { ::close(m_line.ours); }
    MotorEnd(const MotorEnd &) = delete;
    MotorEnd &operator=(const MotorEnd &) = delete;

    /// Takes what comes until `drives` drive messages and `stops` stops were heard, or that long.
    bool hear(int drives, int stops, SteadyClock::duration time = patience)
    {
        const Instant end = SteadyClock::now() + time;
        while (m_drives < drives || m_stops < stops) {
            const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - SteadyClock::now());
            pollfd source{m_line.ours, POLLIN, 0};
            if (left <= 0ms || ::poll(&source, 1, static_cast<int>(left.count()) + 1) <= 0)
                return false;
            std::array<char, 512> part{};
            const ssize_t got = ::read(m_line.ours, part.data(), part.size());
            if (got <= 0)
                return false;
            take(std::string(part.data(), static_cast<std::size_t>(got)));
        }
        return true;
    }
    void forget() { m_drives = m_stops = 0; }
    [[nodiscard]] int drives() const { return m_drives; }
    [[nodiscard]] int stops() const { return m_stops; }
    [[nodiscard]] Instant firstStop() const { return m_firstStop; }
    int answersFrom = 1; ///< the stop, counted from 1, that gets the first answer; on a terminal

private:
    void take(const std::string &bytes)
    {
        if (m_line.packets) {
            can_frame frame{};
            ASSERT_EQ(bytes.size(), sizeof frame);
            std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char *>(&frame));
            count(frame.data[0] == 0);
            return;
        }
        m_text += bytes;
        for (auto end = m_text.find('\n'); end != std::string::npos; end = m_text.find('\n')) {
            const std::string text = m_text.substr(0, end);
            m_text.erase(0, end + 1);
            count(text.find("#01") == std::string::npos);
            if (text == "STOP" && m_stops >= answersFrom) {
                EXPECT_EQ(::write(m_line.ours, "..ok", 4), 4);
            }
        }
    }
    void count(bool stop)
    {
        if (stop && m_stops++ == 0)
            m_firstStop = SteadyClock::now();
        m_drives += stop ? 0 : 1;
    }

    Line m_line;
    int m_drives = 0;
    int m_stops = 0;
    Instant m_firstStop{};
    std::string m_text;
};

/// guardedprogram, in a process group of its own.
class Program {
public:
    explicit Program(const Line &line)
    {
        std::array<int, 2> pipe{};
        EXPECT_EQ(::pipe2(pipe.data(), O_CLOEXEC), 0);
        const std::string folder = guardianBesideThisProgram().substr(0, guardianBesideThisProgram().rfind('/'));
        const std::string path = folder + "/guardedprogram";
        m_pid = ::fork();
        if (m_pid == 0) {
            ::setpgid(0, 0);
            ::dup2(pipe[1], STDOUT_FILENO);
            const int theirs = ::fcntl(line.theirs, F_DUPFD, 20);
            ::dup2(theirs, 5);
            ::close(theirs);
            ::execl(path.c_str(), path.c_str(), line.packets ? "packet" : "stream", nullptr);
            ::_exit(127);
        }
        ::close(pipe[1]);
        ::close(line.theirs);
        m_output = pipe[0];
    }
    ~Program()
    {
        signal(SIGKILL);
        ::close(m_output);
        if (m_pid > 0)
            ::waitpid(m_pid, nullptr, 0);
    }
    Program(const Program &) = delete;
    Program &operator=(const Program &) = delete;

    void signal(int number) const { ::kill(m_pid, number); }
    void signalGroup(int number) const { ::kill(-m_pid, number); }
    /// The next line of its output that begins so, without that beginning; empty when none comes.
    std::string next(const std::string &begin)
    {
        const Instant end = SteadyClock::now() + patience;
        for (;;) {
            for (auto at = m_text.find('\n'); at != std::string::npos; at = m_text.find('\n')) {
                const std::string text = m_text.substr(0, at);
                m_text.erase(0, at + 1);
                if (text.rfind(begin, 0) == 0)
                    return text.substr(begin.size());
            }
            pollfd source{m_output, POLLIN, 0};
            std::array<char, 512> part{};
            if (SteadyClock::now() > end || ::poll(&source, 1, 1000) < 0)
                return {};
            const ssize_t got = source.revents != 0 ? ::read(m_output, part.data(), part.size()) : 0;
            if (got == 0 && source.revents != 0)
                return {};
            m_text.append(part.data(), static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
        }
    }

private:
    pid_t m_pid = -1;
    int m_output = -1;
    std::string m_text;
};

class GuardianProcess : public testing::TestWithParam<bool> {
protected:
    [[nodiscard]] static Line line() { return GetParam() ? packetLine() : terminalLine(); }
    /// The program drives; yields its guardian.
    static pid_t drive(Program &program, MotorEnd &motor)
    {
        EXPECT_TRUE(motor.hear(20, 0)) << "the motor is driven, 50 times a second";
        const std::string pid = program.next("guardian ");
        EXPECT_FALSE(pid.empty());
        motor.forget();
        return static_cast<pid_t>(std::atoi(pid.c_str()));
    }
    static void expectStopped(MotorEnd &motor, Instant since, const char *what)
    {
        ASSERT_TRUE(motor.hear(0, 1)) << "no stop came";
        const auto taken = motor.firstStop() - since;
        std::printf("%s: stop on the %s after %.1f ms (limit %d)\n", what, GetParam() ? "socket" : "terminal",
            std::chrono::duration<double, std::milli>(taken).count(), static_cast<int>(limit.count()));
        EXPECT_LE(taken, limit);
    }
    /// Nothing drives for so long.
    static void expectQuiet(MotorEnd &motor, SteadyClock::duration time)
    {
        const int driven = motor.drives();
        EXPECT_FALSE(motor.hear(driven + 1, 0, time));
        EXPECT_EQ(motor.drives(), driven);
    }
    /// One that has ended and that nobody has waited for is gone too: who waits for an orphan is not this program's to say.
    static bool isRunning(pid_t pid)
    {
        std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
        const std::string stat{std::istreambuf_iterator<char>(file), {}};
        const auto name = stat.rfind(')');
        return name != std::string::npos && name + 2 < stat.size() && stat[name + 2] != 'Z';
    }
    static bool isGone(pid_t pid)
    {
        for (int i = 0; i < 1000 && isRunning(pid); ++i)
            ::usleep(10'000);
        return !isRunning(pid);
    }
};

TEST_P(GuardianProcess, AKilledProgramLeavesNoMotorRunning)
{
    const Line ends = line();
    MotorEnd motor(ends);
    Program program(ends);
    const pid_t guardian = drive(program, motor);
    const Instant at = SteadyClock::now();
    program.signal(SIGKILL);
    expectStopped(motor, at, "SIGKILL");
    expectQuiet(motor, 300ms);
    EXPECT_TRUE(isGone(guardian)) << "the guardian ends with its work";
}

TEST_P(GuardianProcess, AFrozenProgramLeavesNoMotorRunningAndDoesNotGoOnWhenItThaws)
{
    const Line ends = line();
    MotorEnd motor(ends);
    Program program(ends);
    drive(program, motor);
    const Instant at = SteadyClock::now();
    program.signal(SIGSTOP);
    expectStopped(motor, at, "SIGSTOP");
    expectQuiet(motor, 300ms);
    program.signal(SIGCONT);
    EXPECT_NE(program.next("ended: "), "") << "it knows that its motion is over";
    expectQuiet(motor, 500ms);
}

TEST_P(GuardianProcess, KeysOfTheTerminalReachTheProgramAndNotTheGuardian)
{
    for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
        const Line ends = line();
        MotorEnd motor(ends);
        Program program(ends);
        const pid_t guardian = drive(program, motor);
        for (const int own : {SIGINT, SIGTERM, SIGHUP})
            ::kill(guardian, own);
        const Instant at = SteadyClock::now();
        program.signalGroup(number);
        expectStopped(motor, at, ::strsignal(number));
    }
}

TEST_P(GuardianProcess, AGuardianThatIsKilledEndsTheMotion)
{
    const Line ends = line();
    MotorEnd motor(ends);
    Program program(ends);
    const pid_t guardian = drive(program, motor);
    const Instant at = SteadyClock::now();
    ::kill(guardian, SIGKILL);
    expectStopped(motor, at, "guardian killed");
    EXPECT_EQ(program.next("ended: "), "the guardian ended unexpectedly");
    expectQuiet(motor, 300ms);
}

TEST_P(GuardianProcess, AGuardianThatIsFrozenEndsTheMotion)
{
    const Line ends = line();
    MotorEnd motor(ends);
    Program program(ends);
    const pid_t guardian = drive(program, motor);
    ::kill(guardian, SIGSTOP);
    EXPECT_EQ(program.next("ended: "), "the guardian does not answer");
    EXPECT_TRUE(motor.hear(0, 1));
    ::kill(guardian, SIGKILL);
}

TEST_P(GuardianProcess, HoldsNothingThatIsNotItsBusiness)
{
    const Line ends = line();
    MotorEnd motor(ends);
    Program program(ends);
    const pid_t guardian = drive(program, motor);
    std::vector<std::string> open;
    for (const auto &entry : std::filesystem::directory_iterator("/proc/" + std::to_string(guardian) + "/fd"))
        open.push_back(entry.path().filename());
    std::sort(open.begin(), open.end());
    EXPECT_EQ(open, (std::vector<std::string>{"0", "1", "2", "3"}));
    EXPECT_EQ(::getsid(guardian), guardian) << "a session of its own";
}

INSTANTIATE_TEST_SUITE_P(Lines, GuardianProcess, testing::Values(true, false),
    [](const auto &entry) { return entry.param ? "Socket" : "Terminal"; });

TEST(GuardianOnATerminal, RepeatsTheStopUntilItIsAnswered)
{
    const Line ends = terminalLine();
    MotorEnd motor(ends);
    motor.answersFrom = 4;
    Program program(ends);
    ASSERT_TRUE(motor.hear(20, 0));
    motor.forget();
    program.signal(SIGKILL);
    EXPECT_TRUE(motor.hear(0, 4));
    EXPECT_FALSE(motor.hear(0, 5, 500ms)) << "and not once more";
}

TEST(GuardianThatIsMissing, IsNamedWithTheRemedy)
{
    const auto started
        = startGuardian("/nowhere/motorbench-guardian", {{Outlet::Form::Stream, STDIN_FILENO}, {}, {}, {}});
    ASSERT_FALSE(started);
    EXPECT_EQ(started.error().fault, Fault::Unsafe);
    EXPECT_NE(started.error().text().find("/nowhere/motorbench-guardian is missing"), std::string::npos);
}

TEST(GuardianByHand, SaysWhoStartsIt)
{
    const std::string command = guardianBesideThisProgram() + " packet 2>&1 3<&-";
    FILE *const output = ::popen(command.c_str(), "r");
    ASSERT_NE(output, nullptr);
    std::array<char, 256> text{};
    EXPECT_NE(std::fgets(text.data(), text.size(), output), nullptr);
    EXPECT_EQ(WEXITSTATUS(::pclose(output)), 2);
    EXPECT_NE(std::string(text.data()).find("not by hand"), std::string::npos);
}

} // namespace
} // namespace mb
