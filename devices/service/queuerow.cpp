// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/queuerow.h"

namespace mb::service {

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
