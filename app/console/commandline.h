// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/console.h"

#include <string>
#include <vector>

namespace mb::console {

struct CommandLine {
    Options options;
    Job job;          ///< none when only `text` is to be printed
    std::string text; ///< of --help and --version
};

/// `arguments` without the program's name. OutOfRange with one line for everything that is not understood.
[[nodiscard]] Result<CommandLine> parseCommandLine(std::vector<std::string> arguments);

} // namespace mb::console
