// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"
#include "model/setpoint.h"

#include <array>
#include <map>

namespace mb {

/// Seconds for the whole range of a set-point from one end to the other, as they stand in the list; 0 is a step.
inline constexpr std::array slewTimes{0.0, 0.2, 1.0, 5.0};
inline constexpr int usualSlew = 2;

/// What a person has entered of the set-points of one motor, in units of docs/names.md#units.
struct SetPointEntries {
    struct Range {
        double target = 0.0;
        double limit = 0.0;   ///< either way; 0: the usual
        bool touched = false; ///< by a person
    };
    std::map<Mode, Range> ranges;
    int slew = -1;                ///< place in the list; -1: the usual
    double velocity = 2000.0;     ///< of a profile, counts/s
    double acceleration = 4000.0; ///< counts/s²
    SetPoint options;             ///< ramp, brake, directions and limits of it; nothing else

    /// Nothing was entered for a mode: an untouched range.
    [[nodiscard]] Range range(Mode mode) const;
    /// ± this far.
    [[nodiscard]] double limit(const Family *family, Mode mode) const;
    /// How fast a set-point moves, per second; 0 jumps.
    [[nodiscard]] double slewRate(const Family *family, Mode mode) const;
    /// Positions mean another place now.
    void forgetPositions();
};

/// A set-point of this mode begins where the motor is, so that nothing jumps.
[[nodiscard]] bool startsAtPresent(Mode mode);
/// Where a mode starts: a hand cannot do much harm within it, and it can be raised. Without a family: of most.
[[nodiscard]] double usualLimit(const Family *family, Mode mode);
/// The device makes the way to the set-point by itself, from what the command says.
[[nodiscard]] bool isProfiled(const Family *family, Mode mode);

} // namespace mb
