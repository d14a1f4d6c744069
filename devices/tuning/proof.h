// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/trial.h"
#include "tuning/gainscale.h"
#include "tuning/prediction.h"
#include "tuning/velocityfilter.h"

#include <vector>

namespace mb::tuning {

/// How large a step proves a loop: clear of noise and friction, and within duty and envelope; a travel or speed that nobody knows (the
/// pages, before it is entered: resolve() lets no tuning begin without it) bounds nothing. In the unit of the loop.
[[nodiscard]] double proofStep(
    Mode loop, const PlantModel &plant, const ContinuousGains &gains, const Envelope &envelope);

/// Steps each way that prove a current loop, in noise of σ A: their mean tells what one alone does not. At least 6, at most 30.
[[nodiscard]] int currentRepeats(double noise, double step);
/// A, the largest noise in which that many steps are enough.
[[nodiscard]] double mostNoise(double step);

/// The device has a least output that overcomes friction, and an error that is good enough.
[[nodiscard]] bool hasFrictionHelp(const Family &family);
/// Adds the least output that overcomes friction, and the error that is good enough, or the bound of the integral, where the slot
/// has them: a position loop comes to rest before its target otherwise. Any other loop would never come to rest with such an output: that
/// of a position loop which was in its slot before is taken away.
void addFrictionHelp(const Family &family, Mode loop, int axis, int slot, const PlantModel &plant, ScaledGains &into);

/// Takes away the bound that the slot has for the integral of other gains, where it has one and these have an integral: of a smaller I it
/// would leave too little to hold a speed or a current.
void freeIntegral(const Family &family, Mode loop, int axis, int slot, ScaledGains &into);

/// A slot of the device bounds the output of its loop.
[[nodiscard]] bool hasOutputLimits(const Family &family);
/// Has the device keep its loop to this duty, where its slot has such limits; `now` is what the slot has: a narrower one stays.
void limitOutput(
    const Family &family, Mode loop, int axis, int slot, double duty, const KnownGains &now, ScaledGains &into);

/// How a velocity loop takes its velocity at a speed, counts/s: as the family tells, else as it was found out.
[[nodiscard]] VelocityTaking velocityTaking(
    const Device &device, double speed, const std::optional<VelocityFilter> &found);

/// The loop of a family as proposals run in it.
[[nodiscard]] LoopShape shapeOf(
    const Family &family, Mode loop, const PlantModel &plant, const Envelope &envelope, const VelocityTaking &taking);

/// s that a proof holds a step of these gains, so that it settles even where it takes longer than predicted.
[[nodiscard]] double proofHold(Mode loop, const ContinuousGains &gains, const Prediction &predicted);
/// Counts that a velocity loop goes one way in so many holds of a step, until it is stopped.
[[nodiscard]] double wayOfProof(const PlantModel &plant, double step, double hold, int repeats);

/// How often a velocity loop has room for it, of `asked` times: once at least. Any other loop as often as that.
[[nodiscard]] int repeatsWithin(
    const std::optional<double> &room, Mode loop, const PlantModel &plant, double step, double hold, int asked);
/// The smallest step that tells anything of a velocity or position loop: beyond friction, and of some steps of what is read.
[[nodiscard]] double leastProofStep(
    const Family &family, Mode loop, const PlantModel &plant, const ContinuousGains &gains);

/// Of each metric the worse of the trials; nothing where one of them has none.
[[nodiscard]] Metrics worseOf(const std::vector<Trial> &trials);

/// The error that a loop may leave, and why nothing mends it.
struct RestingError {
    enum class Below {
        Motor,    ///< what P makes of it does not move the motor
        Allowed,  ///< it is good enough: the device does nothing about it
        Integral, ///< it adds nothing to the integral
        Time,     ///< the integral takes longer than a hold to overcome friction
    };
    double error = 0.0; ///< in the unit of the loop
    Below below = Below::Motor;
};
/// After so many seconds. A position whose integral does not move is left where friction holds P, or where it is good enough for a least
/// output that overcomes friction; a velocity is left to P alone.
[[nodiscard]] RestingError restingError(
    Mode loop, const LoopShape &shape, const PlantModel &plant, const ContinuousGains &gains, double seconds);

/// Share of its step that a current is from its target at the end, of the mean of all steps of a trial, the worst of the trials: one sample
/// is a whole step of its reading.
[[nodiscard]] std::optional<double> restOfCurrent(const std::vector<Trial> &trials);

/// The error, A, that a current loop must leave while its motor speeds up: its integral follows the motor's own voltage, which grows, from
/// behind; and half a step of what is read. Of the largest speeding up in the trials; 0 where the model does not know what a count/s takes off the duty.
[[nodiscard]] double droopOf(const std::vector<Trial> &trials, const PlantModel &plant, const ContinuousGains &gains);

/// What a proof may do and is still kept, where its samples are quiet.
struct ProofLimits {
    double overshoot = 0.0;       ///< of the step
    std::optional<double> settle; ///< s; empty: it depends on how quickly it rises
    double error = 0.0;           ///< of the step, at rest
};
/// `resting` error in the unit of the step.
[[nodiscard]] ProofLimits proofLimits(const Metrics &predicted, double step, double resting);

/// Empty when a proof did what was predicted; else what it did instead, with the numbers. `resting` error in the unit of the step.
[[nodiscard]] Message judgeProof(const Metrics &measured, const Metrics &predicted, double step, double resting);

} // namespace mb::tuning
