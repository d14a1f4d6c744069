// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/supermodified/motioncount.h"
#include "families/supermodified/node.h"
#include "model/setpoint.h"

#include <optional>

namespace mb::supermodified {

/// What the firmware of one node can carry out without harm, by what is known of the node; what would have to be known and is
/// not is refused. Judges only. Node and entry outlive it.
class MoveBounds {
public:
    MoveBounds(const Node &node, const Roster::Entry &known)
        : m_node(node)
        , m_known(known)
    {
    }

    /// OutOfRange for a velocity or acceleration of the profile that the firmware cannot do, also the velocity that it has; Unsafe for a profiled move whose
    /// profile is not known, because it could not be told whether it passes its target (README.md#passed-target).
    [[nodiscard]] Result<void> checkProfile(const SetPoint &setPoint) const;
    /// The loop of D1 and D2 multiplies the error by P in 32 bits (README.md#overflow): an un-profiled move is one step of it, and with
    /// every other the set-point may run ahead of a motor that does not follow. OutOfRange, or Unsafe when P or the step is not known.
    [[nodiscard]] Result<void> checkReach(const SetPoint &setPoint, std::optional<MotionCount::Step> step) const;
    /// The same of a P that is written while the motor is driven by this order.
    [[nodiscard]] Result<void> checkGain(
        std::int64_t p, const SetPoint &applied, std::optional<MotionCount::Step> error) const;
    /// Settings that it changes for good, targets that it may pass; empty most of the time.
    [[nodiscard]] Message caution(const SetPoint &setPoint) const;
    /// Ticks behind its target from which a profiled move over this distance has gone wrong; nothing where none does.
    [[nodiscard]] std::optional<double> overrun(const SetPoint &setPoint, double distance) const;

private:
    /// D1 and D2.
    [[nodiscard]] bool isNarrow() const { return m_node.dialect && m_node.dialect != Dialect::D3; }
    [[nodiscard]] std::optional<double> velocity(const SetPoint &setPoint) const;
    [[nodiscard]] std::optional<double> acceleration(const SetPoint &setPoint) const;
    [[nodiscard]] std::optional<double> farthest(const SetPoint &setPoint, std::optional<MotionCount::Step> step) const;

    const Node &m_node;
    const Roster::Entry &m_known;
};

/// OutOfRange with the legal range.
[[nodiscard]] Result<void> checkNumber(
    const MessageArgument &name, double value, double low, double high, std::string_view unit);

} // namespace mb::supermodified
