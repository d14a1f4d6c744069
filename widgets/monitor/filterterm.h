// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/monitor/framefacts.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace mb {

/// One question to a record, such as id:100..1FF or field.trgt>0.5.
struct FilterTerm {
    enum class Test { Id, Family, Message, Device, Sent, Data, Extended, Remote, Error, Unknown, Control, Field, Word };
    enum class Comparison { Exists, Less, AtMost, More, AtLeast, Equal, Differs };
    struct Range {
        std::uint32_t low = 0;
        std::uint32_t high = 0;
    };

    Test test = Test::Word;
    std::vector<std::string> patterns; ///< lower case, one of them must match
    std::vector<Range> ranges;         ///< of numbers
    Comparison comparison = Comparison::Exists;
    double number = 0.0;
    bool percent = false; ///< of the full scale of the field
};
[[nodiscard]] bool holds(const FilterTerm &term, const FrameFacts &facts);

/// Terms and what joins them. Without nodes everything passes.
struct FilterTree {
    enum class Join { Term, Not, And, Or };
    struct Node {
        Join join = Join::Term;
        std::size_t left = 0; ///< places of nodes
        std::size_t right = 0;
        FilterTerm term;
    };
    std::vector<Node> nodes;
    std::size_t root = 0;
};

/// Whether all of `text` matches `pattern`, which is in lower case and may hold `*` and `?`.
[[nodiscard]] bool wildcardMatches(std::string_view pattern, std::string_view text);

} // namespace mb
