// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "experiment/trace.h"

#include <span>
#include <vector>

namespace mb::tuning {

/// Of a duty that comes in steps: s, and the share of all that moves the motor, that comes with it.
struct DutyStep {
    double at = 0.0;
    double share = 1.0;
};

/// A push with constant duty from standstill, as telemetry saw it.
struct PushRecord {
    Trace position;    ///< counts as received, t = 0 when the duty was applied or ordered, in the mean
    double duty = 0.0; ///< applied, sign included; over the mean bus voltage if that sags: duty × volts / volts at rest
    double growth = 0.0;           ///< s until all of its duty was there
    std::vector<DutyStep> steps{}; ///< in which it came; none: at t = 0
    double heat = 0.0; ///< that the pushes before it and it itself have left in the winding, in squares of their duty
};

/// Full duties, at which the lag of a motor is told.
constexpr double dutyOfLag = 0.3;
/// How many times longer the lag is at this duty than at that: a supply with a resistance of its own adds it to the winding's, the
/// more the longer it is switched on.
[[nodiscard]] constexpr double sagged(double sag, double duty)
{
    return 1.0 + sag * (duty * duty - dutyOfLag * dutyOfLag);
}

/// What pushes have in common: position = A·(t' − τ(1 − e^(−t'/τ))) with t' = t − delay.
struct PushFit {
    double tau = 0.0;   ///< s; of the motor as cold as it was, at dutyOfLag
    double delay = 0.0; ///< s, dead time up to 80 ms; holds the latency of the link where t is the order's
    double tauError = 0.0;
    double delayError = 0.0;    ///< ± two standard errors
    std::vector<double> speeds; ///< A of each record, counts/s; of the motor as cold as it was
    double cost = 0.0;          ///< 1: what is left over is whole counts and time stamps off by 1 ms
    double sag = 0.0;           ///< as PlantModel::sag; 0 where the pushes do not tell it
    double warming = 0.0;       ///< share by which τ grows with PushRecord::heat; the same
};

/// Fits all records together by variable projection (docs/tuning-method.md#identification). Nothing is resampled; the fit works at
/// telemetry periods from 1 ms to 100 ms. `pass`: s between two of the device's loop, for which an order and its counts wait, each
/// push differently: of more than 1 ms the half is taken back, 1 ms at most. OutOfRange where a record has fewer than eight samples
/// or moved fewer than 50 counts.
[[nodiscard]] Result<PushFit> fitPushes(std::span<const PushRecord> records, double pass = 0.0);

} // namespace mb::tuning
