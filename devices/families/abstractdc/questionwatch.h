// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/abstractdc/protocol.h"
#include "transport/canlink.h"

#include <vector>

namespace mb::abstractdc {

/// Whether a log may answer a question that somebody else asked: pollers, this program's own above all, are answered on identifiers
/// where another dialect would answer a probe (6.3, the table), and such an answer proves nothing.
class QuestionWatch {
public:
    QuestionWatch(CanLink &link, Clock &clock);

    /// The probe's own question. Whoever asks the same gets an answer that proves the same.
    void attend(int offset, std::uint8_t code);
    /// The log that is passing now may be somebody's answer to another question; for listeners of `received`.
    [[nodiscard]] bool isForOthers() const { return m_isForOthers; }

private:
    struct Question {
        int offset = 0;
        std::uint8_t code = 0;
        Instant until{}; ///< an answer may come until then
    };

    void pass(const CanFrame &frame);

    CanLink &m_link;
    Clock &m_clock;
    Question m_attended{-1, 0, {}};
    std::vector<Question> m_open; ///< oldest first
    bool m_isForOthers = false;
    Subscription m_traffic;
};

} // namespace mb::abstractdc
