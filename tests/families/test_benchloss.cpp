// SPDX-License-Identifier: GPL-3.0-or-later
// A simulated bench loses nothing by what the program itself does there.
#include "support/simulatedsession.h"
#include "transport/canlink.h"

namespace mb {
namespace {

using namespace std::chrono_literals;
using test::run;
using test::SimulatedSession;

void expectNothingLost(SimulatedSession &bench)
{
    for (const Device *device : bench.session.devices()) {
        for (std::uint16_t i = 0; i < device->telemetry()->channels().size(); ++i)
            EXPECT_EQ(device->telemetry()->lost({i}), 0U)
                << device->selector() << ' ' << device->telemetry()->channels()[i].key;
    }
}

TEST(BenchLoss, NobodyIsAskedBehindAPageOfFirmware)
{
    SimulatedSession bench;
    bench.scan();
    bench.clock.advance(2s);
    auto &link = static_cast<CanLink &>(*bench.link);
    for (int page = 0; page < 20; ++page) {
        for (int i = 0; i < 513; ++i)
            ASSERT_TRUE(link.send(extendedFrame(0x0206FC7FU, {1, 2, 3, 4, 5, 6, 7, 8}))); // data for number 63
        bench.clock.advance(130ms);
    }
    bench.clock.advance(2s);
    expectNothingLost(bench);
}

TEST(BenchLoss, AnAnswerThatAPageOfFirmwareHoldsBackIsNotLost)
{
    SimulatedSession bench;
    bench.scan();
    bench.clock.advance(2s);
    auto &link = static_cast<CanLink &>(*bench.link);
    bool asked = false;
    const Subscription watching = link.traffic().add([&asked](const Traffic &traffic) {
        asked = asked || (traffic.direction == Direction::Sent && !traffic.can->extended && traffic.can->size == 1);
    });
    for (int page = 0; page < 20; ++page) {
        asked = false;
        ASSERT_TRUE(bench.clock.runUntil([&asked] { return asked; }, 1s)) << "a drive is polled";
        for (int i = 0; i < 513; ++i)
            ASSERT_TRUE(link.send(extendedFrame(0x0206FC7FU, {1, 2, 3, 4, 5, 6, 7, 8}))); // wins over its answer
        bench.clock.advance(130ms);
    }
    bench.clock.advance(2s);
    expectNothingLost(bench);
}

TEST(BenchLoss, APeriodThatIsWrittenAgainChangesNothing)
{
    SimulatedSession bench;
    bench.scan();
    Device *const device = bench.device(5);
    ASSERT_NE(device, nullptr);
    const auto position = *findChannel(device->family().channels, "position");
    for (int i = 0; i < 100; ++i) {
        ASSERT_TRUE(run(bench.clock, device->setRate(position, 100.0)));
        bench.clock.advance(i * 1700us);
    }
    bench.clock.advance(1s);
    expectNothingLost(bench);
}

} // namespace
} // namespace mb
