// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"

#include <span>

namespace mb::quadquad2drv {

/// Family::experiments: which reading of the inputs is right (README.md#inputs), and the scale of the gains (README.md#gain-scale).
[[nodiscard]] std::span<const Experiment> experiments();

/// Sets calibration::inputReading from the status bit. The user says which level the pin has. Nothing moves, the counter is
/// not touched, and the input is set up afterwards as it was.
[[nodiscard]] Task<ExperimentReport> findInputReading(
    Device &device, SetPointStream &stream, ExperimentOptions options, Progress &progress);

/// Sets the scales of calibrations.h. The shaft turns to and fro, freely, some turns each way, for one to two minutes and never
/// with more than `options.power`.
[[nodiscard]] Task<ExperimentReport> findGainScales(
    Device &device, SetPointStream &stream, ExperimentOptions options, Progress &progress);

} // namespace mb::quadquad2drv
