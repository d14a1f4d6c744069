// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/queuerow.h"

#include <array>

namespace mb::service {

std::string_view toString(RowState state)
{
    constexpr std::array<std::string_view, 6> words{"waiting", "running", "skipped", "passed", "failed", "refused"};
    return words[static_cast<std::size_t>(state)];
}

RowState stateOf(Outcome outcome)
{
    switch (outcome) {
    case Outcome::Passed: return RowState::Passed;
    case Outcome::Failed: return RowState::Failed;
    case Outcome::Refused: return RowState::Refused;
    case Outcome::Open: break;
    }
    return RowState::Waiting;
}

} // namespace mb::service
