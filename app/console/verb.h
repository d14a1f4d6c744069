// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/console.h"

#include <CLI/CLI.hpp>

#include <span>
#include <string_view>

namespace mb::console {

/// One verb: its name, what it does, and a function that declares its arguments and yields the job that uses them.
struct Verb {
    std::string_view name;
    std::string_view usage; ///< what follows the name
    std::string_view help;
    Job (*declare)(CLI::App &arguments);
    std::string_view mayBeEmpty = {}; ///< the option, if any, where an empty value means something
};

[[nodiscard]] std::span<const Verb> verbs();

[[nodiscard]] Job declareLinks(CLI::App &arguments);
[[nodiscard]] Job declareScan(CLI::App &arguments);
[[nodiscard]] Job declareInfo(CLI::App &arguments);
[[nodiscard]] Job declareParameters(CLI::App &arguments);
[[nodiscard]] Job declareGet(CLI::App &arguments);
[[nodiscard]] Job declareSet(CLI::App &arguments);
[[nodiscard]] Job declareRestore(CLI::App &arguments);
[[nodiscard]] Job declareSnapshot(CLI::App &arguments);
[[nodiscard]] Job declareSnapshots(CLI::App &arguments);
[[nodiscard]] Job declareDiff(CLI::App &arguments);
[[nodiscard]] Job declareWatch(CLI::App &arguments);
[[nodiscard]] Job declareDrive(CLI::App &arguments);
[[nodiscard]] Job declareFlash(CLI::App &arguments);
[[nodiscard]] Job declareIdentify(CLI::App &arguments);
[[nodiscard]] Job declareRestart(CLI::App &arguments);
[[nodiscard]] Job declareNumber(CLI::App &arguments);
[[nodiscard]] Job declareRename(CLI::App &arguments);
[[nodiscard]] Job declareMonitor(CLI::App &arguments);
[[nodiscard]] Job declareDecode(CLI::App &arguments);
[[nodiscard]] Job declarePlot(CLI::App &arguments);
[[nodiscard]] Job declareSimulate(CLI::App &arguments);
[[nodiscard]] Job declareHelp(CLI::App &arguments);
[[nodiscard]] Job declareCompletion(CLI::App &arguments);
[[nodiscard]] Job declareStep(CLI::App &arguments);
[[nodiscard]] Job declareTune(CLI::App &arguments);
[[nodiscard]] Job declareTrials(CLI::App &arguments);
[[nodiscard]] Job declareService(CLI::App &arguments);
[[nodiscard]] Job declareJournal(CLI::App &arguments);
[[nodiscard]] Job declareReport(CLI::App &arguments);

} // namespace mb::console
