// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"

#include <span>

namespace mb::quadquad2drv::calibration {

/// Of the device's profile. The two readings decide what the reference leaves open (`Readings`); the scales say how many power
/// units a raw gain of 1 gives: P for an error of 1 count (or count/s), I for that error in one pass of the loop, D for an error
/// that changes by 1 count in one pass.
constexpr std::string_view targetShift = "velocity_target_shift";
constexpr std::string_view inputReading = "input_reading";
constexpr std::string_view positionP = "position.p.scale";
constexpr std::string_view positionI = "position.i.scale";
constexpr std::string_view positionD = "position.d.scale";
constexpr std::string_view velocityP = "velocity.p.scale";
constexpr std::string_view velocityI = "velocity.i.scale";

/// Raw values of the readings; the first of each is the likely and safe one.
constexpr int plainTarget = 0;
constexpr int shiftedTarget = 12;
constexpr int asLibrary = 0;
constexpr int asDataSheet = 1;

[[nodiscard]] std::span<const Calibration> table();

} // namespace mb::quadquad2drv::calibration
