// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "firmware/updateroute.h"
#include "transport/linkaddress.h"

#include <chrono>
#include <string>
#include <vector>

namespace mb::quadquad2drv {

/// What the maker does not tell (README.md#firmware), with the likely reading.
struct BootSettings {
    std::chrono::milliseconds lineTime{50};     ///< least time between lines
    std::chrono::milliseconds answerTime{2000}; ///< for the confirmation of a line
    std::chrono::seconds bannerTime{30};        ///< for jumper and reset, by hand
    int baudrate = 115200;
    std::string ending = "\r";         ///< of a line, as the terminal program of the data sheet sends it
    std::string banner = "bootloader"; ///< what its greeting holds, in whatever case
    std::vector<std::string> failures{"err", "fail", "bad", "invalid"}; ///< what a refusal holds, in whatever case
    std::string farewell = "reset"; ///< leaves the bootloader; empty: only jumper and reset do

    /// Takes the settings out of the options of `--via` (Family::routes). OutOfRange for a value that is none.
    [[nodiscard]] static Result<BootSettings> take(LinkAddress &via);
};

/// UpdateRoute::settings: the same for people.
[[nodiscard]] std::span<const UpdateSetting> bootUnknowns();

} // namespace mb::quadquad2drv
