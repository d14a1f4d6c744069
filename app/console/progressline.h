// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/console.h"
#include "async/noncopyable.h"
#include "async/progress.h"

namespace mb::console {

/// Progress on standard error: a bar that is redrawn on a terminal, otherwise a line a second at most. Nothing with
/// --quiet.
class ProgressLine final : public Progress, private NonCopyable {
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

} // namespace mb::console
