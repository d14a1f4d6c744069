// SPDX-License-Identifier: GPL-3.0-or-later
// What the window's picture costs the engine, thirty times a second: with what seldom changes shared, and copied each time.
#include "model/snapshot.h"
#include "support/simulatedsession.h"

#include <benchmark/benchmark.h>

namespace mb {
namespace {

using namespace std::chrono_literals;

void takePictures(benchmark::State &state, bool copied)
{
    test::SimulatedSession bench;
    bench.scan();
    bench.clock.advance(3s);
    const std::vector<Device *> devices = bench.session.devices();
    for (auto _ : state) {
        std::vector<DeviceView> views;
        for (Device *device : devices) {
            DeviceView &view = views.emplace_back(viewOf(bench.session, *device));
            if (copied) {
                benchmark::DoNotOptimize(view.identity.edit());
                benchmark::DoNotOptimize(view.parameters.edit());
                benchmark::DoNotOptimize(view.profile.edit());
            }
        }
        benchmark::DoNotOptimize(views);
    }
    state.counters["s/device"]
        = benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(devices.size()),
            benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK_CAPTURE(takePictures, shared, false);
BENCHMARK_CAPTURE(takePictures, copied, true);

} // namespace
} // namespace mb
