// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/device.h"
#include "model/parametertransfer.h"
#include "tuning/gainrules.h"

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace mb::tuning {

/// The parameters of a loop that make these gains on a device, rounded to what it stores.
struct ScaledGains {
    struct Row {
        std::string key;
        std::int64_t raw = 0;
        double number = 0.0;    ///< in the unit of the parameter
        Role role = Role::None; ///< not of one that was kept in a file
    };
    std::vector<Row> rows;
    std::vector<ParameterChange> changes; ///< the same
    ContinuousGains made;                 ///< what they make after rounding: predict with these
};

/// What raw gains of a loop make, found by trying them against each other where its arithmetic tells no duty (twopointfit.h).
struct TriedScale {
    double p = 0.0;         ///< duty for a count, of a raw P of 1
    double d = 0.0;         ///< duty for a count/s, of a raw D of 1
    double cycle = 0.0;     ///< s between two passes of the loop
    double strongest = 0.0; ///< raw D that one count may meet
    double quickest = 0.0;  ///< s, 1/omega of a loop that what was tried vouches for
    double i = 0.0;         ///< duty for a count·s, of a raw I of 1; 0: not known
    double rate = 0.0;      ///< counts/s, with which set-points go to their targets while it is tuned; 0: at once

    friend bool operator==(const TriedScale &, const TriedScale &) = default;
};

/// OutOfRange where the scale of this loop is not known or not calibrated, a gain does not fit, or one has fewer than 10 steps.
/// `tried` takes the place of what the family tells; such a loop has no I.
[[nodiscard]] Result<ScaledGains> scaleGains(const Device &device, Mode loop, int axis, int slot,
    const ContinuousGains &gains, const std::optional<TriedScale> &tried = {});

/// The same by what is known of a device: for those that have none.
[[nodiscard]] Result<ScaledGains> scaleGains(const Family &family, const DeviceProfile &profile, Mode loop, int axis,
    int slot, const ContinuousGains &gains, const std::optional<TriedScale> &tried = {});

/// Numbers of parameters by key, in their units; nothing for what is not known.
using KnownGains = std::vector<std::pair<std::string, std::optional<double>>>;

/// The loop's parameters as they are known of a device, by key, in their units.
[[nodiscard]] KnownGains knownGains(
    const Family &family, Mode loop, int axis, int slot, std::span<const ParameterStore::Entry> entries);
/// The same parameters with the same values.
[[nodiscard]] bool isSameSet(const ScaledGains &a, const ScaledGains &b);

/// scaleGains() read backwards: what these numbers make on a device. Nothing where one of a gain's is not known, or has no scale and is
/// not 0.
[[nodiscard]] std::optional<ScaledGains> gainsMadeBy(const Family &family, const DeviceProfile &profile, Mode loop,
    int axis, int slot, const KnownGains &numbers, const std::optional<TriedScale> &tried = {});

/// OutOfRange, with what finds them out, where a gain of this loop has a scale that must be calibrated and was not.
[[nodiscard]] Result<void> checkScales(const Device &device, Mode loop);
[[nodiscard]] Result<void> checkScales(const Family &family, const DeviceProfile &profile, Mode loop);

/// Units of the loop's own arithmetic for 1 count/s, count or A; nothing where the family's scale is not known.
[[nodiscard]] std::optional<double> loopUnits(const Family &family, Mode loop);

} // namespace mb::tuning
