// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/trial.h"
#include "tuning/identification.h"
#include "tuning/motoridentification.h"

#include <vector>

namespace mb::tuning {

/// Pushes of duty from standstill: of two sizes, both ways; how strong and how long is found out by a few that grow until the
/// motor turns. A position loop without the room for them is left to RelayIdentification.
class PushIdentification final : public MotorIdentification {
public:
    [[nodiscard]] Task<void> identify(AutotuneRun &run) override;

private:
    [[nodiscard]] Task<void> probe(AutotuneRun &run);
    [[nodiscard]] Task<void> feelSpeed(AutotuneRun &run, double allowed);
    [[nodiscard]] Task<void> measureOut(AutotuneRun &run, Trial seen);
    [[nodiscard]] Result<void> checkRoom(const AutotuneRun &run);
    [[nodiscard]] Task<void> push(AutotuneRun &run);
    [[nodiscard]] double weakerDuty() const;
    [[nodiscard]] double leastDuty() const;
    [[nodiscard]] Result<void> conclude(AutotuneRun &run, MotorFound found) const;

    std::vector<Trial> m_pushes;
    double m_duty = 0.0;     ///< of the stronger pushes
    double m_seconds = 0.0;  ///< of each
    double m_probed = 0.0;   ///< duty that moved it
    double m_held = 0.0;     ///< the last that did not; 0: the first one did
    double m_speed = 0.0;    ///< counts/s, that it makes of that
    double m_careful = 1.0;  ///< duty, within which no probe makes more speed than is allowed
    bool m_isNarrow = false; ///< there is no room for pushes that last: RelayIdentification
};

} // namespace mb::tuning
