// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/simulator.h"

#include "families/abstractdc/simulatorunit.h"
#include "simulation/simulatedtwins.h"

namespace mb::abstractdc {
Result<std::unique_ptr<Simulator>> simulate(Link &link, Clock &clock, const SimulatedUnit &unit)
{
    auto *const can = dynamic_cast<CanLink *>(&link);
    if (!can)
        return fail(Fault::Unsupported, say("Abstract DC Drives live on CAN links only"));
    MB_TRY(const auto options, simulation::UnitOptions::parse(unit));
    auto made = std::make_unique<SimulatedTwins<simulation::Unit>>("abstractdc:" + std::to_string(options.offset));
    made->add(*can, clock, options);
    if (options.find(FaultKind::Duplicate)) {
        simulation::UnitOptions twin = options;
        twin.temperatureOffset = 2;
        made->addBeside(*can, clock, twin);
    }
    return made;
}

} // namespace mb::abstractdc
