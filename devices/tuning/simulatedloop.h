// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/gainrules.h"

#include <cmath>
#include <deque>

namespace mb::tuning {

/// What a device's loop is beside its gains. A loop without any of it is a continuous one.
struct LoopShape {
    double period = 0.0005; ///< s, of the loop
    double mostDuty = 1.0;  ///< the output is held within ±
    double window = 0.0;    ///< s, over which it takes its velocity: half of it is in the plant's delay; 0: at once
    double windowCounts
        = 0.0; ///< it takes it over so many counts instead, or as long as it waits for them; `window` is that at speed
    double integralStep = 0.0; ///< duty; the integral grows in whole steps of it
    double integralMost = 0.0; ///< duty, that it is held within ±; 0: nothing holds it
    double outputStep = 0.0;   ///< duty; so does the output
    double leastOutput = 0.0;  ///< duty, of any output while the error is more than `goodEnough`
    double goodEnough = 0.0;   ///< within it the output is 0
    bool isCounted = false;    ///< positions are whole counts
    double clock = 0.0;        ///< s, that it counts in, whole ones, from pass to pass; 0: exactly
    double phase = 0.0;        ///< of a count and of its clock, with which it begins: nobody knows it
    double setPointRate = 0.0; ///< counts/s, with which the set-point goes to its target; 0: at once
    double winding = 0.0;      ///< s, L/R, with which the current follows the output; it is in the plant's delay
};

/// What nobody can foresee of one step taken away: which of its passes a clock of whole milliseconds takes for longer.
[[nodiscard]] inline LoopShape withoutClock(LoopShape shape)
{
    shape.clock = 0.0;
    return shape;
}

/// That of a motor follows the output through its winding.
class LateCurrent {
public:
    LateCurrent(double seconds, double period)
        : m_inPasses(seconds / period)
        , m_behind(seconds > 0.0 ? std::exp(-period / seconds) : 0.0)
    {
    }
    /// Duty that the current makes in the mean of the next pass.
    [[nodiscard]] double follow(double duty)
    {
        const double late = m_followed - duty;
        m_followed = duty + late * m_behind;
        return duty + late * (1.0 - m_behind) * m_inPasses;
    }

private:
    double m_inPasses;
    double m_behind; ///< share of a change that is left after a pass
    double m_followed = 0.0;
};

/// The motor of a model in a device's loop, from rest at a value: seconds of it in microseconds. The integral goes on
/// while the output is at its end: few devices know better.
class SimulatedLoop {
public:
    SimulatedLoop(
        Mode loop, const PlantModel &plant, const ContinuousGains &gains, const LoopShape &shape, double from);

    /// Its set-point was left there by what was before.
    void beginAt(double setPoint) { m_setPoint = setPoint; }
    /// Its motor has become this one.
    void turnInto(const PlantModel &plant);
    /// One pass of the loop, and the motor until the next one. Yields the duty.
    double pass(double target);
    /// Of the shaft: counts/s, counts, or A.
    [[nodiscard]] double value() const { return m_integrates ? m_place : m_speed; }
    /// Of the shaft, counts/s.
    [[nodiscard]] double speed() const { return m_speed; }
    /// As the loop measured it in the last pass.
    [[nodiscard]] double measured() const { return m_measured; }
    /// A, at the duty of the last pass; 0 where the model knows none.
    [[nodiscard]] double current() const { return m_plant.stallCurrent * (m_duty - m_plant.backDuty * m_speed); }

private:
    void lookAtClock();
    [[nodiscard]] bool isWindowed() const { return m_span > 0; }
    [[nodiscard]] double follow(double target);
    [[nodiscard]] double measure();
    [[nodiscard]] double measureByCounts();
    [[nodiscard]] double output(double target, double measured);
    void turn(double duty);
    double advance(double duty, double seconds);

    bool m_integrates;
    PlantModel m_plant;
    ContinuousGains m_gains;
    LoopShape m_shape;
    double m_kept;   ///< of the speed, of one pass to the next
    double m_braked; ///< the same while its current brakes it
    LateCurrent m_current;
    double m_held; ///< duty that does not move it from rest
    double m_speed;
    double m_place;
    double m_measured;
    double m_setPoint;
    double m_time;    ///< s, at the next pass
    double m_elapsed; ///< s, of the last one as it counts them
    double m_duty = 0.0;
    double m_integral = 0.0;
    double m_lastError = 0.0; ///< it begins at rest
    std::size_t m_lag = 0;    ///< passes
    std::size_t m_span = 0;   ///< of the window
    std::deque<double> m_late;
};

} // namespace mb::tuning
