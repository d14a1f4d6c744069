// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/tunereport.h"

namespace mb::tuning {

/// What is to be known of the proposed set: which of its gains have so few steps that they cannot be set finely; why F is written as 0,
/// so that one that was there does not stay. `family` tells what the parameters of a tuning from a file are for.
[[nodiscard]] std::vector<Message> designNotes(const TuneReport &report, const Family *family = nullptr);

} // namespace mb::tuning
