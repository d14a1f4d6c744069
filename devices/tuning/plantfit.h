// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "tuning/trace.h"

#include <optional>
#include <span>
#include <vector>

namespace mb::tuning {

/// A push with constant duty from standstill, as telemetry saw it.
struct PushRecord {
    Trace position;    ///< counts as received, t = 0 when the duty was applied or ordered
    double duty = 0.0; ///< applied, sign included; over the mean bus voltage if that sags: duty × volts / volts at rest
    double growth = 0.0; ///< s until all of its duty was there
};

/// What pushes have in common: position = A·(t' − τ(1 − e^(−t'/τ))) with t' = t − delay.
struct PushFit {
    double tau = 0.0;   ///< s
    double delay = 0.0; ///< s, dead time up to 80 ms; holds the latency of the link where t is the order's
    double tauError = 0.0;
    double delayError = 0.0;    ///< ± two standard errors
    std::vector<double> speeds; ///< A of each record, counts/s
    double cost = 0.0;          ///< 1: what is left over is whole counts and time stamps off by 1 ms
};

/// Fits all records together by variable projection (docs/tuning.md, "Identification"). Nothing is resampled; the fit works at
/// telemetry periods from 1 ms to 100 ms. OutOfRange where a record has fewer than eight samples or moved fewer than 50 counts.
[[nodiscard]] Result<PushFit> fitPushes(std::span<const PushRecord> records);

/// How final speed follows from duty: duty = friction·sgn + offset + speed/gain.
struct GainFit {
    double gain = 0.0;     ///< counts/s at full duty
    double friction = 0.0; ///< duty that moving friction takes
    double offset = 0.0;   ///< duty that a load takes which always pulls one way; 0 unless both directions were seen
    double gainError = 0.0;
    double frictionError = 0.0;
    double forward = 0.0; ///< counts/s per duty beyond friction, of each direction alone
    double reverse = 0.0;
    /// |forward − reverse| over their mean.
    [[nodiscard]] double asymmetry() const;
};

/// Least squares over pushes of two sizes at least. OutOfRange where all have one size, or a motor did not turn with its duty.
[[nodiscard]] Result<GainFit> fitGain(std::span<const double> duties, std::span<const double> speeds);

/// A slow ramp of duty, up or down from standstill.
struct RampRecord {
    Trace position; ///< counts
    Trace duty;     ///< as PushRecord::duty, at times of its own
};

/// Gain and friction from ramps alone, by integrals; `tau` from fitPushes(). More exact than fitGain() where friction is small.
/// OutOfRange where a ramp never got going.
[[nodiscard]] Result<GainFit> fitRamps(std::span<const RampRecord> ramps, double tau);

} // namespace mb::tuning
