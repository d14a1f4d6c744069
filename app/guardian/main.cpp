// SPDX-License-Identifier: GPL-3.0-or-later
// The guardian of one link (docs/architecture.md, Guardian). Started by the program that drives motors there, with the packet socket
// to it as descriptor 0 and a duplicate of the link's as 3:   motorbench-guardian packet|stream|spi
#include "app/guardian/port.h"
#include "app/guardian/watchman.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>

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
constexpr int line = 3;

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
    if (::poll(&terminal, 1, 0) != 1 || ::write(STDERR_FILENO, whole.data(), whole.size()) < 0)
        ::syslog(LOG_USER | LOG_WARNING, "%s", text.c_str());
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
    ::close_range(line + 1, ~0U, 0);
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

void waitFor(const Watchman &watchman, bool hungUp)
{
    // A negative descriptor is not looked at.
    std::array<pollfd, 2> sources{
        {{hungUp ? -1 : program, POLLIN, 0}, {watchman.isListening() ? line : -1, POLLIN, 0}}};
    const auto due = watchman.due();
    const Time left = due ? std::max(*due - now(), Time::zero()) : Time::zero();
    const auto whole = std::chrono::duration_cast<std::chrono::seconds>(left);
    const timespec limit{whole.count(), static_cast<long>((left - whole).count())};
    ::ppoll(sources.data(), sources.size(), due ? &limit : nullptr, nullptr);
    if ((sources[1].revents & (POLLERR | POLLHUP)) != 0)
        ::usleep(1000); // a dead line is always ready
}

} // namespace

int main(int argc, char **argv)
{
    const auto port = argc == 2 ? makePort(argv[1], line) : nullptr;
    if (!port || ::fcntl(line, F_GETFD) < 0) {
        std::fputs("motorbench-guardian is started by motorbench and motorbenchctl, not by hand\n", stderr);
        return 2;
    }
    takePost();
    Watchman watchman(*port, {report, log});
    bool hungUp = false;
    while (!watchman.isDone()) {
        waitFor(watchman, hungUp);
        // First what was said in time, then what the time says: a delay of ours is no silence of the program.
        if (!hungUp && !listen(watchman)) {
            hungUp = true;
            watchman.hangUp(now());
        }
        watchman.proceed(now());
    }
    return 0;
}
