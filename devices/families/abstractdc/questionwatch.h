// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/abstractdc/questionbook.h"
#include "transport/canlink.h"

#include <array>
#include <optional>
#include <vector>

namespace mb::abstractdc {

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

    /// Drives with offsets other than 0 have answered within the last seconds, whoever asked them: what is sent to offset 0 reaches
    /// them, too (README.md#offsets).
    [[nodiscard]] bool hearsOthers() const;
    /// Some drive was heard to speak it.
    [[nodiscard]] bool hears(const Dialect &dialect) const;
    /// Somebody has asked this and may still be answered.
    [[nodiscard]] bool isOpen(const Question &question) const;
    /// Nobody else waits for an answer on this identifier.
    [[nodiscard]] bool isFree(const Question &question, std::uint32_t answer) const;

private:
    void pass(const CanFrame &frame);
    void holdBack(const CanFrame &order);
    void settle();
    [[nodiscard]] bool isOfAnother(std::uint32_t identifier) const;

    CanLink &m_link;
    Clock &m_clock;
    QuestionBook m_book;
    QuestionBook m_toAll;                 ///< those to offset 0, which no first answer closes: all drives answer them
    std::vector<Explanation> m_explained; ///< of the log that is passing
    std::array<const Dialect *, maxOffset + 1> m_heard{};
    std::optional<Instant> m_othersAt;
    Subscription m_traffic;
};

} // namespace mb::abstractdc
