// SPDX-License-Identifier: GPL-3.0-or-later
// docs/names.md#numbers: decode and store, at least 2 000 000 frames/s on one core.
#include "async/virtualclock.h"
#include "model/device.h"
#include "model/family.h"
#include "model/registry.h"
#include "transport/backends/virtualcan.h"

#include <benchmark/benchmark.h>

namespace mb {
namespace {

using namespace std::chrono_literals;

/// A link that is fed by hand: what a backend does, without one.
class FedLink final : public CanLink {
public:
    explicit FedLink(Clock &clock)
        : CanLink(LinkAddress{"sim", "can", {}}, clock)
    {
    }
    void feed(const CanFrame &frame) { deliver(frame); }
    void end() { endBatch(); }

private:
    Result<void> doOpen() override { return {}; }
    void doClose() override { }
    Result<void> doSend(const CanFrame &, Priority) override { return {}; }
    [[nodiscard]] std::size_t doBacklog() const override { return 0; }
    [[nodiscard]] int doBitrate() const override { return 1'000'000; }
};

/// Status frames of one unit as they come at 1 kHz: frame → link → controller → samples → history.
void decodeAndStore(benchmark::State &state)
{
    VirtualClock clock;
    FedLink link(clock);
    (void)link.open();
    Identity identity;
    identity.family = "dmc60c";
    identity.address = 5;
    identity.session = 0x1234;
    const Family &family = *findFamily(families(), "dmc60c");
    const auto device = family.open(link, clock, identity);
    std::array frames{*canFrameFromText("02061405#0040110000000000"), *canFrameFromText("02061485#01E240FED4000014"),
        *canFrameFromText("020614C5#4C03FF3B00F6FF1B")};
    std::size_t next = 0;
    for (auto _ : state) {
        clock.advance(64us);
        for (int i = 0; i < 64; ++i) {
            CanFrame &frame = frames[next++ % frames.size()];
            frame.time = clock.now();
            link.feed(frame);
        }
        link.end();
        device->telemetry()->commit();
        if (device->telemetry()->memoryUse() > 512u * 1024 * 1024) {
            state.PauseTiming();
            device->telemetry()->clear();
            state.ResumeTiming();
        }
    }
    state.counters["frames/s"]
        = benchmark::Counter(static_cast<double>(state.iterations()) * 64, benchmark::Counter::kIsRate);
}
BENCHMARK(decodeAndStore);

} // namespace
} // namespace mb
