// SPDX-License-Identifier: GPL-3.0-or-later
// A bus that loses frames: what is read is complete or said to be missing, and what is lost is counted.
#include "model/parametertransfer.h"
#include "support/simulatedsession.h"

#include <cmath>

namespace mb {
namespace {

using namespace std::chrono_literals;
using test::run;
using test::SimulatedSession;

struct Loss {
    const char *text;
    double fraction;
};

class Dmc60cLoss : public testing::TestWithParam<Loss> {
protected:
    [[nodiscard]] static std::string link(int seed)
    {
        return std::string("sim:can?loss=") + GetParam().text + "&seed=" + std::to_string(seed);
    }
};

TEST_P(Dmc60cLoss, RepeatedScansFindAllThreeUnits)
{
    for (int seed = 1; seed <= 20; ++seed) {
        SimulatedSession bench(link(seed));
        std::size_t most = 0;
        for (int scan = 0; scan < 3; ++scan) {
            bench.scan();
            most = bench.devices("dmc60c").size();
        }
        EXPECT_EQ(most, 3U) << "seed " << seed;
        for (const Device *device : bench.devices("dmc60c"))
            EXPECT_NE(device->identity().state, DeviceState::Duplicate) << "seed " << seed;
    }
}

TEST_P(Dmc60cLoss, AllParametersAreReadInTheEnd)
{
    for (int seed = 1; seed <= 10; ++seed) {
        SimulatedSession bench(link(seed));
        for (int scan = 0; scan < 3 && !bench.device(5); ++scan)
            bench.scan();
        Device *device = bench.device(5);
        ASSERT_NE(device, nullptr) << "seed " << seed;
        NoProgress progress;
        const auto outcomes = run(bench.clock, readParameters(*device, readable(*device), progress));
        ASSERT_TRUE(outcomes) << "seed " << seed;
        for (const TransferOutcome &outcome : *outcomes) {
            EXPECT_TRUE(outcome.raw) << "seed " << seed << ' ' << device->parameters().parameter(outcome.index).key;
        }
    }
}

TEST_P(Dmc60cLoss, LostStatusFramesAreCountedWithinAFewPercent)
{
    SimulatedSession bench(link(3));
    for (int scan = 0; scan < 3 && !bench.device(5); ++scan)
        bench.scan();
    Device *device = bench.device(5);
    ASSERT_NE(device, nullptr);
    const auto duty = device->telemetry()->find("duty");
    ASSERT_TRUE(duty);
    bench.clock.advance(1s);
    device->telemetry()->commit();
    const auto samplesBefore = device->telemetry()->size(*duty);
    const auto lostBefore = device->telemetry()->lost(*duty);
    bench.clock.advance(100s);
    device->telemetry()->commit();
    const auto samples = static_cast<double>(device->telemetry()->size(*duty) - samplesBefore);
    const auto lost = static_cast<double>(device->telemetry()->lost(*duty) - lostBefore);
    EXPECT_NEAR(samples + lost, 10000.0, 20.0); // one every 10 ms
    const double expected = 10000.0 * GetParam().fraction;
    EXPECT_NEAR(lost, expected, 5.0 * std::sqrt(expected));
}

INSTANTIATE_TEST_SUITE_P(Fractions, Dmc60cLoss, testing::Values(Loss{"0.01", 0.01}, Loss{"0.1", 0.1}),
    [](const auto &entry) { return std::string(entry.param.fraction < 0.05 ? "OnePercent" : "TenPercent"); });

} // namespace
} // namespace mb
