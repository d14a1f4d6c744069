// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/crashreport.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>

#include <execinfo.h>
#include <fcntl.h>
#include <unistd.h>

namespace mb {
namespace {

constexpr std::size_t textRoom = 4096;
constexpr int mostCalls = 64;
constexpr int crashSignals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

/// What a signal handler may touch has to be there before: nothing is allocated in it.
struct Prepared {
    std::array<char, textRoom> path{};
    std::array<char, textRoom> head{};
    std::array<char, 65536> stack{};
};
Prepared prepared; // the handler has no argument of ours

void put(int file, const char *text)
{
    std::size_t rest = std::strlen(text);
    while (rest > 0) {
        const ssize_t written = ::write(file, text, rest);
        if (written <= 0)
            return;
        text += written;
        rest -= static_cast<std::size_t>(written);
    }
}

const char *nameOfSignal(int signal)
{
    switch (signal) {
    case SIGSEGV: return "SIGSEGV: memory that is not the program's\n";
    case SIGBUS: return "SIGBUS: memory that is not there any more\n";
    case SIGFPE: return "SIGFPE: an impossible calculation\n";
    case SIGILL: return "SIGILL: an instruction that this processor has not\n";
    default: return "SIGABRT: the program found itself in a state that cannot be\n";
    }
}

void writeReport(int signal)
{
    const int file = ::open(prepared.path.data(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    if (file >= 0) {
        put(file, prepared.head.data());
        put(file, nameOfSignal(signal));
        put(file, "\nCalls, the innermost first:\n");
        std::array<void *, mostCalls> calls{};
        ::backtrace_symbols_fd(calls.data(), ::backtrace(calls.data(), mostCalls), file);
        ::close(file);
    }
    std::signal(signal, SIG_DFL);
    ::raise(signal);
}

void keep(std::array<char, textRoom> &place, const QString &text)
{
    const QByteArray bytes = QFile::encodeName(text);
    const auto length = std::min<std::size_t>(static_cast<std::size_t>(bytes.size()), textRoom - 1);
    std::copy_n(bytes.constData(), length, place.begin());
    place[length] = '\0';
}

} // namespace

void installCrashReport(const QString &folder, const QString &versions)
{
    if (!QDir().mkpath(folder))
        return;
    const QString time = QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss"));
    keep(prepared.path, QStringLiteral("%1/crash-%2-%3.txt").arg(folder, time).arg(QCoreApplication::applicationPid()));
    keep(prepared.head,
        QStringLiteral("MotorBench crashed. Nothing in this report names a person or a device.\nStarted %1\n%2\n")
            .arg(time, versions));
    std::array<void *, 1> first{};
    (void)::backtrace(first.data(), 1); // loads what it needs now: not in the handler
    stack_t stack{};
    stack.ss_sp = prepared.stack.data();
    stack.ss_size = prepared.stack.size();
    (void)::sigaltstack(&stack, nullptr); // a stack that is full has no room for a handler
    struct sigaction action { };
    action.sa_handler = writeReport;
    action.sa_flags = SA_ONSTACK | static_cast<int>(SA_RESETHAND);
    for (const int signal : crashSignals)
        (void)::sigaction(signal, &action, nullptr);
}

QString newestCrashReport(const QString &folder)
{
    const QStringList names
        = QDir(folder).entryList({QStringLiteral("crash-*.txt")}, QDir::Files, QDir::Name | QDir::Reversed);
    return names.isEmpty() ? QString() : QDir(folder).filePath(names.constFirst());
}

} // namespace mb
