// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/motoridentification.h"
#include "tuning/twopointruns.h"
#include "tuning/twopointsteps.h"

#include <vector>

namespace mb::tuning {

/// For a position loop without a duty command, whose gains may have an unknown scale: steps both ways with three pairs of gains,
/// small enough that the output is never at its end (twopointsteps.h, twopointfit.h), of which a motor with its friction is made (loopfit.h). Where play
/// spoils them, a second round with larger ones.
class TwoPointIdentification final : public MotorIdentification {
public:
    [[nodiscard]] Task<void> identify(AutotuneRun &run) override;

private:
    [[nodiscard]] Task<void> look(AutotuneRun &run);
    [[nodiscard]] Task<void> begin(AutotuneRun &run);
    [[nodiscard]] Task<void> settle(AutotuneRun &run);
    [[nodiscard]] Task<void> step(AutotuneRun &run, RawGains gains, double counts);
    [[nodiscard]] Task<void> tryAll(AutotuneRun &run);
    [[nodiscard]] bool calm();
    [[nodiscard]] LoopLaw lawOf(const AutotuneRun &run, const TwoPointFit &linear) const;
    [[nodiscard]] Task<bool> conclude(AutotuneRun &run);
    [[nodiscard]] bool enlarge(const AutotuneRun &run);
    [[nodiscard]] MotorFound motorOf(const LoopFit &fit, const LoopLaw &law) const;

    StepGround m_ground;
    TwoPointSteps m_steps;
    TwoPointRuns m_seen;
    double m_seconds = 0.8; ///< of each step
    bool m_swung = false;   ///< the last step was ended because the loop swung itself up
    bool m_calmed = false;  ///< it was begun anew with less D
    std::vector<Trial> m_trials;
};

} // namespace mb::tuning
