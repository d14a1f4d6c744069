// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "async/listeners.h"

#include <QJsonObject>

#include <string>
#include <string_view>

namespace mb::console {

/// Standard output, gathered for at most 10 ms so that a full bus does not cost one system call a frame. A reader that
/// went away (`… | head`) is no error: what follows is dropped, and broken() says so once.
class Output {
public:
    explicit Output(Clock &clock);
    Output(const Output &) = delete;
    Output &operator=(const Output &) = delete;
    ~Output() { flush(); }

    /// One line; the end is added.
    void line(std::string_view text);
    /// One object on one line.
    void json(const QJsonObject &object);
    void flush();

    [[nodiscard]] Listeners<> &broken() { return m_broken; }
    [[nodiscard]] bool isBroken() const { return m_isBroken; }
    /// Why the last write failed, empty when it did not, or when the reader has gone.
    [[nodiscard]] const std::string &error() const { return m_error; }

private:
    void failed(int number);

    Timer m_timer;
    std::string m_buffer;
    std::string m_error;
    bool m_isBroken = false;
    Listeners<> m_broken;
};

/// One line on standard error.
void complain(std::string_view text);

} // namespace mb::console
