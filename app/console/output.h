// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/outlet.h"
#include "async/clock.h"
#include "async/listeners.h"
#include "async/noncopyable.h"
#include "async/task.h"

#include <QJsonObject>
#include <QSocketNotifier>

#include <string>
#include <string_view>

namespace mb::console {

/// Standard output, gathered for at most 10 ms so that a full bus does not cost one system call a frame. It never waits for
/// its reader: what he has not taken is kept here, up to a limit. A reader that went away (`… | head`) is no error: what
/// follows is dropped, and broken() says so once. One that reads nothing any more is, at the limit.
class Output : NonCopyable {
public:
    static constexpr std::size_t mostWaiting = 32 * 1024 * 1024; ///< bytes

    explicit Output(Clock &clock);
    ~Output() { flush(); }

    /// One line; the end is added.
    void line(std::string_view text);
    /// One object on one line.
    void json(const QJsonObject &object);
    /// Writes what the reader takes now.
    void flush();

    /// Everything was written, or never will be.
    [[nodiscard]] bool isDone() const { return m_buffer.empty() || m_isBroken; }
    [[nodiscard]] Listeners<> &done() { return m_done; }
    /// What waits is little. A source that can wait as well, a file, is read on only then.
    [[nodiscard]] bool hasRoom() const;
    /// Lets everybody else have a turn, signals too, and then waits for room.
    [[nodiscard]] Task<void> room();
    /// Drops what waits, and says that it was lost.
    void abandon();

    [[nodiscard]] Listeners<> &broken() { return m_broken; }
    [[nodiscard]] bool isBroken() const { return m_isBroken; }
    /// Why the last write failed, empty when it did not, or when the reader has gone.
    [[nodiscard]] const Error &error() const { return m_error; }

private:
    void append(std::string_view text);
    void failed(Error error);

    Clock &m_clock;
    Outlet m_outlet;
    Timer m_timer;
    Timer m_posted;
    QSocketNotifier m_writable;
    std::string m_buffer;
    Error m_error{Fault::Refused, {}};
    bool m_isBroken = false;
    Listeners<> m_done;
    Listeners<> m_broken;
};

/// For a cell or a name within a line: whoever wrote it, it moves no cursor and ends no line.
[[nodiscard]] std::string onOneLine(std::string_view text);
/// One line on standard error. What its reader does not take is dropped.
void complain(std::string_view text);
/// The same, and waits for the reader for at most a second: the last words of a program.
void complainAtLast(std::string_view text);
/// That, without the name of the program in front.
void complainPlain(std::string_view text);

} // namespace mb::console
