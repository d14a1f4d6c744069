// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/simulator.h"

#include "families/dmc60c/simulatorunit.h"

namespace mb::dmc60c {
namespace {

using simulation::Unit;
using simulation::UnitOptions;

class SimulatedDmc60c final : public Simulator {
public:
    SimulatedDmc60c(CanLink &link, Clock &clock, const UnitOptions &options)
        : m_number(options.number)
    {
        addUnit(link, clock, options);
        if (options.has("duplicate"))
            addUnit(link, clock, options.twin());
    }

    [[nodiscard]] std::string name() const override { return "dmc60c:" + std::to_string(m_number); }
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
    void addUnit(CanLink &link, Clock &clock, const UnitOptions &options)
    {
        auto notify
            = [this](Instant time, std::string_view what, double value) { emitEvent(time, std::string(what), value); };
        m_units.push_back(std::make_unique<Unit>(link, clock, options, std::move(notify)));
    }

    int m_number;
    std::vector<std::unique_ptr<Unit>> m_units; ///< two of them with the fault `duplicate`
};

} // namespace

Result<std::unique_ptr<Simulator>> simulate(Link &link, Clock &clock, const SimulatedUnit &unit)
{
    if (link.kind() != LinkKind::Can)
        return fail(Fault::OutOfRange, "a DMC60C is simulated on a CAN link");
    const auto options = UnitOptions::parse(unit);
    if (!options)
        return fail(options.error());
    return std::make_unique<SimulatedDmc60c>(static_cast<CanLink &>(link), clock, *options);
}

} // namespace mb::dmc60c
