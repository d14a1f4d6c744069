// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/tuning/experimentbench.h"
#include "tuning/autotune.h"

#include <cstdio>

namespace mb::test {

using tuning::ScaledGains;
using tuning::Trial;
using tuning::TunePlan;
using tuning::TuneReport;

[[nodiscard]] inline TunePlan planOf(Mode loop)
{
    TunePlan plan;
    plan.loop = loop;
    return plan;
}

[[nodiscard]] inline Result<TuneReport> tune(ExperimentBench &bench, const TunePlan &plan)
{
    return test::run(bench.bench.clock,
        autotune(*bench.device, bench.bench.session.stream(*bench.device), plan, bench.surroundings));
}

[[nodiscard]] inline std::int64_t rawOf(ExperimentBench &bench, std::string_view key)
{
    const auto raw = test::run(bench.bench.clock, bench.device->read(bench.bench.index(*bench.device, key)));
    return raw.value_or(-1);
}

inline void print(const TuneReport &report)
{
    const auto number = [](const std::optional<double> &value) { return value.value_or(-1.0); };
    std::printf("%s %s: %s, %s\n", report.device.c_str(), std::string(toString(report.loop)).c_str(),
        std::string(toString(report.result)).c_str(), report.evidence.english().c_str());
    if (report.motor)
        std::printf("  gain %.0f  tau %.1f ms  delay %.1f ms  friction %.4f  filter %s %.0f ms  cost %.2f\n",
            report.plant.gain, 1e3 * report.plant.tau, 1e3 * report.plant.delay, report.plant.friction,
            report.motor->filter ? std::string(toString(report.motor->filter->kind)).c_str() : "-",
            report.motor->filter ? 1e3 * report.motor->filter->window : 0.0, report.motor->pushes.cost);
    if (report.predicted)
        std::printf("  predicted: overshoot %.3f settle %.3f rise %.3f\n", number(report.predicted->metrics.overshoot),
            number(report.predicted->metrics.settle), number(report.predicted->metrics.rise));
    std::printf("  measured:  overshoot %.3f settle %.3f rise %.3f sse %.4f; %.1f s, %zu trials\n",
        number(report.measured.overshoot), number(report.measured.settle), number(report.measured.rise),
        number(report.measured.sse), report.seconds, report.trials.size());
    std::printf("  noise %.4f\n", number(report.measured.noise));
    for (const Trial &trial : report.proof)
        std::printf("  to %.0f: overshoot %.3f settle %.3f sse %.4f holds %zu\n", trial.stimulus.to,
            number(trial.metrics.overshoot), number(trial.metrics.settle), number(trial.metrics.sse),
            trial.holds.size());
    for (const ScaledGains::Row &row : report.proposed.rows)
        std::printf("  %s = %.6g\n", row.key.c_str(), row.number);
}

} // namespace mb::test
