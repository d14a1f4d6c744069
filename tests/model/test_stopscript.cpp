// SPDX-License-Identifier: GPL-3.0-or-later
// What a stop script is on each kind of link.
#include "async/virtualclock.h"
#include "model/stopscript.h"
#include "transport/backends/virtualserial.h"
#include "transport/backends/virtualspi.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <span>
#include <vector>

namespace mb {
namespace {

using namespace std::chrono_literals;
using Bytes = std::vector<std::uint8_t>;

TEST(StopScripts, GoOutAsFramesAsBytesOrAsTransfersAndInTheirOrder)
{
    VirtualClock clock;
    const StopScript both{
        {{extendedFrame(0x100, {0}), {1, 2}, {}, {}, 5ms, 3}, {extendedFrame(0x200, {0}), {3}, {}, {}, 5ms, 1}}};
    EXPECT_TRUE(StopScript{}.isEmpty());
    EXPECT_FALSE(both.isEmpty());

    VirtualSerialLine wire(clock, VirtualSerialLine::Wiring::FullDuplex, 1);
    VirtualSerialLink serial(*LinkAddress::parse("sim:serial"), wire);
    ASSERT_TRUE(serial.open());
    Bytes bytes;
    const auto sentBytes = serial.traffic().add(
        [&bytes](const Traffic &traffic) { bytes.insert(bytes.end(), traffic.bytes.begin(), traffic.bytes.end()); });
    sendScript(serial, both);
    EXPECT_EQ(bytes, (Bytes{1, 2, 3})) << "each once";

    struct Board final : SpiSlave {
        void transfer(std::span<const std::uint8_t> mosi, std::span<std::uint8_t>) override
        {
            heard.emplace_back(mosi.begin(), mosi.end());
        }
        [[nodiscard]] bool isReady() const override { return false; }
        void reset() override { }
        std::vector<Bytes> heard;
    } board;
    VirtualSpiSlaveLink slave(*LinkAddress::parse("sim:spi"));
    VirtualSpiLink spi(*LinkAddress::parse("sim:spi"), clock, slave, 500'000, 1);
    slave.attach(&board);
    ASSERT_TRUE(spi.open());
    sendScript(spi, {{both.steps[0]}});
    clock.advance(10ms);
    EXPECT_EQ(board.heard, (std::vector<Bytes>{{1, 2}}));
}

} // namespace
} // namespace mb
