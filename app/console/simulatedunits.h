// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/console.h"
#include "app/console/ending.h"
#include "transport/backends/ptyline.h"

#include <QJsonArray>

#include <list>
#include <memory>

namespace mb::console {

struct PlannedUnit {
    LinkAddress link;
    SimulatedUnit unit;
    const Family *family = nullptr;
};

/// Simulated units on real links, each with an end of the link of its own, so that they hear each other as real ones do. A
/// serial port cannot be opened twice: there they share one end.
class SimulatedUnits {
public:
    SimulatedUnits(Console &console, bool events);
    Result<void> add(const PlannedUnit &unit);
    void watch(Ending &ending);
    /// All that are served, each once.
    [[nodiscard]] const QJsonArray &links() const { return m_links; }

private:
    struct Running {
        std::unique_ptr<Simulator> simulator;
        Subscription events;
    };
    struct Terminal {
        LinkAddress address;
        std::unique_ptr<PtyLine> line;
    };
    [[nodiscard]] Result<Link *> endOf(const LinkAddress &address);
    [[nodiscard]] Result<std::unique_ptr<Link>> makeEnd(const LinkAddress &address);
    void print(const Link &link, const Simulator &simulator, const Family &family, const SimulatorEvent &event);

    Console &m_console;
    bool m_events;
    std::list<Terminal> m_terminals;
    std::list<std::unique_ptr<Link>> m_ends;
    std::list<Running> m_units;
    QJsonArray m_links;
};

} // namespace mb::console
