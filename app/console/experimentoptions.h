// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/console.h"
#include "model/trialtraits.h"

#include <string>

namespace CLI {
class App;
} // namespace CLI

namespace mb::console {

/// Beyond every number that means something.
constexpr double anyNumber = 1e12;

/// The options that verbs which experiment on a loop share: which axis and slot, and what must not be left. As typed.
struct ExperimentOptions {
    std::string axis;
    std::string slot;
    std::string travel;
    std::string speed;
    std::string current;
    std::string duty;

    /// `slotHelp`: what the slot is for.
    void declare(CLI::App &arguments, const std::string &slotHelp);
    struct Values {
        int axis = 1;
        int slot = 0;
        Envelope limits;
    };
    /// OutOfRange names the option.
    [[nodiscard]] Result<Values> parse(const Family &family) const;
};

/// Whether `--save PATH` could be written, asked before anything moves. Empty: it was not given.
[[nodiscard]] Result<void> checkSave(const std::string &path);
/// What a verb ends with that was to save its result: what became of the motor comes first, and then a file that was not written.
[[nodiscard]] Result<int> afterSaving(const Console &console, Result<int> verdict, const Result<void> &saved);

} // namespace mb::console
