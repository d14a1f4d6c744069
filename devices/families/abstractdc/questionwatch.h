// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/abstractdc/protocol.h"
#include "transport/canlink.h"

#include <array>
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

/// Hears every question on a link, this program's and others', and says which of them the log that is passing may answer: one
/// identifier is the answer of drives with other offsets in other dialects, and one of all drives (README.md#dialects). A
/// question is open for twice the time of an answer, and for what this program sends to other families meanwhile, by the time stamps of the frames: whoever is held up judges no differently.
class QuestionWatch {
public:
    QuestionWatch(CanLink &link, Clock &clock);

    // Of the log that is passing now; for listeners of `received`, and of `traffic` that came later.
    /// It answers this question, and no other that is open whatever dialects the drives speak. The question to everybody does
    /// not count: who answers that answers the same question.
    [[nodiscard]] bool isAnswerTo(const Question &question) const;
    /// All open questions that it may answer have this code, and there is one.
    [[nodiscard]] bool answersOnly(std::uint8_t code) const;
    /// It comes from this drive; with others, in the dialects that they were heard to speak, it cannot be mistaken.
    /// `dialect` nullptr: of a drive that was asked for the speed and by itself.
    [[nodiscard]] bool isOf(int offset, const Dialect *dialect) const;

    /// Somebody has asked this and may still be answered.
    [[nodiscard]] bool isOpen(const Question &question) const;
    /// Nobody else waits for an answer on this identifier.
    [[nodiscard]] bool isFree(const Question &question, std::uint32_t answer) const;

private:
    struct Open {
        Question question;
        Instant until{}; ///< an answer may come until then
    };

    void pass(const CanFrame &frame);
    void holdBack(const CanFrame &order);
    void ask(const Question &question, Instant time);
    void answer(std::uint32_t identifier);
    void learn(const Question &question);

    CanLink &m_link;
    Clock &m_clock;
    std::vector<Open> m_open;          ///< oldest first
    std::uint32_t m_passing = 0;       ///< identifier of the log that is passing
    std::vector<Question> m_explained; ///< the open questions that it may answer
    std::array<const Dialect *, maxOffset + 1> m_heard{};
    Subscription m_traffic;
};

} // namespace mb::abstractdc
