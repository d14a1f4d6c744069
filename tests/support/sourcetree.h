// SPDX-License-Identifier: GPL-3.0-or-later
// Files of the source tree that tests read.
#pragma once

#include <string>

namespace mb {

// The path of a file named relative to the source folder, for example "resources/firmware/dmc60c-demo.hex". It stands in one
// object file, so that a compiler cache serves the tests of every checkout.
std::string inSourceTree(const std::string &relative);

} // namespace mb
