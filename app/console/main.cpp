// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/commandline.h"
#include "app/console/signals.h"
#include "app/sleep/logindinhibitor.h"
#include "app/sleep/sleepguard.h"
#include "async/scope.h"
#include "model/registry.h"
#include "transport/qtclock.h"

#include <QCoreApplication>

#include <clocale>
#include <csignal>
#include <iostream>

namespace {

using namespace mb;
using namespace mb::console;

/// Runs one job to its end in the program's only event loop.
class Program {
public:
    Program(QCoreApplication &application, Options options)
        : m_application(application)
        , m_console(m_clock, families(), options)
        , m_sleepGuard(m_console.session(), m_clock, m_inhibitor)
        , m_mayBeSuspended(m_inhibitor.troubled().add([this](const std::string &text) { m_console.note(text); }))
        , m_scope(m_clock)
        , m_signals([this] { interrupt(); })
        , m_broken(m_console.out().broken().add([this] { interrupt(); }))
    {
    }

    int run(const Job &job)
    {
        m_scope.spawn<int>(job(m_console), [this](Result<int> result) { ended(result); });
        int status = m_application.exec();
        m_console.out().flush();
        if (const std::string &error = m_console.out().error(); !error.empty()) {
            complain(error);
            status = status == exitDone ? exitDevice : status;
        }
        return status;
    }

private:
    void ended(const Result<int> &result)
    {
        if (!result)
            complain(lineOf(result.error()));
        m_application.exit(result ? *result : exitStatusOf(result.error().fault));
    }
    void interrupt()
    {
        const bool ends = m_console.interrupted().size() > 0;
        m_console.interrupt();
        if (ends)
            return;
        if (m_console.out().isBroken())
            m_application.exit(exitDone);
        else
            ended(fail(Fault::Cancelled, "interrupted before it was done"));
    }

    QCoreApplication &m_application;
    QtClock m_clock;
    Console m_console;
    LogindInhibitor m_inhibitor;
    SleepGuard m_sleepGuard;
    Subscription m_mayBeSuspended;
    Scope m_scope; ///< its task uses everything above
    Signals m_signals;
    Subscription m_broken;
};

} // namespace

int main(int argc, char **argv)
{
    std::signal(SIGPIPE, SIG_IGN);
    auto line = parseCommandLine({argv + 1, argv + argc});
    if (!line) {
        complain(lineOf(line.error()));
        return exitUsage;
    }
    if (!line->job) {
        std::cout << line->text << std::flush;
        return exitDone;
    }
    QCoreApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C"); // a number has a dot whatever the locale
    Program program(application, line->options);
    return program.run(line->job);
}
