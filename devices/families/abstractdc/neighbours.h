// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/abstractdc/questionwatch.h"

#include <optional>
#include <vector>

namespace mb::abstractdc {

/// Whether drives with offsets other than 0 answer on a link, whoever asks them: what is sent to offset 0 reaches them, too
/// (README.md#offsets). Offset 0 itself, in any dialect, never counts. Engine thread.
class Neighbours {
public:
    Neighbours(CanLink &link, Clock &clock);

    /// One answered within the last seconds.
    [[nodiscard]] bool areHeard() const;

private:
    struct Asked {
        Question question;
        Instant until{}; ///< an answer may come until then
    };

    void pass(const CanFrame &frame);
    void ask(const Question &question, Instant time);

    CanLink &m_link;
    Clock &m_clock;
    std::vector<Asked> m_asked; ///< stays behind its first answer: all drives answer what offset 0 is asked
    std::optional<Instant> m_heardAt;
    Subscription m_traffic;
};

} // namespace mb::abstractdc
