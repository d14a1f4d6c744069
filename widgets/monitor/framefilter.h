// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/monitor/framedecoder.h"

#include <QString>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mb {

/// A record as a filter looks at it: decoded at most once, and only when a term asks.
class FrameFacts {
public:
    /// `asked`: whom it is from, where it does not tell (FrameFollower).
    FrameFacts(const TrafficRecord &record, const FrameDecoder &decoder, std::optional<int> asked = {})
        : m_record(record)
        , m_decoder(decoder)
        , m_asked(asked)
    {
    }
    [[nodiscard]] const TrafficRecord &record() const { return m_record; }
    /// nullptr when nobody knows it.
    [[nodiscard]] const FrameMeaning *meaning() const;

private:
    const TrafficRecord &m_record;
    const FrameDecoder &m_decoder;
    std::optional<int> m_asked;
    mutable bool m_looked = false;
    mutable std::optional<FrameMeaning> m_meaning;
};

/// Decides which records are shown. The language, for people: help(). Terms stand behind each other and must all hold;
/// `or`, `not` (or a minus) and brackets join them.
///   id:0x2041* id:100..1FF family:dmc60c message:STS* device:5 dir:tx data:A1* is:error field.trgt>0.5 WORD
/// Upper and lower case are one; `*` and `?` stand for any characters; a comma gives alternatives.
class FrameFilter {
public:
    FrameFilter() = default; ///< passes everything
    explicit FrameFilter(const QString &text);

    /// What both pass.
    [[nodiscard]] static FrameFilter both(FrameFilter a, const FrameFilter &b);

    [[nodiscard]] bool passes(const FrameFacts &facts) const;
    [[nodiscard]] bool isEmpty() const { return m_nodes.empty(); }
    /// What is wrong with the text and what would be right; empty when all is well. A filter with a problem passes
    /// everything.
    [[nodiscard]] const QString &problem() const { return m_problem; }
    /// The language on one page, as rich text.
    [[nodiscard]] static QString help();

private:
    friend class FrameFilterParser;

    enum class Test { Id, Family, Message, Device, Sent, Data, Extended, Remote, Error, Unknown, Control, Field, Word };
    enum class Comparison { Exists, Less, AtMost, More, AtLeast, Equal, Differs };
    struct Range {
        std::uint32_t low = 0;
        std::uint32_t high = 0;
    };
    struct Term {
        Test test = Test::Word;
        std::vector<std::string> patterns; ///< lower case, one of them must match
        std::vector<Range> ranges;         ///< of numbers
        Comparison comparison = Comparison::Exists;
        double number = 0.0;
        bool percent = false; ///< of the full scale of the field
    };
    enum class Join { Term, Not, And, Or };
    struct Node {
        Join join = Join::Term;
        std::size_t left = 0;
        std::size_t right = 0;
        Term term;
    };

    [[nodiscard]] bool holds(std::size_t node, const FrameFacts &facts) const;
    [[nodiscard]] static bool holds(const Term &term, const FrameFacts &facts);
    [[nodiscard]] static bool holdsMeaning(const Term &term, const FrameFacts &facts);
    [[nodiscard]] static bool holdsId(const Term &term, const CanFrame &frame);
    [[nodiscard]] static bool holdsData(const Term &term, const TrafficRecord &record);
    [[nodiscard]] static bool holdsField(const Term &term, const DecodedFrame &frame);
    [[nodiscard]] static bool holdsWord(const Term &term, const FrameFacts &facts);

    std::vector<Node> m_nodes;
    std::size_t m_root = 0;
    QString m_problem;
};

/// Whether all of `text` matches `pattern`, which is in lower case and may hold `*` and `?`.
[[nodiscard]] bool wildcardMatches(std::string_view pattern, std::string_view text);

} // namespace mb
