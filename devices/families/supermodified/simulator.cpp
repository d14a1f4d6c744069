// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/simulator.h"

#include "families/supermodified/simulatorunit.h"
#include "simulation/faultplan.h"
#include "simulation/simulatedtwins.h"

namespace mb::supermodified {
Result<std::unique_ptr<Simulator>> simulate(Link &link, Clock &clock, const SimulatedUnit &unit)
{
    auto *const serial = dynamic_cast<SerialLink *>(&link);
    if (!serial)
        return fail(Fault::OutOfRange, say("a Supermodified is simulated on a serial link"));
    MB_TRY(const auto options, simulation::UnitOptions::parse(unit));
    auto made = std::make_unique<SimulatedTwins<simulation::Unit>>("supermodified:" + std::to_string(options.node));
    made->add(*serial, clock, options);
    if (findFault(options.faults, FaultKind::Duplicate)) {
        simulation::UnitOptions twin = options;
        twin.seed ^= 0x5DEECE66DULL;
        made->add(*serial, clock, twin);
    }
    return made;
}

} // namespace mb::supermodified
