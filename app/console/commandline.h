// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/console.h"

#include <string>
#include <string_view>
#include <vector>

namespace mb::console {

struct CommandLine {
    Options options;
    Job job;          ///< none when only `text` is to be printed
    std::string text; ///< of --help and --version
    std::string key;  ///< what that is in JSON: "help" …
    std::string value;
};

/// `arguments` without the program's name. Usage with cause and remedy for everything that is not understood.
[[nodiscard]] Result<CommandLine> parseCommandLine(std::vector<std::string> arguments);

/// What `--help` prints of the program, or of a verb. Usage when there is no such verb.
[[nodiscard]] Result<std::string> helpText(std::string_view verb = {});

struct OptionRow {
    std::string name; ///< with its dashes
    bool takesValue = false;
    std::string help;
};
/// Of one verb, those that every verb has among them.
[[nodiscard]] std::vector<OptionRow> optionsOf(std::string_view verb);

} // namespace mb::console
