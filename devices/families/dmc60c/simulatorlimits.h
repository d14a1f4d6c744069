// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/dmc60c/simulatorparameters.h"
#include "families/dmc60c/simulatorrig.h"
#include "families/dmc60c/simulatorstatus.h"
#include "families/dmc60c/simulatorword.h"

namespace mb::dmc60c::simulation {

/// The two limit switches and the soft limits.
struct Limits {
    LimitPin forward;
    LimitPin reverse;

    void read(const Rig &rig, const ParameterBank &bank, const ControlWord &word, std::int32_t position);
    /// A duty of this sign is not allowed.
    [[nodiscard]] bool block(std::int32_t duty, bool overridden) const;
};

} // namespace mb::dmc60c::simulation
