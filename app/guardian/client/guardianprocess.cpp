// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/guardian/client/guardianprocess.h"

#include "app/guardian/client/wirescript.h"
#include "async/descriptor.h"

#include <array>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstring>

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

namespace mb {
namespace {

constexpr int childSocket = 0;
constexpr int childLine = 3;
constexpr int aboveTheirs = 10; // no number that is given out in the child is one that is still to be copied there

int spawn(pid_t &pid, const std::string &program, const GuardedLine &guarded, int socket, int line)
{
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawnattr_init(&attributes);
    ::posix_spawn_file_actions_adddup2(&actions, socket, childSocket);
    ::posix_spawn_file_actions_addopen(
        &actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0); // ours may be somebody's pipe
    ::posix_spawn_file_actions_adddup2(&actions, line, childLine);
    sigset_t none;
    sigset_t all;
    sigemptyset(&none);
    sigfillset(&all);
    ::posix_spawnattr_setsigmask(&attributes, &none);
    ::posix_spawnattr_setsigdefault(&attributes, &all);
    ::posix_spawnattr_setflags(
        &attributes, static_cast<short>(POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF));
    const auto form = portFormOf(guarded.outlet.form);
    std::array<std::string, 5> words{
        program, form ? toString(*form) : "", guarded.folder, guarded.identity, guarded.name};
    std::array<char *, 6> arguments{
        words[0].data(), words[1].data(), words[2].data(), words[3].data(), words[4].data(), nullptr};
    const int cause = ::posix_spawn(&pid, program.c_str(), &actions, &attributes, arguments.data(), environ);
    ::posix_spawnattr_destroy(&attributes);
    ::posix_spawn_file_actions_destroy(&actions);
    return cause;
}

} // namespace

Result<GuardianProcess> startGuardian(const std::string &program, const GuardedLine &guarded)
{
    if (::access(program.c_str(), X_OK) != 0)
        return fail(Fault::Unsafe, say("%1 is missing", program),
            say("without it nothing would stop this motor if the program died: install it there"));
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0)
        return fail(Fault::Unsafe, say("no guardian can be started: %1", std::strerror(errno)));
    Descriptor ours(ends[0]);
    const Descriptor theirs(ends[1]);
    const Descriptor socket(::fcntl(theirs.get(), F_DUPFD_CLOEXEC, aboveTheirs));
    const Descriptor line(::fcntl(guarded.outlet.descriptor, F_DUPFD_CLOEXEC, aboveTheirs));
    GuardianProcess process;
    const int cause
        = socket.get() < 0 || line.get() < 0 ? errno : spawn(process.pid, program, guarded, socket.get(), line.get());
    if (cause != 0)
        return fail(Fault::Unsafe, say("no guardian can be started: %1", std::strerror(cause)));
    process.socket = ours.give();
    return process;
}

std::string guardianBesideThisProgram()
{
    std::array<char, PATH_MAX> path{};
    const ssize_t length = ::readlink("/proc/self/exe", path.data(), path.size());
    const std::string self(path.data(), length > 0 ? static_cast<std::size_t>(length) : 0U);
    return self.substr(0, self.rfind('/') + 1) + "motorbench-guardian";
}

void reap(std::vector<pid_t> &ended)
{
    std::erase_if(ended, [](pid_t pid) { return ::waitpid(pid, nullptr, WNOHANG) != 0; });
}

} // namespace mb
