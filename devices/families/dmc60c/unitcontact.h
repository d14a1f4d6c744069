// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/dmc60c/parameterexchange.h"

#include <functional>

namespace mb::dmc60c {

/// How the parts of a controller reach its unit. Link and clock outlive them.
struct UnitContact {
    CanLink &link;
    Clock &clock;
    std::function<ParameterExchange::Target()> target; ///< number and session as they are known now
    std::function<void()> unanswered; ///< a question had no answer, which is what a wrong session looks like
};

} // namespace mb::dmc60c
