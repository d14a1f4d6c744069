// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/task.h"

namespace mb::tuning {

class AutotuneRun;

/// How little moves a motor whose loop has gains of an unknown scale.
struct FirstMotion {
    double push = 0.0;    ///< P times counts; two thirds of it did not
    double current = 0.0; ///< A for P times counts, where the device tells them and friction held it; 0: not known
};

/// Steps as short as the check of the direction, which the first of them is, both ways: with a P that is an eighth of the stored one and
/// grows until they move, without D, for friction damps so short a way. Never more than the stored P would make of the
/// steps that follow. The run is over where nothing moves it.
[[nodiscard]] Task<FirstMotion> findFirstMotion(AutotuneRun &run, double storedP);

} // namespace mb::tuning
