// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/commandline.h"
#include "app/console/signals.h"
#include "app/folders/relativefolders.h"
#include "app/sleep/logindinhibitor.h"
#include "app/sleep/sleepguard.h"
#include "async/scope.h"
#include "model/registry.h"
#include "transport/qtclock.h"

#include <QCoreApplication>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <cerrno>
#include <clocale>
#include <csignal>
#include <cstring>
#include <optional>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace {

using namespace mb;
using namespace mb::console;

constexpr Duration lastOutput = std::chrono::seconds(1); // after a signal, for a reader that is slow

/// Runs one job to its end in the program's only event loop.
class Program {
public:
    Program(QCoreApplication &application, Options options)
        : m_application(application)
        , m_console(m_clock, families(), options)
        , m_sleepGuard(m_console.session(), m_clock, m_inhibitor, [this] { return m_console.staysAwake(); })
        , m_mayBeSuspended(m_inhibitor.troubled().add([this](const Message &text) { m_console.note(text.english()); }))
        , m_scope(m_clock)
        , m_signals([this] { interrupt(); })
        , m_broken(m_console.out().broken().add([this] { interrupt(); }))
        , m_drained(m_console.out().done().add([this] { leave(); }))
        , m_limit(m_clock)
    {
    }

    int run(const Job &job)
    {
        m_scope.spawn<int>(job(m_console), [this](Result<int> result) { ended(result); });
        return m_application.exec();
    }

private:
    /// What is written is on its way, however slowly it is read; a signal cuts that short.
    void ended(const Result<int> &result)
    {
        m_status = result ? *result : m_console.fails(result.error());
        m_console.out().flush();
        if (m_console.isInterrupted())
            m_limit.startIn(lastOutput, [this] { m_console.out().abandon(); });
        leave();
    }
    void leave()
    {
        if (!m_status || !m_console.out().isDone())
            return;
        const Error &error = m_console.out().error();
        if (!error.detail.empty() && !std::exchange(m_hasTold, true)) {
            const int status = m_console.fails(error);
            m_status = *m_status == exitDone ? status : *m_status;
        }
        m_application.exit(*m_status);
    }
    void interrupt()
    {
        if (m_status) { // only its output was awaited
            m_console.out().abandon();
            leave();
            return;
        }
        const bool ends = m_console.interrupted().size() > 0;
        m_console.interrupt();
        if (ends)
            return;
        if (m_console.out().isBroken())
            ended(exitDone);
        else
            ended(fail(Fault::Cancelled, say("interrupted before it was done")));
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
    Subscription m_drained;
    Timer m_limit;
    std::optional<int> m_status; ///< of the verb, once it has ended
    bool m_hasTold = false;
};

/// A standard stream that was closed (`>&-`) would be the number of the next file that is opened, and a line for people would go
/// into a port or a database. What takes its place refuses what it is for.
void occupyStandardStreams()
{
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) < 0 && errno == EBADF)
            (void)::open("/", O_RDONLY); // a folder; it takes the lowest number that is free
    }
}

/// What --help and --version print, with --json.
std::string jsonOf(const CommandLine &line)
{
    return QJsonDocument(QJsonObject{{qt(line.key), qt(line.value)}}).toJson(QJsonDocument::Compact).toStdString()
        + '\n';
}

/// Before there is an event loop. A reader that has gone is no error.
int print(const std::string &text, const Options &options)
{
    std::string_view rest = text;
    while (!rest.empty()) {
        const ssize_t written = ::write(STDOUT_FILENO, rest.data(), rest.size());
        if (written >= 0)
            rest.remove_prefix(static_cast<std::size_t>(written));
        else if (errno == EPIPE)
            return exitDone;
        else if (errno != EINTR && errno != EAGAIN) {
            tell({Fault::Refused, say("standard output cannot be written: %1", std::strerror(errno)),
                     say("make room, or choose another place")},
                exitDevice, options);
            return exitDevice;
        }
    }
    return exitDone;
}

} // namespace

int main(int argc, char **argv)
{
    occupyStandardStreams();
    ignoreRelativeFolders();
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN); // a file that may not grow is an error of the file
    const std::vector<std::string> words(argv + 1, argv + argc);
    Options before; // anything is understood
    before.json = std::ranges::find(words, "--json") != words.end();
    auto line = parseCommandLine(words);
    if (!line) {
        tell(line.error(), exitUsage, before);
        return exitUsage;
    }
    if (!line->job)
        return print(before.json ? jsonOf(*line) : line->text, before);
    QCoreApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C");  // a number has a dot whatever the locale
    std::setlocale(LC_MESSAGES, "C"); // and what the system says of an error is English, as all around it
    Program program(application, line->options);
    return program.run(line->job);
}
