// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/setpoint.h"
#include "tuning/motoridentification.h"

#include <memory>

namespace mb {
struct Family;
} // namespace mb

namespace mb::tuning {

/// The way that fits a loop of a family: pushes of duty; steps with gains tried against each other where it has no duty command;
/// short pushes that tell its resistance for a current loop.
/// nullptr where there is none.
[[nodiscard]] std::unique_ptr<MotorIdentification> identificationOf(const Family &family, Mode loop);

} // namespace mb::tuning
