// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/simulator.h"
#include "transport/link.h"

#include <memory>

namespace mb::abstractdc {

/// A simulated Abstract DC Drive on a CAN link of any bit rate. It shares only protocol.h and the framing with the code that
/// drives a real one.
///
/// Address (offset) 0…99. Options: `dialect=F|L|LL|D` (F), `motor` and `load` (simulation/motormodel.h; 25d), `serial` (accepted as
/// everywhere, but the drive has none), `gains=tuned|default|overshoot` (what flash holds; default is blank flash),
/// `glitches=N` (every N-th position log is off by 65 535, README.md#position). Anything else: OutOfRange.
///
/// The converter gives 20 counts per ampere (whatever the direction) and 10 per °C. At output 0 the bridge brakes.
///
/// Faults count the frames the device sends (`drop`, `corrupt`, `delay`, and `silent`: nothing from that frame on), or those
/// it hears (`power`: the supply goes before the N-th and returns after 200 ms), or seconds from the start. `duplicate` adds
/// a second unit with the same offset. `busoff`: for 100 ms it hears and sends nothing. Others: Unsupported.
///
/// Events: output-on, output-off, reset, power-lost, power-on, settings-saved (value: the loop), memory-overrun.
///
/// disturb(): `load-torque` (N·m at the shaft), `stall` (0/1), `bus-voltage` (V), `glitch` (the next position log is off).
[[nodiscard]] Result<std::unique_ptr<Simulator>> simulate(Link &link, Clock &clock, const SimulatedUnit &unit);

} // namespace mb::abstractdc
