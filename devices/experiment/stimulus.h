// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "async/result.h"

#include <optional>
#include <string_view>
#include <vector>

namespace mb::tuning {

enum class Profile { Step, Square, Ramp, Sine, Chirp, Prbs };

[[nodiscard]] std::string_view toString(Profile profile);
[[nodiscard]] std::optional<Profile> profileFromString(std::string_view text);

/// What a loop is asked to follow, from `from` to `to` and back to `from`; both in the unit of the mode. Times in seconds.
/// Pure: the same stimulus gives the same targets.
struct Stimulus {
    Profile profile = Profile::Step;
    double from = 0.0;
    double to = 0.0;
    double time = 0.0; ///< step: the hold; ramp: the rise; others: the whole
    bool ends
        = false; ///< a step's hold ends before `time` once the loop has settled; a ramp is not held where it has come to
    double period = 0.0; ///< square, sine: of one swing; prbs: of one bit
    double low = 0.0;    ///< chirp: first and last frequency, Hz
    double high = 0.0;

    /// With the usual times of the profile, or `seconds` of it. `beat` is the command period of the device, s.
    /// OutOfRange with the number where edges or swings are finer than that, or no time is left.
    [[nodiscard]] static Result<Stimulus> make(
        Profile profile, double from, double to, std::optional<double> seconds, double beat);

    /// The target `t` seconds after its beginning; `from` before it.
    [[nodiscard]] double at(double t) const;
    /// Longest time from its beginning to its end, the way back excluded.
    [[nodiscard]] double length() const;
    /// Jumps from `from` to `to`, s after the beginning; none for profiles that never jump.
    [[nodiscard]] std::vector<double> edges() const;
    /// It moves all the time: the rarer its set-points, the larger the jumps that a loop answers.
    [[nodiscard]] bool glides() const;
    /// How long the target stays after such a jump.
    [[nodiscard]] double hold() const { return profile == Profile::Square ? period / 2.0 : time; }

    friend bool operator==(const Stimulus &, const Stimulus &) = default;
};

/// The bits of a maximal sequence of 7 bits: 127 of them, then again.
[[nodiscard]] bool prbsBit(int index);

} // namespace mb::tuning
