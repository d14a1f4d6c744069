// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/console.h"
#include "async/noncopyable.h"
#include "async/progress.h"

namespace mb::console {

/// Progress on standard error: a bar that is redrawn on a terminal, otherwise a line a second at most. Nothing with
/// --quiet.
class ProgressLine : public Progress, private NonCopyable {
public:
    explicit ProgressLine(Console &console);
    ~ProgressLine() override { erase(); }

    void step(const Message &what, int done, int total) override;
    void part(int, PartState) override { }
    void log(Severity severity, const Message &text) override;

private:
    void draw(const std::string &what, int done, int total);
    void erase();

    Console &m_console;
    bool m_terminal = false;
    bool m_drawn = false;
    Instant m_next{};
    std::string m_last; ///< said already
};

/// Of values that are written one after the other; says how far it came where the program is interrupted between two of them.
class WriteProgress final : public ProgressLine {
public:
    explicit WriteProgress(Console &console);
    ~WriteProgress() override;

    void step(const Message &what, int done, int total) override;

private:
    Console &m_console;
    int m_done = 0;
    int m_total = 0;
};

} // namespace mb::console
