// SPDX-License-Identifier: GPL-3.0-or-later
// Key to metrics: from the end of a step's hold to its metrics, in the thread of the engine, on the simulated bench of every
// family. Wanted: 0.3 s in the window, which shows what the engine tells at least every 33 ms.
#include "tests/tuning/experimentbench.h"

#include <benchmark/benchmark.h>

#include <chrono>

namespace mb {
namespace {

using Wall = std::chrono::steady_clock;

struct Unit {
    const char *link;
    const char *family;
    int address;
    Mode mode;
    double to;
};

constexpr Unit units[] = {
    {"sim:can", "dmc60c", 5, Mode::Velocity, 60'000.0},
    {"sim:can", "abstractdc", 3, Mode::Velocity, 4000.0},
    {"sim:serial", "supermodified", 4, Mode::Position, 400.0},
    {"sim:spi", "quadquad2drv", 0, Mode::Velocity, 1000.0},
};

void holdToMetrics(benchmark::State &state)
{
    const Unit &unit = units[state.range(0)];
    double samples = 0.0;
    for ([[maybe_unused]] auto run : state) {
        test::ExperimentBench bench(unit.link, unit.family, unit.address);
        SetPointStream &stream = bench.bench.session.stream(*bench.device);
        Wall::time_point held;
        double seconds = 0.0;
        double target = 0.0;
        const Subscription watching = stream.changed().add([&] {
            const double now = stream.isRunning() ? stream.setPoint().target : target;
            if (target == unit.to && now != target)
                held = Wall::now();
            target = now;
        });
        bench.surroundings.measured = [&](const tuning::Trial &trial) {
            seconds = std::chrono::duration<double>(Wall::now() - held).count();
            samples = static_cast<double>(trial.samples);
        };
        const auto trial = bench.run(test::stepTo(unit.mode, unit.to));
        if (!trial || seconds <= 0.0)
            state.SkipWithError("the step was not measured");
        state.SetIterationTime(seconds);
    }
    state.SetLabel(unit.family);
    state.counters["samples"] = samples;
}

BENCHMARK(holdToMetrics)->DenseRange(0, 3)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(20);

} // namespace
} // namespace mb
