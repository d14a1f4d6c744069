// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/tunereport.h"

namespace mb::tuning {

/// OutOfRange or Unsupported for what cannot be tuned on this family; needs no device.
[[nodiscard]] Result<void> checkTuning(const Family &family, const TunePlan &plan);

/// Whether it writes gains: where there is no duty command or a scale is searched, already to find out what they make.
[[nodiscard]] bool writesGains(const Device &device, const TunePlan &plan);
/// Whether some of them are put back afterwards, and so a journal must hold what was there. Not where nobody knows that and it may stay
/// (TunePlan::keep).
[[nodiscard]] bool owesGains(const Device &device, const TunePlan &plan);

/// From an unknown motor to proven gains, or a refusal that says why (docs/tuning-method.md): a model (motoridentification.h), gains
/// within bounds, their step in both directions, and the gains stay only if they do what was predicted. Where those of an aim do not,
/// the model is corrected by what they did instead, and failing that the calm ones are proven. The gains run in the slot that does
/// not hold the result where there are two. Everything of ExperimentSurroundings holds; the stream's lease is the caller's to renew.
/// Fails only where nothing has moved.
[[nodiscard]] Task<TuneReport> autotune(
    Device &device, SetPointStream &stream, TunePlan plan, ExperimentSurroundings surroundings);

} // namespace mb::tuning
