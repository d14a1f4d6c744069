// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/simulator.h"
#include "transport/canlink.h"

#include <algorithm>
#include <memory>
#include <optional>

namespace mb {

/// A simulated controller as one, or, with the fault `duplicate`, two units that answer to one number and cannot be told apart
/// from outside. `Unit` has the functions of Simulator, and is made of link, clock, options and a sink for its events.
template <class Unit> class SimulatedTwins final : public Simulator {
public:
    explicit SimulatedTwins(std::string name)
        : m_name(std::move(name))
    {
    }
    template <class LinkShape, class Options> void add(LinkShape &link, Clock &clock, const Options &options)
    {
        auto notify
            = [this](Instant time, std::string_view what, double value) { emitEvent(time, std::string(what), value); };
        m_units.push_back(std::make_unique<Unit>(link, clock, options, std::move(notify)));
    }
    /// With an end of its own, where the bus has one: what both send at once is one frame where it is alike, and destroyed where not.
    template <class Options> void addBeside(CanLink &link, Clock &clock, const Options &options)
    {
        m_end = link.makeAnotherEnd();
        if (!m_end)
            return add(link, clock, options);
        const auto follow = [this](LinkState state) {
            if (state == LinkState::Open)
                (void)m_end->open();
        };
        follow(link.state());
        m_linkState = link.stateChanged().add(follow);
        add(*m_end, clock, options);
    }

    [[nodiscard]] std::string name() const override { return m_name; }
    [[nodiscard]] bool isOutputOn() const override
    {
        return std::ranges::any_of(m_units, [](const auto &unit) { return unit->isOutputOn(); });
    }
    [[nodiscard]] double speed() const override { return m_units.front()->speed(); }
    [[nodiscard]] double position() const override { return m_units.front()->position(); }
    [[nodiscard]] std::optional<double> current() const override
    {
        if constexpr (requires(Unit & unit) { unit.current(); })
            return m_units.front()->current();
        else
            return std::nullopt;
    }
    [[nodiscard]] std::optional<std::int64_t> gain(std::string_view key) const override
    {
        if constexpr (requires(Unit & unit) { unit.gain(key); })
            return m_units.front()->gain(key);
        else
            return std::nullopt;
    }
    [[nodiscard]] std::vector<std::uint8_t> flash() const override
    {
        if constexpr (requires(const Unit &unit) { unit.flash(); })
            return m_units.front()->flash();
        else
            return {};
    }
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
    std::string m_name;
    std::unique_ptr<CanLink> m_end; ///< of the second unit
    Subscription m_linkState;
    std::vector<std::unique_ptr<Unit>> m_units;
};

} // namespace mb
