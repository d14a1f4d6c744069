// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/tuning/matrix/bruteforce.h"

#include <map>

namespace mb::test {

/// What came of one tuning of the matrix.
struct MatrixRow {
    Cell cell;
    std::string result; ///< of the tuning; "failed" where nothing moved
    std::string reason; ///< what it says for people
    tuning::PlantModel truth;
    tuning::PlantModel found;
    double predictedOvershoot = 0.0;
    double measuredOvershoot = 0.0;                    ///< as the proof saw it
    double measuredNoise = 0.0;                        ///< σ, of the step
    double seconds = 0.0;                              ///< of the device
    std::map<std::string, double> stages;              ///< of them, by what was done: "pushing", "proving" …
    std::vector<std::pair<double, std::string>> notes; ///< what it said, and when, s; its gates last
    bool gainsAsBefore = true;                         ///< of those that were not kept, where they can be read
    bool stopped = true;
    bool isWithin = false; ///< the kept gains hold the bounds of bruteForce(), but for the overshoot
    double step = 0.0;
    int steps = 0; ///< that have proven what was kept
    tuning::ContinuousGains keptGains;
    tuning::ContinuousGains bestGains;
    tuning::ContinuousGains formerGains; ///< that were there before; 0 where they are not known
    bool isFormerWithin = false;         ///< they hold the same bounds
    std::optional<ShaftResponse> kept;
    std::optional<ShaftResponse> before;
    std::optional<ShaftResponse> best;
    std::optional<ShaftResponse> zieglerNichols;
    std::optional<ShaftResponse> tyreusLuyben;
    std::optional<ShaftResponse> regression;
};

/// What is tried beside a tuning: nothing, its own gains and those before, or also the best there are and those of published rules.
enum class Compare { Nothing, Kept, All };
[[nodiscard]] MatrixRow tuneCell(const Cell &cell, Compare compare);

/// The conditions of a seed: load from 0.6 to 1.6 times, and of friction, backlash, a sagging supply, ripple and lost frames
/// none, some or all.
[[nodiscard]] Cell cellOf(const std::string &family, const std::string &motor, Mode loop, std::uint64_t seed,
    double rate, const std::string &dialect = "");

/// One line of a table, its cells parted by tabs, and its head.
[[nodiscard]] std::string matrixHead();
[[nodiscard]] std::string textOf(const MatrixRow &row);

} // namespace mb::test
