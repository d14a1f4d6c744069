// SPDX-License-Identifier: GPL-3.0-or-later
// The guardian of one link (docs/architecture.md#guardian). Started by the program that drives motors there, with the packet socket
// to it as descriptor 0 and a duplicate of the link's as 3:   motorbench-guardian packet|stream|spi FOLDER IDENTITY NAME
// The last three say where debts are kept, and how the line is found again.
#include "app/guardian/debts.h"
#include "app/guardian/line.h"
#include "app/guardian/watchman.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <optional>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <syslog.h>
#include <time.h>
#include <unistd.h>

namespace {

using namespace mb::guardian;

constexpr int program = 0;
constexpr int lineDescriptor = 3;
constexpr Time tryEvery = std::chrono::milliseconds(50); ///< whether the line is back: within 100 ms
constexpr Time againEvery = std::chrono::seconds(1);     ///< on a line that is there

bool hasLeftTerminal = false;

Time now()
{
    timespec time{};
    ::clock_gettime(CLOCK_MONOTONIC, &time);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

void log(const std::string &text)
{
    const std::string whole = "motorbench-guardian: " + text + "\n";
    pollfd terminal{STDERR_FILENO, POLLOUT, 0}; // one that is held must not hold us
    if (hasLeftTerminal || ::poll(&terminal, 1, 0) != 1 || ::write(STDERR_FILENO, whole.data(), whole.size()) < 0)
        ::syslog(LOG_USER | LOG_WARNING, "%s", text.c_str());
}

/// Whoever waits for the end of the program's output must not wait for what is owed, too: from here on the system's log has it.
void leaveTerminal()
{
    const int nothing = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    ::dup2(nothing, STDERR_FILENO);
    ::close(nothing);
}

void report(const Report &said)
{
    const Bytes packet = encode(said);
    (void)::send(program, packet.data(), packet.size(), MSG_DONTWAIT | MSG_NOSIGNAL); // it may be gone
}

/// What ends or stops the program must not end this one, and nothing should keep it waiting.
void takePost()
{
    for (const int number :
        {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGTSTP, SIGTTIN, SIGTTOU, SIGUSR1, SIGUSR2, SIGALRM})
        std::signal(number, SIG_IGN);
    ::setsid();
    ::close_range(lineDescriptor + 1, ~0U, 0);
    if (::chdir("/") != 0) { } // only so that no disk is kept busy
    // As far as an ordinary user may.
    sched_param urgent{};
    urgent.sched_priority = ::sched_get_priority_min(SCHED_FIFO);
    if (::sched_setscheduler(0, SCHED_FIFO, &urgent) != 0)
        ::setpriority(PRIO_PROCESS, 0, -15);
    ::mlockall(MCL_CURRENT);
}

/// Hands over what has come from the program. False once it has hung up.
bool listen(Watchman &watchman)
{
    std::array<std::uint8_t, largestMessage> packet{};
    for (;;) {
        const ssize_t got = ::recv(program, packet.data(), packet.size(), MSG_DONTWAIT);
        if (got > 0)
            watchman.hear({packet.data(), static_cast<std::size_t>(got)}, now());
        else if (got == 0 || (errno != EAGAIN && errno != EINTR))
            return false;
        else
            return true;
    }
}

void waitFor(const Watchman &watchman, const Line &line, std::optional<Time> due, bool hungUp)
{
    // A negative descriptor is not looked at.
    std::array<pollfd, 2> sources{
        {{hungUp ? -1 : program, POLLIN, 0}, {watchman.isListening() ? line.ear() : -1, POLLIN, 0}}};
    const Time left = due ? std::max(*due - now(), Time::zero()) : Time::zero();
    const auto whole = std::chrono::duration_cast<std::chrono::seconds>(left);
    const timespec limit{whole.count(), static_cast<long>((left - whole).count())};
    ::ppoll(sources.data(), sources.size(), due ? &limit : nullptr, nullptr);
    if ((sources[1].revents & (POLLERR | POLLHUP)) != 0)
        ::usleep(1000); // a dead line is always ready
}

/// Tries what is owed whenever the line is there and is nobody else's business. A program that fell silent has none.
class Paymaster {
public:
    Paymaster(Watchman &watchman, Line &line, DebtBook &book)
        : m_watchman(watchman)
        , m_line(line)
        , m_book(book)
    {
    }
    [[nodiscard]] std::optional<Time> due() const
    {
        return m_watchman.isOwing() ? std::optional(next()) : std::nullopt;
    }
    void proceed(Time present)
    {
        if (!m_watchman.isIdle())
            return;
        m_book.disown(); // between two tries whoever opens the link takes over
        if (!m_watchman.isOwing() || present < next())
            return;
        m_triedAt = present;
        dropSettled();
        if (!m_watchman.isOwing())
            return;
        if (!m_book.exists()) {
            m_isKept = true;
            m_watchman.tellDebts(); // into a new book, where there can be one
        }
        if (!m_isKept || m_watchman.hasFallenSilent() || m_book.claim() != DebtBook::Claim::Others) {
            if (!m_line.reopen()) {
                m_book.disown(); // a program that opens it first finds nobody in its way
                return;
            }
            m_watchman.pay(present);
            m_watchman.proceed(present);
        }
    }
    void note(const Watchman::Owed &owed, bool isOwed)
    {
        if (!isOwed) {
            m_book.remove(owed.name);
            return;
        }
        const auto age = std::chrono::duration_cast<std::chrono::milliseconds>(now() - owed.since);
        const bool isWritten = m_book.add({owed.name, owed.script, runTime() - age});
        m_isKept = m_isKept && isWritten;
    }

private:
    /// Whoever has seen a motor stand strikes it out. A book that cannot be read settles nothing.
    void dropSettled()
    {
        const std::vector<Debt> booked = m_book.read();
        if (!m_isKept || (booked.empty() && !m_book.isSettled()))
            return;
        m_watchman.settle([&booked](const Watchman::Owed &owed) {
            return std::ranges::none_of(
                booked, [&owed](const Debt &debt) { return unitOf(debt.name) == unitOf(owed.name); });
        });
    }
    [[nodiscard]] Time next() const { return m_triedAt + (m_watchman.isCut() ? tryEvery : againEvery); }

    Watchman &m_watchman;
    Line &m_line;
    DebtBook &m_book;
    bool m_isKept = true; ///< all of it, where others find it
    Time m_triedAt{};
};

std::optional<Time> earlier(std::optional<Time> a, std::optional<Time> b)
{
    return a && b ? std::min(a, b) : a ? a : b;
}

} // namespace

int main(int argc, char **argv)
{
    const auto form = argc == 5 ? portFormFrom(argv[1]) : std::nullopt;
    if (!form || ::fcntl(lineDescriptor, F_GETFD) < 0) {
        std::fputs("motorbench-guardian is started by motorbench and motorbenchctl, not by hand\n", stderr);
        return 2;
    }
    Line line({*form, argv[3], argv[4]}, lineDescriptor);
    takePost();
    DebtBook book(argv[2], argv[3]);
    Paymaster *teller = nullptr;
    Watchman watchman(
        line, {report, log, [&teller](const Watchman::Owed &owed, bool isOwed) { teller->note(owed, isOwed); }});
    Paymaster paymaster(watchman, line, book);
    teller = &paymaster;
    bool hungUp = false;
    while (!watchman.isDone()) {
        waitFor(watchman, line, earlier(watchman.due(), paymaster.due()), hungUp);
        // First what was said in time, then what the time says: a delay of ours is no silence of the program.
        if (!hungUp && !listen(watchman)) {
            hungUp = true;
            watchman.hangUp(now());
            line.share();
        }
        watchman.proceed(now());
        paymaster.proceed(now());
        if (hungUp && watchman.isOwing() && !std::exchange(hasLeftTerminal, true))
            leaveTerminal();
    }
    return 0;
}
