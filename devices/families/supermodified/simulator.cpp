// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/simulator.h"

#include "families/supermodified/simulatorunit.h"

namespace mb::supermodified {
namespace {

using simulation::Unit;
using simulation::UnitOptions;

class SimulatedSupermodified final : public Simulator {
public:
    SimulatedSupermodified(SerialLink &link, Clock &clock, const UnitOptions &options)
        : m_node(options.node)
    {
        addUnit(link, clock, options);
        if (options.has("duplicate")) {
            UnitOptions twin = options;
            twin.seed = options.seed ^ 0x5DEECE66DULL;
            addUnit(link, clock, twin);
        }
    }

    [[nodiscard]] std::string name() const override { return "supermodified:" + std::to_string(m_node); }
    [[nodiscard]] bool isOutputOn() const override
    {
        bool on = false;
        for (const auto &unit : m_units)
            on = unit->isOutputOn() || on;
        return on;
    }
    [[nodiscard]] double speed() const override { return m_units.front()->speed(); }
    [[nodiscard]] double position() const override { return m_units.front()->position(); }
    void setPowered(bool powered) override
    {
        for (const auto &unit : m_units)
            unit->setPowered(powered);
    }
    bool disturb(std::string_view what, double value) override
    {
        bool known = true;
        for (const auto &unit : m_units)
            known = unit->disturb(what, value) && known;
        return known;
    }

private:
    void addUnit(SerialLink &link, Clock &clock, const UnitOptions &options)
    {
        auto notify
            = [this](Instant time, std::string_view what, double value) { emitEvent(time, std::string(what), value); };
        m_units.push_back(std::make_unique<Unit>(link, clock, options, std::move(notify)));
    }

    int m_node;
    std::vector<std::unique_ptr<Unit>> m_units; ///< two of them with the fault `duplicate`
};

} // namespace

Result<std::unique_ptr<Simulator>> simulate(Link &link, Clock &clock, const SimulatedUnit &unit)
{
    auto *const serial = dynamic_cast<SerialLink *>(&link);
    if (!serial)
        return fail(Fault::OutOfRange, "a Supermodified is simulated on a serial link");
    const auto options = UnitOptions::parse(unit);
    if (!options)
        return fail(options.error());
    return std::make_unique<SimulatedSupermodified>(*serial, clock, *options);
}

} // namespace mb::supermodified
