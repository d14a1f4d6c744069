// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/question.h"

#include "async/event.h"

#include <QObject>
#include <QSocketNotifier>

#include <array>
#include <iostream>

#include <termios.h>
#include <unistd.h>

namespace mb::console {
namespace {

/// A terminal hands over whole lines.
std::string line()
{
    std::array<char, 64> bytes{};
    const ssize_t count = ::read(STDIN_FILENO, bytes.data(), bytes.size());
    std::string text(bytes.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
    return text.substr(0, text.find('\n'));
}

} // namespace

Task<bool> ask(Console &console, std::string question)
{
    ::tcflush(STDIN_FILENO, TCIFLUSH); // what was typed before it was asked is no answer
    std::cerr << question << " [y/N] " << std::flush;
    Event over;
    Timer posted(console.clock()); // nobody is ended from inside its own signal
    const auto end = [&posted, &over] { posted.startIn(Duration::zero(), [&over] { over.set(); }); };
    QSocketNotifier typed(STDIN_FILENO, QSocketNotifier::Read);
    QObject::connect(&typed, &QSocketNotifier::activated, &typed, [&typed, &end] {
        typed.setEnabled(false);
        end();
    });
    const Subscription signal = console.interrupted().add(end);
    if (console.isInterrupted())
        end();
    co_await over.wait();
    if (console.isInterrupted()) {
        std::cerr << '\n';
        co_return fail(Fault::Cancelled, say("interrupted before it was done"));
    }
    const std::string answer = line();
    co_return answer == "y" || answer == "Y" || answer == "yes";
}

Task<bool> isAgreedTo(Console &console, std::string question)
{
    if (::isatty(STDIN_FILENO) != 1 || ::isatty(STDERR_FILENO) != 1)
        co_return false;
    co_return co_await ask(console, std::move(question));
}

} // namespace mb::console
