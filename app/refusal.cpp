// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/refusal.h"

#include "widgets/common/devicetext.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <cerrno>
#include <csignal>
#include <cstdio>

#include <unistd.h>

namespace mb {
namespace {

constexpr int notDone = 1;
constexpr int wrongInput = 2;

int statusOf(const Error &error)
{
    return error.fault == Fault::NotKept || error.fault == Fault::Cancelled ? notDone : wrongInput;
}

QByteArray lineOf(Error error, bool json)
{
    if (error.help().empty())
        error.remedy = mb::say("--help tells what there is");
    if (!json)
        return QByteArray(program_invocation_short_name) + ": " + error.text().c_str() + '\n';
    const char *const fault = error.fault == Fault::Cancelled ? "cancelled"
        : error.fault == Fault::NotKept                       ? "refused"
                                                              : "out-of-range";
    const QJsonObject row{{QStringLiteral("status"), statusOf(error)}, {QStringLiteral("fault"), QLatin1String(fault)},
        {QStringLiteral("cause"), qt(error.detail.english())}, {QStringLiteral("remedy"), qt(error.help().english())}};
    return QJsonDocument(QJsonObject{{QStringLiteral("error"), row}}).toJson(QJsonDocument::Compact) + '\n';
}

/// The handler may neither allocate nor format. Never destroyed: it may come at any time.
const QByteArray *lastLine = nullptr;

void end(int)
{
    (void)!::write(STDERR_FILENO, lastLine->constData(), static_cast<std::size_t>(lastLine->size()));
    ::_exit(notDone);
}

} // namespace

int refuse(const Error &error, bool json)
{
    std::fputs(lineOf(error, json).constData(), stderr);
    return statusOf(error);
}

void endOnSignals(bool json)
{
    lastLine = new QByteArray(
        lineOf({Fault::Cancelled, mb::say("interrupted before it was done"), mb::say("run it again to finish")}, json));
    sigset_t all;
    sigemptyset(&all);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction action { };
        ::sigaction(number, nullptr, &action);
        if (number == SIGHUP && action.sa_handler == SIG_IGN)
            continue;
        action = {};
        action.sa_handler = end;
        ::sigaction(number, &action, nullptr);
        sigaddset(&all, number);
    }
    ::sigprocmask(SIG_UNBLOCK, &all, nullptr);
}

} // namespace mb
