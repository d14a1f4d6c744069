// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "async/noncopyable.h"
#include "async/result.h"

#include <coroutine>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class QProcess;

namespace mb {

/// Somebody else's program that does a part of a job, such as the programmer of a microcontroller. Runs it without a shell and
/// without standard input, and yields what it prints, standard output and standard error merged in the order they come:
///
///     ExternalProgram program(clock);
///     if (auto started = program.start({"openocd", {"--version"}}); !started)
///         co_return fail(started.error());
///     for (;;) {
///         const auto piece = co_await program.next(10s); // Timeout: nothing printed for so long
///         if (!*piece) break;                            // it has ended
///         … (*piece)->text …
///     }
///     const ExternalProgram::Exit exit = program.exit();
///
/// Destroying it ends the program at once (SIGKILL): cancelling the task that owns it cancels the work, so forbid that while
/// a cut is fatal (Progress::mayInterrupt). Keys of a terminal do not reach it, and it outlives this program where that dies. Needs an event loop in the thread that made
/// it; times are those of the clock.
/// Coroutines are resumed from the clock, never from inside a signal of the process.
class ExternalProgram : NonCopyable {
public:
    struct Command {
        std::string program; ///< a name that is looked up in PATH, or a path
        std::vector<std::string> arguments;
    };
    struct Piece {
        std::string text;     ///< without the end of line; bytes that are not UTF-8 are replaced
        bool complete = true; ///< false: a line so far, told again each time it has grown (a bar of # that gets longer)
    };
    struct Exit {
        int status = 0;       ///< as the program gave it
        bool crashed = false; ///< ended by a signal
        [[nodiscard]] bool isSuccess() const { return status == 0 && !crashed; }
    };
    /// A line longer than this is cut into several.
    static constexpr std::size_t longestLine = 4096;

    explicit ExternalProgram(Clock &clock);
    ~ExternalProgram();

    /// Where PATH finds `program`; nothing when it is not installed.
    [[nodiscard]] static std::optional<std::string> locate(const std::string &program);

    /// Once. LinkLost when there is no such program or it cannot be run; that it dies later shows in exit().
    [[nodiscard]] Result<void> start(const Command &command);

    class Next : NonCopyable {
    public:
        Next(ExternalProgram &program, Duration timeout)
            : m_program(program)
            , m_timeout(timeout)
        {
        }
        ~Next() { m_program.forget(); }
        [[nodiscard]] bool await_ready() const { return m_program.isReady(); }
        void await_suspend(std::coroutine_handle<> handle) { m_program.wait(handle, m_timeout); }
        [[nodiscard]] Result<std::optional<Piece>> await_resume() { return m_program.take(); }

    private:
        ExternalProgram &m_program;
        Duration m_timeout;
    };
    /// The next line, ended by LF, CR or the end of the program, or the present one as far as it is; nothing once the program
    /// has ended and all was told; Timeout.
    [[nodiscard]] Next next(Duration timeout) { return Next(*this, timeout); }

    /// Only after next() yielded nothing.
    [[nodiscard]] const Exit &exit() const { return m_exit; }

private:
    void read();
    void take(char byte);
    void endLine();
    void ended(bool crashed, int status);
    void wakeSoon();
    [[nodiscard]] bool isReady() const { return !m_pieces.empty() || m_partialGrew || m_ended; }
    void wait(std::coroutine_handle<> handle, Duration timeout);
    [[nodiscard]] Result<std::optional<Piece>> take();
    void forget();
    void resume();

    std::unique_ptr<QProcess> m_process;
    std::string m_name;
    std::deque<std::string> m_pieces; ///< complete lines
    std::string m_partial;
    bool m_partialGrew = false;
    bool m_ended = false;
    std::optional<Error> m_error;
    Exit m_exit;
    std::coroutine_handle<> m_waiting;
    Timer m_timeout;
    Timer m_wake;
};

} // namespace mb
