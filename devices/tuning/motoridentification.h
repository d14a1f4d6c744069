// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "async/task.h"

namespace mb::tuning {

class AutotuneRun;

/// A way to find out what a motor does, as one of its loops sees it: one class a way. Lives as long as the tuning.
class MotorIdentification : NonCopyable {
public:
    virtual ~MotorIdentification() = default;

    /// Experiments until AutotuneRun::take() has what they tell. Also ends, without that, when the run is over. Refused,
    /// OutOfRange with the reason where they do not tell it.
    [[nodiscard]] virtual Task<void> identify(AutotuneRun &run) = 0;
};

} // namespace mb::tuning
