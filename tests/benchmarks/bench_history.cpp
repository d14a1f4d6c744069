// SPDX-License-Identifier: GPL-3.0-or-later
// docs/names.md#numbers: at most 16 bytes a stored sample, pyramid included; the part of a replot that is not painting.
#include "telemetry/history.h"
#include "telemetry/telemetry.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

namespace {

using namespace mb;
using namespace std::chrono_literals;

constexpr int width = 1600;

/// Sine plus noise of 1 % of the pane, or noise over the whole height, at 1 kHz.
void fill(History &history, std::int64_t samples, bool noiseOnly)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> noise(-1.0, 1.0);
    for (std::int64_t i = 0; i < samples; ++i) {
        const double sine = std::sin(static_cast<double>(i) * 2e-6);
        history.append(Instant(i * 1ms), noiseOnly ? noise(random) : sine + 0.01 * noise(random));
    }
}

void append(benchmark::State &state)
{
    std::vector<double> values(1 << 16);
    std::mt19937 random(1);
    std::normal_distribution<double> noise;
    for (double &value : values)
        value = noise(random);
    History history;
    std::size_t i = 0;
    for (auto _ : state) {
        history.append(Instant(static_cast<std::int64_t>(i) * 1ms), values[i % values.size()]);
        if (++i % 4'000'000 == 0) {
            state.PauseTiming();
            history.clear();
            state.ResumeTiming();
        }
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()));
}
BENCHMARK(append);

void appendAndCommit(benchmark::State &state)
{
    static constexpr std::array<Channel, 4> channels{{{"a", "", "A"}, {"b", "", "B"}, {"c", "", "C"}, {"d", "", "D"}}};
    Telemetry telemetry(channels);
    std::int64_t i = 0;
    for (auto _ : state) {
        const auto channel = static_cast<std::uint16_t>(i % 4);
        telemetry.append({ChannelIndex{channel}, Instant(i / 4 * 1ms), static_cast<double>(i & 0xFFF)});
        if (++i % 500 == 0)
            telemetry.commit();
        if (i % 4'000'000 == 0) {
            state.PauseTiming();
            telemetry.clear();
            state.ResumeTiming();
        }
    }
    state.SetItemsProcessed(i);
}
BENCHMARK(appendAndCommit);

/// Sixteen traces, a new window each time, so that nothing is in the cache from the time before.
void columnsOfSixteenTraces(benchmark::State &state)
{
    std::vector<History> traces(16);
    for (History &trace : traces)
        fill(trace, state.range(0), state.range(1) != 0);
    const Duration span = state.range(0) * 1ms;
    std::vector<Point> points;
    Instant from{};
    const std::uint64_t visited = traces.front().visited();
    for (auto _ : state) {
        for (const History &trace : traces) {
            trace.columns(from, from + span, width, points);
            benchmark::DoNotOptimize(points.data());
        }
        from += 16667us;
    }
    const auto queries = static_cast<double>(state.iterations());
    state.counters["points"] = static_cast<double>(points.size());
    state.counters["visited/column"] = static_cast<double>(traces.front().visited() - visited) / queries / width;
    state.counters["bytes/sample"]
        = static_cast<double>(traces.front().memoryUse()) / static_cast<double>(traces.front().size());
}
BENCHMARK(columnsOfSixteenTraces)
    ->ArgNames({"samples", "noise"})
    ->Args({3'600'000, 0})
    ->Args({3'600'000, 1})
    ->Unit(benchmark::kMillisecond);

/// The same as a live plot asks for it: the window moves by a frame, what is drawn already is kept.
void scrollOfSixteenTraces(benchmark::State &state)
{
    std::vector<History> traces(16);
    for (History &trace : traces)
        fill(trace, 3'700'000, false);
    std::vector<ColumnWindow> windows(16);
    Instant from{};
    for (auto _ : state) {
        for (std::size_t i = 0; i < traces.size(); ++i)
            traces[i].columns(from, from + 3600s, width, windows[i]);
        from = from < Instant(90s) ? from + 16667us : Instant();
    }
    state.counters["points"] = static_cast<double>(windows.front().points().size());
}
BENCHMARK(scrollOfSixteenTraces)->Unit(benchmark::kMillisecond);

/// One trace: the whole of it, a middle hour, a second.
void columns(benchmark::State &state)
{
    History history;
    fill(history, state.range(0), false);
    const Instant middle = Instant(state.range(0) / 2 * 1ms);
    const Duration half = std::chrono::milliseconds(state.range(1)) / 2;
    std::vector<Point> points;
    const std::uint64_t visited = history.visited();
    for (auto _ : state) {
        history.columns(middle - half, middle + half, width, points);
        benchmark::DoNotOptimize(points.data());
    }
    const auto queries = static_cast<double>(state.iterations());
    state.counters["points"] = static_cast<double>(points.size());
    state.counters["visited/column"] = static_cast<double>(history.visited() - visited) / queries / width;
    state.counters["bytes/sample"] = static_cast<double>(history.memoryUse()) / static_cast<double>(history.size());
}
BENCHMARK(columns)
    ->ArgNames({"samples", "window_ms"})
    ->Args({3'600'000, 3'600'000})
    ->Args({20'000'000, 20'000'000})
    ->Args({20'000'000, 3'600'000})
    ->Args({20'000'000, 1'000})
    ->Unit(benchmark::kMicrosecond);

} // namespace
