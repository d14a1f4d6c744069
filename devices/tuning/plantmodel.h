// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace mb::tuning {

/// A motor as one of its loops sees it: gain·e^(−delay·s)/(tau·s + 1) from duty to what the loop measures; to its speed in a
/// position loop, which integrates it.
struct PlantModel {
    double gain = 0.0;         ///< counts/s per duty; A per duty in a current loop
    double tau = 0.0;          ///< s
    double delay = 0.0;        ///< s, of the whole loop
    double friction = 0.0;     ///< duty
    double braking = 1.0;      ///< times as strongly as it drives, that a current brakes (rollout.h)
    double stallCurrent = 0.0; ///< A per duty at standstill; 0: not known
    double backDuty = 0.0;     ///< duty that a count/s takes off it
    double noise = 0.0;        ///< σ of what a current loop measures, A
    double reading = 0.0;      ///< A, steps in which it is read
    double lagDoubt = 0.0;     ///< share by which tau of a current loop may be off; 0: it is taken, nobody has seen it
    double pickUp = 0.0;       ///< counts/s² per A, that the motor of a current loop speeds up with
    double idle = 0.0;         ///< A of it, that friction takes
    double sag = 0.0;     ///< share by which tau grows with the square of the duty (pushfit.h); it is that of dutyOfLag
    double warming = 0.0; ///< as PushFit::warming; gain and tau are of the cold motor (windingheat.h)
    double breakaway = 0.0; ///< duty that surely moves it from rest, as a ramp told it; 0: none did

    friend bool operator==(const PlantModel &, const PlantModel &) = default;
};

constexpr double mostBraking = 2.5; ///< PlantModel::braking of a gear, the strongest that steps are taken for

/// duty = p·e + i·∫e dt + d·de/dt + f·target, in duty per counts/s, counts or A, and seconds.
struct ContinuousGains {
    double p = 0.0;
    double i = 0.0;
    double d = 0.0;
    double f = 0.0;

    friend bool operator==(const ContinuousGains &, const ContinuousGains &) = default;
};

} // namespace mb::tuning
