// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/trace.h"

#include <optional>
#include <string_view>

namespace mb::tuning {

/// How a device makes the velocity that its loop feeds back. Half of a loop's dead time is often here, and no datasheet says so.
struct VelocityFilter {
    enum class Kind {
        None,    ///< as fresh as the positions
        Rolling, ///< over a window, anew with each sample
        Block    ///< over a window, and held until the next is full
    };
    Kind kind = Kind::None;
    double window = 0.0; ///< s
    double delay = 0.0;  ///< s, half the window and what the velocity is late beyond it
    double hold = 0.0;   ///< s, median time between changes of it
};
[[nodiscard]] std::string_view toString(VelocityFilter::Kind kind);

/// How a loop takes its velocity, at the speed that it is designed for.
struct VelocityTaking {
    double window = 0.0; ///< s
    double delay = 0.0;  ///< s, half of it and what it is late beyond
    double counts = 0.0; ///< the window is as long as they take; 0: always the same

    friend bool operator==(const VelocityTaking &, const VelocityTaking &) = default;
};

/// Compares what the device calls its velocity with its own positions (docs/tuning-method.md#velocity-filter). Counts and counts/s of
/// the same clock while the speed changes, some seconds of it: a square wave of duty. Nothing where there are too few samples or
/// the speed never changed.
[[nodiscard]] std::optional<VelocityFilter> fingerprint(const Trace &position, const Trace &velocity);

} // namespace mb::tuning
