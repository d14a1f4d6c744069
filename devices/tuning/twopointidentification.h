// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/firstmotion.h"
#include "tuning/identification.h"
#include "tuning/loopfit.h"
#include "tuning/motoridentification.h"
#include "tuning/rawstep.h"
#include "tuning/twopointfit.h"

#include <vector>

namespace mb::tuning {

/// For a position loop without a duty command, whose gains may have an unknown scale: steps both ways with three pairs of gains,
/// small enough that the output is never at its end (twopointfit.h), of which a motor with its friction is made (loopfit.h). Where play
/// spoils them, a second round with larger ones.
class TwoPointIdentification final : public MotorIdentification {
public:
    [[nodiscard]] Task<void> identify(AutotuneRun &run) override;

private:
    [[nodiscard]] Task<void> look(AutotuneRun &run);
    [[nodiscard]] Task<void> begin(AutotuneRun &run);
    [[nodiscard]] Result<void> choose(const AutotuneRun &run);
    [[nodiscard]] Task<void> settle(AutotuneRun &run);
    [[nodiscard]] Task<void> step(AutotuneRun &run, RawGains gains, double counts);
    [[nodiscard]] Task<void> tryAll(AutotuneRun &run);
    [[nodiscard]] bool calm();
    [[nodiscard]] double holding() const;
    [[nodiscard]] double mostDrive(const AutotuneRun &run) const;
    [[nodiscard]] Result<void> chooseGentle(const AutotuneRun &run);
    void chooseRate(const AutotuneRun &run);
    [[nodiscard]] LoopLaw lawOf(const AutotuneRun &run, const TwoPointFit &linear) const;
    [[nodiscard]] Task<bool> conclude(AutotuneRun &run);
    [[nodiscard]] bool enlarge(const AutotuneRun &run);
    [[nodiscard]] bool isLinear() const;
    [[nodiscard]] std::vector<Gate> gatesOf(const LoopFit &fit) const;
    [[nodiscard]] MotorFound motorOf(const LoopFit &fit, const LoopLaw &law) const;

    RawGains m_stored;       ///< before the tuning
    RawGains m_first;        ///< the calmest that is tried
    FirstMotion m_moves;     ///< where its gains have an unknown scale
    bool m_known = false;    ///< raw P times counts of full output are known
    double m_full = 0.0;     ///< that, or twice what was tried
    double m_drive = 0.0;    ///< raw P times counts of each step
    double m_rate = 0.0;     ///< counts/s, at which the unit's profile leads to the targets; 0: they are steps
    double m_seconds = 0.8;  ///< of each step
    bool m_isLed = false;    ///< by the unit's own profile, at m_rate
    bool m_swung = false;    ///< the last step was ended because the loop swung itself up
    bool m_calmed = false;   ///< it was begun anew with less D
    bool m_grown = false;    ///< the steps were made larger because friction took much of them
    bool m_enlarged = false; ///< the steps were made larger because play took much of them
    std::vector<LoopRun> m_runs;
    std::vector<LoopRun> m_creeping; ///< slower than the model needs: they tell what friction holds
    std::vector<Trial> m_trials;
};

} // namespace mb::tuning
