// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/experiment.h"
#include "tuning/gainrules.h"

#include <vector>

namespace mb::tuning {

/// What a motor answers to one sine of duty around a speed at which it never reverses, so that friction drops out.
struct FrequencyPoint {
    double hertz = 0.0;
    double magnitude = 0.0; ///< counts/s per duty; 0: its trial told none
    double phase = 0.0;     ///< degrees, 0 … −360
    double coherence = 0.0; ///< share of the movement beside the mean speed that this sine explains, 0 … 1
    bool trusted = false;   ///< enough samples a swing, and coherence 0.9 or more
};

/// Out of a trial of Profile::Sine in duty mode: least squares of a line, the start's own decay and the sine to the counts as they were
/// received, of the sine to the duty as the device told it (or as it was ordered). `tau` of the motor, s. OutOfRange where there are
/// too few samples or the motor reversed.
[[nodiscard]] Result<FrequencyPoint> frequencyPoint(const Trial &trial, double tau);

/// Sines one after the other, from slow to quick.
struct SweepPlan {
    int axis = 1;
    int slot = 0;
    double bias = 0.0;         ///< duty
    double swing = 0.0;        ///< duty, either side of it
    std::vector<double> hertz; ///< ascending
    double seconds = 0.0;      ///< of all of them
    double speed = 0.0;        ///< counts/s, the fastest that the model expects
    double travel = 0.0;       ///< counts, of the longest
    Envelope limits;           ///< what the caller allows
};
/// Eight sines between a twentieth and ten times the motor's corner, as far as a device that takes a set-point every `beat` s can follow them,
/// as large as the envelope in force allows. OutOfRange where it leaves too little.
[[nodiscard]] Result<SweepPlan> planSweep(const PlantModel &plant, const Envelope &inForce, double beat);
/// "duty 14 ± 6 %, at most 260 000 counts/s, 4 100 000 counts one way, 58 s": said before it moves.
[[nodiscard]] Message announcementOf(const SweepPlan &plan);

struct FrequencyResponse {
    std::vector<FrequencyPoint> points;
    EndReason stopReason = EndReason::None; ///< of the trial that cut it short
    Message evidence;                       ///< one sentence for people
    bool stopped = true;                    ///< the motor was seen stopped
    bool simulated = false;
    std::vector<std::int64_t> trials; ///< numbers in the notebook

    /// The highest frequency up to which every point is to be trusted; 0: none.
    [[nodiscard]] double trustedUpTo() const;
};

/// Every sine is a guarded experiment of its own. Everything of ExperimentSurroundings holds; the stream's lease is the caller's to
/// renew. Fails only where nothing has moved.
[[nodiscard]] Task<FrequencyResponse> measureFrequencyResponse(
    Device &device, SetPointStream &stream, SweepPlan plan, PlantModel plant, ExperimentSurroundings surroundings);

} // namespace mb::tuning
