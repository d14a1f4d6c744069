// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/adviser.h"
#include "tuning/proposals.h"

namespace mb::tuning {

/// What is to be known of one property of a set of gains before it is written.
struct SetAdvice {
    enum class State {
        Fine,
        Fixed,   ///< the gains in force have it, the set has not
        Notable, ///< the set has it, or the device beside it
        Unread   ///< the parameter that tells it is not known
    };
    Cause cause = Cause::FeedForward; ///< FeedForward, Deadband, DerivativeNoise, Resolution or Ramp; Number as there
    State state = State::Fine;
    double number = 0.0;
    double limit = 0.0;                                  ///< of the number; 0: none
    std::string key;                                     ///< the parameter that it is about; empty: none
    Role role = Role::None;                              ///< of that parameter
    std::vector<std::pair<std::string, double>> changes; ///< as Advice::changes

    friend bool operator==(const SetAdvice &, const SetAdvice &) = default;
};

/// Five properties that a trial would show too late, always in the same order; a current loop has no deadband. Of the set as the
/// device stores it, on the model that it stands on. `now`: the loop's parameters as the device has them. Pure.
[[nodiscard]] std::vector<SetAdvice> adviseOnSet(
    const ProposalBasis &basis, const Proposal &proposal, const KnownGains &now);

} // namespace mb::tuning
