// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/latepush.h"

#include "model/family.h"
#include "model/loopparameters.h"

#include <algorithm>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr double longest = 5.0; ///< s

/// Duty that a gain of the trial's loop makes of 1 count/s, I in each pass; nothing where that is not known.
std::optional<double> madeBy(const Device &device, const Trial &trial, Role role)
{
    const Family &family = device.family();
    const auto calibration = std::ranges::find_if(
        family.calibrations, [&](const Calibration &row) { return row.loop == trial.mode && row.gain == role; });
    const auto gain
        = std::ranges::find_if(trial.gains, [&](const auto &known) { return roleOf(family, known.first) == role; });
    const double one
        = calibration == family.calibrations.end() ? 0.0 : device.knowledge().profile().calibrated(calibration->key);
    if (gain == trial.gains.end() || !gain->second || one <= 0.0)
        return std::nullopt;
    return *gain->second * one / family.loop->fullDuty;
}

} // namespace

double secondsUntilPush(const Device &device, const Trial &trial, double duty)
{
    const LoopScale *const scale = device.family().loop;
    if (trial.mode != Mode::Velocity || !scale || !scale->calibrated)
        return 0.0;
    const auto p = madeBy(device, trial, Role::Proportional);
    const auto i = madeBy(device, trial, Role::Integral);
    const double step = std::max(std::abs(trial.stimulus.from), std::abs(trial.stimulus.to));
    if (!p || !i || *i * step <= 0.0)
        return 0.0;
    return std::clamp((duty - *p * step) / (*i * step) * scale->period, 0.0, longest);
}

} // namespace mb::tuning
