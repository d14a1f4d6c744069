// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/simulator.h"

#include "families/dmc60c/simulatorunit.h"
#include "simulation/simulatedtwins.h"

namespace mb::dmc60c {
Result<std::unique_ptr<Simulator>> simulate(Link &link, Clock &clock, const SimulatedUnit &unit)
{
    if (link.kind() != LinkKind::Can)
        return fail(Fault::OutOfRange, say("a DMC60C is simulated on a CAN link"));
    MB_TRY(const auto options, simulation::UnitOptions::parse(unit));
    auto &can = static_cast<CanLink &>(link);
    auto made = std::make_unique<SimulatedTwins<simulation::Unit>>("dmc60c:" + std::to_string(options.number));
    made->add(can, clock, options);
    if (findFault(options.faults, FaultKind::Duplicate))
        made->addBeside(can, clock, options.twin());
    return made;
}

} // namespace mb::dmc60c
