// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/task.h"
#include "tuning/identification.h"

namespace mb::tuning {

class AutotuneRun;

/// The stage of an identification that tells breakaway from the friction of a motor that turns: a duty that grows slowly, each way once.
/// An identification by itself (TunePlan::propose) always has it, a whole tuning where the friction of its pushes is in doubt.
class FrictionRamp {
public:
    /// `strongest`: duty of the pushes. `held`: the largest duty that did not move the motor; 0: each did.
    FrictionRamp(double strongest, double held)
        : m_strongest(strongest)
        , m_held(held)
    {
    }

    /// Adds to `found` what the ramps tell; nothing where they are not wanted, there is no room or time for them, or they tell nothing.
    [[nodiscard]] Task<void> run(AutotuneRun &run, MotorFound &found);

private:
    [[nodiscard]] bool isWanted(const AutotuneRun &run, const MotorFound &found) const;
    [[nodiscard]] bool hasRoom(const AutotuneRun &run, const MotorFound &found) const;

    double m_strongest;
    double m_held;
    double m_top = 0.0; ///< duty
};

/// Keeps what was read; friction is the ramps' from then on where they are to be believed.
void takeRamp(MotorFound &found, const RampFound &ramp);

/// What the ramps have told: "ramp", a warning where its friction is not to be believed. Refuses nothing. Nothing without ramps.
[[nodiscard]] std::optional<Gate> rampGate(const MotorFound &found);

} // namespace mb::tuning
