// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/simulatedloop.h"

#include <vector>

namespace mb::tuning {

/// A winding in a device's current loop, from a motor at rest: the motor speeds up and takes more and more off the duty, which the
/// integral follows from behind. The loop puts out at once what it makes of what it reads.
class CurrentLoop {
public:
    /// `parts` of a pass, between which value() can be seen.
    CurrentLoop(const PlantModel &plant, const ContinuousGains &gains, const LoopShape &shape, int parts = 1);

    /// Reads, and puts out what is in force until the next pass.
    void look(double target);
    /// One part of a pass.
    void turn();
    [[nodiscard]] double value() const { return m_current; } ///< A

private:
    PlantModel m_plant;
    ContinuousGains m_gains;
    LoopShape m_shape;
    double m_part; ///< s
    double m_kept; ///< of a current, of one part to the next
    double m_current = 0.0;
    double m_speed = 0.0; ///< counts/s
    double m_duty = 0.0;
    double m_integral = 0.0;
};

/// A, at the end of each of `parts` of each pass, of a step of `step` A from the pass on that first knew of it.
[[nodiscard]] std::vector<double> currentResponse(const PlantModel &plant, const ContinuousGains &gains,
    const LoopShape &shape, double step, double seconds, int parts);

/// What a step of a current did.
struct CurrentError {
    double itae = 0.0;      ///< s², integral of time times error over the step
    double overshoot = 0.0; ///< of the step
};
/// Given up as soon as its integral is more than `most`.
[[nodiscard]] CurrentError errorOfCurrent(const PlantModel &plant, const ContinuousGains &gains, const LoopShape &shape,
    double step, double seconds, double most);

} // namespace mb::tuning
