// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace mb {

/// A cause and a remedy, each a label of its own (`QT_TRANSLATE_NOOP("table", …)`).
struct Advice {
    std::string_view cause;
    std::string_view remedy;
};

/// What a piece of an external program's output means for people.
struct ProgramMeaning {
    std::string_view words; ///< lower case
    Fault fault = Fault::BadReply;
    Advice advice;
};

/// ASCII letters only.
[[nodiscard]] inline std::string lowered(std::string_view text)
{
    std::string low(text);
    std::transform(low.begin(), low.end(), low.begin(),
        [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return low;
}

/// The first row of the table whose words are in the output, which is in lower case.
[[nodiscard]] inline std::optional<Error> meaningOf(std::span<const ProgramMeaning> table, std::string_view output)
{
    for (const ProgramMeaning &meaning : table) {
        if (output.find(meaning.words) != std::string_view::npos)
            return Error{meaning.fault, Message::label(meaning.advice.cause), Message::label(meaning.advice.remedy)};
    }
    return std::nullopt;
}

} // namespace mb
