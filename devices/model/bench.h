// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"
#include "simulation/simulatedbus.h"
#include "transport/pacedclock.h"

#include <memory>
#include <vector>

namespace mb {

/// The simulated bench behind a `sim:` link: a bus in memory with the units that the families list, factory-fresh.
/// Options of the address: seed, loss, bitrate, fault (docs/names.md#links). It lives on a time of its own, in which
/// everything happens when it is due: on a computer that is held up it catches up, and nothing is lost but by `loss` and `fault`.
class Bench {
public:
    /// OutOfRange when an option does not parse; Unsupported when no family has units for such a link.
    [[nodiscard]] static Result<std::unique_ptr<Bench>> create(
        const LinkAddress &address, Clock &clock, std::span<const Family *const> families);

    /// The host's end of the bus; the bench outlives it.
    [[nodiscard]] std::unique_ptr<Link> hostLink();
    [[nodiscard]] std::vector<Simulator *> simulators() const;
    /// Whoever follows the link must live on this clock.
    [[nodiscard]] Clock &clock() { return m_clock; }
    /// The share of frames that is lost from now on, 0 to 1, as `loss=` of the address sets it from the start.
    void setLoss(double fraction) { m_bus->setLoss(fraction); }

private:
    Bench(LinkAddress address, Clock &outer, std::uint64_t seed);
    [[nodiscard]] Result<void> populate(
        std::span<const Family *const> families, const std::vector<SimulatedFault> &faults);
    [[nodiscard]] Result<void> addUnit(const Family &family, SimulatedUnit unit);

    LinkAddress m_address;
    PacedClock m_clock;
    std::uint64_t m_seed;
    std::unique_ptr<SimulatedBus> m_bus;
    std::vector<std::unique_ptr<Link>> m_links;
    std::vector<std::unique_ptr<Simulator>> m_simulators;
    Timer m_busOff;
    std::optional<double> m_busOffAt; ///< seconds after the host opened its end
};

/// `sim:` stands for every simulated link that has units, each with those of the faults that its units can have; another address for
/// itself.
[[nodiscard]] std::vector<LinkAddress> expandLink(const LinkAddress &address, std::span<const Family *const> families);

} // namespace mb
