// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

#include <algorithm>
#include <optional>

namespace mb {

/// What the user wants of questions to devices (`--timeout`, `--retries`); without it the family's own, measured times. Of polls, motion and
/// stops nothing of it holds: their times are safety.
struct Patience {
    std::optional<Duration> timeout; ///< for one answer
    int retries = 0;                 ///< more than the family's own, of what may be repeated at all

    /// For an answer that comes at once.
    [[nodiscard]] Duration answer(Duration usual) const { return timeout.value_or(usual); }
    /// For an answer that comes once the device has worked (written, erased, restarted): never less than that takes.
    [[nodiscard]] Duration work(Duration usual) const { return std::max(timeout.value_or(usual), usual); }
    /// What is sent only once stays so: it must not happen twice.
    [[nodiscard]] int tries(int usual) const { return usual > 1 ? usual + retries : usual; }
};

} // namespace mb
