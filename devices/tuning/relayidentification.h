// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/task.h"
#include "tuning/gainrules.h"
#include "tuning/identification.h"

#include <vector>

namespace mb::tuning {

class AutotuneRun;

/// For a position loop whose motor may not turn far enough for pushes that last: short ones, each ended by the room that there is, tell
/// gain, friction and delay, and a duty that changes its sign with the position makes it swing about its place. How far and how quickly
/// it swings gives τ (relaycycle.h): of a hundredth of the way that a push needs.
class RelayIdentification {
public:
    /// `duty`: what moved it. Until AutotuneRun::take() has what they tell, or the run is over. Refused, OutOfRange with the reason
    /// where they do not tell it.
    [[nodiscard]] Task<void> identify(AutotuneRun &run, double duty);

private:
    [[nodiscard]] Task<void> push(AutotuneRun &run, double duty);
    [[nodiscard]] Task<void> swing(AutotuneRun &run);
    [[nodiscard]] Result<void> readPushes();
    [[nodiscard]] Result<void> conclude(AutotuneRun &run, const Trial &swung) const;

    std::vector<Trial> m_pushes;
    MotorFound m_found;
    PlantModel m_plant;   ///< τ of the short pushes
    double m_doubt = 0.0; ///< of its gain, a share
    double m_duty = 0.0;  ///< of the relay
};

} // namespace mb::tuning
