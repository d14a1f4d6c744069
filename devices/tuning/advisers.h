// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/trial.h"

#include <string>
#include <string_view>
#include <vector>

namespace mb::tuning {

/// What an adviser has to say. Closed: each has its words in the window, its number here.
enum class Cause {
    FeedForwardConflict, ///< F and I both remove the lag: what was late is paid back as overshoot
    Deadband,            ///< a P loop stops where friction holds it
    LowResolution,       ///< the step has few counts
    GainResolution,      ///< a gain has few steps of the device's number
    DerivativeNoise,     ///< one count of noise moves the duty much
    Saturated,           ///< the duty was at its limit, so gains cannot help
    CurrentLimited,
    RampLimited,
    HiddenDelay,  ///< the measured velocity comes late
    SlowIntegral, ///< the end is reached by I alone, slowly
    Underdamped,  ///< it rings
    DidNotMove,
};
[[nodiscard]] std::string_view toString(Cause cause);

/// A gain to try instead; nothing is written by an adviser.
struct StagedGain {
    std::string key;
    double value = 0.0; ///< unit of the parameter

    friend bool operator==(const StagedGain &, const StagedGain &) = default;
};

struct Advice {
    Cause cause = Cause::DidNotMove;
    double number = 0.0;            ///< what it saw: a share, seconds, counts, by cause
    std::string sentence;           ///< English, with that number and what to do
    std::vector<StagedGain> remedy; ///< empty: the remedy is no gain
};

/// What is known of the plant and the device, beside the trial; what is not stays empty, and whoever needs it is silent.
struct AdviserKnowledge {
    std::optional<double> friction;    ///< duty that overcomes it
    std::optional<double> countDuty;   ///< duty that D gives for one count of change
    std::optional<double> steps;       ///< least number of raw steps that a gain other than 0 has
    std::optional<double> stiffness;   ///< duty per count of error, of P in a position loop
    std::optional<double> feedForward; ///< F over what the plant needs: 1 is exact
};

/// Every cause that fits, the gravest first. Pure.
[[nodiscard]] std::vector<Advice> advise(const Trial &trial, const AdviserKnowledge &known);

/// What the family's numbers tell of a trial's gains: friction must come from an identification.
[[nodiscard]] AdviserKnowledge knowledgeOf(const Family &family, const Trial &trial, std::optional<double> friction);

} // namespace mb::tuning
