// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"

#include <QString>

#include <optional>
#include <vector>

namespace mb {

/// The parameters of one loop in the order of the panel: gains first, then what bounds them.
struct GainSet {
    std::vector<ParameterIndex> gains;
    std::vector<ParameterIndex> bounds;
};

/// The rows that act in `mode` with gain slot `slot`: those of the family's loop (TrialTraits::loops); with the limits of the
/// axis where it has several (0: it has not).
[[nodiscard]] GainSet gainSet(const Family &family, Mode mode, int slot, int axis = 0);
/// P, I, D, F: as short as it stands at a row of its own. Of what bounds a gain, the label of the table.
[[nodiscard]] QString shortName(const Parameter &parameter);
/// Its value beside that: whole where its integer is what it says, else as in its field (valuetext.h).
[[nodiscard]] QString shortNumber(const Parameter &parameter, double value);
/// Whether the device closes a loop in this mode.
[[nodiscard]] bool isClosedLoop(Mode mode);

/// "throttle per count/100 ms": the unit of a gain in this mode, for people; the table's where nothing better is known.
[[nodiscard]] QString gainUnit(const Family &family, const Parameter &parameter, Mode mode);
/// A gain in units of the physical loop (docs/names.md#integer-gains).
struct SiGain {
    double value = 0.0;
    QString unit;

    /// "2.49e−3 duty/(rad/s)"
    [[nodiscard]] QString text() const;
};
/// Nothing where the family's scale or the divisor is not known.
/// `divisor`: of the loop; 1 where there is none or it is not known.
[[nodiscard]] std::optional<SiGain> siGain(const Family &family, const Parameter &parameter, Mode mode, double number,
    double countsPerRevolution, double divisor = 1.0);
/// The same of one whose number is not that of a device, but duty per count, counts/s or A, and seconds.
[[nodiscard]] SiGain siGain(Role gain, Mode mode, double number, double countsPerRevolution);

} // namespace mb
