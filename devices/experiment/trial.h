// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/endreason.h"
#include "experiment/metrics.h"
#include "experiment/stimulus.h"
#include "model/parameter.h"
#include "model/setpoint.h"
#include "model/trialtraits.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mb::tuning {

/// A signal of a trial, seconds since its first edge.
struct Signal {
    std::string channel; ///< key of the family's table
    std::string unit;
    Trace trace;

    friend bool operator==(const Signal &, const Signal &) = default;
};

/// Names of flags, as in JSON.
namespace flag {
constexpr std::string_view saturated = "saturated";
constexpr std::string_view currentLimit = "current-limit";
constexpr std::string_view rampLimit = "ramp-limit";
constexpr std::string_view limitSwitch = "switch";
constexpr std::string_view lostSamples = "lost-samples";
constexpr std::string_view aborted = "aborted";
constexpr std::string_view lowResolution = "low-resolution";
constexpr std::string_view asymmetric = "asymmetric";
constexpr std::string_view didNotMove = "did-not-move";
constexpr std::string_view restartNeeded = "restart-needed";
} // namespace flag

/// A stretch of a trial, seconds since its first edge.
struct Span {
    double from = 0.0;
    double to = 0.0;

    friend bool operator==(const Span &, const Span &) = default;
};

/// One experiment on one loop: what was asked, what came of it. A value; what is not known is empty.
struct Trial {
    std::optional<std::int64_t> number; ///< in the notebook, where it is kept
    std::string device;                 ///< selector
    std::string unit;                   ///< who it is across links: serial number, or this place
    std::string firmware;               ///< version, empty when unknown
    bool simulated = false;
    Mode mode = Mode::Velocity;
    int axis = 1;
    int slot = 0;
    Stimulus stimulus;
    int repeat = 1;
    std::vector<std::pair<std::string, std::optional<double>>> gains; ///< of the loop, in the unit of the parameter
    Envelope envelope;                                                ///< in which it ran
    Metrics metrics;
    Metrics errors; ///< ±, of repeats
    std::vector<std::string> flags;
    EndReason reason = EndReason::None;
    Message detail; ///< one clause about it; empty for done
    Message
        notPutBack; ///< why what it has written is still in force, and owed; empty: the gains are as planned. Not kept
    bool stopped = false;
    std::uint64_t samples = 0;
    std::uint64_t lost = 0;
    std::vector<Span> holds;   ///< each stay at Y, from its edge on
    std::vector<Span> returns; ///< each way back to X
    std::vector<Signal> signals;

    [[nodiscard]] bool has(std::string_view flag) const;
    /// Whether another may follow by itself: it was done, its motor was seen to stand, and its gains are as planned.
    [[nodiscard]] bool mayGoOn() const { return reason == EndReason::Done && stopped && notPutBack.empty(); }
    [[nodiscard]] const Signal *signal(std::string_view key) const; ///< of its axis; nullptr: not recorded
    /// The mean of all repeats (averaged(), equivalenttime.h), t = 0 at the edge, some of what was before: the hold as long as all
    /// have it, then the ways back, each from where the shortest hold has ended. The signal as it is where nothing steps.
    [[nodiscard]] Trace folded(std::string_view key) const;
};

} // namespace mb::tuning
