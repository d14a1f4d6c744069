// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"

namespace mb::quadquad2drv {

/// The simulated board with four motors, on the board's end of an SPI link (SpiSlaveLink).
///
/// Options: `motor=` and `load=` for all four motors, `firmware=1.3`, `boot=LINK` (its bootloader's serial line),
/// `jumper=closed` (a reset enters the bootloader), `state=bootloader`, `scale=` (what a raw gain makes, 0.001…1000), `inputs=` and
/// `target=` (the readings of the document that units differ in), `serial` (accepted, not on the wire).
/// Faults: drop, corrupt, delay, silent (N-th packet that the board sends), power (the supply goes before its N-th request and
/// returns after 200 ms), power-page (with `boot`: at that line), reset, brownout (no supply for 6 s), encoder-dead, stall (seconds),
/// encoder-reversed; the last three concern channel 1. Others: Unsupported. Disturbances: load-torque, stall, bus-voltage (all axes), `input1`… (level), jumper.
[[nodiscard]] Result<std::unique_ptr<Simulator>> simulate(Link &link, Clock &clock, const SimulatedUnit &unit);

} // namespace mb::quadquad2drv
