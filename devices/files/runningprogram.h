// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace mb {

/// Names a process, given by its number, among all of this computer's, those to come included; empty when there is none.
[[nodiscard]] std::string programOf(const std::string &process);
[[nodiscard]] std::string thisProgram();
/// A process of that name is there, and is not this one.
[[nodiscard]] bool isAnotherRunning(const std::string &program);

} // namespace mb
