// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/simulator.h"
#include "transport/link.h"

#include <memory>

namespace mb::dmc60c {

/// A simulated DMC60C on a CAN link, which may be opened before or after. It shares only protocol.h and the framing
/// with the code that drives a real one.
///
/// Address 0…63. Options: `motor` and `load` (simulation/motormodel.h), `gains=tuned|default|overshoot` (what is stored:
/// slot 0 for velocity, slot 1 for position; tuned unless given), `serial` (12 characters), `session` (1…65535, or
/// 0x…), `name`, `firmware=1.23`, `product=601`, `state=application|bootloader`, `crc=A|B|C` (README.md#page-check), `velocity=rolling|block`,
/// `button=brake|coast` (its stored setting). Anything else: OutOfRange.
///
/// Faults count the frames the device sends (`drop`, `corrupt`, `delay`, and `silent`: nothing from that frame on), or
/// those addressed to it, enumeration included (`power`: the supply goes before the N-th is acted upon), or seconds
/// from the start. A lost supply returns after 200 ms unless setPowered(false) took it away. `brownout` lasts 6 s
/// at 5.0 V; `busoff` 100 ms. `duplicate` adds a second unit of the same number with another session and serial number.
///
/// Events: output-on, output-off, halted, fault (value: the bits), reset, bootloader, application, page-written (value:
/// the page), page-failed, config-flash (value: the sequence number), power-lost, power-on, bricked. Times are exact.
///
/// disturb(): `load-torque` (N·m at the shaft), `stall` (0/1), `bus-voltage` (V), `analog-input` (V), `forward-limit`
/// and `reverse-limit` (1: switch closed), `gate-fault` (0/1), `temperature` (°C of the case), `current-noise` (σ of the current that it reads, in
/// its 31.6 mA; 2 unless set), `flash-fail` (page whose
/// next write fails).
[[nodiscard]] Result<std::unique_ptr<Simulator>> simulate(Link &link, Clock &clock, const SimulatedUnit &unit);

} // namespace mb::dmc60c
