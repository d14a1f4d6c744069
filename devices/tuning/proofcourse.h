// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/announcement.h"
#include "tuning/proposals.h"

namespace mb::tuning {

/// s of an experiment in one direction with so many such steps, at most.
[[nodiscard]] double proofSeconds(double hold, int repeats);
/// Steps each way of a loop that is not that of a current, where there is time for them.
inline constexpr int usualProofs = 2;

/// What will happen when a set is put to the proof, to be said before it does.
struct ProofCourse {
    int slot = 0;         ///< that it is tried in: the one that the result is not for, where there are two
    int steps = 0;        ///< both ways together
    double seconds = 0.0; ///< of the motor, at most
    Extent extent;        ///< of the steps of one way
    ProofLimits limits;   ///< within which it is kept
};
[[nodiscard]] ProofCourse courseOf(const ProposalBasis &basis, const Proposal &proposal);

} // namespace mb::tuning
