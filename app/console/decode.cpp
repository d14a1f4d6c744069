// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/framelines.h"
#include "app/console/target.h"
#include "app/console/verb.h"
#include "async/event.h"
#include "wire/bytelog.h"
#include "wire/framelog.h"

#include <QFile>
#include <QFileInfo>
#include <QSocketNotifier>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <variant>

#include <fcntl.h>
#include <unistd.h>

namespace mb::console {
namespace {

constexpr std::size_t chunkSize = 65536;

struct DecodeArguments {
    std::string file;
    std::string dialect;
};

/// Takes text in pieces. What one piece brings is printed only when every line of it is good.
class LogReader {
public:
    LogReader(Console &console, std::string name, std::string dialect)
        : m_console(console)
        , m_name(std::move(name))
        , m_lines(console, std::move(dialect))
    {
    }
    Result<void> take(std::string_view text, bool prints = true)
    {
        m_rest += text;
        std::size_t begin = 0;
        for (auto end = m_rest.find('\n'); end != std::string::npos; end = m_rest.find('\n', begin)) {
            MB_TRY_VOID(parse(std::string_view(m_rest).substr(begin, end - begin)));
            begin = end + 1;
        }
        m_rest.erase(0, begin);
        if (m_rest.size() > FrameLogParser::longestLine)
            return fail(m_parser.tooLong().about(m_name));
        print(prints);
        return {};
    }
    Result<void> finish(bool prints = true)
    {
        const std::string last = std::exchange(m_rest, {});
        MB_TRY_VOID(parse(last, true));
        print(prints);
        if (!prints)
            return {};
        m_lines.finish();
        if (const Message remark = m_parser.remark(); !remark.empty())
            m_console.note(m_name + ": " + remark.english());
        return {};
    }

private:
    /// `isLast`: what follows the last end of a line.
    Result<void> parse(std::string_view text, bool isLast = false)
    {
        if (auto bytes = parseByteLine(text)) {
            m_parsed.emplace_back(std::move(*bytes));
            text = {}; // counted, and nothing to see for the other
            if (isLast)
                m_parser.leaveOpen();
        }
        auto frame = isLast ? m_parser.parseLast(text) : m_parser.parse(text);
        if (!frame)
            return fail(frame.error().about(m_name));
        if (*frame)
            m_parsed.emplace_back(std::move(**frame));
        return {};
    }
    void print(bool prints)
    {
        for (const auto &line : m_parsed) {
            if (!prints)
                break;
            if (const auto *frame = std::get_if<LoggedFrame>(&line))
                m_lines.print(frame->time, frame->link, frame->frame);
            else if (const auto *bytes = std::get_if<LoggedBytes>(&line))
                m_lines.print(bytes->time, bytes->link, directionOf(*bytes), bytes->bytes);
        }
        m_parsed.clear();
    }
    static Direction directionOf(const LoggedBytes &line)
    {
        return line.direction == LogDirection::Sent ? Direction::Sent : Direction::Received;
    }

    Console &m_console;
    std::string m_name;
    std::string m_rest;
    FrameLogParser m_parser;
    std::vector<std::variant<LoggedFrame, LoggedBytes>> m_parsed;
    FrameLines m_lines;
};

Task<void> readAll(Console &console, QFile &file, LogReader reader, bool prints)
{
    file.seek(0);
    while (!file.atEnd()) {
        const QByteArray chunk = file.read(static_cast<qint64>(chunkSize));
        if (chunk.isEmpty())
            co_return fail(Fault::OutOfRange,
                say("%1 cannot be read: %2", file.fileName().toStdString(), file.errorString().toStdString()));
        if (auto taken
            = reader.take(std::string_view(chunk.constData(), static_cast<std::size_t>(chunk.size())), prints);
            !taken)
            co_return fail(taken.error());
        co_await console.out().room();
    }
    co_await reader.finish(prints);
    co_return {};
}

/// A file is read twice, so that a bad line at its end leaves standard output empty.
Task<int> decodeFile(Console &console, QFile &file, std::string dialect)
{
    const std::string name = file.fileName().toStdString();
    for (const bool prints : {false, true})
        co_await readAll(console, file, LogReader(console, name, dialect), prints);
    co_return exitDone;
}

/// Standard input, or a pipe that was named, as it comes: there is no beginning to go back to.
class InputReader {
public:
    InputReader(Console &console, std::string name, int descriptor, const std::string &dialect)
        : m_out(console.out())
        , m_name(std::move(name))
        , m_reader(console, m_name, dialect)
        , m_descriptor(descriptor)
        , m_notifier(descriptor, QSocketNotifier::Read)
        , m_taken(m_out.done().add([this] { m_notifier.setEnabled(!done.isSet()); }))
    {
        QObject::connect(&m_notifier, &QSocketNotifier::activated, &m_notifier, [this] { read(); });
    }

