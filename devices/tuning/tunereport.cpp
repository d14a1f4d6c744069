// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/tunereport.h"

#include <algorithm>
#include <array>

namespace mb::tuning {

std::string_view toString(TuneResult result)
{
    static constexpr std::array<std::string_view, 5> names{
        MB_LABEL("kept"), MB_LABEL("proposed"), MB_LABEL("rolled-back"), MB_LABEL("refused"), MB_LABEL("stopped")};
    return names[static_cast<std::size_t>(result)];
}

bool replacesUnknown(const TuneReport &report)
{
    return std::ranges::any_of(report.before, [](const auto &gain) { return !gain.second.has_value(); });
}

bool isPutBack(const TuneReport &report)
{
    return report.notPutBack.empty() && !replacesUnknown(report);
}

} // namespace mb::tuning
