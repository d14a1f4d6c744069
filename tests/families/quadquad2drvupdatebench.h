// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/quadquad2drv/firmware.h"
#include "families/quadquad2drv/simulatorboard.h"
#include "families/quadquad2drv/simulatorboot.h"
#include "families/quadquad2drv/updater.h"
#include "model/operation.h"
#include "model/registry.h"
#include "support/simulatedsession.h"
#include "transport/backends/virtualserial.h"
#include "transport/backends/virtualspi.h"

namespace mb::quadquad2drv {

using namespace std::chrono_literals;

inline constexpr std::string_view hex = ":0400000001020304F2\n:0400040005060708DE\n:00000001FF\n";

/// Board, bootloader and host, all in memory.
struct QuadQuad2DrvUpdateBench {
    explicit QuadQuad2DrvUpdateBench(const std::string &options = {})
        : slave(*LinkAddress::parse("sim:spi"))
        , spi(*LinkAddress::parse("sim:spi"), clock, slave, 500'000, 1)
        , line(clock, VirtualSerialLine::Wiring::FullDuplex, 1)
        , boardEnd(*LinkAddress::parse("sim:serial"), line)
        , hostEnd(*LinkAddress::parse("sim:serial"), line)
    {
        simulation::BoardOptions made
            = *simulation::BoardOptions::parse(*SimulatedUnit::parse("quadquad2drv:0" + options));
        (void)slave.open();
        board = std::make_unique<simulation::Board>(slave, clock, made, [](std::string_view, double) {});
        (void)boardEnd.open();
        boot = std::make_unique<simulation::Boot>(boardEnd, clock, *board, made);
        (void)spi.open();
        Identity identity;
        identity.family = "quadquad2drv";
        device = findFamily(families(), "quadquad2drv")->open(spi, clock, identity);
        (void)test::run(clock, device->refresh());
    }
    UpdateReport update(const BootSettings &settings = {})
    {
        Updater updater(*device, hostEnd, image, operation, settings);
        std::optional<UpdateReport> end;
        operation.run<UpdateReport>(
            updater.run(false), [&end](Result<UpdateReport> report) { end = report ? *report : UpdateReport{}; });
        EXPECT_TRUE(clock.runUntil(
            [&] {
                if (hand)
                    hand();
                return end.has_value();
            },
            10min));
        return end.value_or(UpdateReport{});
    }
    [[nodiscard]] PartState step(int number) const { return operation.status().parts.at(number); }
    [[nodiscard]] bool said(std::string_view text) const
    {
        const auto &log = operation.status().log;
        return std::any_of(log.begin(), log.end(),
            [text](const LogLine &row) { return row.text.english().find(text) != std::string::npos; });
    }

    VirtualClock clock;
    VirtualSpiSlaveLink slave;
    VirtualSpiLink spi;
    VirtualSerialLine line;
    VirtualSerialLink boardEnd;
    VirtualSerialLink hostEnd;
    std::unique_ptr<simulation::Board> board;
    std::unique_ptr<simulation::Boot> boot;
    std::unique_ptr<Device> device;
    FirmwareImage image = *FirmwareImage::fromIntelHex(hex);
    Operation operation{clock, say("update")};
    std::function<void()> hand; ///< what the user does, looked at often
};

} // namespace mb::quadquad2drv
