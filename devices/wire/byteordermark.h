// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace mb {

/// A text without the mark of UTF-8 that spreadsheets and editors put before its first line.
[[nodiscard]] constexpr std::string_view withoutByteOrderMark(std::string_view text)
{
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

} // namespace mb
