// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/simulator.h"
#include "transport/link.h"

#include <memory>

namespace mb::supermodified {

/// A simulated Supermodified on a serial link, which may be opened before or after. It shares only protocol.h and the framing
/// with the code that drives a real one.
///
/// Address 1…127, the node id. Options: `dialect=D1|D2|D3` (D1), `motor` and `load` (simulation/motormodel.h; a 25d whose output
/// turns the encoder), `gains=tuned|default` (what is stored; tuned), `baud` (its rate; the link's own where the address of
/// the link fixes one, else 115200, or 57600 for D3 and on simulated links), `mask` (1…255), `level=0|1` (D1, D2), `halfpacket=0|1` (the newest
/// firmware, which drops half a frame after 50 ms), `hang=0|1` (1: asking the encoder of a started D1 or D2 can hang it,
/// README.md#hang), `serial` (accepted, not on the wire). Anything else: OutOfRange.
///
/// Faults count the frames the device sends (`drop`, `corrupt`, `delay`, and `silent`: nothing from that frame on), or those
/// addressed to it (`power`: the supply goes before the N-th is acted upon), or seconds from the start (`reset`,
/// `encoder-dead`, `brownout`, `stall`). A lost supply returns after 200 ms unless setPowered(false) took it away.
/// `duplicate` adds a second unit with the same id. Others: Unsupported.
///
/// Events: output-on, output-off, fault (value: the code), power-lost, power-on, hung (value: the command) and
/// crashed (the byte count that overran its buffer): the motor goes on as it was, and only a restart helps.
///
/// disturb(): `load-torque` (N·m at the shaft), `stall` (0/1), `bus-voltage` (V), `error` (a code to queue), `analog1`…`analog4`
/// (V).
[[nodiscard]] Result<std::unique_ptr<Simulator>> simulate(Link &link, Clock &clock, const SimulatedUnit &unit);

} // namespace mb::supermodified