    Event done;
    Result<void> result;

private:
    void read()
    {
        std::array<char, chunkSize> buffer{};
        const auto got = ::read(m_descriptor, buffer.data(), buffer.size());
        if (got < 0 && (errno == EINTR || errno == EAGAIN))
            return;
        if (got < 0)
            result = fail(Fault::OutOfRange,
                say("%1 cannot be read: %2", m_name, // main.cpp puts a folder where a closed stream was
                    errno == EISDIR ? "it is closed, or a folder" : std::strerror(errno)),
                say("name a file, or let another program write into it"));
        else if (got == 0)
            result = m_reader.finish();
        else
            result = m_reader.take(std::string_view(buffer.data(), static_cast<std::size_t>(got)));
        const bool goesOn = got > 0 && result;
        m_notifier.setEnabled(goesOn && m_out.hasRoom());
        if (!goesOn)
            done.set();
    }

    Output &m_out;
    std::string m_name;
    LogReader m_reader;
    int m_descriptor;
    QSocketNotifier m_notifier;
    Subscription m_taken;
};

Task<int> decodeStream(Console &console, std::string name, int descriptor, std::string dialect)
{
    const auto input = std::make_unique<InputReader>(console, std::move(name), descriptor, dialect);
    co_await input->done.wait();
    if (!input->result)
        co_return fail(input->result.error());
    co_return exitDone;
}

Result<void> openForReading(QFile &file)
{
    const std::string name = file.fileName().toStdString();
    if (QFileInfo(file).isDir())
        return fail(Fault::OutOfRange, say("%1 is a directory", name), say("name a file"));
    std::error_code unknown;
    if (std::filesystem::is_fifo(name, unknown)) { // to open it waits for who writes, and no signal would end that
        const int pipe = ::open(name.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
        if (pipe < 0 || !file.open(pipe, QIODevice::ReadOnly | QIODevice::Unbuffered, QFileDevice::AutoCloseHandle))
            return fail(Fault::OutOfRange, say("%1 cannot be read: %2", name, std::strerror(errno)));
        return {};
    }
    if (!file.open(QIODevice::ReadOnly | QIODevice::Unbuffered))
        return fail(Fault::OutOfRange, say("%1 cannot be read: %2", name, file.errorString().toStdString()));
    return {};
}

Task<int> decode(Console &console, DecodeArguments arguments)
{
    co_await checkDialect(console, arguments.dialect);
    if (arguments.file.empty() || arguments.file == "-") {
        co_return co_await decodeStream(console, "standard input", STDIN_FILENO, arguments.dialect);
    }
    QFile file(qt(arguments.file));
    co_await openForReading(file);
    if (file.isSequential()) {
        co_return co_await decodeStream(console, arguments.file, file.handle(), arguments.dialect);
    }
    co_return co_await decodeFile(console, file, arguments.dialect);
}

} // namespace

Job declareDecode(CLI::App &arguments)
{
    const auto a = std::make_shared<DecodeArguments>();
    arguments.add_option(
        "file", a->file, "Text of candump -L, of monitor, or a Vector ASC log; standard input otherwise");
    arguments.add_option("--dialect", a->dialect, dialectHelp());
    return [a](Console &console) { return decode(console, *a); };
}

} // namespace mb::console
