// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/simulator.h"

#include "families/abstractdc/simulatorunit.h"

namespace mb::abstractdc {
namespace {

using simulation::Unit;
using simulation::UnitOptions;

class SimulatedDrive final : public Simulator {
public:
    SimulatedDrive(CanLink &link, Clock &clock, const UnitOptions &options)
        : m_name("abstractdc:" + std::to_string(options.offset))
        , m_unit(link, clock, options,
              [this](Instant time, std::string_view what, double value) { emitEvent(time, std::string(what), value); })
    {
        if (options.find("duplicate"))
            m_twin = std::make_unique<Unit>(link, clock, options, [](Instant, std::string_view, double) {});
    }
    [[nodiscard]] std::string name() const override { return m_name; }
    [[nodiscard]] bool isOutputOn() const override { return m_unit.isOutputOn(); }
    [[nodiscard]] double speed() const override { return m_unit.speed(); }
    [[nodiscard]] double position() const override { return m_unit.position(); }
    [[nodiscard]] std::optional<double> current() const override { return m_unit.current(); }
    void setPowered(bool powered) override
    {
        m_unit.setPowered(powered);
        if (m_twin)
            m_twin->setPowered(powered);
    }
    bool disturb(std::string_view what, double value) override { return m_unit.disturb(what, value); }

private:
    std::string m_name;
    mutable Unit m_unit; ///< looking at the motor lets it turn up to now
    std::unique_ptr<Unit> m_twin;
};

} // namespace

Result<std::unique_ptr<Simulator>> simulate(Link &link, Clock &clock, const SimulatedUnit &unit)
{
    auto *const can = dynamic_cast<CanLink *>(&link);
    if (!can)
        return fail(Fault::Unsupported, say("Abstract DC Drives live on CAN links only"));
    const auto options = UnitOptions::parse(unit);
    if (!options)
        return fail(options.error());
    return std::unique_ptr<Simulator>(std::make_unique<SimulatedDrive>(*can, clock, *options));
}

} // namespace mb::abstractdc
