// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/direction.h"
#include "experiment/experimentplan.h"
#include "model/setpointstream.h"

namespace mb::tuning {

/// OutOfRange for what no device of the family could do: a mode without a loop, edges too fine, a parameter that is no part of
/// an experiment. Needs no device.
[[nodiscard]] Result<void> checkPlan(const Family &family, const ExperimentPlan &plan);

/// One guarded experiment: checks the envelope from where the motor stands, writes the gains given, checks the direction
/// before the first closed loop of a run, goes to X, follows the stimulus, returns to X, stops, puts back what it changed.
/// Whatever ends it, the motor was told to stop at once; the trial says why, and whether it was seen stopped.
///
/// The stream is of the same device, idle, and its lease (1 s) is the caller's to renew while the task runs. Fails, and nothing
/// has moved, with OutOfRange (the remedy in the text), Unsafe, Refused, Unsupported, Timeout, LinkLost, or NotKept (the notebook). Deterministic
/// for a simulated device on a virtual clock.
[[nodiscard]] Task<Trial> runExperiment(
    Device &device, SetPointStream &stream, ExperimentPlan plan, ExperimentSurroundings surroundings);

} // namespace mb::tuning
