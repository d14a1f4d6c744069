// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/battery.h"

#include <array>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr std::array<double, 5> sizes{0.2, 0.4, 0.6, 0.8, 1.0}; ///< of the largest step

bool neverSettled(const Metrics &metrics)
{
    return metrics.noise && !metrics.settle && *metrics.noise <= unreadableNoise;
}

} // namespace

Battery batteryOf(const ExperimentPlan &largest, double here, bool counted)
{
    Battery battery;
    const bool place = largest.mode == Mode::Position;
    const double origin = !place ? largest.from.value_or(0.0) : counted ? 0.0 : here;
    for (const double size : sizes) {
        for (const double sign : {1.0, -1.0}) {
            ExperimentPlan step = largest;
            step.profile = Profile::Step;
            step.repeat = 1;
            step.seconds.reset();
            step.from = place ? std::optional<double>() : origin;
            step.to = origin + sign * size * (largest.to - origin);
            battery.steps.push_back(std::move(step));
        }
    }
    return battery;
}

BatteryWorst worstOf(std::span<const Trial> trials)
{
    BatteryWorst worst;
    const auto &keys = metricKeys();
    for (std::size_t key = 0; key < keys.size(); ++key) {
        std::optional<double> &value = worst.metrics.*keys[key].value;
        for (std::size_t i = 0; i < trials.size(); ++i) {
            const auto &one = trials[i].metrics.*keys[key].value;
            const bool isNever = keys[key].value == &Metrics::settle && neverSettled(trials[i].metrics);
            if (isNever || (one && (!value || std::abs(*one) > std::abs(*value)))) {
                value = one;
                worst.where[key] = i;
            }
            if (isNever)
                break;
        }
    }
    return worst;
}

} // namespace mb::tuning
