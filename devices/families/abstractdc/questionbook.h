// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "families/abstractdc/protocol.h"
#include "wire/canframe.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace mb::abstractdc {

/// One drive asked for one log, as a code of whatever dialect it speaks.
struct Question {
    int offset = 0;
    std::uint32_t base = id::logRequest; ///< of its identifier
    std::uint8_t code = 0;

    friend bool operator==(const Question &, const Question &) = default;
};
/// The question that a data frame with a short identifier is.
[[nodiscard]] std::optional<Question> questionIn(const CanFrame &frame);
/// Only scans ask everybody, and only for the speed, the one code that all dialects share; the same as a question to the drive with
/// offset 0.
[[nodiscard]] bool isToAll(const Question &question);

/// Who may have sent a log: the drive with this offset, if it speaks this dialect, because it was asked this.
struct Explanation {
    Question question;
    int offset = 0;
    const Dialect *dialect = nullptr;
};
/// Of a log with this identifier as the answer to this question; `everybody` was asked, not only the drive with its offset.
[[nodiscard]] std::vector<Explanation> explain(const Question &question, std::uint32_t identifier, bool everybody);

/// The questions on a link that may still be answered, oldest first: an identifier alone does not tell whose a log is
/// (README.md#dialects).
class QuestionBook {
public:
    struct Open {
        Question question;
        Instant until{}; ///< an answer may come until then
    };
    /// Asked at `time`; the same one that was open before is not any more.
    void ask(const Question &question, Instant time, Duration patience);
    void close(const Question &question);
    /// Forgets those that nobody will answer any more.
    void expire(Instant now);
    [[nodiscard]] std::vector<Open> &open() { return m_open; }
    [[nodiscard]] const std::vector<Open> &open() const { return m_open; }
    /// By all that is open.
    [[nodiscard]] std::vector<Explanation> explain(std::uint32_t identifier) const;

private:
    std::vector<Open> m_open;
};

} // namespace mb::abstractdc
