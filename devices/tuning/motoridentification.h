// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/task.h"
#include "model/setpoint.h"

#include <memory>

namespace mb {
struct Family;
} // namespace mb

namespace mb::tuning {

class AutotuneRun;

/// A way to find out what a motor does, as one of its loops sees it: one class a way. Lives as long as the tuning.
class MotorIdentification {
public:
    MotorIdentification() = default;
    MotorIdentification(const MotorIdentification &) = delete;
    MotorIdentification &operator=(const MotorIdentification &) = delete;
    virtual ~MotorIdentification() = default;

    /// Experiments until AutotuneRun::take() has what they tell. Also ends, without that, when the run is over. Refused,
    /// OutOfRange with the reason where they do not tell it.
    [[nodiscard]] virtual Task<void> identify(AutotuneRun &run) = 0;
};

/// The way that fits a loop of a family: pushes of duty; steps with gains tried against each other where it has no duty command;
/// short pushes that tell its resistance for a current loop.
/// nullptr where there is none.
[[nodiscard]] std::unique_ptr<MotorIdentification> identificationOf(const Family &family, Mode loop);

} // namespace mb::tuning
