// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/message.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mb::service {

/// What is done to a unit, in this order. Their words are stable: journal and JSON have them.
enum class Step { Preflight, Backup, Firmware, Parameters, Test, Number, Proof, Done };
[[nodiscard]] std::string_view toString(
    Step step); ///< preflight backup firmware parameters self-test number proof done
[[nodiscard]] Step stepFromString(std::string_view text);

/// What came of a unit. Refused: nothing was done to it. Open: nobody has seen the end yet.
enum class Outcome { Open, Passed, Failed, Refused };
[[nodiscard]] std::string_view toString(Outcome outcome); ///< open passed failed refused
[[nodiscard]] Outcome outcomeFromString(std::string_view text);

/// What of a unit that has failed or was refused concerns more than this unit; None for everything else.
enum class Ending {
    None,
    StopUnconfirmed, ///< nobody has seen its motor stand after a self-test
    NumbersUsedUp,   ///< there is none for the next unit either
};
[[nodiscard]] std::string_view toString(Ending ending); ///< "" stop-unconfirmed numbers-used-up
[[nodiscard]] Ending endingFromString(std::string_view text);

/// One value of a self-test.
struct TestValue {
    std::string key;
    std::optional<double> value; ///< nothing: it could not be measured
    std::optional<double> low;   ///< limits of the recipe
    std::optional<double> high;
    bool passed = true;
    bool unusual = false; ///< outside the golden band: only a warning

    friend bool operator==(const TestValue &, const TestValue &) = default;
};

/// That a step began, or how it ended.
struct StepEntry {
    Step step = Step::Preflight;
    double time = 0.0; ///< Unix, s
    bool ended = false;
    Message detail; ///< what came of it, one sentence

    friend bool operator==(const StepEntry &, const StepEntry &) = default;
};

/// One unit under one recipe, once: what the journal keeps. A value; what is empty is not known.
struct Visit {
    std::string id;    ///< the same on every computer; empty: not in the journal yet
    std::string run;   ///< of one start of a queue; those that it resumed have the same
    double time = 0.0; ///< Unix, s
    std::string station;
    std::string person;
    std::string recipe; ///< its name
    std::string recipeHash;
    std::string imageHash;
    std::string unit; ///< unitKeyOf()
    std::string serial;
    std::string device; ///< selector, the last that it had
    std::string family;
    bool simulated = false;
    Step step = Step::Preflight; ///< the last that began
    Outcome outcome = Outcome::Open;
    std::string from;              ///< firmware before
    std::string to;                ///< firmware afterwards
    bool unproved = false;         ///< it was written, and told the same before
    std::optional<int> parameters; ///< values of the recipe that were read back
    std::vector<TestValue> test;
    std::optional<int> number;            ///< that it was given
    std::optional<std::int64_t> snapshot; ///< the backup, in the notebook of this computer
    std::optional<std::int64_t> trial;    ///< the self-test's, likewise
    double seconds = 0.0;
    Message cause; ///< of Failed and Refused
    Ending ending = Ending::None;
    Message remedy;
    Message evidence; ///< one sentence: what proves it
    std::string note; ///< of the operator
    std::vector<StepEntry> steps;

    friend bool operator==(const Visit &, const Visit &) = default;
};

/// Numbers are given once in it: "dmc60c drive-base rev C"; simulated units have numbers of their own.
[[nodiscard]] std::string numberScopeOf(const Visit &visit);
/// Who a number is given to: Visit::unit, or Visit::id of one known by its place.
[[nodiscard]] std::string numberOwnerOf(const Visit &visit);

} // namespace mb::service
