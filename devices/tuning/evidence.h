// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/trial.h"
#include "model/parameter.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mb {
struct Family;
struct LoopScale;
} // namespace mb

namespace mb::tuning {

/// What can be read out of one trial about why it went as it did: each number by itself, nothing where the samples or the
/// meaning of the gains do not tell. Looks at the first hold. Both outlive it.
class Evidence {
public:
    Evidence(const Family &family, const Trial &trial);

    [[nodiscard]] const Trial &trial() const { return m_trial; }
    /// nullptr: what the gains mean is not known.
    [[nodiscard]] const LoopScale *scale() const;
    /// What was in force of this role; 0 where the loop has none or it is not known.
    [[nodiscard]] double gain(Role role) const;
    /// Its key; empty where the loop has none.
    [[nodiscard]] std::string key(Role role) const;
    /// Steps of the integer that hold it.
    [[nodiscard]] std::optional<double> stepsOf(Role role) const;
    [[nodiscard]] double overshoot() const { return m_trial.metrics.overshoot.value_or(0.0); }

    /// Velocity that full duty would give times what F gives for it.
    [[nodiscard]] std::optional<double> feedForwardTimesGain() const;
    /// Target minus where it ends.
    [[nodiscard]] std::optional<double> countsLeft() const;
    /// Mean duty over the last quarter of the hold; before the edge.
    [[nodiscard]] std::optional<double> dutyAtEnd() const { return meanOf("duty", 0.75 * m_hold, m_hold); }
    [[nodiscard]] std::optional<double> dutyBefore() const;
    /// Duty that D gives for one count between two of its looks.
    [[nodiscard]] std::optional<double> leapOfOneCount() const;
    /// Seconds that the drive's ramp takes to full duty; nothing without one.
    [[nodiscard]] std::optional<double> rampTime() const;
    /// Seconds at 98 % of the duty limit or more, during the hold.
    [[nodiscard]] double timeAtLimit() const;
    /// What was missing to the target when the duty left its limit first, in the unit of the loop's error.
    [[nodiscard]] std::optional<double> errorAfterLimit() const;
    /// Duty that P asks for at the edge.
    [[nodiscard]] std::optional<double> demandOfStep() const;
    /// How much later than the slope of the positions the velocity is half way.
    [[nodiscard]] std::optional<double> velocityDelay() const;
    /// Usual time between two values of velocity that differ, while it changes; nothing when each sample differs.
    [[nodiscard]] std::optional<double> velocityHold() const;

    struct Start {
        double time = 0.0; ///< s since the edge
        double duty = 0.0; ///< then
    };
    /// When the position has gone three counts.
    [[nodiscard]] std::optional<Start> startOfMotion() const;

    struct Swing {
        double counts = 0.0; ///< from end to end
        int turns = 0;       ///< changes of direction of the duty
    };
    /// Of the position over the last half of the hold.
    [[nodiscard]] std::optional<Swing> swingAtEnd() const;

private:
    [[nodiscard]] Trace held(std::string_view channel, double from, double to) const;
    [[nodiscard]] std::optional<double> meanOf(std::string_view channel, double from, double to) const;

    const Family &m_family;
    const Trial &m_trial;
    std::vector<Role> m_roles; ///< of the trial's gains
    double m_hold = 0.0;       ///< s
};

} // namespace mb::tuning
