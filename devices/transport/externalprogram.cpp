// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/externalprogram.h"

#include "files/qttext.h"

#include <QProcess>
#include <QStandardPaths>
#include <QStringList>

#include <csignal>
#include <utility>

#include <unistd.h>

namespace mb {
namespace {

/// Whatever the program's encoding is, ours is UTF-8.
std::string clean(const std::string &bytes)
{
    return QString::fromUtf8(bytes.data(), static_cast<int>(bytes.size())).toStdString();
}

/// Ctrl+C in a terminal goes to every process of a group, and who writes into a pipe that nobody reads gets SIGPIPE: neither must
/// cut what only this program may end, not even when this program dies.
class ProcessOfItsOwnGroup final : public QProcess {
private:
    void setupChildProcess() override
    {
        ::setpgid(0, 0);
        ::signal(SIGPIPE, SIG_IGN); // QProcess has just set it back
    }
};

} // namespace

ExternalProgram::ExternalProgram(Clock &clock)
    : m_process(std::make_unique<ProcessOfItsOwnGroup>())
    , m_timeout(clock)
    , m_wake(clock)
{
    m_process->setProcessChannelMode(QProcess::MergedChannels);
    m_process->setStandardInputFile(QProcess::nullDevice());
    QObject::connect(m_process.get(), &QProcess::readyReadStandardOutput, m_process.get(), [this] { read(); });
    QObject::connect(m_process.get(), qOverload<int, QProcess::ExitStatus>(&QProcess::finished), m_process.get(),
        [this](int status, QProcess::ExitStatus how) { ended(how == QProcess::CrashExit, status); });
    QObject::connect(m_process.get(), &QProcess::errorOccurred, m_process.get(), [this](QProcess::ProcessError error) {
        if (error != QProcess::FailedToStart)
            return; // the others end in finished()
        m_error
            = Error{Fault::LinkLost, say("%1 cannot be started: %2", m_name, m_process->errorString().toStdString())};
        m_ended = true;
        wakeSoon();
    });
}

ExternalProgram::~ExternalProgram()
{
    m_process->disconnect();
    if (m_process->state() == QProcess::NotRunning)
        return;
    m_process->kill();
    m_process->waitForFinished(1000); // SIGKILL: milliseconds
}

std::optional<std::string> ExternalProgram::locate(const std::string &program)
{
    const QString path = QStandardPaths::findExecutable(qt(program));
    return path.isEmpty() ? std::nullopt : std::optional<std::string>(path.toStdString());
}

Result<void> ExternalProgram::start(const Command &command)
{
    m_name = command.program;
    const auto path = locate(command.program);
    if (!path)
        return fail(
            Fault::LinkLost, say("%1 is not installed", m_name), say("install the package that has it and try again"));
    QStringList arguments;
    for (const std::string &argument : command.arguments)
        arguments << qt(argument);
    m_process->start(qt(*path), arguments, QIODevice::ReadOnly);
    if (m_error)
        return fail(*m_error);
    return {};
}

void ExternalProgram::read()
{
    const QByteArray bytes = m_process->readAllStandardOutput();
    for (const char byte : bytes)
        take(byte);
    if (isReady())
        wakeSoon();
}

void ExternalProgram::take(char byte)
{
    if (byte == '\n' || byte == '\r') {
        if (!m_partial.empty()) // empty lines, and the LF behind a CR, say nothing
            endLine();
        return;
    }
    m_partial += byte;
    m_partialGrew = true;
    if (m_partial.size() >= longestLine)
        endLine();
}

void ExternalProgram::endLine()
{
    m_pieces.push_back(clean(std::exchange(m_partial, {})));
    m_partialGrew = false;
}

void ExternalProgram::ended(bool crashed, int status)
{
    read();
    if (!m_partial.empty())
        endLine();
    m_exit = {status, crashed};
    m_ended = true;
    wakeSoon();
}

void ExternalProgram::wakeSoon()
{
    if (m_waiting && !m_wake.isActive())
        m_wake.startIn(Duration::zero(), [this] { resume(); });
}

void ExternalProgram::wait(std::coroutine_handle<> handle, Duration timeout)
{
    m_waiting = handle;
    m_timeout.startIn(timeout, [this] { resume(); });
}

void ExternalProgram::resume()
{
    m_timeout.stop();
    m_wake.stop();
    if (const auto handle = std::exchange(m_waiting, {}))
        handle.resume();
}

void ExternalProgram::forget()
{
    m_waiting = {};
    m_timeout.stop();
    m_wake.stop();
}

Result<std::optional<ExternalProgram::Piece>> ExternalProgram::take()
{
    if (!m_pieces.empty()) {
        Piece piece{std::move(m_pieces.front()), true};
        m_pieces.pop_front();
        return piece;
    }
    if (std::exchange(m_partialGrew, false))
        return Piece{clean(m_partial), false};
    if (m_error)
        return fail(*m_error);
    if (m_ended)
        return std::optional<Piece>();
    return fail(Fault::Timeout, say("%1 said nothing for too long", m_name));
}

} // namespace mb
